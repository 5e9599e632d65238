//! The narrow phase.

use super::{ColliderHandle, ContactPair, to_pair};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::OnceLock;

/// All contact and intersection pairs.
///
/// The engine's pairs have another representation. The first read of a pair after a step converts it.
#[derive(Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct NarrowPhase {
    engine: engine::geometry::NarrowPhase,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    converted: ConvertedPairs,
}

/// Trie of the pairs that were read since the last step, by the hash of their colliders.
///
/// A read inserts one pair under a shared borrow, and never moves the pairs that are borrowed already.
#[derive(Default)]
struct ConvertedPairs(OnceLock<Box<ConvertedPair>>);

/// A node of the trie. Two bits of the hash select the child.
struct ConvertedPair {
    pair: ContactPair,
    children: [ConvertedPairs; 4],
}

impl ConvertedPairs {
    /// The converted form of a pair.
    fn get_or_convert(&self, pair: &engine::geometry::ContactPair) -> &ContactPair {
        let mut hasher = DefaultHasher::new();
        (pair.collider1, pair.collider2).hash(&mut hasher);
        let (mut hash, mut trie) = (hasher.finish(), self);
        loop {
            let convert = || ConvertedPair { pair: to_pair(pair), children: Default::default() };
            let node = trie.0.get_or_init(|| Box::new(convert()));
            let is_same = node.pair.collider1 == pair.collider1;
            if is_same && node.pair.collider2 == pair.collider2 {
                return &node.pair;
            }
            trie = &node.children[(hash % 4) as usize];
            hash = hash.rotate_right(2);
        }
    }
}

impl Clone for NarrowPhase {
    fn clone(&self) -> Self {
        Self { engine: self.engine.clone(), converted: ConvertedPairs::default() }
    }
}

impl core::ops::Deref for NarrowPhase {
    type Target = engine::geometry::NarrowPhase;

    fn deref(&self) -> &engine::geometry::NarrowPhase {
        &self.engine
    }
}

impl NarrowPhase {
    /// An empty narrow phase.
    pub fn new() -> Self {
        Self::default()
    }

    /// Mutable access for a step, after which all pairs are converted again.
    pub(crate) fn begin_step(&mut self) -> &mut engine::geometry::NarrowPhase {
        self.converted = ConvertedPairs::default();
        &mut self.engine
    }

    /// All contact pairs.
    pub fn contact_pairs(&self) -> impl Iterator<Item = &ContactPair> {
        self.engine.contact_pairs().map(|(.., pair)| self.converted.get_or_convert(pair))
    }

    /// All contact pairs of a collider.
    pub fn contact_pairs_with(
        &self,
        collider: ColliderHandle,
    ) -> impl Iterator<Item = &ContactPair> {
        self.engine.contact_pairs_with(collider).map(|pair| self.converted.get_or_convert(pair))
    }

    /// The contact pair of two colliders, in either order.
    pub fn contact_pair(
        &self,
        collider1: ColliderHandle,
        collider2: ColliderHandle,
    ) -> Option<&ContactPair> {
        Some(self.converted.get_or_convert(self.engine.contact_pair(collider1, collider2)?))
    }
}
