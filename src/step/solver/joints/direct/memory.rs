//! The rows of a block of joints, between the lanes that make them and the factorisation that reads them.

use super::super::block::{AxisRow, JointBlock, Wrench};
use super::super::geometry::Geometry;
use super::super::passes::{Locked, compliance_of, note_angvel_change, rates_here, store_couple};
use super::super::rows::{Masses, Row};
use super::super::substep_end::SubstepEnd;
use super::driven_rows::{DrivenRow, write_driven};
use super::joint::DirectJoint;
use super::masses::InverseMass;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Lane, Wide};
use crate::dim::joint::{components, from_components};
use crate::dim::math::{AngVector, DIM, Real, SPATIAL_DIM, Vector};
use crate::dim::spatial::join;
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};
use crate::dim::wide::{
    ANG_ZERO_LANES, WideAngVector, WideSymmetric, WideVector, ZERO_INERTIA, ang_lane, load_ang,
    set_ang_lane, set_symmetric_lane, store_ang, symmetric_lane,
};
use crate::model::params::JointPass;
use crate::step::solver::states::Bodies;

/// The rows of all directly solved joints at one moment.
#[derive(Default)]
pub(in super::super) struct Jacobians {
    /// The locked axes, by block.
    pub blocks: Vec<JacobianBlock>,
    /// The driven axes, by [`AxisRow`].
    pub driven: Vec<DrivenRow>,
}

/// [`Jacobians`] to be shared out.
#[derive(Copy, Clone)]
pub(in super::super) struct SharedJacobians<'a> {
    pub blocks: DisjointMut<'a, JacobianBlock>,
    pub driven: DisjointMut<'a, DrivenRow>,
}

impl Jacobians {
    pub fn clear(&mut self) {
        self.blocks.clear();
        self.driven.clear();
    }

    /// Makes room for blocks with this number of driven axes.
    pub fn resize(&mut self, block_count: usize, row_count: usize) {
        self.blocks.resize(block_count, JacobianBlock::EMPTY);
        self.driven.resize(row_count, DrivenRow::EMPTY);
    }

    /// The driven rows of the block of a joint that belong to the joint.
    pub(super) fn driven_of(&self, member: &DirectJoint) -> &[DrivenRow] {
        let first = self.blocks[member.block as usize].first_row;
        self.driven.get(first..first + usize::from(member.form.driven)).unwrap_or_default()
    }

    pub fn share(&mut self) -> SharedJacobians<'_> {
        let Self { blocks, driven } = self;
        SharedJacobians { blocks: DisjointMut::new(blocks), driven: DisjointMut::new(driven) }
    }
}

/// The locked axes of a block's joints at one moment.
#[derive(Clone, Debug)]
pub(in super::super) struct JacobianBlock {
    /// By axis and body: the row `J`, with the sign of that body.
    pub rows: [[[Lane; SPATIAL_DIM]; 2]; SPATIAL_DIM],
    /// `J v + bias + Γ λ`, where `Γ` is the compliance times the diagonal.
    pub rates: [Lane; SPATIAL_DIM],
    pub impulses: [Lane; SPATIAL_DIM],
    /// The parts of the rates that correct an error.
    pub corrections: [Lane; SPATIAL_DIM],
    pub compliance: Lane,
    /// The first of the block's driven rows.
    pub first_row: usize,
    /// One where the solve pass uses the rows of the predicted poses, zero for those of the current poses.
    pub at_predicted_pose: Lane,
    /// One where the solve pass includes the curvature.
    pub includes_curvature: Lane,
    /// One where errors are corrected apart.
    pub is_corrected_apart: Lane,
    /// Masses of its bodies at the current poses.
    pub inv_mass: [WideVector<Lane>; 2],
    pub inv_inertia: [WideSymmetric<Lane>; 2],
    /// Out: the changes of the impulses.
    pub changes: [Lane; SPATIAL_DIM],
}

impl JacobianBlock {
    pub const EMPTY: Self = {
        let zero = Lane::ZERO;
        Self {
            rows: [[[zero; SPATIAL_DIM]; 2]; SPATIAL_DIM],
            rates: [zero; SPATIAL_DIM],
            impulses: [zero; SPATIAL_DIM],
            corrections: [zero; SPATIAL_DIM],
            compliance: zero,
            first_row: 0,
            at_predicted_pose: zero,
            includes_curvature: zero,
            is_corrected_apart: zero,
            inv_mass: [WideVector::ZERO; 2],
            inv_inertia: [ZERO_INERTIA; 2],
            changes: [zero; SPATIAL_DIM],
        }
    };

    /// Loads the inverse inertias of contacts.
    pub fn take_inertias(&mut self, block: &JointBlock, poses: &[BodyPose]) {
        for (inertias, bodies) in self.inv_inertia.iter_mut().zip(&block.bodies) {
            for (lane, &body) in
                bodies.iter().enumerate().filter(|(_, body)| *body & READ_ONLY == 0)
            {
                set_symmetric_lane(inertias, lane, &poses[body as usize].inv_inertia());
            }
        }
    }

    /// The work of the changes of a lane's impulses on its two bodies at these velocities: `λ J v`.
    pub fn work(&self, lane: usize, velocities: [(Vector, AngVector); 2]) -> Real {
        let mut work = 0.0;
        // Rows that no joint of the block locks are those of another step.
        let changed =
            self.rows.iter().zip(&self.changes).filter(|(_, change)| change.0[lane] != 0.0);
        for (row, change) in changed {
            for (row, (linvel, angvel)) in row.iter().zip(velocities) {
                let rates = row.iter().zip(join(linvel, angvel));
                let rate: Real = rates.map(|(number, velocity)| number.0[lane] * velocity).sum();
                work += change.0[lane] * rate;
            }
        }
        work
    }

    /// Response of a body of the joint in a lane to impulses.
    pub(super) fn inverse_mass(&self, side: usize, lane: usize) -> InverseMass {
        let inv_inertia = symmetric_lane(&self.inv_inertia[side], lane);
        InverseMass::new(self.inv_mass[side].lane(lane), &inv_inertia)
    }
}

/// Impulses of a block's joints in the impacts of a round, with their moments about the second anchors.
#[derive(Clone, Debug)]
pub(in super::super) struct ImpactImpulse {
    impulse: WideVector<Lane>,
    moment: WideAngVector<Lane>,
}

impl ImpactImpulse {
    pub const NONE: Self = Self { impulse: WideVector::ZERO, moment: ANG_ZERO_LANES };

    /// Adds this fraction of a lane's impact impulses to its impulses of the step, and nowhere else: they are
    /// no warm-start load.
    pub fn commit(&self, block: &mut JointBlock, lane: usize, fraction: Real) {
        let impulse = block.total_impulse.lane(lane) + self.impulse.lane(lane) * fraction;
        block.total_impulse.set_lane(lane, impulse);
        let given = ang_lane(&self.moment, lane) * fraction;
        let moment = ang_lane(&block.total_moment, lane) + given;
        set_ang_lane(&mut block.total_moment, lane, moment);
    }
}

/// Computes the rows of a block at the current poses and velocities of its bodies. Rows of rotations are
/// written where a joint locks one.
///
/// # Safety
/// No other thread writes the states of the block's bodies.
#[inline(always)]
pub(in super::super) unsafe fn write_rows<W: Wide>(
    block: &mut JointBlock,
    axis_rows: &mut [AxisRow],
    to: &mut JacobianBlock,
    driven: &mut [DrivenRow],
    states: &DisjointMut<BodyState>,
    pass: &JointPass,
) {
    // SAFETY: the caller's promise.
    let bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    let now = Geometry::new(block, &bodies.displacements);
    let substep_end = pass.is_biased.then(|| SubstepEnd::new(block, &bodies, pass));
    let moment = Moment { bodies, now, substep_end, pass };
    match block.locks_rotations {
        true => write_locked::<W, SPATIAL_DIM>(block, to, &moment),
        false => write_locked::<W, DIM>(block, to, &moment),
    }
    to.first_row = block.first_row;
    if block.row_count > 0 {
        write_driven::<W>(to, axis_rows.iter_mut().zip(driven), &moment);
    }
}

/// A block's joints at the moment when their rows are written.
pub(super) struct Moment<'a, W> {
    pub bodies: Bodies<W>,
    pub now: Geometry<W>,
    /// In the solve pass.
    pub substep_end: Option<SubstepEnd<W>>,
    pub pass: &'a JointPass,
}

/// Computes the locked rows of a block whose first `N` axes alone may be locked.
#[inline(always)]
fn write_locked<W: Wide, const N: usize>(
    block: &mut JointBlock,
    memory: &mut JacobianBlock,
    moment: &Moment<'_, W>,
) {
    let locked = Locked::<W, N>::new(block, &moment.now);
    let (rows, rates) = match &moment.substep_end {
        Some(end) => rows_biased(block, memory, &locked, moment, end),
        None => {
            let bias_rate = W::load(&block.bias_rate);
            for k in 0..N {
                (locked.errors[k] * bias_rate).store(&mut memory.corrections[k]);
            }
            let rates = rates_here(block, &locked.rows, &moment.bodies);
            (locked.rows, rates)
        }
    };
    memory.changes = [Lane::ZERO; SPATIAL_DIM];
    for k in 0..N {
        rates[k].store(&mut memory.rates[k]);
        W::load(&block.impulses[k]).store(&mut memory.impulses[k]);
        store_row(&rows[k], &mut memory.rows[k]);
    }
    compliance_of::<W>(block, moment.pass.is_biased).store(&mut memory.compliance);
    (memory.inv_mass, memory.inv_inertia) = (block.inv_mass, *block.inertias.lanes());
}

#[inline(always)]
pub(super) fn store_row<W: Wide>(row: &Row<W>, to: &mut [[Lane; SPATIAL_DIM]; 2]) {
    store_all(components(-row.linear, -row.angular[0]), &mut to[0]);
    store_all(components(row.linear, row.angular[1]), &mut to[1]);
}

/// Rows and velocity errors of the solve pass, with the curvature of the present velocities. Stiff joints use
/// the rows of the predicted poses, others those of the current poses. Joints with a large unconstrained
/// displacement (`../geometric_stiffness.rs`) are excluded.
#[inline(always)]
fn rows_biased<W: Wide, const N: usize>(
    block: &mut JointBlock,
    memory: &mut JacobianBlock,
    locked: &Locked<W, N>,
    moment: &Moment<'_, W>,
    end: &SubstepEnd<W>,
) -> ([Row<W>; N], [W; N]) {
    let at_predicted_pose = W::zero().lt(W::load(&memory.at_predicted_pose));
    let includes_curvature = W::zero().lt(W::load(&memory.includes_curvature));
    let is_corrected_apart = W::zero().lt(W::load(&memory.is_corrected_apart));
    let (errors, mut rows) = end.then.locked_axes::<N>();
    let mut rates = end.rates::<N>(block, &moment.now, [locked.errors, errors], moment.pass);
    for k in 0..N {
        let bias = W::load(&block.held_bias[k]);
        bias.store(&mut memory.corrections[k]);
        rows[k] = rows[k].select(at_predicted_pose, locked.rows[k]);
        let here = rows[k].rate(&moment.bodies.velocities) + bias;
        rates[k] = W::select(includes_curvature, rates[k], here)
            - W::select(is_corrected_apart, bias, W::zero());
    }
    (rows, rates)
}

#[inline(always)]
fn store_all<W: Wide>(values: [W; SPATIAL_DIM], to: &mut [Lane; SPATIAL_DIM]) {
    for (value, lane) in values.into_iter().zip(to) {
        value.store(lane);
    }
}

#[inline(always)]
fn load_all<W: Wide>(from: &[Lane; SPATIAL_DIM]) -> [W; SPATIAL_DIM] {
    let mut values = [W::zero(); SPATIAL_DIM];
    for (value, lane) in values.iter_mut().zip(from) {
        *value = W::load(lane);
    }
    values
}

/// Takes the changes of the impulses into the block and its driven rows. The bodies have them already.
#[inline(always)]
pub(in super::super) fn finish<W: Wide>(
    block: &mut JointBlock,
    axis_rows: &mut [AxisRow],
    from: &JacobianBlock,
    driven: &[DrivenRow],
    is_last_of_substep: bool,
) {
    let earlier = load_ang::<W>(&block.total_moment);
    match block.locks_rotations {
        true => finish_locked::<W, SPATIAL_DIM>(block, from, is_last_of_substep),
        false => finish_locked::<W, DIM>(block, from, is_last_of_substep),
    }
    let mut added = Wrench::<W>::zero();
    let mut moment = load_ang::<W>(&block.total_moment);
    for (row, from) in axis_rows.iter_mut().zip(driven) {
        (row.motor.impulse, row.lower, row.upper) = (from.motor, from.lower, from.upper);
        let (along, change) = (load_row::<W>(&from.row), W::load(&from.change));
        added.add(&along, change);
        if is_last_of_substep {
            row.motor.rate = from.rate;
            let is_rotation = along.linear.dot(along.linear).lt(W::splat(0.5));
            moment = moment + along.angular[1] * W::select(is_rotation, change, W::zero());
        }
    }
    if !driven.is_empty() {
        note_added(block, &added);
        if is_last_of_substep {
            store_ang(moment, &mut block.total_moment);
            let total = WideVector::load(&block.total_impulse) + added.linear;
            total.store(&mut block.total_impulse);
        }
    }
    if is_last_of_substep {
        let added = load_ang::<W>(&block.total_moment) - earlier;
        store_ang(load_ang::<W>(&block.substep_moment) + added, &mut block.substep_moment);
    }
}

#[inline(always)]
fn note_added<W: Wide>(block: &mut JointBlock, added: &Wrench<W>) {
    Wrench::load(&block.applied).plus(added).store(&mut block.applied);
    note_angvel_change(block, Masses::load(block).angvel_change(added));
}

/// Takes the changes of the locked rows of a block whose first `N` axes alone may be locked.
#[inline(always)]
fn finish_locked<W: Wide, const N: usize>(
    block: &mut JointBlock,
    memory: &JacobianBlock,
    is_last_of_substep: bool,
) {
    let rows = rows_of::<W, N>(memory);
    for (impulse, change) in block.impulses.iter_mut().zip(&memory.changes) {
        (W::load(impulse) + W::load(change)).store(impulse);
    }
    let added = added(memory, &rows);
    note_added(block, &added);
    if is_last_of_substep {
        let JointBlock { total_impulse, total_moment, .. } = block;
        add_to_totals(total_impulse, total_moment, memory, &rows, &added);
        store_couple(block, &rows);
    }
}

/// Adds the changes of the impulses to those of an impact. Each iteration of a round starts from admissible
/// velocities, so the joint impulses of a round are the sum over its iterations.
#[inline(always)]
pub(in super::super) fn count<W: Wide>(
    impact_impulse: &mut ImpactImpulse,
    memory: &JacobianBlock,
    locks_rotations: bool,
) {
    match locks_rotations {
        true => count_first_rows::<W, SPATIAL_DIM>(impact_impulse, memory),
        false => count_first_rows::<W, DIM>(impact_impulse, memory),
    }
}

/// As [`count`], for a block whose first `N` axes alone may be locked.
#[inline(always)]
fn count_first_rows<W: Wide, const N: usize>(
    impact_impulse: &mut ImpactImpulse,
    memory: &JacobianBlock,
) {
    let rows = rows_of::<W, N>(memory);
    let added = added(memory, &rows);
    add_to_totals(&mut impact_impulse.impulse, &mut impact_impulse.moment, memory, &rows, &added);
}

#[inline(always)]
fn rows_of<W: Wide, const N: usize>(memory: &JacobianBlock) -> [Row<W>; N] {
    let mut rows = [Row::zero(); N];
    for (row, numbers) in rows.iter_mut().zip(&memory.rows) {
        *row = load_row(numbers);
    }
    rows
}

#[inline(always)]
fn load_row<W: Wide>([first, second]: &[[Lane; SPATIAL_DIM]; 2]) -> Row<W> {
    let (_, first) = from_components::<W>(load_all(first));
    let (linear, second) = from_components::<W>(load_all(second));
    Row { linear, angular: [-first, second] }
}

/// Velocity changes of the bodies by the changes of the impulses.
#[inline(always)]
fn added<W: Wide, const N: usize>(memory: &JacobianBlock, rows: &[Row<W>; N]) -> Wrench<W> {
    let mut added = Wrench::zero();
    for (row, change) in rows.iter().zip(&memory.changes) {
        added.add(row, W::load(change));
    }
    added
}

#[inline(always)]
fn add_to_totals<W: Wide, const N: usize>(
    total_impulse: &mut WideVector<Lane>,
    total_moment: &mut WideAngVector<Lane>,
    memory: &JacobianBlock,
    rows: &[Row<W>; N],
    added: &Wrench<W>,
) {
    let mut moment = load_ang::<W>(total_moment);
    for k in DIM..N {
        moment = moment + rows[k].angular[1] * W::load(&memory.changes[k]);
    }
    store_ang(moment, total_moment);
    (WideVector::load(total_impulse) + added.linear).store(total_impulse);
}
