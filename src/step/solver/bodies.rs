//! Awake bodies as the solver sees them: dense, and group after group.

use super::groups::{Group, Groups};
use super::multibodies::SolverMultibodies;
use crate::base::disjoint::DisjointMut;
use crate::dim::axes::{LockedAxes, inv_mass_per_axis};
use crate::dim::gyro::Gyroscope;
use crate::dim::math::{
    ANG_ZERO, AngVector, Pose, Real, Rotation, Vector, ang_length_squared, integrate_rotation,
    mul_inertia,
};
use crate::dim::spatial::join;
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};
use crate::model::body::{
    RigidBody, RigidBodyHandle, RigidBodySet, RigidBodyType, RigidBodyVelocity,
};
use crate::model::check::checked_pose;
use crate::model::contact::Placement;
use crate::model::island::{IslandManager, NONE};
use crate::model::params::IntegrationParameters;
use core::ops::Range;

/// What integrates a body; no constraint reads it.
#[derive(Copy, Clone, Debug)]
struct Motion {
    rotation: Rotation,
    /// Acceleration by gravity and the user's forces (length/s², rad/s²).
    linear_acceleration: Vector,
    angular_acceleration: AngVector,
    linear_damping: Real,
    angular_damping: Real,
    /// Does gravity pull it, so that it may be part of a pile? What holds piles up counts, too.
    bears_weight: bool,
    /// For a body that tumbles.
    gyroscope: Option<Gyroscope>,
}

/// All awake bodies. Index 0 is the world, index `i + 1` the `i`-th in the order of the groups.
#[derive(Default)]
pub(super) struct SolverBodies {
    pub poses: Vec<BodyPose>,
    pub states: Vec<BodyState>,
    /// Velocities before any impulse of the current substep.
    pub before: Vec<BodyState>,
    motions: Vec<Motion>,
    /// By body slot: the index above, with [`READ_ONLY`] unless constraints may move the body. The
    /// world's for bodies that are not awake.
    indices: Vec<u32>,
    /// The slots whose index is not the world's, to be cleared by the next step.
    listed: Vec<u32>,
    /// By index: with what share of its last impulses a substep begins.
    shares: Vec<Real>,
    /// By index: the island, or [`NONE`].
    pub islands: Vec<u32>,
    /// The indices of those that move: the spectators, and the members of the group that is solved.
    moving: [Range<usize>; 2],
}

const WORLD: u32 = BodyPose::WORLD_INDEX;

impl SolverBodies {
    /// Gathers all awake bodies; those that multibodies move have a place and nobody in it.
    pub fn load(
        &mut self,
        groups: &Groups,
        bodies: &mut RigidBodySet,
        multibodies: &SolverMultibodies,
        gravity: Vector,
        params: &IntegrationParameters,
    ) {
        self.clear();
        self.indices.resize(bodies.slot_count().max(self.indices.len()), WORLD);
        let spectators = 0..groups.spectators();
        let around = (multibodies, gravity, params);
        self.load_members(&groups.order()[spectators], bodies, around, params.dt);
        for group in groups.iter() {
            let h = params.dt / group.substeps as Real;
            let members = &groups.order()[group.members.clone()];
            self.load_members(members, bodies, around, h);
        }
        self.before.clone_from(&self.states);
    }

    fn load_members(
        &mut self,
        members: &[RigidBodyHandle],
        bodies: &mut RigidBodySet,
        (multibodies, gravity, params): (&SolverMultibodies, Vector, &IntegrationParameters),
        h: Real,
    ) {
        for &handle in members {
            let Some(body) = bodies.get_unnoted_mut(handle) else {
                self.push_nobody(); // positions in the order are indices here
                continue;
            };
            let slot = handle.into_raw_parts().0;
            if multibodies.moves(slot) {
                self.push_nobody();
                continue;
            }
            let index = self.states.len() as u32;
            // Colours keep constraints apart at bodies with an island, and at no others.
            let writable = body.link.island != NONE;
            self.indices[slot as usize] = if writable { index } else { index | READ_ONLY };
            self.listed.push(slot);
            self.push(body, gravity, params, h);
        }
    }

    /// From now on this group is solved; the others stand still.
    pub fn enter(&mut self, group: &Group, groups: &Groups) {
        let spectators = 1..1 + groups.spectators();
        for index in spectators.clone() {
            let (v, w) = self.states[index].velocity();
            self.states[index] = BodyState::new(v, w);
        }
        self.moving = [spectators, 1 + group.members.start..1 + group.members.end];
    }

    /// Does the group that is solved have all bodies?
    pub fn are_one_group(&self) -> bool {
        self.moving[1] == (1..self.states.len())
    }

    /// Does the group that is solved have one of two bodies? For pairs of bodies that touch.
    pub fn has_one_of(&self, slots: [u32; 2]) -> bool {
        let [_, members] = &self.moving;
        slots.into_iter().any(|slot| {
            let index = self.index_of(slot);
            index & READ_ONLY == 0 && members.contains(&(index as usize))
        })
    }

    /// With what share of their last impulses two bodies begin: less than 1 if substeps have become shorter, as
    /// impulses of a force are. If they have become longer it stays 1: the springs of soft contacts are then
    /// pressed too far for shorter substeps, push out with more than the weight that they carry, and that must not
    /// be multiplied.
    pub fn share(&self, indices: [u32; 2]) -> Real {
        let moved = indices.into_iter().find(|index| index & READ_ONLY == 0);
        moved.map_or(1.0, |index| self.shares[index as usize])
    }

    /// The island of two bodies that touch.
    pub fn island_of(&self, indices: [u32; 2]) -> u32 {
        let moved = indices.into_iter().find(|index| index & READ_ONLY == 0);
        moved.map_or(NONE, |index| self.islands[index as usize])
    }

    /// No island of a body has this number or a higher one.
    pub fn island_bound(&self) -> usize {
        let ids = self.islands.iter().filter(|&&island| island != NONE);
        ids.max().map_or(0, |&island| island as usize + 1)
    }

    fn clear(&mut self) {
        for slot in self.listed.drain(..) {
            self.indices[slot as usize] = WORLD;
        }
        self.poses.clear();
        self.states.clear();
        self.motions.clear();
        self.shares.clear();
        self.islands.clear();
        self.push_nobody();
    }

    fn push_nobody(&mut self) {
        self.poses.push(BodyPose::WORLD);
        self.states.push(BodyState::default());
        self.motions.push(Motion::AT_REST);
        self.shares.push(1.0);
        self.islands.push(NONE);
    }

    fn push(
        &mut self,
        body: &mut RigidBody,
        gravity: Vector,
        params: &IntegrationParameters,
        h: Real,
    ) {
        let mprops = &body.mprops;
        let (inv_mass, inv_inertia) = (mprops.inv_mass, &mprops.inv_inertia);
        self.poses.push(BodyPose::new(body.pose.rotation, mprops.world_com, inv_mass, inv_inertia));
        if body.body_type == RigidBodyType::KinematicPositionBased {
            let velocity = body.velocity_to_next_position(params.inv_dt());
            (body.linvel, body.angvel) = (velocity.linvel, velocity.angvel);
        }
        self.states.push(BodyState::new(body.linvel, body.angvel));
        self.motions.push(if body.is_dynamic() {
            Motion::of(body, gravity, h)
        } else {
            Motion { rotation: body.pose.rotation, ..Motion::AT_REST }
        });
        self.shares.push(if body.substep > h { h / body.substep } else { 1.0 });
        body.substep = h;
        self.islands.push(body.link.island);
    }

    /// The solver's index of the body in a slot ([`NONE`]: no body).
    pub fn index_of(&self, slot: u32) -> u32 {
        if slot == NONE { WORLD } else { self.indices.get(slot as usize).copied().unwrap_or(WORLD) }
    }

    /// The inverse mass of the body with an index, along the axis where it is largest; 0 if constraints must not move
    /// it.
    pub fn inv_mass_of(&self, index: u32) -> Real {
        self.poses.get(index as usize).map_or(0.0, |pose| pose.inv_mass().max_element())
    }

    /// Is this a body of a pile that creeps, or what a pile stands on ([`Placement`])?
    pub fn creeps(&self, index: u32) -> bool {
        let at = (index & !READ_ONLY) as usize;
        let (_, angvel) = self.states[at].velocity();
        self.motions[at].bears_weight
            && Placement::creeps(ang_length_squared(angvel), index & READ_ONLY == 0)
    }

    /// The states, to be shared among constraints of one colour.
    pub fn shared(&mut self) -> (&[BodyPose], DisjointMut<'_, BodyState>, &[BodyState]) {
        (&self.poses, DisjointMut::new(&mut self.states), &self.before)
    }

    /// Adds gravity and the user's forces, damps, and starts the substep with the last one's impulses.
    ///
    /// At the `first` substep the states hold the impulses of the last step already, which must not be
    /// damped with the velocity.
    pub fn integrate_velocities(&mut self, h: Real, params: &IntegrationParameters, first: bool) {
        let warmth = params.warmstart_coefficient;
        let speed_max = params.max_linear_velocity();
        self.for_each_moving(|state, before, motion| {
            let (old_v, old_w) = before.velocity();
            let (v, w) = state.velocity();
            let (impulse_v, impulse_w) = ((v - old_v) * warmth, (w - old_w) * warmth);
            let (v, w) = if first { (old_v, old_w) } else { (v, w) };
            let (v, w) = motion.accelerated(v, w, h, speed_max);
            before.set_velocity(v, w);
            state.set_velocity(v + impulse_v, w + impulse_w);
        });
    }

    /// Takes over what an impact did to the velocities since the `start`, or as much of it as `share` says for an
    /// island: as if it had happened at the mean time of the blows that a body got, and was no impulse. `delays` are
    /// the sum of these and of each times its time, in place of two components of a velocity.
    pub fn accept_impact(
        &mut self,
        start: &[BodyState],
        delays: &[BodyState],
        share: impl Fn(u32) -> Real,
    ) {
        for index in self.moving.clone().into_iter().flatten() {
            let ((old_v, old_w), (v, w)) = (start[index].velocity(), self.states[index].velocity());
            if (v, w) == (old_v, old_w) {
                continue;
            }
            let share = share(self.islands[index]);
            let (added_v, added_w) = ((v - old_v) * share, (w - old_w) * share);
            self.states[index].set_velocity(old_v + added_v, old_w + added_w);
            let before = &mut self.before[index];
            before.add_velocity(join(added_v, added_w));
            let (blows, _) = delays[index].velocity();
            if blows.x > 0.0 {
                let delay = -blows.y / blows.x;
                self.states[index].add_displacement(join(added_v * delay, added_w * delay));
                self.motions[index].turn(added_w * delay);
            }
        }
    }

    /// Moves all bodies by their velocities.
    pub fn integrate_positions(&mut self, h: Real) {
        self.for_each_moving(|state, before, motion| {
            state.advance(h);
            motion.tumble(state, before, h);
        });
    }

    fn for_each_moving(&mut self, mut f: impl FnMut(&mut BodyState, &mut BodyState, &mut Motion)) {
        for range in self.moving.clone() {
            let states = self.states[range.clone()].iter_mut();
            let befores = &mut self.before[range.clone()];
            for ((state, before), motion) in states.zip(befores).zip(&mut self.motions[range]) {
                f(state, before, motion);
            }
        }
    }

    /// Writes velocities and poses back to the bodies, and notes how far each one moved.
    pub fn store(
        &mut self,
        groups: &Groups,
        islands: &mut IslandManager,
        bodies: &mut RigidBodySet,
        multibodies: &SolverMultibodies,
        params: &IntegrationParameters,
    ) {
        for (position, &handle) in groups.order().iter().enumerate() {
            if multibodies.moves(handle.into_raw_parts().0) {
                continue;
            }
            let Some(body) = bodies.get_unnoted_mut(handle) else { continue };
            let (state, motion) = (&self.states[position + 1], &self.motions[position + 1]);
            let bound = match body.body_type {
                RigidBodyType::KinematicPositionBased => move_to(body, body.next_pose, params.dt),
                _ => commit(body, state, motion),
            };
            islands.set_motion(handle.into_raw_parts().0, bound);
        }
    }
}

/// Gives a body the pose and velocity that the solver found. Returns a bound of how far any point of
/// it moved.
///
/// A body whose numbers overflowed stays where it was and comes to rest: one lost body is better than
/// a world of NaN.
fn commit(body: &mut RigidBody, state: &BodyState, motion: &Motion) -> Real {
    let (linvel, angvel) = state.velocity();
    let (shift, turn) = state.displacement();
    let rotation = match motion.gyroscope {
        Some(_) => motion.rotation.normalize(),
        None => integrate_rotation(motion.rotation, turn),
    };
    let center = body.mprops.world_com + shift;
    let pose = Pose::from_parts(center - rotation * body.mprops.local.local_com, rotation);
    let velocity = RigidBodyVelocity::new(linvel, angvel);
    // Neither an infinite turn nor one whose square is infinite leaves a rotation of unit length.
    let Some(pose) = checked_pose(pose).filter(|_| velocity.is_usable()) else {
        log::error!("a rigid body left the range of numbers at {:?} and was stopped", body.pose);
        (body.linvel, body.angvel) = (Vector::ZERO, ANG_ZERO);
        return 0.0;
    };
    (body.linvel, body.angvel) = (linvel, angvel);
    body.pose = pose;
    let old_center = body.mprops.world_com;
    body.update_world_mass_properties();
    // Far from the origin a position has few digits, and it moves by whole steps of these or not at all.
    let rounded = body.mprops.world_com - old_center;
    let shift = if rounded.length_squared() > shift.length_squared() { rounded } else { shift };
    motion_bound(shift, ang_length_squared(turn), body.extent)
}

/// Puts a position-based kinematic body where the user wants it.
fn move_to(body: &mut RigidBody, pose: Pose, dt: Real) -> Real {
    let old_center = body.mprops.world_com;
    body.pose = pose;
    body.update_world_mass_properties();
    let turn = body.angvel * dt;
    motion_bound(body.mprops.world_com - old_center, ang_length_squared(turn), body.extent)
}

/// The centre moved by `shift`; a point at the distance `extent` from it moved by no more than the
/// angle times that distance besides.
fn motion_bound(shift: Vector, turn_squared: Real, extent: Real) -> Real {
    shift.length() + if turn_squared > 0.0 { turn_squared.sqrt() * extent } else { 0.0 }
}

impl Motion {
    /// Neither accelerates nor is damped.
    const AT_REST: Self = Self {
        rotation: Rotation::IDENTITY,
        linear_acceleration: Vector::ZERO,
        angular_acceleration: ANG_ZERO,
        linear_damping: 0.0,
        angular_damping: 0.0,
        bears_weight: true,
        gyroscope: None,
    };

    fn of(body: &mut RigidBody, gravity: Vector, substep: Real) -> Self {
        let (force, torque) = body.take_forces();
        let mprops = &body.mprops;
        // Gravity accelerates whatever can move, with or without mass.
        let free = inv_mass_per_axis(mprops.locked_axes, 1.0);
        let turns_freely = !mprops.locked_axes.intersects(LockedAxes::ROTATION_LOCKED);
        let gyroscope = if body.gyroscopic_forces_enabled && turns_freely {
            Gyroscope::new(&mprops.local, body.angvel, substep)
        } else {
            None
        };
        Self {
            rotation: body.pose.rotation,
            linear_acceleration: gravity * body.gravity_scale * free + force * mprops.inv_mass,
            angular_acceleration: mul_inertia(&mprops.inv_inertia, torque),
            linear_damping: body.linear_damping,
            angular_damping: body.angular_damping,
            bears_weight: gravity * body.gravity_scale != Vector::ZERO,
            gyroscope,
        }
    }

    /// The velocities after `h` seconds without any constraint.
    fn accelerated(
        &mut self,
        v: Vector,
        w: AngVector,
        h: Real,
        speed_max: Real,
    ) -> (Vector, AngVector) {
        // Damping is integrated implicitly: v' = v + h a - h c v' never overshoots zero.
        let v = (v + self.linear_acceleration * h) / (1.0 + h * self.linear_damping);
        let mut w = (w + self.angular_acceleration * h) / (1.0 + h * self.angular_damping);
        if let Some(gyroscope) = &mut self.gyroscope {
            w = gyroscope.velocity_at_middle(self.rotation, w, h);
        }
        (v.clamp_length_max(speed_max), w)
    }

    /// Turns a tumbling body by this rotation vector.
    fn turn(&mut self, turn: AngVector) {
        if self.gyroscope.is_some() {
            self.rotation = integrate_rotation(self.rotation, turn);
        }
    }

    /// Turns a tumbling body, and its angular velocity as its inertia turns.
    fn tumble(&mut self, state: &mut BodyState, before: &mut BodyState, h: Real) {
        let Some(gyroscope) = &mut self.gyroscope else { return };
        let (v, w) = state.velocity();
        self.rotation = integrate_rotation(self.rotation, w * h);
        let end = gyroscope.velocity_at_end(self.rotation, w);
        state.set_velocity(v, end);
        // What turned the velocity was no impulse: the next substep must not start with it, nor with the
        // rounding of it. Where there was no impulse, `before` becomes `end` to the last bit.
        let (before_v, before_w) = before.velocity();
        before.set_velocity(before_v, end - (w - before_w));
    }
}
