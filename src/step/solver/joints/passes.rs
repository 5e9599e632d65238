//! The passes over a block of joints.

use super::block::{AxisRow, JointBlock, Wrench};
use super::geometry::Geometry;
use super::motors_and_limits::{FreeAxis, impulse_of, solve_axis};
use super::rows::{Factored, Masses, Row};
use super::substep_end::SubstepEnd;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::Wide;
use crate::dim::joint::{angular_to_frame, angular_to_world};
use crate::dim::math::{DIM, SPATIAL_DIM};
use crate::dim::state::{BodyState, WideMotion};
use crate::dim::wide::{
    ANG_ZERO_LANES, WideAngVector, WideVector, ang_dot, load_ang, store_ang, torque,
};
use crate::model::params::JointPass;
use crate::step::solver::states::Bodies;

/// The locked axes of a block at the moment when it is solved: as many as may be, or the translations alone.
pub(super) struct Locked<W, const N: usize> {
    pub errors: [W; N],
    pub rows: [Row<W>; N],
    locked: [W; N],
}

impl<W: Wide, const N: usize> Locked<W, N> {
    #[inline(always)]
    pub fn new(block: &JointBlock, geometry: &Geometry<W>) -> Self {
        let mut locked = [W::zero(); N];
        for (locked, lane) in locked.iter_mut().zip(&block.locked) {
            *locked = W::load(lane);
        }
        let (errors, rows) = geometry.locked_axes();
        Self { errors, rows, locked }
    }

    /// The matrix `K_ll` of the locked axes.
    #[inline(always)]
    pub fn coupling(&self, masses: &Masses<W>) -> [[W; N]; N] {
        masses.coupling(&self.rows, &self.locked)
    }

    /// Notes `J M⁻¹ Jᵀ` of free axes, whose impulses the locked axes react to.
    #[inline(always)]
    pub fn note_responses(
        &self,
        axis_rows: &mut [AxisRow],
        geometry: &Geometry<W>,
        masses: &Masses<W>,
    ) {
        if axis_rows.is_empty() {
            return;
        }
        let matrix = Factored::new(self.coupling(masses));
        for axis_row in axis_rows {
            let (mut along, _) = geometry.free_row(axis_row);
            let fractions = self.reactions_of(&along, masses, &matrix);
            for (locked, fraction) in self.rows.iter().zip(fractions) {
                along = along.minus(locked, fraction);
            }
            masses.effective(&along).store(&mut axis_row.response);
        }
    }

    /// The reaction of the locked axes to an impulse along a row: `K_ll⁻¹ K_lf`.
    #[inline(always)]
    fn reactions_of(&self, row: &Row<W>, masses: &Masses<W>, matrix: &Factored<W, N>) -> [W; N] {
        let mut coupled = masses.couplings(&self.rows, row);
        for k in 0..N {
            coupled[k] = coupled[k] * self.locked[k];
        }
        matrix.solve(coupled)
    }

    /// The wrench of all impulses at the current rows.
    #[inline(always)]
    fn wrench(&self, block: &JointBlock) -> Wrench<W> {
        let mut wrench = Wrench::zero();
        for (row, impulse) in self.rows.iter().zip(&block.impulses) {
            wrench.add(row, W::load(impulse));
        }
        wrench
    }
}

/// Notes the rates of the free axes when the step begins, and their responses to impulses.
///
/// # Safety
/// The caller has exclusive access to the block's rows. No other thread writes the states of its bodies.
#[inline(always)]
pub(super) unsafe fn begin_free_axes<W: Wide>(
    block: &JointBlock,
    rows: &DisjointMut<AxisRow>,
    states: &DisjointMut<BodyState>,
) {
    if block.row_count == 0 {
        return;
    }
    // SAFETY: the caller's promise; the block's rows are in range.
    let (bodies, rows) =
        unsafe { (Bodies::<W>::gather(states, &block.bodies), rows.range_mut(block.axis_rows())) };
    let geometry = Geometry::new(block, &bodies.displacements);
    for row in &mut *rows {
        geometry.free_row(row).0.rate(&bodies.velocities).store(&mut row.motor.rate);
    }
    if block.is_exact {
        let locked = Locked::<W, SPATIAL_DIM>::new(block, &geometry);
        locked.note_responses(rows, &geometry, &Masses::load(block));
    }
}

/// Converts the last step's results into impulses along the rows, and applies them to the bodies.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies, and to its rows.
#[inline(always)]
pub(super) unsafe fn warm_start<W: Wide>(
    block: &mut JointBlock,
    rows: &DisjointMut<AxisRow>,
    states: &DisjointMut<BodyState>,
) {
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    let geometry = Geometry::new(block, &bodies.displacements);
    let locked = Locked::<W, SPATIAL_DIM>::new(block, &geometry);
    let couple = angular_to_world(&geometry.axes, load_ang::<W>(&block.couple));
    for (k, direction) in geometry.locked_directions().iter().enumerate() {
        let along = ang_dot(*direction, couple) * locked.locked[DIM + k];
        let length_squared = ang_dot(*direction, *direction).max(W::splat(1.0e-6));
        (along / length_squared).store(&mut block.impulses[DIM + k]);
    }
    // SAFETY: the caller's promise.
    let wrench = unsafe { wrench_of(block, rows, &geometry, &locked) };
    wrench.store(&mut block.applied);
    let masses = Masses::load(block);
    store_angvel_change(masses.angvel_change(&wrench), block);
    bodies.velocities = masses.push(&wrench, bodies.velocities);
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, &block.bodies) };
}

/// Joints of stiff components start without impulses, including motors and limits. Without the opposing
/// locked axes, these impulses would move the bodies far away.
///
/// # Safety
/// The caller has exclusive access to the block's rows.
#[inline(always)]
unsafe fn clear_stiff<W: Wide>(block: &mut JointBlock, rows: &DisjointMut<AxisRow>) {
    let kept = W::splat(1.0) - W::load(&block.is_stiff);
    for impulse in &mut block.impulses {
        (W::load(impulse) * kept).store(impulse);
    }
    for index in block.axis_rows() {
        // SAFETY: the caller's promise; the block's rows are in range.
        let row = unsafe { rows.get_mut(index) };
        for impulse in [&mut row.motor.impulse, &mut row.lower, &mut row.upper] {
            (W::load(impulse) * kept).store(impulse);
        }
    }
}

/// The effect of the impulses of all rows at the current poses.
///
/// # Safety
/// No other thread writes the block's rows.
#[inline(always)]
unsafe fn wrench_of<W: Wide, const N: usize>(
    block: &JointBlock,
    rows: &DisjointMut<AxisRow>,
    geometry: &Geometry<W>,
    locked: &Locked<W, N>,
) -> Wrench<W> {
    let mut wrench = locked.wrench(block);
    for index in block.axis_rows() {
        // SAFETY: the caller's promise; the block's rows are in range.
        let row = unsafe { rows.get(index) };
        wrench.add(&geometry.free_row(row).0, impulse_of(row));
    }
    wrench
}

/// Solves all rows of iterated joints once: free axes, then locked ones. The rows of direct joints
/// are prepared.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies, and to its rows.
#[inline(always)]
pub(super) unsafe fn iterate<W: Wide>(
    block: &mut JointBlock,
    rows: &DisjointMut<AxisRow>,
    states: &DisjointMut<BodyState>,
    pass: &JointPass,
) {
    // SAFETY: the caller's promise.
    unsafe {
        // Without locked rotations the results are equal, for half of the work.
        match block.locks_rotations {
            true => iterate_rows::<W, SPATIAL_DIM>(block, rows, states, pass),
            false => iterate_rows::<W, DIM>(block, rows, states, pass),
        }
    }
}

/// As [`iterate`], for a block whose first `N` axes alone may be locked.
///
/// # Safety
/// As [`iterate`].
#[inline(always)]
unsafe fn iterate_rows<W: Wide, const N: usize>(
    block: &mut JointBlock,
    rows: &DisjointMut<AxisRow>,
    states: &DisjointMut<BodyState>,
    pass: &JointPass,
) {
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    let geometry = Geometry::new(block, &bodies.displacements);
    if !pass.is_biased {
        block.inertias.rotate(&bodies.displacements);
    }
    let masses = Masses::load(block);
    let locked = Locked::<W, N>::new(block, &geometry);

    let mut wrench = Wrench::load(&block.applied);
    if pass.is_biased {
        // SAFETY: the caller's promise.
        let turned = unsafe {
            clear_stiff::<W>(block, rows);
            wrench_of(block, rows, &geometry, &locked)
        };
        bodies.velocities = give_instead(block, &masses, &turned, bodies.velocities);
        wrench = turned;
    }
    let before = wrench;
    if block.is_exact && !pass.is_biased {
        // SAFETY: the caller's promise; the block's rows are in range.
        let rows = unsafe { rows.range_mut(block.axis_rows()) };
        locked.note_responses(rows, &geometry, &masses);
    }
    if !block.is_exact {
        let coupling = locked.coupling(&masses);
        let has_curvature = pass.is_biased && block.has_distances;
        let substep_end = has_curvature.then(|| SubstepEnd::new(block, &bodies, pass));
        let (masses, locked, substep_end) = (&masses, &locked, substep_end.as_ref());
        let joint = JointNow { geometry: &geometry, substep_end, masses, locked, coupling, pass };
        // SAFETY: the caller's promise.
        let added = unsafe { solve_axes(block, rows, &joint, &mut bodies) };
        wrench = wrench.plus(&added);
    }

    wrench.store(&mut block.applied);
    note_angvel_change(block, masses.angvel_change(&wrench.minus(&before)));
    if !pass.is_biased && pass.is_last_iteration {
        add_to_totals(block, &geometry, &wrench);
        store_couple(block, &locked.rows);
    }
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, &block.bodies) };
}

/// Replaces the applied wrench by another one.
#[inline(always)]
fn give_instead<W: Wide>(
    block: &mut JointBlock,
    masses: &Masses<W>,
    wrench: &Wrench<W>,
    velocities: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    let added = wrench.linear - WideVector::load(&block.applied.linear);
    let [mut m1, mut m2] = masses.push_along(added, velocities);
    let angvel_change = masses.angvel_change(wrench);
    m1.angular = m1.angular + (angvel_change[0] - load_ang::<W>(&block.angvel_change[0]));
    m2.angular = m2.angular + (angvel_change[1] - load_ang::<W>(&block.angvel_change[1]));
    store_angvel_change(angvel_change, block);
    [m1, m2]
}

#[inline(always)]
fn store_angvel_change<W: Wide>(angvel_change: [WideAngVector<W>; 2], block: &mut JointBlock) {
    for (angvel_change, to) in angvel_change.into_iter().zip(&mut block.angvel_change) {
        store_ang(angvel_change, to);
    }
}

/// Stores the change of the angular velocities by added impulses.
#[inline(always)]
pub(super) fn note_angvel_change<W: Wide>(
    block: &mut JointBlock,
    [first, second]: [WideAngVector<W>; 2],
) {
    let angvel_change = [
        load_ang::<W>(&block.angvel_change[0]) + first,
        load_ang::<W>(&block.angvel_change[1]) + second,
    ];
    store_angvel_change(angvel_change, block);
}

/// Common data of the axes of a block during a pass.
struct JointNow<'a, W, const N: usize> {
    geometry: &'a Geometry<W>,
    /// Joint positions at the end of the substep, if required.
    substep_end: Option<&'a SubstepEnd<W>>,
    masses: &'a Masses<W>,
    locked: &'a Locked<W, N>,
    /// `K_ll`, the matrix of the locked axes.
    coupling: [[W; N]; N],
    pass: &'a JointPass,
}

/// Solves free axes, then locked ones; returns the changes.
///
/// # Safety
/// The caller has exclusive access to the block's rows.
#[inline(always)]
unsafe fn solve_axes<W: Wide, const N: usize>(
    block: &mut JointBlock,
    rows: &DisjointMut<AxisRow>,
    joint: &JointNow<'_, W, N>,
    bodies: &mut Bodies<W>,
) -> Wrench<W> {
    let (mut wrench, mut matrix) = (Wrench::zero(), None);
    if block.row_count > 0 {
        let factored = Factored::new(joint.coupling);
        for index in block.axis_rows() {
            // SAFETY: the caller's promise; the block's rows are in range.
            let row = unsafe { rows.get_mut(index) };
            let added = solve_free(row, block, joint, &factored, bodies);
            bodies.velocities = joint.masses.push(&added, bodies.velocities);
            wrench = wrench.plus(&added);
        }
        matrix = Some(factored);
    }
    let added = solve_locked(block, joint, matrix.as_ref(), bodies);
    bodies.velocities = joint.masses.push(&added, bodies.velocities);
    wrench.plus(&added)
}

/// Solves motor and limits of a free axis; returns the changes.
///
/// The locked axes react to the impulses of a free axis. Using `J - K_fl K_ll⁻¹ J_l` in place of the axis's
/// own row `J` moves the bodies as the joint allows. Its effective mass is the true load of the motor, and no
/// iteration between the two is necessary.
#[inline(always)]
fn solve_free<W: Wide, const N: usize>(
    row: &mut AxisRow,
    block: &mut JointBlock,
    joint: &JointNow<'_, W, N>,
    matrix: &Factored<W, N>,
    bodies: &Bodies<W>,
) -> Wrench<W> {
    let pass = joint.pass;
    let (mut along, position) = joint.geometry.free_row(row);
    let fractions = joint.locked.reactions_of(&along, joint.masses, matrix);
    let mut curvature = W::zero();
    if let Some(substep_end) = joint.substep_end {
        // Angles are excluded: most of these are limbs of ragdolls, where the curvature is invisible.
        let (_, then) = substep_end.then.free_row(row);
        let rate = along.rate(&bodies.velocities);
        let of_distance =
            substep_end.curvature(joint.geometry, &along, then - position, rate, pass);
        let is_translation = SubstepEnd::is_translation(&along);
        curvature = W::select(is_translation, of_distance, curvature);
    }
    if !pass.is_biased {
        position.store(&mut row.position);
    }
    for (locked, fraction) in joint.locked.rows.iter().zip(fractions) {
        along = along.minus(locked, fraction);
    }
    let effective = joint.masses.effective(&along);
    let axis = FreeAxis::new(position, effective);
    let rate = along.rate(&bodies.velocities);
    let is_translation = SubstepEnd::is_translation(&along);
    let added = solve_axis::<W>(row, &axis, [rate, curvature], is_translation, pass);
    if !pass.is_biased && pass.is_last_iteration {
        (rate + effective * added).store(&mut row.motor.rate);
    }
    for (impulse, fraction) in block.impulses.iter_mut().zip(fractions) {
        (W::load(impulse) - fraction * added).store(impulse);
    }
    let mut wrench = Wrench::zero();
    wrench.add(&along, added);
    wrench
}

/// Solves all locked axes together; returns the changes. The `matrix` is the one without compliance, if it is
/// known.
#[inline(always)]
fn solve_locked<W: Wide, const N: usize>(
    block: &mut JointBlock,
    joint: &JointNow<'_, W, N>,
    matrix: Option<&Factored<W, N>>,
    bodies: &Bodies<W>,
) -> Wrench<W> {
    let (Locked { rows, locked, .. }, mut coupling) = (joint.locked, joint.coupling);
    let is_biased = joint.pass.is_biased;
    let mut wanted = if is_biased {
        rates_with_bias(block, joint.locked, bodies)
    } else {
        rates_here(block, rows, bodies)
    };
    for k in 0..N {
        wanted[k] = wanted[k] * locked[k];
    }
    let is_rigid = !(is_biased || block.has_springs);
    let change = if let (true, Some(matrix)) = (is_rigid, matrix) {
        matrix.solve(wanted)
    } else {
        let compliance = compliance_of::<W>(block, is_biased);
        for k in 0..N {
            let soft = coupling[k][k] * compliance * locked[k];
            coupling[k][k] = coupling[k][k] + soft;
            wanted[k] = wanted[k] + soft * W::load(&block.impulses[k]);
        }
        Factored::new(coupling).solve(wanted)
    };
    let mut wrench = Wrench::zero();
    for k in 0..N {
        let added = -change[k];
        (W::load(&block.impulses[k]) + added).store(&mut block.impulses[k]);
        wrench.add(&rows[k], added);
    }
    wrench
}

/// Velocity errors of iterated rows in the solve pass: with bias, but without curvature, which would amplify
/// the errors of the iteration.
#[inline(always)]
fn rates_with_bias<W: Wide, const N: usize>(
    block: &mut JointBlock,
    locked: &Locked<W, N>,
    bodies: &Bodies<W>,
) -> [W; N] {
    let bias_rate = W::load(&block.bias_rate);
    let mut rates = [W::zero(); N];
    for k in 0..N {
        let bias = locked.errors[k] * bias_rate;
        bias.store(&mut block.held_bias[k]);
        rates[k] = locked.rows[k].rate(&bodies.velocities) + bias;
    }
    rates
}

/// The rates of the rows in the relax pass; springs pull as they did in the solve pass.
#[inline(always)]
pub(super) fn rates_here<W: Wide, const N: usize>(
    block: &JointBlock,
    rows: &[Row<W>; N],
    bodies: &Bodies<W>,
) -> [W; N] {
    let is_spring = W::load(&block.is_spring);
    let mut rates = [W::zero(); N];
    for k in 0..N {
        rates[k] = rows[k].rate(&bodies.velocities) + W::load(&block.held_bias[k]) * is_spring;
    }
    rates
}

/// The compliance of the rows in a pass: in the relax pass only springs have any.
#[inline(always)]
pub(super) fn compliance_of<W: Wide>(block: &JointBlock, is_biased: bool) -> W {
    let compliance = W::load(&block.compliance);
    if is_biased { compliance } else { compliance * W::load(&block.is_spring) }
}

/// Adds a substep's impulse, and its moment about the second anchor, to those of the step.
#[inline(always)]
fn add_to_totals<W: Wide>(block: &mut JointBlock, geometry: &Geometry<W>, wrench: &Wrench<W>) {
    let moment = wrench.angular[1] - torque(geometry.arms[1], wrench.linear);
    let impulse = WideVector::load(&block.total_impulse) + wrench.linear;
    impulse.store(&mut block.total_impulse);
    let total = load_ang::<W>(&block.total_moment) + moment;
    store_ang(total, &mut block.total_moment);
    store_ang(moment, &mut block.substep_moment);
}

/// Notes the couple of the angular impulses in the first frame, where it means the same in the next step.
#[inline(always)]
pub(super) fn store_couple<W: Wide, const N: usize>(block: &mut JointBlock, rows: &[Row<W>; N]) {
    let mut couple = load_ang::<W>(&ANG_ZERO_LANES);
    let mut axes = [WideVector::zero(); DIM];
    for k in 0..DIM {
        axes[k] = rows[k].linear;
    }
    for k in DIM..N {
        couple = couple + rows[k].angular[1] * W::load(&block.impulses[k]);
    }
    store_ang(angular_to_frame(&axes, couple), &mut block.couple);
}
