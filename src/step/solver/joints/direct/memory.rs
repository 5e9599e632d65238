//! The rows of a block of joints, between the lanes that make them and the factorisation that reads them.

use super::super::block::{JointBlock, Wrench};
use super::super::geometry::Geometry;
use super::super::passes::{compliance_of, note_angvel_change, rates_here, store_couple};
use super::super::rows::{Masses, Row};
use super::super::substep_end::SubstepEnd;
use super::masses::InverseMass;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Lane, Wide};
use crate::dim::joint::{components, from_components};
use crate::dim::math::{AngVector, DIM, Real, SPATIAL_DIM, Vector};
use crate::dim::spatial::join;
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};
use crate::dim::wide::{
    ANG_ZERO_LANES, WideAngVector, WideSymmetric, WideVector, ZERO_INERTIA, ang_lane, load_ang,
    select_ang, set_ang_lane, set_symmetric_lane, store_ang, symmetric_lane,
};
use crate::model::params::JointPass;
use crate::step::solver::states::Bodies;

/// The locked axes of a block's joints at one moment.
#[derive(Clone, Debug)]
pub(in super::super) struct JacobianBlock {
    /// By axis and body: the row `J`, with the sign of that body.
    pub rows: [[[Lane; SPATIAL_DIM]; 2]; SPATIAL_DIM],
    /// `J v + bias + Γ λ`, where `Γ` is the compliance times the diagonal.
    pub rates: [Lane; SPATIAL_DIM],
    pub impulses: [Lane; SPATIAL_DIM],
    pub compliance: Lane,
    /// One where the solve pass uses the rows of the predicted poses, zero for those of the current poses.
    pub at_predicted_pose: Lane,
    /// One where the solve pass includes the curvature.
    pub includes_curvature: Lane,
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
            compliance: zero,
            at_predicted_pose: zero,
            includes_curvature: zero,
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
pub(in super::super) unsafe fn write_rows<W: Wide, const BIASED: bool>(
    block: &mut JointBlock,
    memory: &mut JacobianBlock,
    states: &DisjointMut<BodyState>,
    pass: &JointPass,
) {
    // SAFETY: the caller's promise.
    unsafe {
        match block.locks_rotations {
            true => write_first_rows::<W, BIASED, SPATIAL_DIM>(block, memory, states, pass),
            false => write_first_rows::<W, BIASED, DIM>(block, memory, states, pass),
        }
    }
}

/// As [`write_rows`], for a block whose first `N` axes alone may be locked.
///
/// # Safety
/// As [`write_rows`].
#[inline(always)]
unsafe fn write_first_rows<W: Wide, const BIASED: bool, const N: usize>(
    block: &mut JointBlock,
    memory: &mut JacobianBlock,
    states: &DisjointMut<BodyState>,
    pass: &JointPass,
) {
    // SAFETY: the caller's promise.
    let bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    let (rows, rates) = if BIASED {
        rows_biased::<W, N>(block, memory, &bodies, pass)
    } else {
        let rows = Geometry::new(block, &bodies.displacements).rows::<N>();
        (rows, rates_here(block, &rows, &bodies))
    };
    memory.changes = [Lane::ZERO; SPATIAL_DIM];
    for k in 0..N {
        rates[k].store(&mut memory.rates[k]);
        W::load(&block.impulses[k]).store(&mut memory.impulses[k]);
        for side in 0..2 {
            let linear = if side == 0 { -rows[k].linear } else { rows[k].linear };
            let angular = if side == 0 { -rows[k].angular[0] } else { rows[k].angular[1] };
            store_all(components(linear, angular), &mut memory.rows[k][side]);
        }
    }
    compliance_of::<W, BIASED>(block).store(&mut memory.compliance);
    (memory.inv_mass, memory.inv_inertia) = (block.inv_mass, *block.inertias.lanes());
}

/// Rows and velocity errors of the solve pass, with the curvature of the present velocities. Stiff joints use
/// the rows of the predicted poses, others those of the current poses. Joints with a large unconstrained
/// displacement (`../geometric_stiffness.rs`) are excluded.
#[inline(always)]
fn rows_biased<W: Wide, const N: usize>(
    block: &mut JointBlock,
    memory: &JacobianBlock,
    bodies: &Bodies<W>,
    pass: &JointPass,
) -> ([Row<W>; N], [W; N]) {
    let at_predicted_pose = W::zero().lt(W::load(&memory.at_predicted_pose));
    let includes_curvature = W::zero().lt(W::load(&memory.includes_curvature));
    let now = Geometry::new(block, &bodies.displacements);
    let substep_end = SubstepEnd::new(block, bodies, pass);
    let (mut rows, then) = (now.rows::<N>(), substep_end.then.rows::<N>());
    for (row, then) in rows.iter_mut().zip(&then) {
        row.linear = WideVector::select(at_predicted_pose, then.linear, row.linear);
        for side in 0..2 {
            row.angular[side] =
                select_ang(at_predicted_pose, then.angular[side], row.angular[side]);
        }
    }
    let mut rates = substep_end.rates::<N>(block, &now, pass);
    for (k, rate) in rates.iter_mut().enumerate() {
        let here = rows[k].rate(&bodies.velocities) + W::load(&block.held_bias[k]);
        *rate = W::select(includes_curvature, *rate, here);
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

/// Takes the changes of the impulses into the block. The bodies have them already.
#[inline(always)]
pub(in super::super) fn finish<W: Wide>(
    block: &mut JointBlock,
    memory: &JacobianBlock,
    is_last_of_substep: bool,
) {
    match block.locks_rotations {
        true => finish_first_rows::<W, SPATIAL_DIM>(block, memory, is_last_of_substep),
        false => finish_first_rows::<W, DIM>(block, memory, is_last_of_substep),
    }
}

/// As [`finish`], for a block whose first `N` axes alone may be locked.
#[inline(always)]
fn finish_first_rows<W: Wide, const N: usize>(
    block: &mut JointBlock,
    memory: &JacobianBlock,
    is_last_of_substep: bool,
) {
    let rows = rows_of::<W, N>(memory);
    for (impulse, change) in block.impulses.iter_mut().zip(&memory.changes) {
        (W::load(impulse) + W::load(change)).store(impulse);
    }
    let added = added(memory, &rows);
    Wrench::load(&block.applied).plus(&added).store(&mut block.applied);
    note_angvel_change(block, Masses::load(block).angvel_change(&added));
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
    for (row, [first, second]) in rows.iter_mut().zip(&memory.rows) {
        let (_, first) = from_components::<W>(load_all(first));
        let (linear, second) = from_components::<W>(load_all(second));
        *row = Row { linear, angular: [-first, second] };
    }
    rows
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
