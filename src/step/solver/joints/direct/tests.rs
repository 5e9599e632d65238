//! The sparse solution in its dense equations, and the selection of sparse components.

use super::driven_rows::DrivenRow;
use super::factor::Factor;
use super::joint::DirectJoint;
use super::matrix::Rows;
use super::memory::{JacobianBlock, Jacobians};
use super::pattern::Pattern;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Lane, Simd};
use crate::dim::joint::unit_inertia;
use crate::dim::math::{Real, SPATIAL_DIM, Vector};
use crate::dim::spatial::join;
use crate::dim::state::{BodyState, READ_ONLY};
use crate::dim::wide::set_symmetric_lane;
use crate::model::joint::JointForm;
use crate::step::solver::axis_law::AxisLaw;

const ALL: u8 = (1 << SPATIAL_DIM) - 1;
const FIXED: u32 = READ_ONLY;

/// Pseudorandom numbers between -1 and 1.
struct Numbers(u32);

impl Numbers {
    fn next(&mut self) -> Real {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (f64::from(self.0 >> 8) / f64::from(1_u32 << 23) - 1.0) as Real
    }
}

/// Joints of bodies whose mass and moments of inertia are 1, so that `M⁻¹ Jᵀ` is `Jᵀ`.
struct Net {
    members: Vec<DirectJoint>,
    memory: Jacobians,
    body_count: usize,
}

impl Net {
    /// With joints between these bodies that lock these axes. Their rows are those of a joint without moment
    /// arms, perturbed by random numbers.
    fn new(joints: &[[u32; 2]], locked: impl Fn(usize) -> u8) -> Self {
        let mut numbers = Numbers(7);
        let place = |slot: usize| (slot as u32, (slot % LANES) as u32);
        let members = joints.iter().enumerate().map(|(slot, &bodies)| {
            let (block, lane) = place(slot);
            let inv_masses = bodies.map(|body| if body & READ_ONLY == 0 { 1.0 } else { 0.0 });
            let (slot, locked) = (slot as u32, locked(slot));
            let form = JointForm { locked, ..JointForm::default() };
            let has_locked_body = false;
            let locked_row_count = form.row_count() as u8;
            DirectJoint {
                slot,
                block,
                lane,
                bodies,
                inv_masses,
                is_strained: false,
                has_locked_body,
                form,
                locked_row_count,
            }
        });
        let blocks = (0..joints.len()).map(|slot| rows(slot % LANES, &mut numbers)).collect();
        let memory = Jacobians { blocks, driven: Vec::new() };
        let bodies = joints.iter().flatten().map(|body| (body & !READ_ONLY) as usize + 1);
        let body_count = bodies.max().unwrap_or(0);
        Self { members: members.collect(), memory, body_count }
    }

    fn pattern(&self) -> Pattern {
        let mut pattern = Pattern::default();
        pattern.build(&self.members, self.body_count);
        for member in &self.members {
            let at = [member.block, member.lane].map(|number| number as usize);
            pattern.place(member.slot, at);
        }
        pattern
    }

    /// Solves the one component that the joints are. Returns the largest residual of the equation `J v + Γ Δλ
    /// = -rate`, with the velocities `v` of bodies that were at rest.
    fn solve(&mut self) -> f64 {
        let pattern = self.pattern();
        assert_eq!(pattern.component_count(), 1);
        let mut states = vec![BodyState::default(); self.body_count];
        let mut factor = Factor::default();
        factor.resize(pattern.component(0));
        // SAFETY: this thread owns the states exclusively.
        unsafe {
            let shared = DisjointMut::new(&mut states);
            let component = pattern.component(0);
            factor.solve(component, Rows::All, false, &self.memory, &shared, Simd::detect());
        }
        factor.write_changes(pattern.component(0).members, &mut self.memory);
        let errors = self.members.iter().map(|member| self.worst_error(member, &states));
        errors.fold(0.0, f64::max)
    }

    fn worst_error(&self, member: &DirectJoint, states: &[BodyState]) -> f64 {
        let (memory, lane) = (&self.memory.blocks[member.block as usize], member.lane as usize);
        let number = |from: &Lane| f64::from(from.0[lane]);
        let mut worst: f64 = 0.0;
        for axis in (0..SPATIAL_DIM).filter(|axis| member.form.locked >> axis & 1 == 1) {
            let softened = number(&memory.compliance) * number(&memory.changes[axis]);
            let mut error = number(&memory.rates[axis]);
            for (side, body) in member.movable() {
                let (linear, angular) = states[body as usize].velocity();
                for (j, velocity) in memory.rows[axis][side].iter().zip(join(linear, angular)) {
                    error += number(j) * (f64::from(velocity) + softened * number(j));
                }
            }
            assert!(error.is_finite());
            worst = worst.max(error.abs());
        }
        worst
    }
}

fn rows(lane: usize, numbers: &mut Numbers) -> JacobianBlock {
    let mut memory = JacobianBlock::EMPTY;
    for side in 0..2 {
        memory.inv_mass[side].set_lane(lane, Vector::ONE);
        set_symmetric_lane(&mut memory.inv_inertia[side], lane, &unit_inertia());
    }
    for axis in 0..SPATIAL_DIM {
        for (side, sign) in [-1.0, 1.0].into_iter().enumerate() {
            for k in 0..SPATIAL_DIM {
                let straight = if axis == k { sign } else { 0.0 };
                let number = straight + 0.2 * numbers.next();
                memory.rows[axis][side][k].0[lane] = number;
            }
        }
        memory.rates[axis].0[lane] = numbers.next();
    }
    memory
}

/// Rounding of the velocities, a few units in size, times the numbers of a row.
const ROUNDING: f64 = 1.0e3 * Real::EPSILON as f64;

/// The same for loops, with the error of their damping: 10⁻⁸, times impulses of up to a hundred.
const DAMPED_ERROR_MAX: f64 = ROUNDING + 1.0e-6;

/// A chain that hangs on a fixed body and forks in its middle.
const TREE: [[u32; 2]; 9] =
    [[FIXED, 1], [1, 2], [2, 3], [3, 4], [4, 5], [3, 6], [6, 7], [7, 8], [2, 9]];

#[test]
fn trees_are_solved() {
    assert!(Net::new(&TREE, |_| ALL).solve() < ROUNDING);
    // Joints that lock different axes, and not the same number of them.
    let found = Net::new(&TREE, |slot| if slot % 2 == 0 { ALL } else { ALL - 2 }).solve();
    assert!(found < ROUNDING, "{found}");
}

#[test]
fn loops_are_solved() {
    let ladder =
        [[FIXED, 1], [1, 2], [2, 3], [3, 4], [5, 6], [6, 7], [7, 8], [1, 5], [2, 6], [4, 8]];
    // Eight bodies have twice as many axes as these joints lock.
    let found = Net::new(&ladder, |slot| if slot % 2 == 0 { 1 } else { 2 }).solve();
    assert!(found < DAMPED_ERROR_MAX, "{found}");
}

#[test]
fn softened_joints_yield() {
    let mut net = Net::new(&TREE, |_| ALL);
    for (slot, memory) in net.memory.blocks.iter_mut().enumerate() {
        memory.compliance.0[slot % LANES] = 0.25;
    }
    let found = net.solve();
    assert!(found < ROUNDING, "{found}");
}

#[test]
fn redundant_constraints_are_removed() {
    let mut net = Net::new(&[[FIXED, 1], [1, 2], [1, 2], [2, 3]], |_| ALL);
    // The third joint is the second once more, in another lane.
    for axis in 0..SPATIAL_DIM {
        let (from, to) = (net.memory.blocks[1].clone(), &mut net.memory.blocks[2]);
        to.rates[axis].0[2 % LANES] = from.rates[axis].0[1];
        for (side, k) in (0..2).flat_map(|side| (0..SPATIAL_DIM).map(move |k| (side, k))) {
            to.rows[axis][side][k].0[2 % LANES] = from.rows[axis][side][k].0[1];
        }
    }
    let found = net.solve();
    assert!(found < DAMPED_ERROR_MAX, "{found}");
}

/// Each driven axis ends on its law, whatever the pieces on which its neighbours end: motors from weak to
/// rigid, with and without a bound, between limits that are wide, narrow, equal and exceeded.
#[test]
fn driven_axes_end_on_their_laws() {
    let mut numbers = Numbers(3);
    let (mut pieces, mut missed) = ([0; 3], 0);
    for round in 0..300 {
        let mut net = Net::new(&TREE, |_| ALL - (1 << (SPATIAL_DIM - 1)));
        for (slot, member) in net.members.iter_mut().enumerate() {
            member.form.driven = 1;
            net.memory.blocks[slot].first_row = slot;
            net.memory.driven.push(driven_row(slot % LANES, round + slot, &mut numbers));
        }
        let error = net.solve();
        assert!(error < 10.0 * ROUNDING, "round {round}: {error}");
        for (slot, driven) in net.memory.driven.iter().enumerate() {
            let number = |lanes: &Lane| f64::from(lanes.0[slot % LANES]);
            let law = AxisLaw {
                damping: number(&driven.damping),
                pull: number(&driven.pull),
                bound: number(&driven.bound),
                low: number(&driven.low),
                high: number(&driven.high),
            };
            let (impulse, rate) = (driven.impulse(slot % LANES), number(&driven.rate));
            let room = 1.0e-4 * (1.0 + impulse.abs());
            // A limit pushes only while it holds, and away from the limit the motor gives its own impulse.
            let (motor, slope) = (law.motor(rate), law.damping * room);
            let (may_exceed, may_be_less) = (rate < law.low + room, rate > law.high - room);
            let is_right = (may_exceed || impulse < motor + slope + room)
                && (may_be_less || impulse > motor - slope - room)
                && (rate > law.low - room && rate < law.high + room);
            missed += usize::from(!is_right);
            let kind = if may_exceed || may_be_less { 0 } else { 1 };
            pieces[kind + usize::from(kind == 1 && motor.abs() < law.bound)] += 1;
        }
    }
    // A rigid motor with a small bound beside narrow limits may leave the search without an end: its impulse
    // is kept, and the locked axes hold.
    assert!(missed < 10, "{missed} axes of 2,700");
    // At limits, at the bound of the motor, and on its law.
    assert!(pieces.into_iter().all(|count| count > 100), "{pieces:?}");
}

fn driven_row(lane: usize, kind: usize, numbers: &mut Numbers) -> DrivenRow {
    let mut driven = DrivenRow::EMPTY;
    for (side, sign) in [-1.0, 1.0].into_iter().enumerate() {
        for k in 0..SPATIAL_DIM {
            let straight = if k == SPATIAL_DIM - 1 { sign } else { 0.0 };
            driven.row[side][k].0[lane] = straight + 0.2 * numbers.next();
        }
    }
    let (low, width) = (numbers.next(), [100.0, 1.0, 0.05, 0.0][kind % 4]);
    let damping = [0.0, 1.0e-3, 1.0, 1.0e6][kind / 4 % 4];
    driven.rate.0[lane] = 0.0;
    driven.damping.0[lane] = damping;
    driven.pull.0[lane] = damping * numbers.next();
    driven.bound.0[lane] = if damping > 0.0 { [0.1, 1.0e9][kind / 16 % 2] } else { 0.0 };
    driven.low.0[lane] = low - width;
    driven.high.0[lane] = low + width;
    driven
}

/// Identical joints carry equal loads.
#[test]
fn redundant_constraints_share_the_load() {
    let mut net = Net::new(&[[FIXED, 1], [FIXED, 1], [FIXED, 1]], |_| ALL);
    for copy in 1..3 {
        for axis in 0..SPATIAL_DIM {
            let (from, to) = (net.memory.blocks[0].clone(), &mut net.memory.blocks[copy]);
            to.rates[axis].0[copy] = from.rates[axis].0[0];
            for (side, k) in (0..2).flat_map(|side| (0..SPATIAL_DIM).map(move |k| (side, k))) {
                to.rows[axis][side][k].0[copy] = from.rows[axis][side][k].0[0];
            }
        }
    }
    assert!(net.solve() < DAMPED_ERROR_MAX);
    for axis in 0..SPATIAL_DIM {
        let changes = [0, 1, 2].map(|copy| net.memory.blocks[copy].changes[axis].0[copy]);
        let (most, least) = (changes.map(Real::abs).into_iter().fold(0.0, Real::max), 1.0e-4);
        assert!((changes[1] - changes[0]).abs() < least * most, "{changes:?}");
        assert!((changes[2] - changes[0]).abs() < least * most, "{changes:?}");
    }
}

#[test]
fn contradictions_leave_numbers_behind() {
    // Asserts that they are finite.
    let error = Net::new(&[[FIXED, 1], [FIXED, 1], [FIXED, 1]], |_| ALL).solve();
    assert!(error < 100.0, "{error}");
}

#[test]
fn trees_get_no_blocks_but_their_own() {
    let pattern = Net::new(&TREE, |_| ALL).pattern();
    let blocks: usize = pattern.component(0).columns.iter().map(Vec::len).sum();
    // Joints at one body have a block for each two of them: at bodies 1 to 8.
    assert_eq!(blocks, 1 + 3 + 3 + 1 + 1 + 1);
}

/// A dozen limbs of four joints, each a loop from a hub to a light wheel. The joints at these two are
/// coupled, 24 at each. Elimination of the legs first costs a few blocks for each of their joints.
/// Elimination from the hub on would couple nearly all joints with all.
#[test]
fn legs_go_before_their_hubs() {
    const LEGS: u32 = 12;
    let (hub, wheel) = (0, 1);
    let leg = |k: u32| {
        let [upper, lower, knee] = [2, 3, 4].map(|part| part + 3 * k);
        [[hub, upper], [wheel, upper], [hub, lower], [wheel, lower], [upper, knee], [lower, knee]]
    };
    let joints: Vec<_> = (0..LEGS).flat_map(leg).chain([[hub, wheel]]).collect();
    let pattern = Net::new(&joints, |_| ALL).pattern();
    assert_eq!(pattern.component_count(), 1);
    let blocks: usize = pattern.component(0).columns.iter().map(Vec::len).sum();
    // Each of the two hubs has `2 * LEGS + 1` joints. A full coupling of all of them would take half the
    // square of their number. The joints of the limbs take a few blocks each.
    let (at_hubs, of_legs) = (2 * (2 * LEGS as usize + 1), 6 * LEGS as usize);
    assert!(blocks < at_hubs * at_hubs / 2 + 4 * of_legs, "{blocks}");
}

#[test]
fn nets_are_left_to_the_iterations() {
    let at = |row: u32, column: u32| 1 + 30 * row + column;
    let mut joints = vec![[FIXED, at(0, 0)]];
    for (row, column) in (0..30).flat_map(|row| (1..30).map(move |column| (row, column))) {
        joints.push([at(row, column - 1), at(row, column)]);
        joints.push([at(column - 1, row), at(column, row)]);
    }
    let pattern = Net::new(&joints, |_| ALL).pattern();
    assert_eq!(pattern.component_count(), 0);
}

#[test]
fn free_components_of_even_masses_are_iterated() {
    let body = [[1, 2], [2, 3], [2, 4], [4, 5], [2, 6], [6, 7], [1, 8], [8, 9], [1, 10], [10, 11]];
    let free = Net::new(&body, |_| ALL);
    assert_eq!(free.pattern().component_count(), 0);
    let mut weighted = Net::new(&body, |_| ALL);
    weighted.members[9].inv_masses[1] = 0.01;
    assert_eq!(weighted.pattern().component_count(), 1);
    let held: Vec<_> = body.into_iter().chain([[FIXED, 1]]).collect();
    assert_eq!(Net::new(&held, |_| ALL).pattern().component_count(), 1);
    assert_eq!(Net::new(&body[..3], |_| ALL).pattern().component_count(), 1, "few are no work");
}
