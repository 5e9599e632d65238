//! Pairs of colliders as a graph.

use super::ColliderGraphIndex;
use crate::data::graph::{EdgeIndex, Graph};
use std::collections::BTreeMap;

/// Index of an interaction until the next step.
pub type TemporaryInteractionIndex = EdgeIndex;

/// Two colliders, at least one of them a sensor, whose boxes overlap.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct IntersectionPair {
    /// Whether the shapes intersect.
    pub intersecting: bool,
}

/// A graph whose nodes are objects and whose edges are their interactions.
#[derive(Clone, Debug)]
pub struct InteractionGraph<N, E> {
    graph: Graph<N, E>,
}

impl<N, E> Default for InteractionGraph<N, E> {
    fn default() -> Self {
        Self { graph: Graph::default() }
    }
}

impl<N: Copy, E> InteractionGraph<N, E> {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// The graph of these interactions.
    pub(crate) fn of(interactions: impl Iterator<Item = (N, N, E)>) -> Self
    where
        N: Ord,
    {
        let mut graph = Graph::default();
        let mut nodes = BTreeMap::new();
        for (one, other, data) in interactions {
            let [first, second] =
                [one, other].map(|it| *nodes.entry(it).or_insert_with(|| graph.add_node(it)));
            graph.add_edge(first, second, data);
        }
        Self { graph }
    }

    /// The graph.
    pub fn raw_graph(&self) -> &Graph<N, E> {
        &self.graph
    }

    /// All interactions.
    pub fn interactions(&self) -> impl Iterator<Item = &E> {
        self.graph.raw_edges().iter().map(|edge| &edge.weight)
    }

    /// All interactions with their objects.
    pub fn interactions_with_endpoints(&self) -> impl Iterator<Item = (N, N, &E)> {
        self.graph.raw_edges().iter().map(|edge| self.with_ends(edge))
    }

    /// All interactions of a node, with their objects.
    pub fn interactions_with(&self, id: ColliderGraphIndex) -> impl Iterator<Item = (N, N, &E)> {
        self.graph.edges(id).map(|edge| self.with_ends(edge))
    }

    /// All interactions of two nodes, with their objects.
    pub fn interactions_between(
        &self,
        id1: ColliderGraphIndex,
        id2: ColliderGraphIndex,
    ) -> impl Iterator<Item = (N, N, &E)> {
        let edges = self.graph.edges(id1);
        let joined = move |edge: &&crate::data::graph::Edge<E>| {
            [edge.source(), edge.target()].contains(&id2) && id1 != id2
        };
        edges.filter(joined).map(|edge| self.with_ends(edge))
    }

    /// The interaction of two nodes, with their objects.
    pub fn interaction_pair(
        &self,
        id1: ColliderGraphIndex,
        id2: ColliderGraphIndex,
    ) -> Option<(N, N, &E)> {
        self.interactions_between(id1, id2).next()
    }

    /// An interaction with its objects.
    pub fn index_interaction(&self, id: TemporaryInteractionIndex) -> Option<(N, N, &E)> {
        self.graph.raw_edges().get(id.0 as usize).map(|edge| self.with_ends(edge))
    }

    fn with_ends<'a>(&'a self, edge: &'a crate::data::graph::Edge<E>) -> (N, N, &'a E) {
        let nodes = self.graph.raw_nodes();
        let end = |index: ColliderGraphIndex| nodes[index.0 as usize];
        (end(edge.source()), end(edge.target()), &edge.weight)
    }
}
