//! Identities that the caller gives: an item is known by them from frame to frame, not by its address, its place in a
//! list, or where it is.

use crate::{Ball, Glow, Lamp, Occluder, Top};
use std::sync::atomic::{AtomicU64, Ordering};

/// The caller's name for an item of a scene. No two lamps of a scene have the same one, nor two occluders, two tops, two
/// balls or two glows; a lamp and a top may. An item that comes back with its id is the same item, wherever it is now and
/// however it looks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ItemId(pub u32);

/// Which version of art it is. Art of the same revision has the same pixels: whoever rasterizes others takes a fresh one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Revision(u64);

impl Revision {
    /// That of art that nobody has named.
    pub(crate) const NONE: Revision = Revision(0);

    /// A revision that no art in this process has had.
    pub fn fresh() -> Revision {
        static LAST: AtomicU64 = AtomicU64::new(0);
        Revision(LAST.fetch_add(1, Ordering::Relaxed) + 1)
    }
}

/// What has an identity.
pub(crate) trait Item {
    /// The caller's name for it.
    fn id(&self) -> ItemId;
}

macro_rules! items {
    ($($item:ty),*) => {
        $(impl Item for $item {
            fn id(&self) -> ItemId {
                self.id
            }
        })*
    };
}

items!(Ball, Glow<'_>, Lamp, Occluder, Top);

impl Item for ItemId {
    fn id(&self) -> ItemId {
        *self
    }
}
