//! One number for all that a game on a table depends on.

use super::{LampKind, Table};
use xxhash_rust::xxh3::Xxh3;

/// Of the layout, the rules' text and which lamps there are. Colours, finishes, art and the light are left out, so that
/// a table can be repainted and its recordings still play.
pub(super) fn of(table: &Table) -> u64 {
    let mut hasher = Xxh3::new();
    let mut field = |bytes: &[u8]| {
        hasher.update(&(bytes.len() as u64).to_le_bytes());
        hasher.update(bytes);
    };
    // Plain numbers and names: nothing that postcard could refuse.
    field(&postcard::to_stdvec(&table.layout).unwrap_or_default());
    field(table.rules.as_bytes());
    for lamp in &table.lamps {
        field(lamp.name.as_bytes());
        field(&[u8::from(matches!(lamp.kind, LampKind::Insert { .. }))]);
    }
    hasher.digest()
}
