//! Causes of a failed step: the bodies to disable when several bodies diverged together.
//!
//! The first candidates are bodies that diverge on their own: by their position, velocity, mass, or external
//! forces. Without them, the other bodies may be sound.
//!
//! There may be no single cause: a motor stiffer than the range of numbers, or a mass ratio beyond the
//! precision. In this case the most *stressed* body of each island is selected: the one with the largest
//! displacement within the step under its own loads. Disabling it removes its joints and contacts from the
//! equations. It is the end of a causal chain more often than its beginning. Any choice that splits the group
//! works, and this one depends on the group alone.
//!
//! Each round costs a step. After [`ROUNDS_MAX`] of them all diverged bodies are disabled, and after twice as
//! many all awake bodies. Then nothing moves, and the step cannot fail.

use crate::base::measure::MODERATE_MAX;
use crate::dim::math::{AngVector, Real, Vector, ang_length_squared, mul_inertia};
use crate::model::body::{
    QuarantineCause, RigidBody, RigidBodyHandle, RigidBodyType, RigidBodyVelocity,
};
use crate::model::check::{checked_pose, checked_rotation};
use crate::model::joint::JointMotor;
use crate::step::notes::Diverged;
use crate::step::world::World;

/// Number of rounds in which the most stressed bodies are selected one by one.
const ROUNDS_MAX: usize = 4;

/// A body and the cause of its quarantine.
type Cause = (RigidBodyHandle, QuarantineCause);

/// A failed step.
pub(super) struct Causes<'a> {
    pub world: &'a World<'a>,
    pub diverged: &'a [Diverged],
}

impl Causes<'_> {
    /// Adds the bodies to disable after the step has failed `failures` times before.
    pub fn find(&self, failures: usize, taken: &mut Vec<Cause>) {
        let known = taken.len();
        if failures >= 2 * ROUNDS_MAX {
            let awake = self.world.structure.islands.awake.iter();
            let at_rest = RigidBodyVelocity::zero();
            let all = awake.map(|&body| Diverged { body, velocity: at_rest, is_link: false });
            return all.for_each(|diverged| self.take(&diverged, taken));
        }
        for diverged in self.diverged {
            // The first diverged link of a multibody is unknown.
            let links = if diverged.is_link { self.group_of(diverged.body) } else { &[] };
            let suspects = core::iter::once(&diverged.body).chain(links);
            let mut causes = suspects.filter_map(|&suspect| {
                Some((suspect, self.cause_in(self.world.structure.bodies.get(suspect)?)?))
            });
            if let Some((body, cause)) = causes.next() {
                self.take_with_group(body, cause, taken);
            }
        }
        if taken.len() > known {
            return;
        }
        if failures >= ROUNDS_MAX {
            return self.diverged.iter().for_each(|diverged| self.take(diverged, taken));
        }
        for diverged in self.most_stressed() {
            self.take(diverged, taken);
        }
    }

    /// Adds the edited bodies that move in this step and diverge on their own. Links move with the
    /// coordinates of their multibody.
    pub fn find_in_edits(&self, taken: &mut Vec<Cause>) {
        let World { structure, multibodies, params, .. } = self.world;
        let moves = |body: &RigidBody| {
            params.dt > 0.0 && body.is_enabled() && !body.is_fixed() && !body.is_sleeping()
        };
        let causes = structure.bodies.modified().iter().filter_map(|&handle| {
            let body = structure.bodies.get(handle)?;
            if !moves(body) || self.is_moderate(body) {
                return None;
            }
            let cause = self.cause_in(body)?;
            multibodies.rigid_body_link(handle).is_none().then_some((handle, cause))
        });
        taken.extend(causes);
    }

    /// Returns whether the numbers of a body are far too small to overflow within this step, as after nearly
    /// every edit. Such a body needs no predicted poses.
    fn is_moderate(&self, body: &RigidBody) -> bool {
        let &World { gravity, params, .. } = self.world;
        let is_small = |squared: Real| squared <= MODERATE_MAX * MODERATE_MAX;
        let Accelerations { by_gravity, by_force, by_torque } = Accelerations::of(body, gravity);
        let vectors = [
            body.pose.translation,
            body.mprops.local_mprops.local_com,
            body.vels.linvel,
            (by_gravity + by_force) * params.dt,
        ];
        params.dt <= 1.0
            && body.body_type != RigidBodyType::KinematicPositionBased
            && checked_rotation(body.pose.rotation).is_some()
            && body.mprops.inv_mass.is_finite()
            && vectors.into_iter().all(|vector| is_small(vector.length_squared()))
            && [body.vels.angvel, by_torque * params.dt]
                .into_iter()
                .all(|vector| is_small(ang_length_squared(vector)))
    }

    fn body(&self, diverged: &Diverged) -> Option<&RigidBody> {
        self.world.structure.bodies.get(diverged.body)
    }

    fn take(&self, diverged: &Diverged, taken: &mut Vec<Cause>) {
        let cause = match diverged.is_link {
            true => QuarantineCause::Multibody(diverged.velocity),
            false => QuarantineCause::Constraints(diverged.velocity),
        };
        self.take_with_group(diverged.body, cause, taken);
    }

    /// Selects a body, and with a link all moving links: the rest of a multibody would fall apart.
    fn take_with_group(
        &self,
        body: RigidBodyHandle,
        cause: QuarantineCause,
        taken: &mut Vec<Cause>,
    ) {
        let moves = |link: &&RigidBodyHandle| {
            self.world.structure.bodies.get(**link).is_some_and(RigidBody::is_dynamic)
        };
        taken.push((body, cause));
        let others = self.group_of(body).iter().filter(moves).filter(|link| **link != body);
        taken.extend(others.map(|&link| (link, cause)));
    }

    fn group_of(&self, body: RigidBodyHandle) -> &[RigidBodyHandle] {
        self.world.structure.islands.groups.of(body.into_raw_parts().0)
    }

    // ---- Causes ----

    /// The cause for which a body diverges on its own.
    fn cause_in(&self, body: &RigidBody) -> Option<QuarantineCause> {
        let &World { gravity, params, .. } = self.world;
        if checked_pose(body.pose).is_none() {
            return Some(QuarantineCause::Position(body.pose));
        }
        if !body.mprops.inv_mass.is_finite() {
            return Some(QuarantineCause::Mass(body.mprops.inv_mass));
        }
        if body.body_type == RigidBodyType::KinematicPositionBased {
            let velocity = body.velocity_to_next_position(params.inv_dt());
            let target = QuarantineCause::KinematicTarget(body.next_pose);
            return (!velocity.is_usable()).then_some(target);
        }
        if !self.stays_finite(body, body.vels) {
            return Some(QuarantineCause::Velocity(body.vels));
        }
        let Accelerations { by_gravity, by_force, by_torque } = Accelerations::of(body, gravity);
        let after = |linear: Vector, angular: AngVector| RigidBodyVelocity {
            linvel: body.vels.linvel + linear * params.dt,
            angvel: body.vels.angvel + angular * params.dt,
        };
        if !self.stays_finite(body, after(by_gravity, Default::default())) {
            return Some(QuarantineCause::Gravity(gravity * body.gravity_scale));
        }
        if !self.stays_finite(body, after(by_gravity + by_force, by_torque)) {
            let (force, torque) = body.forces();
            return Some(QuarantineCause::Force { force, torque });
        }
        None
    }

    /// Returns whether a body with this velocity stays finite within the step.
    fn stays_finite(&self, body: &RigidBody, velocity: RigidBodyVelocity) -> bool {
        let dt = self.world.params.dt;
        let velocity = self.integrated(body, velocity);
        let pose = velocity.integrate(dt, &body.pose, body.mprops.local_mprops.local_com);
        velocity.is_usable() && checked_pose(pose).is_some()
    }

    /// The velocity with which the solver integrates the pose: that of a dynamic body is damped, and limited
    /// to the largest speed.
    fn integrated(&self, body: &RigidBody, velocity: RigidBodyVelocity) -> RigidBodyVelocity {
        if !body.is_dynamic() {
            return velocity;
        }
        let params = self.world.params;
        let damped = velocity.apply_damping(params.dt, body.linear_damping, body.angular_damping);
        let linvel = damped.linvel.clamp_length_max(params.max_linear_velocity());
        RigidBodyVelocity { linvel, ..damped }
    }

    /// The most stressed body of each island.
    fn most_stressed(&self) -> Vec<&Diverged> {
        let ranked = self.diverged.iter().filter_map(|diverged| {
            let body = self.body(diverged)?;
            Some((body.link.island, self.stress_of(diverged), diverged))
        });
        let mut ranked: Vec<_> = ranked.collect();
        // The sort is stable, so the solver's order decides between equals.
        ranked.sort_by(|a, b| a.0.cmp(&b.0).then_with(|| b.1.total_cmp(&a.1)));
        ranked.dedup_by_key(|(island, ..)| *island);
        ranked.into_iter().map(|(.., diverged)| diverged).collect()
    }

    /// The stress of a body, or of the most stressed link of a multibody.
    fn stress_of(&self, diverged: &Diverged) -> Real {
        let links = if diverged.is_link { self.group_of(diverged.body) } else { &[] };
        let stresses = core::iter::once(&diverged.body).chain(links).filter_map(|&handle| {
            Some(self.stress_of_body(handle, self.world.structure.bodies.get(handle)?))
        });
        stresses.fold(0.0, larger)
    }

    /// Largest displacement (length units) of a point of the body within a step by any single load.
    fn stress_of_body(&self, handle: RigidBodyHandle, body: &RigidBody) -> Real {
        let dt = self.world.params.dt;
        let Accelerations { by_gravity, by_force, by_torque } =
            Accelerations::of(body, self.world.gravity);
        let by_motors = self.motor_force_max(handle) * body.mprops.local_mprops.inv_mass;
        let length = |angular| ang_length_squared(angular).sqrt() * body.extent;
        let speeds = [body.vels.linvel.length(), length(body.vels.angvel)];
        let accelerations = [(by_gravity + by_force).length(), length(by_torque), by_motors];
        let displacements = speeds.map(|speed| speed * dt).into_iter();
        let displacements = displacements.chain(accelerations.map(|a| a * dt * dt));
        displacements.fold(0.0, larger)
    }

    /// The largest force of a motor that holds a body, a unit of length or velocity away from its target.
    fn motor_force_max(&self, handle: RigidBodyHandle) -> Real {
        let (islands, joints) = (&self.world.structure.islands, &self.world.joints);
        let slots = islands.joints.of_body(handle.into_raw_parts().0).iter();
        let links = slots.filter_map(|&slot| islands.joints.get(slot));
        let motors = links.filter_map(|link| joints.get(link.handle)).flat_map(|joint| {
            let driven = joint.data.driven_axes();
            driven.map(|axis| &joint.data.motors[axis as usize])
        });
        let force = |motor: &JointMotor| {
            let [away, slow] =
                [motor.target_pos, motor.target_vel].map(|target| target.abs() + 1.0);
            (motor.stiffness * away + motor.damping * slow).min(motor.max_force)
        };
        motors.map(force).fold(0.0, Real::max)
    }
}

/// The larger of two numbers that are not negative; NaN counts as the largest.
fn larger(a: Real, b: Real) -> Real {
    if b <= a { a } else { b.abs() }
}

/// Accelerations of a body by gravity and by the user's forces.
struct Accelerations {
    by_gravity: Vector,
    by_force: Vector,
    by_torque: AngVector,
}

impl Accelerations {
    fn of(body: &RigidBody, gravity: Vector) -> Self {
        if !body.is_dynamic() {
            let (by_gravity, by_force) = (Vector::ZERO, Vector::ZERO);
            return Self { by_gravity, by_force, by_torque: Default::default() };
        }
        let mprops = &body.mprops;
        let (force, torque) = body.forces();
        Self {
            by_gravity: body.gravitational_acceleration(gravity),
            by_force: force * mprops.inv_mass,
            by_torque: mul_inertia(&mprops.inv_inertia, torque),
        }
    }
}
