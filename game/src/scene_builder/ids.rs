//! The ids of a scene's items. A solid or a rod has a range of them, whatever of it is there in a picture; lamps and
//! inserts have their numbers in the table; balls have what the machine knows them by.

use physics::PartId;
use tracer::ItemId;

/// Ids from here on are those of balls and of their occluders.
const FIRST_BALL: u32 = 1 << 30;

/// Ids from here on are those of captive balls and of their occluders.
const FIRST_CAPTIVE: u32 = 1 << 31;

/// The first ids of something's occluders and of its tops.
#[derive(Clone, Copy, Debug, Default)]
pub struct FirstIds {
    occluder: u32,
    top: u32,
}

impl FirstIds {
    /// Takes ranges of so many ids: what is left begins after them.
    pub fn take(&mut self, occluders: u32, tops: u32) -> FirstIds {
        let first = *self;
        *self = FirstIds { occluder: first.occluder + occluders, top: first.top + tops };
        first
    }

    /// The id of the occluder of this number.
    pub fn occluder(&self, number: u32) -> ItemId {
        ItemId(self.occluder + number)
    }

    /// The id of the top of this number.
    pub fn top(&self, number: u32) -> ItemId {
        ItemId(self.top + number)
    }
}

/// The id of a ball in play, and of its occluder.
pub fn ball(id: u32) -> ItemId {
    ItemId(FIRST_BALL + id % (FIRST_CAPTIVE - FIRST_BALL))
}

/// The id of a captive ball, and of its occluder.
pub fn captive(part: PartId) -> ItemId {
    ItemId(FIRST_CAPTIVE + u32::from(part.0))
}
