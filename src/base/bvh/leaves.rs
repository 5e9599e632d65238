//! All leaves that a probe finds, one at a time.

use super::BoxTree;
use super::node::{Child, Node, Target};
use super::probe::Probe;
use super::stack::Stack;
use crate::base::wide::{Kernel, LANES, Simd, Wide};
use parry::math::Real;

/// The slots whose boxes a probe finds, in no particular order.
pub struct Leaves<'a, P> {
    nodes: &'a [Node],
    probe: P,
    reach: Real,
    simd: Simd,
    stack: Stack<Child>,
}

impl BoxTree {
    /// The slots whose boxes the probe finds within `reach`, in no particular order.
    pub fn leaves<P: Probe>(&self, probe: P, reach: Real) -> Leaves<'_, P> {
        let mut stack = Stack::new(Child::NONE);
        if self.len > 0 {
            stack.push(Child::of_node(0));
        }
        Leaves { nodes: &self.nodes, probe, reach, simd: Simd::detect(), stack }
    }
}

impl<P: Probe> Iterator for Leaves<'_, P> {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        loop {
            let node = match self.stack.pop()?.target() {
                Target::Slot(slot) => return Some(slot),
                Target::Node(node) => &self.nodes[node],
            };
            let query = Query { node, probe: &self.probe, reach: self.reach };
            let mut bits = self.simd.run(query) & node.taken();
            while bits != 0 {
                self.stack.push(node.children[bits.trailing_zeros() as usize % LANES]);
                bits &= bits - 1;
            }
        }
    }
}

impl BoxTree {
    /// Calls back for the slots whose boxes the probe finds, in no particular order; faster than the
    /// iterator.
    pub fn for_each_leaf<P: Probe>(&self, probe: &P, visit: impl FnMut(u32)) {
        if self.len > 0 {
            Simd::detect().run(Walk { nodes: &self.nodes, probe, visit });
        }
    }
}

/// A walk through the whole tree in one kernel.
struct Walk<'a, P, V> {
    nodes: &'a [Node],
    probe: &'a P,
    visit: V,
}

impl<P: Probe, V: FnMut(u32)> Kernel for Walk<'_, P, V> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(mut self) {
        let mut stack = Stack::new(0);
        stack.push(0);
        while let Some(at) = stack.pop() {
            let node: &Node = &self.nodes[at as usize];
            let (_, mask) = self.probe.test::<W>(&node.planes, Real::MAX);
            let mut bits = W::bits(mask) & node.taken();
            while bits != 0 {
                match node.children[bits.trailing_zeros() as usize % LANES].target() {
                    Target::Node(below) => stack.push(below as u32),
                    Target::Slot(slot) => (self.visit)(slot),
                }
                bits &= bits - 1;
            }
        }
    }
}

/// One bit for each child that the probe finds.
struct Query<'a, P> {
    node: &'a Node,
    probe: &'a P,
    reach: Real,
}

impl<P: Probe> Kernel for Query<'_, P> {
    type Output = u32;

    #[inline(always)]
    fn run<W: Wide>(self) -> u32 {
        let (_, mask) = self.probe.test::<W>(&self.node.planes, self.reach);
        W::bits(mask)
    }
}
