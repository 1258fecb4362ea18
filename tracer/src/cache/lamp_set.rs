//! Lamp sets: sets of lamps, by the slots that the tile caches know them by.

/// Words of 64 slots: there is room for twice [`crate::cache::frame_history::MAX_LAMPS`], which is as many as there can ever be.
const WORDS: usize = 5;

/// A set of slots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct LampSet([u64; WORDS]);

impl LampSet {
    /// Puts a slot in; one that there is no room for is left out.
    pub fn insert(&mut self, slot: usize) {
        if let Some(word) = self.0.get_mut(slot / 64) {
            *word |= 1 << (slot % 64);
        }
    }

    /// Takes a slot out.
    pub fn remove(&mut self, slot: usize) {
        if let Some(word) = self.0.get_mut(slot / 64) {
            *word &= !(1 << (slot % 64));
        }
    }

    /// Whether a slot is in it.
    pub fn contains(&self, slot: usize) -> bool {
        self.0.get(slot / 64).is_some_and(|word| word >> (slot % 64) & 1 == 1)
    }

    /// The slots that are in this set and not in the other.
    pub fn difference<'a>(&'a self, other: &'a LampSet) -> impl Iterator<Item = usize> + 'a {
        self.0.iter().zip(&other.0).enumerate().flat_map(|(at, (all, other))| {
            let mut left = all & !other;
            std::iter::from_fn(move || {
                let bit = (left != 0).then(|| left.trailing_zeros() as usize)?;
                left &= left - 1;
                Some(at * 64 + bit)
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_gives_back_what_was_put_in() {
        let [mut all, mut without] = [LampSet::default(); 2];
        (0..5_000).step_by(3).for_each(|slot| all.insert(slot));
        (0..320).step_by(2).for_each(|slot| without.insert(slot));
        without.remove(6);
        let expected: Vec<usize> = (0..320).filter(|slot| slot % 3 == 0 && (slot % 2 == 1 || *slot == 6)).collect();
        assert_eq!(all.difference(&without).collect::<Vec<_>>(), expected);
        assert!(all.contains(318) && !all.contains(319) && !all.contains(5_000));
    }
}
