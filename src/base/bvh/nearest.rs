//! The search for the nearest, near children first.

use super::BoxTree;
use super::node::{Child, Node, Target};
use super::probe::Probe;
use super::stack::Stack;
use crate::base::wide::{Kernel, LANES, Lane, Simd, Wide};
use parry::math::Real;

/// Visits the slots whose boxes are no farther away than `reach`, the nearest box first, as far as that is
/// known.
///
/// `prepare` receives slots that will probably be visited, for prefetching. `visit` returns the new limit of
/// the distance; equal distances still count.
pub fn nearest<P: Probe>(
    tree: &BoxTree,
    probe: &P,
    reach: Real,
    prepare: impl Fn(u32),
    visit: impl FnMut(u32) -> Real,
) -> Real {
    if tree.len == 0 {
        return reach;
    }
    Simd::detect().run(Search { nodes: &tree.nodes, probe, reach, prepare, visit })
}

struct Search<'a, P, H, V> {
    nodes: &'a [Node],
    probe: &'a P,
    reach: Real,
    prepare: H,
    visit: V,
}

impl<P: Probe, H: Fn(u32), V: FnMut(u32) -> Real> Kernel for Search<'_, P, H, V> {
    /// Final limit of the distance.
    type Output = Real;

    #[inline(always)]
    fn run<W: Wide>(mut self) -> Real {
        let mut stack = Stack::new((0.0, Child::NONE));
        let mut at = 0;
        loop {
            let node = &self.nodes[at];
            let (distances, mask) = self.probe.test::<W>(&node.planes, self.reach);
            let mut lanes = Lane::ZERO;
            distances.store(&mut lanes);
            let bits = W::bits(mask) & node.taken();
            prepare_leaves(node, bits, &self.prepare);
            push_sorted(&mut stack, node, &lanes, bits);
            at = loop {
                let Some((distance, child)) = stack.pop() else { return self.reach };
                // Something nearer may have been found since.
                if distance > self.reach {
                    continue;
                }
                match child.target() {
                    Target::Node(below) => break below,
                    Target::Slot(slot) => self.reach = (self.visit)(slot),
                }
            };
        }
    }
}

#[inline(always)]
fn prepare_leaves(node: &Node, mut bits: u32, prepare: &impl Fn(u32)) {
    while bits != 0 {
        if let Target::Slot(slot) = node.children[bits.trailing_zeros() as usize % LANES].target() {
            prepare(slot);
        }
        bits &= bits - 1;
    }
}

/// Puts the children that matter on the stack, the nearest on top. The first lane precedes equally near ones.
#[inline(always)]
fn push_sorted(stack: &mut Stack<(Real, Child)>, node: &Node, distances: &Lane, mut bits: u32) {
    if bits & bits.wrapping_sub(1) == 0 {
        // Usually there is none or one.
        if bits != 0 {
            let lane = bits.trailing_zeros() as usize % LANES;
            stack.push((distances.0[lane], node.children[lane]));
        }
        return;
    }
    let (mut sorted, mut count) = ([(0.0, Child::NONE); LANES], 0);
    while bits != 0 {
        let lane = bits.trailing_zeros() as usize % LANES;
        bits &= bits - 1;
        let distance = distances.0[lane];
        let mut at = count;
        while at > 0 && sorted[at - 1].0 > distance {
            sorted[at] = sorted[at - 1];
            at -= 1;
        }
        sorted[at] = (distance, node.children[lane]);
        count += 1;
    }
    sorted[..count].iter().rev().for_each(|&entry| stack.push(entry));
}
