//! The narrow phase.

use super::{ColliderHandle, ContactPair, to_pair};
use std::collections::HashMap;
use std::sync::OnceLock;

/// All contact and intersection pairs.
///
/// The engine's pairs have another representation. The first read of a pair after a step converts it.
#[derive(Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct NarrowPhase {
    engine: engine::geometry::NarrowPhase,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    converted: OnceLock<ConvertedPairs>,
}

/// The pairs of a step, each converted at its first read.
struct ConvertedPairs {
    pairs: Vec<OnceLock<ContactPair>>,
    indices: HashMap<[ColliderHandle; 2], usize>,
}

impl Clone for NarrowPhase {
    fn clone(&self) -> Self {
        Self { engine: self.engine.clone(), converted: OnceLock::new() }
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
        self.converted.take();
        &mut self.engine
    }

    fn converted(&self) -> &ConvertedPairs {
        self.converted.get_or_init(|| {
            let keys = self.engine.contact_pairs().map(|(first, second, _)| [first, second]);
            let indices: HashMap<_, _> = keys.enumerate().map(|(i, key)| (key, i)).collect();
            let pairs = core::iter::repeat_with(OnceLock::new).take(indices.len()).collect();
            ConvertedPairs { pairs, indices }
        })
    }

    fn converted_pair(&self, pair: &engine::geometry::ContactPair) -> Option<&ContactPair> {
        let ConvertedPairs { pairs, indices } = self.converted();
        let index = *indices.get(&[pair.collider1, pair.collider2])?;
        Some(pairs.get(index)?.get_or_init(|| to_pair(pair)))
    }

    /// All contact pairs.
    pub fn contact_pairs(&self) -> impl Iterator<Item = &ContactPair> {
        self.engine.contact_pairs().filter_map(|(.., pair)| self.converted_pair(pair))
    }

    /// All contact pairs of a collider.
    pub fn contact_pairs_with(
        &self,
        collider: ColliderHandle,
    ) -> impl Iterator<Item = &ContactPair> {
        self.engine.contact_pairs_with(collider).filter_map(|pair| self.converted_pair(pair))
    }

    /// The contact pair of two colliders, in either order.
    pub fn contact_pair(
        &self,
        collider1: ColliderHandle,
        collider2: ColliderHandle,
    ) -> Option<&ContactPair> {
        self.converted_pair(self.engine.contact_pair(collider1, collider2)?)
    }
}
