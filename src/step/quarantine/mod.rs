//! # Quarantine — who leaves the range of numbers is taken out, and the step taken again
//!
//! Reads:   the solver's note of bodies that it could not store, and what these were given by the user and by joints
//! Writes:  which bodies take part; the whole world, back to what it was when the step began
//! Runs:    serial, when a step has failed; a world at risk is copied before
//! Never:   touches a body that the solver could store
//!
//! Numbers overflow: forces add up, motors are stiff beyond reason, speeds grow. A body whose numbers are none would pass
//! this on to all that it touches, and these to all that they touch. So the solver stores nobody if it cannot store
//! everybody. Here the [culprits] are found and disabled, as a user would disable them, and the step is taken again
//! without them: from the beginning, as if they had been disabled before it. What they hit in this step was not hit, what
//! they woke sleeps, and no event tells of it.
//!
//! **The way back.** By the time when the solver has failed, pairs, islands and colours have followed the step. They are not
//! unwound one by one: that would need a journal of everything that the structure does. Instead a step is begun with a
//! [copy of the world](WayBack) when it might fail: after a step that left a body faster than [`CALM`] or farther than
//! [`FAR`], or when the user has just given such numbers to a body or to a joint's motor. That is rare, and a step that
//! nobody is at risk in pays for a comparison per number of the solver's states (`src/step/solver/bodies/survey.rs`). From calm
//! numbers to impossible ones it is a factor of ten million: what grows there grows over several steps, and is seen.
//!
//! Should a step fail all the same that nobody foresaw (a motor that was never calm, held until now), it is taken again
//! from where it is: bodies and, but for those of [groups](crate::step::solver) that were solved before, impulses are as
//! they were. Numbers are as safe then. But new contacts have been coloured, and sleepers woken, with the culprits still
//! there, and so the rest is the same only up to the order in which the solver visits it.

mod culprits;
mod way_back;

pub(crate) use way_back::WayBack;

use crate::base::measure::{CALM, FAR};
use crate::dim::math::{Real, Vector, ang_length_squared};
use crate::model::body::{QuarantineCause, RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::collider::ColliderSet;
use crate::model::contact::NarrowPhase;
use crate::model::event::QuarantineEvent;
use crate::model::island::IslandManager;
use crate::model::joint::{ImpulseJointSet, JointMotor};
use crate::model::multibody::MultibodyJointSet;
use crate::model::params::IntegrationParameters;
use crate::model::tree::BroadPhaseBvh;
use crate::step::notes::StepNotes;
use culprits::Culprits;

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

/// What bodies move in.
#[derive(Copy, Clone)]
pub(crate) struct Conditions<'a> {
    pub gravity: Vector,
    pub params: &'a IntegrationParameters,
}

/// Who has been taken out in this step.
#[derive(Default)]
pub(crate) struct Quarantine {
    taken: Vec<(RigidBodyHandle, QuarantineCause)>,
    /// How often the step has failed.
    failures: usize,
}

impl Quarantine {
    /// A new step begins.
    pub fn open(&mut self) {
        self.taken.clear();
        self.failures = 0;
    }

    /// Takes culprits out of a world in which a step has failed, and puts everything else back for it to be taken again.
    pub fn take_out(
        &mut self,
        mut world: World<'_>,
        way_back: Option<&WayBack>,
        conditions: Conditions<'_>,
        notes: &mut StepNotes,
    ) {
        let culprits = Culprits { world: &world, conditions, lost: &notes.lost };
        culprits.find(self.failures, &mut self.taken);
        self.failures += 1;
        // Not in the order in which they were found: a user who disables the same bodies need not know it.
        self.taken.sort_by_key(|(handle, _)| handle.into_raw_parts());
        self.taken.dedup_by_key(|(handle, _)| *handle);
        match way_back {
            Some(way_back) => {
                way_back.restore(&mut world);
                notes.clear();
            }
            None => {
                // All pairs have heard of the last motion.
                world.islands.forget_motion();
                notes.clear_attempt();
            }
        }
        for &(handle, cause) in &self.taken {
            if let Some(body) = world.bodies.get_mut(handle) {
                body.put_in_quarantine(cause);
            }
        }
    }

    /// Tells who was taken out. Returns how many.
    pub fn close(&self, bodies: &RigidBodySet, notes: &mut StepNotes) -> usize {
        for &(handle, cause) in &self.taken {
            let Some(body) = bodies.get(handle) else { continue };
            log::error!("{handle:?} is disabled, as it cannot be calculated with: {cause}");
            let (position, velocity) = (body.pose, body.vels());
            notes.quarantined.push(QuarantineEvent::Body { body: handle, cause, position, velocity });
        }
        self.taken.len()
    }
}

/// Might the step that is about to begin fail?
pub(crate) fn is_at_risk(world: &World<'_>, conditions: Conditions<'_>) -> bool {
    let World { islands, bodies, joints, .. } = world;
    let dt = conditions.params.dt;
    // Free fall alone.
    let fall = conditions.gravity.abs().max_element() * dt * dt.max(1.0);
    let is_strained = |&handle: &RigidBodyHandle| {
        bodies.get(handle).is_some_and(|body| !is_calm(body, conditions))
    };
    dt > 0.0
        && (islands.strained
            || fall > CALM
            || bodies.modified().iter().any(is_strained)
            || joints.modified().any(|(handle, _)| {
                let motors = joints.get(handle).map(|joint| &joint.data.motors);
                motors.is_some_and(|motors| !motors.iter().all(motor_is_calm))
            }))
}

/// Is everything that moves a body calm, and the body near?
fn is_calm(body: &RigidBody, Conditions { gravity, params }: Conditions<'_>) -> bool {
    let (force, torque) = body.forces();
    let velocity = body.velocity_to_next_position(params.inv_dt());
    let calm = |value: Real| value.abs() <= CALM;
    let all_calm = |vector: Vector| calm(vector.abs().max_element());
    let turns_calmly = |turn| ang_length_squared(turn) <= CALM * CALM;
    let acceleration = gravity * body.gravity_scale + force * body.mprops.local.inv_mass;
    all_calm(body.linvel * params.dt.max(1.0))
        && turns_calmly(body.angvel)
        && all_calm(force)
        && turns_calmly(torque)
        && all_calm(acceleration * (params.dt * params.dt.max(1.0)))
        && all_calm(velocity.linvel)
        && turns_calmly(velocity.angvel)
        && calm(body.mprops.local.inv_mass)
        && body.pose.translation.abs().max_element() <= FAR
}

fn motor_is_calm(motor: &JointMotor) -> bool {
    let numbers = [motor.stiffness, motor.damping, motor.target_pos, motor.target_vel];
    numbers.into_iter().all(|value| value.abs() <= CALM)
}
