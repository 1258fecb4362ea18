//! Which items of a list were there in the last frame: paired by their ids, in the order of the lists.
//!
//! Most lists have the same ids in every frame, which is one walk over both. Where they have not, ids are looked up in
//! sorted copies, so a list of `n` items costs `n log n`.

use crate::ItemId;
use crate::scene::id::Item;

/// What became of an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pairing {
    /// It is still there, in the same order among those that are: its places in the old list and in the new one.
    Kept(usize, usize),
    /// It was there, at this place of the old list, and is not, or is elsewhere in the order.
    Gone(usize),
    /// It is there, at this place of the new list, and was not, or was elsewhere in the order.
    Came(usize),
}

/// Pairs lists; kept from frame to frame, so that nothing is allocated once it is warm.
#[derive(Clone, Debug, Default)]
pub(crate) struct ItemPairing {
    old: Vec<ItemId>,
    new: Vec<ItemId>,
}

impl ItemPairing {
    /// Calls `found` for every item of both lists, in whose orders they are.
    pub fn pair<T: Item, U: Item>(&mut self, old: &[T], new: &[U], mut found: impl FnMut(Pairing)) {
        let same = old.iter().zip(new).take_while(|(old, new)| old.id() == new.id()).count();
        (0..same).for_each(|at| found(Pairing::Kept(at, at)));
        let (mut from, mut to) = (same, same);
        if same < old.len() && same < new.len() {
            sort_ids(&old[same..], &mut self.old);
            sort_ids(&new[same..], &mut self.new);
        }
        while from < old.len() && to < new.len() {
            let (before, now) = (old[from].id(), new[to].id());
            let gone = before != now && self.new.binary_search(&before).is_err();
            let came = before != now && !gone && self.old.binary_search(&now).is_err();
            match () {
                () if before == now => found(Pairing::Kept(from, to)),
                () if gone => found(Pairing::Gone(from)),
                () if came => found(Pairing::Came(to)),
                () => {
                    found(Pairing::Gone(from));
                    found(Pairing::Came(to));
                }
            }
            from += usize::from(!came);
            to += usize::from(!gone);
        }
        (from..old.len()).for_each(|at| found(Pairing::Gone(at)));
        (to..new.len()).for_each(|at| found(Pairing::Came(at)));
    }

    /// Calls `changed` with every item of the old list that is not in the new one as it was, and with every item of the
    /// new list that was not in the old one as it is.
    pub fn each_change<T: Item + PartialEq>(&mut self, old: &[T], new: &[T], mut changed: impl FnMut(&T)) {
        self.pair(old, new, |pairing| match pairing {
            Pairing::Kept(from, to) if old[from] == new[to] => {}
            Pairing::Kept(from, to) => {
                changed(&old[from]);
                changed(&new[to]);
            }
            Pairing::Gone(at) => changed(&old[at]),
            Pairing::Came(at) => changed(&new[at]),
        });
    }
}

fn sort_ids<T: Item>(items: &[T], ids: &mut Vec<ItemId>) {
    ids.clear();
    ids.extend(items.iter().map(Item::id));
    ids.sort_unstable();
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::rng::SplitMix64;

    fn ids(numbers: &[u32]) -> Vec<ItemId> {
        numbers.iter().map(|&number| ItemId(number)).collect()
    }

    fn paired(old: &[u32], new: &[u32]) -> Vec<Pairing> {
        let mut found = Vec::new();
        ItemPairing::default().pair(&ids(old), &ids(new), |pairing| found.push(pairing));
        found
    }

    #[test]
    fn what_comes_and_goes_leaves_the_others_where_they_were() {
        use Pairing::{Came, Gone, Kept};
        assert_eq!(paired(&[1, 2, 3], &[1, 2, 3]), [Kept(0, 0), Kept(1, 1), Kept(2, 2)]);
        assert_eq!(paired(&[1, 2, 3], &[1, 3]), [Kept(0, 0), Gone(1), Kept(2, 1)]);
        assert_eq!(paired(&[1, 3], &[1, 2, 3]), [Kept(0, 0), Came(1), Kept(1, 2)]);
        assert_eq!(paired(&[1, 2, 3], &[9, 2, 3]), [Gone(0), Came(0), Kept(1, 1), Kept(2, 2)]);
        assert_eq!(paired(&[1, 2], &[2, 1]), [Gone(0), Came(0), Gone(1), Came(1)]);
        assert_eq!(paired(&[], &[5]), [Came(0)]);
        assert_eq!(paired(&[5], &[]), [Gone(0)]);
    }

    /// Each item of both lists is told of once, and those that are kept have the same id and the same order.
    #[test]
    fn every_item_is_told_of_once() {
        let mut random = SplitMix64::new(5);
        for _ in 0..2_000 {
            let mut list = || {
                let mut all: Vec<u32> = (0..9).collect();
                let keys: Vec<f64> = all.iter().map(|_| random.unit()).collect();
                let shuffled = random.unit() < 0.5;
                all.sort_by(|&a, &b| if shuffled { keys[a as usize].total_cmp(&keys[b as usize]) } else { a.cmp(&b) });
                all.retain(|_| random.unit() < 0.7);
                all
            };
            let (old, new) = (list(), list());
            let (mut seen, mut last) = ([vec![0; old.len()], vec![0; new.len()]], None);
            for pairing in paired(&old, &new) {
                match pairing {
                    Pairing::Kept(from, to) => {
                        assert_eq!(old[from], new[to]);
                        assert!(last.is_none_or(|(before, above)| before < from && above < to));
                        last = Some((from, to));
                        seen[0][from] += 1;
                        seen[1][to] += 1;
                    }
                    Pairing::Gone(at) => seen[0][at] += 1,
                    Pairing::Came(at) => seen[1][at] += 1,
                }
            }
            assert!(seen.iter().flatten().all(|&times| times == 1), "{old:?} {new:?}");
        }
    }
}
