//! Top history: the tops of the last frame, in slots that they keep while they are there: what a tile has found out about a top holds
//! whatever comes and goes in the list before it.

use crate::cache::item_pairing::{ItemPairing, Pairing};
use crate::shading::coverage::OutlineSdf;
use crate::{Finish, ItemId, Top};
use geometry::Bounds;

/// The tops of the last frame.
#[derive(Default)]
pub(crate) struct TopHistory {
    slots: Vec<Slot>,
    /// The slots of the frame's tops, from the lowest to the highest, and the tops' ids.
    order: Vec<usize>,
    ids: Vec<ItemId>,
    free: Vec<usize>,
    pairing: ItemPairing,
    /// The ids of the frame before with their slots, sorted, and whether they are still there.
    known: Vec<(ItemId, usize, bool)>,
}

/// A place for a top.
struct Slot {
    top: Top,
    /// `None` where there is nothing to see.
    outline: Option<OutlineSdf>,
    /// Whether the top is there.
    taken: bool,
}

impl TopHistory {
    /// The slots of the frame's tops, from the lowest to the highest.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// The top in a slot.
    pub fn top(&self, slot: usize) -> &Top {
        &self.slots[slot].top
    }

    /// The outline of the top in a slot; `None` where there is nothing to see.
    pub fn outline(&self, slot: usize) -> Option<&OutlineSdf> {
        self.slots[slot].outline.as_ref()
    }

    /// Becomes the tops of a frame. Where tops have moved goes into `moved`; where their own light is another, into
    /// `relit`. Most tops are where they were in the last frame.
    pub fn advance(&mut self, tops: &[Top], moved: &mut Vec<Bounds>, relit: &mut Vec<Bounds>) {
        moved.clear();
        relit.clear();
        self.find_slots(tops, moved);
        for (&slot, top) in self.order.iter().zip(tops) {
            let Some(Slot { top: old, outline, taken }) = self.slots.get_mut(slot) else {
                let outline = OutlineSdf::new(top);
                moved.extend(outline.iter().map(|outline| outline.bounds));
                self.slots.push(Slot { top: top.clone(), outline, taken: true });
                continue;
            };
            if *taken && stands(old, top) {
                if old.finish.emission != top.finish.emission {
                    relit.extend(outline.iter().map(|outline| outline.bounds));
                    old.finish = top.finish;
                }
            } else {
                moved.extend(outline.iter().map(|outline| outline.bounds));
                old.clone_from(top);
                (*outline, *taken) = (OutlineSdf::new(top), true);
                moved.extend(outline.iter().map(|outline| outline.bounds));
            }
        }
        relit.extend_from_slice(moved);
    }

    /// Finds the slots of a frame's tops. One that is not there any more, or is elsewhere in the order, has moved away
    /// from where it was.
    fn find_slots(&mut self, tops: &[Top], moved: &mut Vec<Bounds>) {
        let TopHistory { slots, order, ids, free, pairing, known } = self;
        let mut another = false;
        pairing.pair(ids, tops, |pairing| {
            another |= !matches!(pairing, Pairing::Kept(..));
            if let Pairing::Gone(at) = pairing {
                moved.extend(slots[order[at]].outline.iter().map(|outline| outline.bounds));
            }
        });
        if !another {
            return;
        }
        known.clear();
        known.extend(ids.iter().zip(&*order).map(|(&id, &slot)| (id, slot, false)));
        known.sort_unstable();
        for top in tops {
            if let Ok(at) = known.binary_search_by_key(&top.id, |known| known.0) {
                known[at].2 = true;
            }
        }
        for &(_, slot, _) in known.iter().filter(|known| !known.2) {
            slots[slot].taken = false;
            free.push(slot);
        }
        ids.clear();
        order.clear();
        let mut end = slots.len();
        for top in tops {
            let slot = match known.binary_search_by_key(&top.id, |known| known.0) {
                Ok(at) => known[at].1,
                Err(_) => free.pop().unwrap_or_else(|| {
                    end += 1;
                    end - 1
                }),
            };
            ids.push(top.id);
            order.push(slot);
        }
    }
}

/// Whether a top covers what it covered, and leans and looks as it did; its own light may be another.
fn stands(old: &Top, new: &Top) -> bool {
    let finish = Finish { emission: old.finish.emission, ..new.finish };
    old.outline == new.outline && old.group == new.group && old.finish == finish
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes;
    use crate::{Outline, View};
    use geometry::rng::SplitMix64;
    use geometry::{DVec2, Shape};

    /// Whatever comes, goes and changes places, every top is in a slot of its own, and one that stands keeps its slot; one
    /// that does not has moved.
    #[test]
    fn a_top_keeps_its_slot() {
        let view = View::fit(16, 32, scenes::SIZE_MM);
        let props = scenes::props(&view);
        let all = scenes::table(view, &props).tops;
        let (mut random, mut history) = (SplitMix64::new(3), TopHistory::default());
        let (mut moved, mut relit) = (Vec::new(), Vec::new());
        let mut before: Vec<(Top, usize)> = Vec::new();
        for round in 0..300 {
            let mut tops: Vec<Top> = all.iter().filter(|_| random.unit() < 0.9).cloned().collect();
            if round % 3 == 0 {
                let (a, b) = ((random.unit() * tops.len() as f64) as usize, (random.unit() * 9.0) as usize);
                tops.swap(a, b);
            }
            let disc = Shape::disc(random.point_within(DVec2::splat(300.0)), 9.0);
            tops[round % 20].outline = Outline::Shape(disc);
            history.advance(&tops, &mut moved, &mut relit);
            assert_eq!(history.order().len(), tops.len());
            let now: Vec<(Top, usize)> = tops.into_iter().zip(history.order().iter().copied()).collect();
            for (at, (top, slot)) in now.iter().enumerate() {
                assert!(now[..at].iter().all(|(_, other)| other != slot));
                assert_eq!(history.top(*slot), top);
                assert!(before.iter().all(|(old, kept)| old.id != top.id || kept == slot));
                let stood = before.iter().any(|(old, _)| old == top);
                let bounds = history.outline(*slot).expect("it can be seen").bounds;
                assert!(stood || moved.contains(&bounds), "what is new is where something has moved");
            }
            for (old, _) in before.iter().filter(|(old, _)| now.iter().all(|(top, _)| top != old)) {
                let bounds = OutlineSdf::new(old).expect("it can be seen").bounds;
                assert!(moved.contains(&bounds), "what is gone has moved");
            }
            before = now;
        }
    }
}
