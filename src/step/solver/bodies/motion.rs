//! Free motion of bodies, [`LANES`] at a time.

use crate::base::wide::{Kernel, LANES, Wide, gather};
use crate::dim::math::{AngularInertia, Real, Vector, mul_inertia};
use crate::dim::motion::{FreeMotion, accelerated, gyroscopic, without_forces};
use crate::dim::rotation_vector::{turned_further, turned_inertia};
use crate::dim::state::{BodyPose, BodyState, WideDisplacement, WideMotion, WideState, motions};
use crate::dim::wide::{
    ZERO_INERTIA, load_symmetric, set_symmetric_lane, store_symmetric, symmetric_lane,
};
use crate::model::body::RigidBody;
use crate::step::solver::states::{load_states, store_states};

/// The free motion of a dynamic body in a step with this substep.
pub(super) fn motion_of(body: &RigidBody, gravity: Vector, substep: Real) -> FreeMotion {
    let (force, torque) = body.forces();
    let mprops = &body.mprops;
    let linear = body.gravitational_acceleration(gravity) + force * mprops.inv_mass;
    let angular = mul_inertia(&mprops.inv_inertia, torque);
    let damping = [body.linear_damping, body.angular_damping];
    let may_be_in_pile = gravity * body.gravity_scale != Vector::ZERO;
    let motion = FreeMotion::new(body.pose.rotation, linear, angular, damping, may_be_in_pile);
    if body.gyroscopic_forces_enabled && mprops.rotates_freely() {
        motion.with_gyroscope(&mprops.local_mprops, body.vels.angvel, substep)
    } else {
        motion
    }
}

/// Adjacent bodies, and their velocities before any impulse of the substep.
pub(super) struct BodyChunk<'a> {
    pub states: &'a mut [BodyState],
    pub before: &'a mut [BodyState],
    /// Receives the velocities that they have without the forces of this substep; may be empty.
    pub last: &'a mut [BodyState],
    pub motions: &'a mut [FreeMotion],
}

impl BodyChunk<'_> {
    /// Returns chunks of `LANES` bodies.
    fn chunks(self) -> impl Iterator<Item = Self> {
        let states = self.states.chunks_mut(LANES);
        let others = self.before.chunks_mut(LANES).zip(self.motions.chunks_mut(LANES));
        let mut lasts = self.last.chunks_mut(LANES);
        states.zip(others).map(move |(states, (before, motions))| {
            let last = lasts.next().unwrap_or_default();
            BodyChunk { states, before, last, motions }
        })
    }
}

/// Adds gravity and the user's forces, damps, and starts the substep with the last one's impulses.
pub(super) struct Accelerate<'a> {
    pub bodies: BodyChunk<'a>,
    pub h: Real,
    /// The fraction of the last impulses with which it starts.
    pub warm_start_coefficient: Real,
    pub speed_max: Real,
    /// The states hold the impulses of the last step already, which must not be damped with the velocity.
    pub is_first: bool,
}

impl Kernel for Accelerate<'_> {
    /// Number of bodies that were limited to the largest speed.
    type Output = usize;

    #[inline(always)]
    fn run<W: Wide>(self) -> usize {
        let (warm_start_coefficient, mut limited) = (W::splat(self.warm_start_coefficient), 0);
        for BodyChunk { states, before, last, motions } in self.bodies.chunks() {
            let (old, _) = load_states::<W>(before);
            let (velocity, displacement) = load_states::<W>(states);
            let linear = (velocity.linear - old.linear) * warm_start_coefficient;
            let angular = (velocity.angular - old.angular) * warm_start_coefficient;
            let start = if self.is_first { old } else { velocity };
            let mut free = accelerated(motions, start, self.h);
            if !last.is_empty() {
                let angular = without_forces(motions, start.angular, free.angular, self.h);
                store_states(last, (WideMotion { angular, ..start }, displacement));
            }
            let (slow, are_faster) = free.linear.clamped(self.speed_max);
            free.linear = slow;
            limited += are_faster.count_ones() as usize;
            store_states(before, (free, displacement));
            let linear = free.linear + linear;
            let angular = free.angular + angular;
            store_states(states, (WideMotion { linear, angular }, displacement));
        }
        limited
    }
}

/// Moves bodies by their velocities.
pub(super) struct Advance<'a> {
    pub bodies: BodyChunk<'a>,
    pub h: Real,
}

impl Kernel for Advance<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        let h = W::splat(self.h);
        for BodyChunk { states, before, motions, .. } in self.bodies.chunks() {
            let (mut velocity, moved) = load_states::<W>(states);
            let linear = moved.linear + velocity.linear * h;
            let angular = turned_further(moved.angular, velocity.angular * h);
            if motions.iter().any(FreeMotion::is_gyroscopic) {
                let (mut old, displacement) = load_states::<W>(before);
                gyroscopic(motions, &mut velocity.angular, &mut old.angular, self.h);
                store_states(before, (old, displacement));
            }
            store_states(states, (velocity, WideDisplacement::new(linear, angular)));
        }
    }
}

/// Rotates the inverse inertias of uneven bodies by the rotations since the step began.
pub(super) struct TurnInertias<'a> {
    pub uneven_starts: &'a [(u32, AngularInertia)],
    pub states: &'a [BodyState],
    pub poses: &'a mut [BodyPose],
}

impl Kernel for TurnInertias<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        for chunk in self.uneven_starts.chunks(LANES) {
            let mut inertias = ZERO_INERTIA;
            let mut rows = [const { &BodyState::AT_REST.0 }; LANES];
            for (lane, (body, start)) in chunk.iter().enumerate() {
                rows[lane] = &self.states[*body as usize].0;
                set_symmetric_lane(&mut inertias, lane, start);
            }
            let (_, moved): WideState<W> = motions(gather(rows));
            let turned = turned_inertia(load_symmetric(&inertias), moved.rotation());
            store_symmetric(turned, &mut inertias);
            for (lane, &(body, _)) in chunk.iter().enumerate() {
                self.poses[body as usize].set_inv_inertia(&symmetric_lane(&inertias, lane));
            }
        }
    }
}
