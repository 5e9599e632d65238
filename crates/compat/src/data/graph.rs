//! A directed graph in lists.

/// Index of a node.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct NodeIndex(pub u32);

/// Index of an edge.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct EdgeIndex(pub u32);

/// An edge between two nodes.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Edge<E> {
    /// Data of the edge.
    pub weight: E,
    nodes: [NodeIndex; 2],
}

impl<E> Edge<E> {
    /// The first node.
    pub fn source(&self) -> NodeIndex {
        self.nodes[0]
    }

    /// The second node.
    pub fn target(&self) -> NodeIndex {
        self.nodes[1]
    }
}

/// A graph whose nodes and edges have data. A search for the edges of a node reads all edges.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Graph<N, E> {
    nodes: Vec<N>,
    edges: Vec<Edge<E>>,
}

impl<N, E> Default for Graph<N, E> {
    fn default() -> Self {
        Self { nodes: Vec::new(), edges: Vec::new() }
    }
}

impl<N, E> Graph<N, E> {
    /// An empty graph with space for nodes and edges.
    pub fn with_capacity(nodes: usize, edges: usize) -> Self {
        Self { nodes: Vec::with_capacity(nodes), edges: Vec::with_capacity(edges) }
    }

    /// Adds a node.
    pub fn add_node(&mut self, weight: N) -> NodeIndex {
        self.nodes.push(weight);
        NodeIndex(self.nodes.len() as u32 - 1)
    }

    /// Adds an edge between two nodes.
    ///
    /// # Panics
    /// If a node does not exist.
    pub fn add_edge(&mut self, source: NodeIndex, target: NodeIndex, weight: E) -> EdgeIndex {
        for node in [source, target] {
            assert!((node.0 as usize) < self.nodes.len(), "{node:?} is no node of the graph");
        }
        self.edges.push(Edge { weight, nodes: [source, target] });
        EdgeIndex(self.edges.len() as u32 - 1)
    }

    /// Data of a node.
    pub fn node_weight(&self, node: NodeIndex) -> Option<&N> {
        self.nodes.get(node.0 as usize)
    }

    /// Data of an edge.
    pub fn edge_weight(&self, edge: EdgeIndex) -> Option<&E> {
        self.edges.get(edge.0 as usize).map(|edge| &edge.weight)
    }

    /// Mutable access to the data of an edge.
    pub fn edge_weight_mut(&mut self, edge: EdgeIndex) -> Option<&mut E> {
        self.edges.get_mut(edge.0 as usize).map(|edge| &mut edge.weight)
    }

    /// The nodes of an edge.
    pub fn edge_endpoints(&self, edge: EdgeIndex) -> Option<(NodeIndex, NodeIndex)> {
        self.edges.get(edge.0 as usize).map(|edge| (edge.source(), edge.target()))
    }

    /// Removes an edge. The last edge gets its index.
    pub fn remove_edge(&mut self, edge: EdgeIndex) -> Option<E> {
        let exists = (edge.0 as usize) < self.edges.len();
        exists.then(|| self.edges.swap_remove(edge.0 as usize).weight)
    }

    /// Removes a node and its edges. The last node gets its index.
    pub fn remove_node(&mut self, node: NodeIndex) -> Option<N> {
        if node.0 as usize >= self.nodes.len() {
            return None;
        }
        self.edges.retain(|edge| !edge.nodes.contains(&node));
        let removed = self.nodes.swap_remove(node.0 as usize);
        let moved = NodeIndex(self.nodes.len() as u32);
        let ends = self.edges.iter_mut().flat_map(|edge| &mut edge.nodes);
        ends.filter(|end| **end == moved).for_each(|end| *end = node);
        Some(removed)
    }

    /// The edge from one node to another.
    pub fn find_edge(&self, source: NodeIndex, target: NodeIndex) -> Option<EdgeIndex> {
        let found = self.edges.iter().position(|edge| edge.nodes == [source, target])?;
        Some(EdgeIndex(found as u32))
    }

    /// The edges that begin or end at a node.
    pub fn edges(&self, node: NodeIndex) -> impl Iterator<Item = &Edge<E>> {
        self.edges.iter().filter(move |edge| edge.nodes.contains(&node))
    }

    /// All nodes.
    pub fn raw_nodes(&self) -> &[N] {
        &self.nodes
    }

    /// All edges.
    pub fn raw_edges(&self) -> &[Edge<E>] {
        &self.edges
    }
}
