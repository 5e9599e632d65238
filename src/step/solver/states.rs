//! Body states and poses in registers: one body per lane.

use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Wide, gather, gather_adjacent, scatter, scatter_adjacent};
use crate::dim::math::{AngVector, Real, SPATIAL_DIM, SpatialVector, Vector};
use crate::dim::rotation_vector::composed_rotation;
use crate::dim::spatial::{angular, linear};
use crate::dim::state::{
    BodyPose, BodyState, MOTION_LEN, POSE_LEN, READ_ONLY, STATE_LEN, WRITTEN_LEN, WideDisplacement,
    WideMotion, WidePose, WideState, motions, numbers, pose,
};

impl BodyState {
    /// A body with these velocities that has not moved yet.
    pub fn new(linvel: Vector, angvel: AngVector) -> Self {
        let mut state = Self::AT_REST;
        state.set_velocity(linvel, angvel);
        state
    }

    /// Adds to the linear and then the angular components of the velocity.
    #[inline]
    pub fn add_velocity(&mut self, change: [Real; SPATIAL_DIM]) {
        for (value, change) in self.0.iter_mut().zip(change) {
            *value += change;
        }
    }

    /// Moves further by the linear components, and rotates further by the angular components.
    pub fn add_displacement(&mut self, change: SpatialVector) {
        let (at, rotvec) = self.displacement();
        let rotvec = composed_rotation(rotvec, angular(&change));
        self.set_displacement(at + linear(&change), rotvec);
    }

    /// Returns whether a body moved exactly as another since the step began.
    pub fn has_displacement_of(&self, other: &Self) -> bool {
        let bits = |state: &Self| state.0.map(Real::to_bits);
        bits(self)[MOTION_LEN..] == bits(other)[MOTION_LEN..]
    }

    /// Returns whether all numbers of these states are finite and within a bound.
    ///
    /// Counts the numbers beyond the bound per component, as numbers of the same width, so that the
    /// comparison is vectorised.
    pub fn are_within(states: &[Self], bound: Real) -> bool {
        let mut beyond = [0.0; STATE_LEN];
        for state in states {
            for (beyond, value) in beyond.iter_mut().zip(state.0) {
                *beyond += if value.abs() <= bound { 0.0 } else { 1.0 };
            }
        }
        beyond == [0.0; STATE_LEN]
    }
}

/// Reads velocity and displacement of one body per lane.
///
/// # Safety
/// No other thread writes the states of these bodies.
#[inline(always)]
pub(super) unsafe fn gather_states<W: Wide>(
    states: &DisjointMut<BodyState>,
    indices: &[u32; LANES],
) -> WideState<W> {
    let mut rows = [const { &[0.0; STATE_LEN] }; LANES];
    for (row, &index) in rows.iter_mut().zip(indices) {
        // SAFETY: the caller's promise.
        *row = unsafe { &states.get((index & !READ_ONLY) as usize).0 };
    }
    motions(gather::<W, STATE_LEN>(rows))
}

/// Writes the velocity of one body per lane, except read-only ones.
///
/// The displacement must be the one that was gathered with it: half a register cannot be written.
///
/// # Safety
/// The caller has exclusive access to the states of the bodies that are not read-only.
#[inline(always)]
pub(super) unsafe fn scatter_states<W: Wide>(
    states: &DisjointMut<BodyState>,
    indices: &[u32; LANES],
    state: WideState<W>,
) {
    let mut rows = [const { None }; LANES];
    for (row, &index) in rows.iter_mut().zip(indices) {
        if index & READ_ONLY == 0 {
            // SAFETY: the caller's promise.
            let state = unsafe { states.get_mut(index as usize) };
            *row = state.0.first_chunk_mut();
        }
    }
    let mut written = [W::zero(); WRITTEN_LEN];
    written.copy_from_slice(&numbers(state)[..WRITTEN_LEN]);
    scatter::<W, WRITTEN_LEN>(written, rows);
}

/// Velocities and displacements of a block's two bodies.
pub(super) struct Bodies<W> {
    pub velocities: [WideMotion<W>; 2],
    pub displacements: [WideDisplacement<W>; 2],
}

impl<W: Wide> Bodies<W> {
    /// Reads velocities and displacements of two bodies per lane.
    ///
    /// # Safety
    /// As [`gather_states`], for both bodies.
    #[inline(always)]
    pub unsafe fn gather(states: &DisjointMut<BodyState>, indices: &[[u32; LANES]; 2]) -> Self {
        // SAFETY: the caller's promise.
        let ((v1, d1), (v2, d2)) =
            unsafe { (gather_states(states, &indices[0]), gather_states(states, &indices[1])) };
        Self { velocities: [v1, v2], displacements: [d1, d2] }
    }

    /// Displacements of the bodies since the step began.
    #[inline(always)]
    pub fn moved(&self) -> [WideMotion<W>; 2] {
        [self.displacements[0].motion(), self.displacements[1].motion()]
    }

    /// Writes the velocities of two bodies per lane, except read-only ones.
    ///
    /// # Safety
    /// As [`scatter_states`], for both bodies.
    #[inline(always)]
    pub unsafe fn scatter(self, states: &DisjointMut<BodyState>, indices: &[[u32; LANES]; 2]) {
        let ([v1, v2], [d1, d2]) = (self.velocities, self.displacements);
        // SAFETY: the caller's promise.
        unsafe {
            scatter_states(states, &indices[0], (v1, d1));
            scatter_states(states, &indices[1], (v2, d2));
        }
    }
}

/// Reads the velocity of one body per lane.
#[inline(always)]
pub(super) fn gather_velocities<W: Wide>(
    states: &[BodyState],
    indices: &[u32; LANES],
) -> WideMotion<W> {
    let mut rows = [const { &[0.0; STATE_LEN] }; LANES];
    for (row, &index) in rows.iter_mut().zip(indices) {
        *row = &states[(index & !READ_ONLY) as usize].0;
    }
    let (velocity, _) = motions(gather::<W, STATE_LEN>(rows));
    velocity
}

/// Reads velocity and displacement of up to [`LANES`] adjacent bodies; the other lanes get
/// zeros.
#[inline(always)]
pub(super) fn load_states<W: Wide>(states: &[BodyState]) -> WideState<W> {
    motions(gather_adjacent(states, |state| &state.0))
}

/// Writes velocity and displacement of up to [`LANES`] adjacent bodies.
#[inline(always)]
pub(super) fn store_states<W: Wide>(states: &mut [BodyState], motions: WideState<W>) {
    scatter_adjacent(numbers(motions), states, |state| &mut state.0);
}

/// Reads the pose of one body per lane.
#[inline(always)]
pub(super) fn gather_poses<W: Wide>(poses: &[BodyPose], indices: &[u32; LANES]) -> WidePose<W> {
    let mut rows = [const { &[0.0; POSE_LEN] }; LANES];
    for (row, &index) in rows.iter_mut().zip(indices) {
        *row = &poses[(index & !READ_ONLY) as usize].0;
    }
    pose(gather::<W, POSE_LEN>(rows))
}
