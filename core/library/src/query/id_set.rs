//! A set of clips, for intersecting what several terms give.

use std::collections::BTreeMap;

/// Ids of one chunk, one bit each.
const CHUNK_BITS: u32 = 16;

/// Numbers of clips. As they are given out one by one, nearly all lie side by side: a bit for each.
#[derive(Debug, Default)]
pub(super) struct IdSet {
    chunks: BTreeMap<i64, Box<[u64; 1 << (CHUNK_BITS - 6)]>>,
}

impl IdSet {
    pub fn insert(&mut self, id: i64) {
        let (chunk, word, bit) = place(id);
        let words = self.chunks.entry(chunk).or_insert_with(|| Box::new([0; 1 << (CHUNK_BITS - 6)]));
        words[word] |= bit;
    }

    pub fn contains(&self, id: i64) -> bool {
        let (chunk, word, bit) = place(id);
        self.chunks.get(&chunk).is_some_and(|words| words[word] & bit != 0)
    }
}

/// Returns the chunk of an id, the word in it (below its length: the bits of a chunk less those of a word), and the bit.
fn place(id: i64) -> (i64, usize, u64) {
    let within = id & ((1 << CHUNK_BITS) - 1);
    (id >> CHUNK_BITS, (within >> 6) as usize, 1 << (within & 63))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::HashSet;

    proptest! {
        #[test]
        fn it_holds_what_was_put_in(ids: Vec<i64>, near in prop::collection::vec(0..200_000i64, 0..50), asked: Vec<i64>) {
            let all: HashSet<i64> = ids.into_iter().chain(near).collect();
            let mut set = IdSet::default();
            for id in &all {
                set.insert(*id);
            }
            for id in all.iter().flat_map(|id| [*id, id.wrapping_add(1), *id ^ 64]).chain(asked) {
                prop_assert_eq!(set.contains(id), all.contains(&id));
            }
        }
    }
}
