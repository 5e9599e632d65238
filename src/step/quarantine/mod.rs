//! # Quarantine: bodies with unusable numbers are disabled, and the step is repeated
//!
//! Reads:   the solver's note of bodies that it could not store, and their user input and joint loads
//! Writes:  enabled flags of bodies; the whole world, restored to the start of the step
//! Runs:    serial, after a failed step; a step at risk begins with a copy of the world
//! Never:   touches a body that the solver could store
//!
//! Numbers overflow: forces add up, motors are stiff beyond reason, speeds grow. A body that is not finite
//! would spread that to all bodies that it touches, and from these to their neighbours. The solver therefore
//! stores no body if it cannot store all of them. This stage finds the [causes] and disables them, as a user
//! would disable them. The step is then repeated without them from the beginning. The failed attempt leaves
//! no impulses, wakes no body and emits no event.
//!
//! **The checkpoint.** By the time when the solver has failed, pairs, islands and colours have followed the
//! step. They are not unwound one by one: that would need a journal of everything that the structure does. A
//! step begins with a [copy of the world](Checkpoint) if it may fail. There are four conditions. The last
//! step left a body faster than [`MODERATE_MAX`] or farther than [`COORDINATE_MODERATE_MAX`]; a body touches
//! a much lighter one; an edit is not [moderate](EDIT_VELOCITY_MAX); or the step is [long](DURATION_MAX).
//! That is rare. Other steps pay for a comparison per number of the solver's states
//! (`src/step/solver/bodies/divergence.rs`). Moderate and non-finite numbers are a factor of 10⁹ apart.
//! Values that grow there grow over several steps, and are detected.
//!
//! A step may fail without such a sign, for example because of an extreme motor that was blocked so far. It
//! is then repeated from the current state: bodies and impulses are unchanged. Numbers are as safe then. But
//! new contacts are coloured already, and sleeping bodies are awake, with the causes still enabled. The order
//! of their contacts may therefore differ.

mod causes;
mod checkpoint;

pub(crate) use checkpoint::Checkpoint;

use crate::base::hash::FastHashMap;
use crate::base::measure::{COORDINATE_MODERATE_MAX, MODERATE_MAX};
use crate::dim::math::{AngVector, Real, Vector, ang_length_squared, mul_inertia};
use crate::model::body::{QuarantineCause, RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::collider::{ColliderHandle, ColliderMassProps, ColliderSet};
use crate::model::contact::NarrowPhase;
use crate::model::event::{CollisionEvent, QuarantineEvent};
use crate::model::island::IslandManager;
use crate::model::joint::{ImpulseJointSet, JointMotor};
use crate::model::multibody::MultibodyJointSet;
use crate::model::params::IntegrationParameters;
use crate::model::tree::BroadPhaseBvh;
use crate::step::notes::StepNotes;
use causes::Causes;

/// A velocity set by the user above this value, or reached within a step, requires a checkpoint (in length
/// units, and radians, per second).
const EDIT_VELOCITY_MAX: Real = 1.0e3;

/// Steps longer than this (s) always have a checkpoint: rotations within them are unpredictable.
const DURATION_MAX: Real = 0.1;

/// All that a step changes.
pub(crate) struct World<'a> {
    pub islands: &'a mut IslandManager,
    pub broad_phase: &'a mut BroadPhaseBvh,
    pub narrow_phase: &'a mut NarrowPhase,
    pub bodies: &'a mut RigidBodySet,
    pub colliders: &'a mut ColliderSet,
    pub joints: &'a mut ImpulseJointSet,
    pub multibodies: &'a mut MultibodyJointSet,
}

/// Gravity and parameters of the step.
#[derive(Copy, Clone)]
pub(crate) struct StepConditions<'a> {
    pub gravity: Vector,
    pub params: &'a IntegrationParameters,
}

/// The bodies that were disabled in this step.
#[derive(Default)]
pub(crate) struct Quarantine {
    taken: Vec<(RigidBodyHandle, QuarantineCause)>,
    /// Number of failed attempts.
    failures: usize,
    /// Number of events that failed attempts emitted.
    emitted: usize,
}

impl Quarantine {
    /// A new step begins.
    pub fn open(&mut self) {
        self.taken.clear();
        self.failures = 0;
        self.emitted = 0;
    }

    /// Disables the causes in a world in which a step has failed, and restores everything else for the
    /// repetition.
    pub fn take_out(
        &mut self,
        mut world: World<'_>,
        checkpoint: Option<&Checkpoint>,
        conditions: StepConditions<'_>,
        notes: &mut StepNotes,
    ) {
        let causes = Causes { world: &world, conditions, diverged: &notes.diverged };
        causes.find(self.failures, &mut self.taken);
        self.failures += 1;
        // The order is that of the handles, so manual disabling of the same bodies gives the same result.
        self.taken.sort_by_key(|(handle, _)| handle.into_raw_parts());
        self.taken.dedup_by_key(|(handle, _)| *handle);
        match checkpoint {
            Some(checkpoint) => {
                checkpoint.restore(&mut world);
                notes.clear();
            }
            None => {
                // All pairs already include the last motion.
                world.islands.forget_motion();
                notes.clear_attempt();
            }
        }
        self.emitted = notes.events.len();
        for &(handle, cause) in &self.taken {
            if let Some(body) = world.bodies.get_mut(handle) {
                body.put_in_quarantine(cause);
            }
        }
    }

    /// Reports the disabled bodies. Returns how many.
    pub fn close(&self, bodies: &RigidBodySet, notes: &mut StepNotes) -> usize {
        if self.failures > 0 {
            cancel_out(&mut notes.events, self.emitted);
        }
        for &(handle, cause) in &self.taken {
            let Some(body) = bodies.get(handle) else { continue };
            log::error!("{handle:?} is disabled, as it cannot be calculated with: {cause}");
            let (position, velocity) = (body.pose, body.vels());
            notes.quarantined.push(QuarantineEvent::Body {
                body: handle,
                cause,
                position,
                velocity,
            });
        }
        self.taken.len()
    }
}

/// Cancels pairs of events: contacts that began in a failed attempt and ended because one body was disabled.
/// Failed attempts emitted the first `emitted` events. Contacts that began later and ended in the same step
/// (a crossed sensor) keep both events.
fn cancel_out(events: &mut Vec<CollisionEvent>, emitted: usize) {
    let mut began = FastHashMap::default();
    let mut is_void = vec![false; events.len()];
    for (index, event) in events.iter().enumerate() {
        let pair = (event.collider1(), event.collider2());
        if event.started() && index < emitted {
            began.insert(pair, index);
        } else if let Some(start) = began.remove(&pair) {
            (is_void[start], is_void[index]) = (true, true);
        }
    }
    let mut is_void = is_void.into_iter();
    events.retain(|_| !is_void.next().unwrap_or_default());
}

/// Returns whether the step that is about to begin may fail.
pub(crate) fn is_at_risk(world: &World<'_>, conditions: StepConditions<'_>) -> bool {
    let World { islands, bodies, colliders, joints, .. } = world;
    let is_ill_conditioned = |&handle: &RigidBodyHandle| {
        bodies.get(handle).is_some_and(|body| !conditions.is_moderate_edit(body))
    };
    let is_heavy = |&handle: &ColliderHandle| {
        colliders.get(handle).is_some_and(|collider| !mass_is_moderate(&collider.mass_props))
    };
    conditions.params.dt > 0.0
        && (islands.ill_conditioned
            || conditions.params.dt > DURATION_MAX
            || !conditions.is_moderate_velocity(conditions.gravity * conditions.params.dt)
            || bodies.modified().iter().any(is_ill_conditioned)
            || colliders.modified().iter().any(is_heavy)
            || joints.modified().any(|(handle, _)| {
                let motors = joints.get(handle).map(|joint| &joint.data.motors);
                motors.is_some_and(|motors| !motors.iter().all(motor_is_moderate))
            }))
}

impl StepConditions<'_> {
    /// Returns whether all user-provided values of a body are moderate, its position included.
    fn is_moderate_edit(self, body: &RigidBody) -> bool {
        let Self { gravity, params } = self;
        let (force, torque) = body.forces();
        let to_target = body.velocity_to_next_position(params.inv_dt());
        let inv_mass = body.mprops.local_mprops.inv_mass;
        let acceleration = gravity * body.gravity_scale + force * inv_mass;
        let twist = mul_inertia(&body.mprops.inv_inertia, torque);
        self.is_moderate_velocity(body.linvel)
            && self.is_moderate_velocity(acceleration * params.dt)
            && self.is_moderate_velocity(to_target.linvel)
            && rotates_moderately(body.angvel)
            && rotates_moderately(twist * params.dt)
            && rotates_moderately(to_target.angvel)
            // The mass of a new body is not yet computed.
            && is_within(force, MODERATE_MAX)
            && ang_length_squared(torque) <= MODERATE_MAX * MODERATE_MAX
            && inv_mass <= MODERATE_MAX
            && is_within(body.pose.translation, COORDINATE_MODERATE_MAX)
    }

    /// Returns whether the value is moderate as a velocity, even in a long step.
    fn is_moderate_velocity(self, velocity: Vector) -> bool {
        is_within(
            velocity * self.params.dt.max(1.0),
            EDIT_VELOCITY_MAX * self.params.length_unit.max(1.0),
        )
    }
}

fn rotates_moderately(velocity: AngVector) -> bool {
    ang_length_squared(velocity) <= EDIT_VELOCITY_MAX * EDIT_VELOCITY_MAX
}

fn is_within(vector: Vector, bound: Real) -> bool {
    vector.abs().max_element() <= bound
}

/// Returns whether masses of this order and their inverses are harmless.
fn mass_is_moderate(mass: &ColliderMassProps) -> bool {
    let value = match mass {
        ColliderMassProps::Density(value) | ColliderMassProps::Mass(value) => *value,
        ColliderMassProps::MassProperties(mass) => mass.inv_mass,
    };
    value == 0.0 || (1.0 / MODERATE_MAX..=MODERATE_MAX).contains(&value)
}

fn motor_is_moderate(motor: &JointMotor) -> bool {
    let numbers = [motor.stiffness, motor.damping, motor.target_pos, motor.target_vel];
    numbers.into_iter().all(|value| value.abs() <= MODERATE_MAX)
}

#[cfg(test)]
mod tests {
    use super::cancel_out;
    use crate::model::collider::ColliderHandle;
    use crate::model::event::{CollisionEvent, CollisionEventFlags};

    fn pair(slot: u32) -> (ColliderHandle, ColliderHandle, CollisionEventFlags) {
        let other = ColliderHandle::from_raw_parts(slot, 0);
        (ColliderHandle::from_raw_parts(99, 0), other, CollisionEventFlags::empty())
    }

    fn started(slot: u32) -> CollisionEvent {
        let (collider1, collider2, flags) = pair(slot);
        CollisionEvent::Started(collider1, collider2, flags)
    }

    fn stopped(slot: u32) -> CollisionEvent {
        let (collider1, collider2, flags) = pair(slot);
        CollisionEvent::Stopped(collider1, collider2, flags)
    }

    #[test]
    fn what_began_and_stopped_in_attempts_did_neither() {
        let mut events = vec![
            stopped(1),
            started(2),
            started(3),
            stopped(2),
            stopped(4),
            started(4),
            started(5),
        ];
        events.extend([stopped(4), stopped(3), started(1)]);
        cancel_out(&mut events, 7);
        assert_eq!(events, [stopped(1), stopped(4), started(5), started(1)]);
    }

    /// The begin event was not cancelled: the contact existed before, and has ended.
    #[test]
    fn what_is_passed_after_all_attempts_is_told() {
        let mut events = vec![started(1), stopped(1), started(2), stopped(2)];
        cancel_out(&mut events, 1);
        assert_eq!(events, [started(2), stopped(2)]);
    }
}
