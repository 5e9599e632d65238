//! The passes over a block of joints.

use super::block::{AxisRow, JointBlock, Wrench};
use super::drive::{FreeAxis, solve_limits, solve_motor};
use super::geometry::Geometry;
use super::rows::{Masses, Row, solve_symmetric};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::Wide;
use crate::dim::joint::{angular_to_frame, angular_to_world};
use crate::dim::math::{DIM, SPATIAL_DIM};
use crate::dim::state::{BodyState, WideMotion, gather_states, scatter_states};
use crate::dim::wide::{ANG_ZERO_LANES, WideVector, ang_dot, load_ang, store_ang, torque};
use crate::model::params::JointPass;

/// Velocities and displacements of a block's two bodies.
pub(super) struct Bodies<W> {
    pub velocities: [WideMotion<W>; 2],
    pub displacements: [WideMotion<W>; 2],
}

impl<W: Wide> Bodies<W> {
    /// # Safety
    /// As [`gather_states`], for both bodies.
    #[inline(always)]
    pub unsafe fn gather(states: &DisjointMut<BodyState>, block: &JointBlock) -> Self {
        // SAFETY: the caller's promise.
        let ([v1, d1], [v2, d2]) = unsafe {
            (gather_states(states, &block.bodies[0]), gather_states(states, &block.bodies[1]))
        };
        Self { velocities: [v1, v2], displacements: [d1, d2] }
    }

    /// # Safety
    /// As [`scatter_states`], for both bodies.
    #[inline(always)]
    unsafe fn scatter(self, states: &DisjointMut<BodyState>, block: &JointBlock) {
        let ([v1, v2], [d1, d2]) = (self.velocities, self.displacements);
        // SAFETY: the caller's promise.
        unsafe {
            scatter_states(states, &block.bodies[0], [v1, d1]);
            scatter_states(states, &block.bodies[1], [v2, d2]);
        }
    }
}

/// The locked axes of a block at the moment when it is solved.
pub(super) struct Locked<W> {
    pub rows: [Row<W>; SPATIAL_DIM],
    locked: [W; SPATIAL_DIM],
}

impl<W: Wide> Locked<W> {
    #[inline(always)]
    pub fn new(block: &JointBlock, geometry: &Geometry<W>) -> Self {
        let mut locked = [W::zero(); SPATIAL_DIM];
        for (locked, lane) in locked.iter_mut().zip(&block.locked) {
            *locked = W::load(lane);
        }
        Self { rows: geometry.rows(), locked }
    }

    /// The wrench of all impulses as the rows stand now.
    #[inline(always)]
    fn wrench(&self, block: &JointBlock) -> Wrench<W> {
        let mut wrench = Wrench::zero();
        for (row, impulse) in self.rows.iter().zip(&block.impulses) {
            wrench.add(row, W::load(impulse));
        }
        wrench
    }
}

/// Turns what the last step left into impulses along the rows, and gives it to the bodies.
///
/// # Safety
/// Nobody else may touch the states of the block's bodies, or its rows, meanwhile.
#[inline(always)]
pub(super) unsafe fn warm_start<W: Wide>(
    block: &mut JointBlock,
    rows: &DisjointMut<AxisRow>,
    states: &DisjointMut<BodyState>,
) {
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, block) };
    let geometry = Geometry::new(block, &bodies.displacements);
    let locked = Locked::new(block, &geometry);
    let couple = angular_to_world(&geometry.axes, load_ang::<W>(&block.couple));
    for (k, direction) in geometry.directions.iter().enumerate() {
        let along = ang_dot(*direction, couple) * locked.locked[DIM + k];
        let length_squared = ang_dot(*direction, *direction).max(W::splat(1.0e-6));
        (along / length_squared).store(&mut block.impulses[DIM + k]);
    }
    // SAFETY: the caller's promise.
    let wrench = unsafe { wrench_of(block, rows, &geometry, &locked) };
    wrench.store(&mut block.applied);
    bodies.velocities = Masses::load(block).push(&wrench, bodies.velocities);
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, block) };
}

/// What the impulses of all rows do as the rows stand now.
///
/// # Safety
/// Nobody may write to the block's rows meanwhile.
#[inline(always)]
unsafe fn wrench_of<W: Wide>(
    block: &JointBlock,
    rows: &DisjointMut<AxisRow>,
    geometry: &Geometry<W>,
    locked: &Locked<W>,
) -> Wrench<W> {
    let mut wrench = locked.wrench(block);
    for index in block.first_row..block.first_row + block.row_count {
        // SAFETY: the caller's promise; the block's rows are in range.
        let row = unsafe { rows.get(index) };
        wrench.add(&geometry.free_row(row).0, impulse_of(row));
    }
    wrench
}

/// The impulse of a free axis: motor and limits together.
#[inline(always)]
fn impulse_of<W: Wide>(row: &AxisRow) -> W {
    W::load(&row.motor.impulse) + (W::load(&row.lower) - W::load(&row.upper))
}

/// Solves all rows once: free axes, then locked ones. `AHEAD`: so that the bodies are where they should be at the
/// end of the substep; otherwise so that nothing moves apart from where they are.
///
/// # Safety
/// Nobody else may touch the states of the block's bodies, or its rows, meanwhile.
#[inline(always)]
pub(super) unsafe fn visit<W: Wide, const AHEAD: bool>(
    block: &mut JointBlock,
    rows: &DisjointMut<AxisRow>,
    states: &DisjointMut<BodyState>,
    pass: &JointPass,
) {
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, block) };
    let geometry = Geometry::new(block, &bodies.displacements);
    let masses = Masses::load(block);
    let locked = Locked::new(block, &geometry);

    let mut wrench = Wrench::load(&block.applied);
    if AHEAD {
        // SAFETY: the caller's promise.
        let now = unsafe { wrench_of(block, rows, &geometry, &locked) };
        bodies.velocities = masses.push(&now.minus(&wrench), bodies.velocities);
        wrench = now;
    }
    for index in block.first_row..block.first_row + block.row_count {
        // SAFETY: the caller's promise.
        let row = unsafe { rows.get_mut(index) };
        let added = solve_free::<W, AHEAD>(row, &geometry, &masses, &bodies.velocities, pass);
        bodies.velocities = masses.push(&added, bodies.velocities);
        wrench = wrench.plus(&added);
    }
    let added = solve_locked::<W, AHEAD>(block, &geometry, &masses, &locked, &bodies, pass);
    bodies.velocities = masses.push(&added, bodies.velocities);
    wrench = wrench.plus(&added);

    wrench.store(&mut block.applied);
    if !AHEAD && pass.is_last_visit {
        add_to_totals(block, &geometry, &wrench);
        store_couple(block, &locked.rows);
    }
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, block) };
}

/// Solves motor and limits of a free axis; returns what they add.
#[inline(always)]
fn solve_free<W: Wide, const AHEAD: bool>(
    row: &mut AxisRow,
    geometry: &Geometry<W>,
    masses: &Masses<W>,
    velocities: &[WideMotion<W>; 2],
    pass: &JointPass,
) -> Wrench<W> {
    let (along, position) = geometry.free_row(row);
    let effective = masses.effective(&along);
    let (zero, one) = (W::zero(), W::splat(1.0));
    let movable = zero.lt(effective);
    let inverse = W::select(movable, one / W::select(movable, effective, one), zero);
    let axis = FreeAxis { position, effective, inverse };
    let rate = along.rate(velocities);
    let driven = solve_motor::<W, AHEAD>(&mut row.motor, &axis, rate, pass);
    let limited = solve_limits::<W, AHEAD>(row, &axis, rate + effective * driven, pass);
    let mut wrench = Wrench::zero();
    wrench.add(&along, driven + limited);
    wrench
}

/// Solves all locked axes together; returns what they add.
#[inline(always)]
fn solve_locked<W: Wide, const AHEAD: bool>(
    block: &mut JointBlock,
    geometry: &Geometry<W>,
    masses: &Masses<W>,
    Locked { rows, locked }: &Locked<W>,
    bodies: &Bodies<W>,
    pass: &JointPass,
) -> Wrench<W> {
    let mut wanted = [W::zero(); SPATIAL_DIM];
    for (wanted, row) in wanted.iter_mut().zip(rows) {
        *wanted = row.rate(&bodies.velocities);
    }
    if AHEAD {
        add_bias(&mut wanted, block, geometry, bodies, pass);
    } else {
        add_held_bias(&mut wanted, block);
    }
    let swept = W::load(&block.swept);
    let mut solved = [W::zero(); SPATIAL_DIM];
    for k in 0..SPATIAL_DIM {
        solved[k] = locked[k] * swept;
        wanted[k] = wanted[k] * solved[k];
    }
    let mut coupling = masses.coupling(rows, &solved);
    let yields = yields_of::<W, AHEAD>(block);
    for k in 0..SPATIAL_DIM {
        let soft = coupling[k][k] * yields * solved[k];
        coupling[k][k] = coupling[k][k] + soft;
        wanted[k] = wanted[k] + soft * W::load(&block.impulses[k]);
    }
    let change = solve_symmetric(coupling, wanted);
    let mut wrench = Wrench::zero();
    for k in 0..SPATIAL_DIM {
        let added = -change[k];
        (W::load(&block.impulses[k]) + added).store(&mut block.impulses[k]);
        wrench.add(&rows[k], added);
    }
    wrench
}

/// Adds errors and the curvature ahead to the rates: see the module's head.
#[inline(always)]
pub(super) fn add_bias<W: Wide>(
    rates: &mut [W; SPATIAL_DIM],
    block: &mut JointBlock,
    geometry: &Geometry<W>,
    bodies: &Bodies<W>,
    pass: &JointPass,
) {
    let h = W::splat(pass.substep);
    let inv_h = W::splat(pass.inv_substep);
    let ahead = [
        advanced(&bodies.displacements[0], &bodies.velocities[0], h),
        advanced(&bodies.displacements[1], &bodies.velocities[1], h),
    ];
    let then = Geometry::new(block, &ahead).errors();
    let now = geometry.errors();
    let bias_rate = W::load(&block.bias_rate);
    for k in 0..SPATIAL_DIM {
        // Ċ and the curvature together: all that the substep would change.
        let change = (then[k] - now[k]) * inv_h;
        let bias = now[k] * bias_rate;
        bias.store(&mut block.held_bias[k]);
        rates[k] = change + bias;
    }
}

/// What the relax pass adds to the rates: nothing, but for springs, which pull as they did.
#[inline(always)]
pub(super) fn add_held_bias<W: Wide>(rates: &mut [W; SPATIAL_DIM], block: &JointBlock) {
    let is_spring = W::load(&block.is_spring);
    for (rate, bias) in rates.iter_mut().zip(&block.held_bias) {
        *rate = *rate + W::load(bias) * is_spring;
    }
}

/// How much the rows yield in a pass: in the relax pass only springs do.
#[inline(always)]
pub(super) fn yields_of<W: Wide, const AHEAD: bool>(block: &JointBlock) -> W {
    let yields = W::load(&block.yields);
    if AHEAD { yields } else { yields * W::load(&block.is_spring) }
}

#[inline(always)]
fn advanced<W: Wide>(
    displacement: &WideMotion<W>,
    velocity: &WideMotion<W>,
    h: W,
) -> WideMotion<W> {
    WideMotion {
        linear: displacement.linear + velocity.linear * h,
        angular: displacement.angular + velocity.angular * h,
    }
}

/// Adds a substep's impulse, and its moment about the second anchor, to those of the step.
#[inline(always)]
fn add_to_totals<W: Wide>(block: &mut JointBlock, geometry: &Geometry<W>, wrench: &Wrench<W>) {
    let moment = wrench.angular[1] - torque(geometry.levers[1], wrench.linear);
    let impulse = WideVector::load(&block.total_impulse) + wrench.linear;
    impulse.store(&mut block.total_impulse);
    let total = load_ang::<W>(&block.total_moment) + moment;
    store_ang(total, &mut block.total_moment);
}

/// Notes the couple of the angular impulses in the first frame, where it means the same in the next step.
#[inline(always)]
pub(super) fn store_couple<W: Wide>(block: &mut JointBlock, rows: &[Row<W>; SPATIAL_DIM]) {
    let mut couple = load_ang::<W>(&ANG_ZERO_LANES);
    let mut axes = [WideVector::zero(); DIM];
    for k in 0..DIM {
        axes[k] = rows[k].linear;
    }
    for k in DIM..SPATIAL_DIM {
        couple = couple + rows[k].angular[1] * W::load(&block.impulses[k]);
    }
    store_ang(angular_to_frame(&axes, couple), &mut block.couple);
}
