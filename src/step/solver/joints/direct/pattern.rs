//! Connected joints, their elimination order, and the places of blocks.

use super::joint::{DirectJoint, has_moderate_mass_ratio};
use super::order::{Ordering, products};
use crate::model::island::NONE;
use core::ops::{Range, RangeInclusive};

/// Largest average number of block products per joint. Beyond that, iterations are so much cheaper that their
/// errors are acceptable. A walking machine of 109 joints on twelve legs needs 113, and 30 hinges between the
/// same two bodies need 165.
const BLOCK_PRODUCTS_PER_JOINT_MAX: usize = 200;
/// The same for nets: loops of joints that hold two points together and nothing else, between bodies of
/// moderate mass ratios. Iterations let them sag by little, at a hundredth of the time: 6 by 6 knots are
/// solved directly, 10 by 10 are not.
const NET_BLOCK_PRODUCTS_PER_JOINT_MAX: usize = 40;
/// Largest number of joints per body of a net, as of braced cubes. A board on 25 point-to-point joints is no
/// net.
const NET_JOINTS_PER_BODY_MAX: usize = 6;

/// Numbers of joints of unattached components with moderate mass ratios that are solved iteratively:
/// ragdolls. They carry no load for long, and a force passes through them in some substeps. Fewer joints cost
/// little, and keep the energy of rotating components. Iterations that add energy have not converged: the
/// component is solved directly in the next step. Springs and motors carry loads, and those that are stiffer
/// than iterations can follow would add energy.
const UNATTACHED_JOINT_COUNTS: RangeInclusive<usize> = 6..=24;

/// The structure of all components.
#[derive(Default)]
pub(super) struct Pattern {
    /// All joints, as they were when the pattern was built.
    given: Vec<DirectJoint>,
    sorted: Vec<DirectJoint>,
    /// By slot: the position of a joint that is in a component, [`NONE`] of others.
    position_of_slot: Vec<u32>,
    /// By slot: whether the joint is connected with no other one, and drives a single axis.
    is_alone: Vec<bool>,
    /// By slot: whether the joint's component is too large for a direct solution.
    is_too_large: Vec<bool>,
    /// In the order of elimination; those of one component together.
    members: Vec<DirectJoint>,
    components: Vec<Part>,
    /// By direct joint: the later members of its component in whose rows its column has a block, ascending.
    columns: Vec<Vec<u32>>,
    /// By direct joint: its bodies, numbered within the component.
    bodies: Vec<[u32; 2]>,
    search: Search,
    ordering: Ordering,
}

/// Range of a component's joints, and data of the component.
struct Part {
    members: Range<usize>,
    body_count: usize,
    has_driven_axes: bool,
    is_redundant: bool,
}

/// One component.
#[derive(Copy, Clone)]
pub(super) struct Component<'a> {
    pub members: &'a [DirectJoint],
    /// Positions within the component.
    pub columns: &'a [Vec<u32>],
    /// By member: its bodies, numbered within the component.
    pub bodies: &'a [[u32; 2]],
    pub body_count: usize,
    pub has_driven_axes: bool,
    /// Whether rows may be redundant: in a loop, including loops through immovable bodies, or at bodies with
    /// locked axes of their own.
    pub is_redundant: bool,
}

/// Buffers of the search.
#[derive(Default)]
struct Search {
    /// By body: its joints, as indices into the members.
    first: Vec<u32>,
    of_body: Vec<u32>,
    visited: Vec<bool>,
    order: Vec<u32>,
    /// Number of bodies of these joints.
    body_count: usize,
    /// By body: whether it has been counted.
    seen: Vec<bool>,
    /// By body: its number in its component.
    number: Vec<u32>,
    /// By direct joint: its position in its component.
    position: Vec<u32>,
}

impl Pattern {
    pub fn component_count(&self) -> usize {
        self.components.len()
    }

    /// Returns whether the joint is in a component.
    pub fn contains(&self, slot: u32) -> bool {
        self.position_of_slot.get(slot as usize).is_some_and(|&position| position != NONE)
    }

    /// Returns whether the joint is connected with no other one, and drives a single axis.
    pub fn is_alone(&self, slot: u32) -> bool {
        self.is_alone.get(slot as usize).is_some_and(|is_alone| *is_alone)
    }

    /// Returns whether the joint's component is too large for a direct solution: a large net.
    pub fn is_too_large(&self, slot: u32) -> bool {
        self.is_too_large.get(slot as usize).is_some_and(|is_too_large| *is_too_large)
    }

    /// Notes the block and the lane of a joint's rows. Returns whether the joint is in a component.
    pub fn place(&mut self, slot: u32, [block, lane]: [usize; 2]) -> bool {
        let contains = self.contains(slot);
        if contains {
            let position = self.position_of_slot[slot as usize] as usize;
            let member = &mut self.members[position];
            (member.block, member.lane) = (block as u32, lane as u32);
        }
        contains
    }

    pub fn component(&self, index: usize) -> Component<'_> {
        let Part { members: range, body_count, has_driven_axes, is_redundant } =
            &self.components[index];
        Component {
            members: &self.members[range.clone()],
            columns: &self.columns[range.clone()],
            bodies: &self.bodies[range.clone()],
            body_count: *body_count,
            has_driven_axes: *has_driven_axes,
            is_redundant: *is_redundant,
        }
    }

    /// Builds the components of the joints that are solved directly. An unchanged list of joints is kept.
    pub fn build(&mut self, given: &[DirectJoint], body_count: usize) {
        if self.given == given {
            return;
        }
        self.given.clear();
        self.given.extend_from_slice(given);
        let mut members = core::mem::take(&mut self.sorted);
        members.clear();
        members.extend(given.iter().filter(|member| member.row_count() > 0));
        members.sort_unstable_by_key(|member| member.slot);
        self.members.clear();
        self.bodies.clear();
        self.components.clear();
        let slots = given.iter().map(|member| member.slot as usize + 1).max().unwrap_or(0);
        for list in [&mut self.is_alone, &mut self.is_too_large] {
            list.clear();
            list.resize(slots, false);
        }
        self.search.start(&members, body_count);
        self.find_components(&members);
        self.sorted = members;
        self.position_of_slot.clear();
        self.position_of_slot.resize(slots, NONE);
        for (position, member) in self.members.iter().enumerate() {
            let known = &mut self.position_of_slot[member.slot as usize];
            debug_assert_eq!(*known, NONE, "a joint is in one component");
            *known = position as u32;
        }
        debug_assert!(
            self.components.is_sorted_by(|one, two| one.members.end == two.members.start),
            "components have no common joint"
        );
        debug_assert_eq!(self.bodies.len(), self.members.len());
    }

    fn find_components(&mut self, members: &[DirectJoint]) {
        for root in 0..members.len() {
            if self.search.visited[root] {
                continue;
            }
            self.search.collect(root, members);
            if self.search.order.len() == 1 {
                let member = &members[root];
                self.is_alone[member.slot as usize] = member.form.driven == 1;
            }
            if self.search.is_easy(members) || self.search.is_single_row(members) {
                continue;
            }
            if self.add_component(members) {
                continue;
            }
            for &index in &self.search.order {
                self.is_too_large[members[index as usize].slot as usize] = true;
            }
            if self.search.keep_transmissions(members) {
                self.add_component(members);
            }
        }
    }

    /// Adds the component that the search has just collected. Returns whether it is solved directly.
    fn add_component(&mut self, members: &[DirectJoint]) -> bool {
        let has_loops = self.search.has_loops(members);
        let is_net = has_loops && self.search.is_net(members);
        let work = match is_net {
            // Those of a net that is left to the iterative solver have no other method.
            _ if self.search.are_transmissions(members) => usize::MAX,
            true => NET_BLOCK_PRODUCTS_PER_JOINT_MAX * self.search.order.len(),
            false => BLOCK_PRODUCTS_PER_JOINT_MAX * self.search.order.len(),
        };
        // The last ones found are the leaves.
        self.search.order.reverse();
        if has_loops && !self.reorder(members, work) {
            return false;
        }
        let start = self.members.len();
        for (position, &index) in self.search.order.iter().enumerate() {
            self.search.position[index as usize] = position as u32;
            self.members.push(members[index as usize]);
        }
        let count = self.members.len() - start;
        while self.columns.len() < self.members.len() {
            self.columns.push(Vec::new());
        }
        let columns = &mut self.columns[start..start + count];
        columns.iter_mut().for_each(Vec::clear);
        let (search, members_here) = (&self.search, &self.members[start..]);
        let neighbours = |at: usize, column: &mut Vec<u32>| {
            search.add_neighbours(&members_here[at], column);
        };
        let is_direct = fill(columns, neighbours, work);
        if is_direct {
            debug_assert!(self.columns[start..].iter().zip(0..).take(count).all(is_below_diagonal));
            let body_count = self.search.number_bodies(&self.members[start..], &mut self.bodies);
            let members = &self.members[start..];
            self.components.push(Part {
                members: start..start + count,
                body_count,
                has_driven_axes: members.iter().any(|member| member.form.driven > 0),
                is_redundant: has_loops || members.iter().any(|member| member.has_locked_body),
            });
        } else {
            self.members.truncate(start);
        }
        is_direct
    }

    /// Sorts the collected joints in an order that suits loops. Returns whether elimination takes at most
    /// `work` products of blocks.
    fn reorder(&mut self, members: &[DirectJoint], work: usize) -> bool {
        let search = &mut self.search;
        for (position, &index) in search.order.iter().enumerate() {
            search.position[index as usize] = position as u32;
        }
        let neighbours = |at: usize, list: &mut Vec<u32>| {
            search.add_neighbours(&members[search.order[at] as usize], list);
        };
        let count = search.order.len();
        let is_worth_it = self.ordering.find(count, neighbours, work);
        for position in &mut self.ordering.order {
            *position = search.order[*position as usize];
        }
        core::mem::swap(&mut search.order, &mut self.ordering.order);
        is_worth_it
    }
}

/// Returns whether the blocks of a column are in ascending rows below the diagonal.
fn is_below_diagonal((column, at): (&Vec<u32>, u32)) -> bool {
    column.is_sorted_by(|row, next| row < next) && column.first().is_none_or(|&row| row > at)
}

impl Search {
    fn start(&mut self, members: &[DirectJoint], body_count: usize) {
        self.first.clear();
        self.first.resize(body_count + 1, 0);
        for (_, body) in members.iter().flat_map(DirectJoint::movable) {
            self.first[body as usize + 1] += 1;
        }
        for body in 0..body_count {
            self.first[body + 1] += self.first[body];
        }
        self.of_body.clear();
        self.of_body.resize(self.first[body_count] as usize, 0);
        let mut next = self.first.clone();
        for (index, member) in members.iter().enumerate() {
            for (_, body) in member.movable() {
                self.of_body[next[body as usize] as usize] = index as u32;
                next[body as usize] += 1;
            }
        }
        self.visited.clear();
        self.visited.resize(members.len(), false);
        self.seen.clear();
        self.seen.resize(body_count, false);
        self.number.clear();
        self.number.resize(body_count, NONE);
        self.position.clear();
        self.position.resize(members.len(), 0);
    }

    /// Adds the positions of all joints with a common body.
    fn add_neighbours(&self, member: &DirectJoint, list: &mut Vec<u32>) {
        for (_, body) in member.movable() {
            let others = self.joints_of(body).iter().map(|&other| self.position[other as usize]);
            list.extend(others.filter(|&position| position != NONE));
        }
    }

    fn joints_of(&self, body: u32) -> &[u32] {
        let body = body as usize;
        &self.of_body[self.first[body] as usize..self.first[body + 1] as usize]
    }

    /// The component that was collected.
    fn component<'a>(
        &'a self,
        members: &'a [DirectJoint],
    ) -> impl Iterator<Item = &'a DirectJoint> + Clone {
        self.order.iter().map(|&index| &members[index as usize])
    }

    /// Returns whether the iterative solver is as good for this component.
    fn is_easy(&self, members: &[DirectJoint]) -> bool {
        let is_unattached = self.component(members).all(|member| member.movable().count() == 2);
        !self.has_transmission(members)
            && !self.component(members).any(|member| member.is_strained || member.form.does_work)
            && UNATTACHED_JOINT_COUNTS.contains(&self.order.len())
            && is_unattached
            && has_moderate_mass_ratio(self.component(members))
    }

    /// Returns whether there is one joint with one driven axis: the iterative solver is exact.
    fn is_single_row(&self, members: &[DirectJoint]) -> bool {
        let mut all = self.component(members);
        let first = all.next().map(|member| (member.form.locked, member.form.driven));
        all.next().is_none() && first == Some((0, 1)) && !self.has_transmission(members)
    }

    /// Leaves the transmissions in the component that was collected. Returns whether there are any. The
    /// others have no position.
    fn keep_transmissions(&mut self, members: &[DirectJoint]) -> bool {
        let Self { order, position, .. } = self;
        order.iter().for_each(|&index| position[index as usize] = NONE);
        order.retain(|&index| members[index as usize].form.is_transmission);
        order.sort_unstable();
        // They may be redundant.
        self.body_count = 0;
        !self.order.is_empty()
    }

    /// Returns whether all joints are transmissions.
    fn are_transmissions(&self, members: &[DirectJoint]) -> bool {
        self.component(members).all(|member| member.form.is_transmission)
    }

    /// Returns whether one of the joints is a transmission. These are solved directly in any case.
    fn has_transmission(&self, members: &[DirectJoint]) -> bool {
        self.component(members).any(|member| member.form.is_transmission)
    }

    /// Numbers the bodies of a component from 0 on, in the order of its members. Returns their number.
    fn number_bodies(&mut self, members: &[DirectJoint], to: &mut Vec<[u32; 2]>) -> usize {
        let mut count = 0;
        for member in members {
            let mut numbers = [NONE; 2];
            for (side, body) in member.movable() {
                let number = &mut self.number[body as usize];
                if *number == NONE {
                    *number = count;
                    count += 1;
                }
                numbers[side] = *number;
            }
            to.push(numbers);
        }
        count as usize
    }

    /// Returns whether all joints are point-to-point joints, with few joints and no heavy body.
    fn is_net(&self, members: &[DirectJoint]) -> bool {
        let is_wide = self.order.len() <= NET_JOINTS_PER_BODY_MAX * self.body_count;
        is_wide
            && self.component(members).all(|member| member.form.is_point_to_point)
            && has_moderate_mass_ratio(self.component(members))
    }

    /// Returns whether the component has loops. All that cannot move is one body here. A connected graph
    /// without loops has one edge less than it has nodes.
    fn has_loops(&self, members: &[DirectJoint]) -> bool {
        let is_anchored = self.component(members).any(|member| member.movable().count() < 2);
        self.order.len() + 1 > self.body_count + usize::from(is_anchored)
    }

    /// Breadth first from a member: all that are connected to it.
    fn collect(&mut self, root: usize, members: &[DirectJoint]) {
        self.order.clear();
        self.order.push(root as u32);
        self.visited[root] = true;
        self.body_count = 0;
        let mut next = 0;
        while let Some(&index) = self.order.get(next) {
            next += 1;
            for (_, body) in members[index as usize].movable() {
                let is_new = !core::mem::replace(&mut self.seen[body as usize], true);
                self.body_count += usize::from(is_new);
                let range = self.first[body as usize]..self.first[body as usize + 1];
                for k in range {
                    let other = self.of_body[k as usize];
                    if !core::mem::replace(&mut self.visited[other as usize], true) {
                        self.order.push(other);
                    }
                }
            }
        }
    }
}

/// Finds the blocks of each column, with those that elimination adds. Returns whether elimination takes at
/// most `work` products of blocks.
///
/// When a column is eliminated, its blocks are added to the column of the first of them. (George and Liu,
/// "Computer Solution of Large Sparse Positive Definite Systems", 1981.)
fn fill(columns: &mut [Vec<u32>], neighbours: impl Fn(usize, &mut Vec<u32>), work: usize) -> bool {
    let mut done = 0;
    for at in 0..columns.len() {
        let mut column = core::mem::take(&mut columns[at]);
        neighbours(at, &mut column);
        column.retain(|&row| row as usize > at);
        column.sort_unstable();
        column.dedup();
        done += products(column.len());
        if done > work {
            return false;
        }
        if let [parent, rest @ ..] = column.as_slice() {
            columns[*parent as usize].extend_from_slice(rest);
        }
        columns[at] = column;
    }
    true
}
