//! The narrow phase.

use super::{
    ColliderHandle, ContactData, ContactManifoldData, ContactPair, InteractionGraph,
    IntersectionPair, to_pair,
};
use crate::parry::query::{DefaultQueryDispatcher, PersistentQueryDispatcher};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Arc, OnceLock};

/// Algorithms for pairs of shapes.
type DynDispatcher = dyn PersistentQueryDispatcher<ContactManifoldData, ContactData>;

/// The dispatcher of a narrow phase.
#[derive(Clone)]
struct Dispatcher(Arc<DynDispatcher>);

impl Default for Dispatcher {
    fn default() -> Self {
        Self(Arc::new(DefaultQueryDispatcher))
    }
}

/// All contact and intersection pairs.
///
/// The engine's pairs have another representation. The first read of a pair after a step converts it.
#[derive(Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct NarrowPhase {
    engine: engine::geometry::NarrowPhase,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    converted: ConvertedPairs,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    graphs: Graphs,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    dispatcher: Dispatcher,
}

/// All pairs as graphs, from the first access after a step on.
#[derive(Default)]
struct Graphs {
    contacts: OnceLock<InteractionGraph<ColliderHandle, ContactPair>>,
    intersections: OnceLock<InteractionGraph<ColliderHandle, IntersectionPair>>,
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
        let (engine, dispatcher) = (self.engine.clone(), self.dispatcher.clone());
        Self { engine, dispatcher, ..Self::default() }
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

    /// An empty narrow phase with algorithms of the program. Queries use them; contacts are the engine's.
    pub fn with_query_dispatcher<D>(dispatcher: D) -> Self
    where
        D: 'static + PersistentQueryDispatcher<ContactManifoldData, ContactData>,
    {
        Self { dispatcher: Dispatcher(Arc::new(dispatcher)), ..Self::default() }
    }

    /// Sets the algorithms of queries. Contacts are the engine's.
    pub fn set_query_dispatcher<D>(&mut self, dispatcher: D)
    where
        D: 'static + PersistentQueryDispatcher<ContactManifoldData, ContactData>,
    {
        self.dispatcher = Dispatcher(Arc::new(dispatcher));
    }

    /// The algorithms of queries.
    pub fn query_dispatcher(
        &self,
    ) -> &dyn PersistentQueryDispatcher<ContactManifoldData, ContactData> {
        &*self.dispatcher.0
    }

    /// Mutable access for a step, after which all pairs are converted again.
    pub(crate) fn begin_step(&mut self) -> &mut engine::geometry::NarrowPhase {
        self.converted = ConvertedPairs::default();
        self.graphs = Graphs::default();
        &mut self.engine
    }

    /// All contact pairs.
    pub fn contact_pairs(&self) -> impl Iterator<Item = &ContactPair> {
        self.engine.contact_pairs().map(|(.., pair)| self.converted.get_or_convert(pair))
    }

    /// All contact pairs as a graph, which the first access after a step makes.
    pub fn contact_graph(&self) -> &InteractionGraph<ColliderHandle, ContactPair> {
        self.graphs.contacts.get_or_init(|| {
            InteractionGraph::of(
                self.engine.contact_pairs().map(|(one, other, pair)| (one, other, to_pair(pair))),
            )
        })
    }

    /// All intersection pairs as a graph, which the first access after a step makes.
    pub fn intersection_graph(&self) -> &InteractionGraph<ColliderHandle, IntersectionPair> {
        self.graphs.intersections.get_or_init(|| {
            InteractionGraph::of(
                self.engine.intersection_pairs().map(|(one, other, intersecting)| {
                    (one, other, IntersectionPair { intersecting })
                }),
            )
        })
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
