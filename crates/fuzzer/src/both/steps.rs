//! Steps, with user code during them: hooks and handlers that reject pairs, change contacts, and panic.

use super::play::Play;
use super::rapier::prelude::*;
use super::values::some_real;
use super::world::check;
use crate::deliberate_panic::{completes, panic_deliberately};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Number of steps in a row.
const STEPS: usize = 40;

/// Runs a step of any variant and checks the world afterwards. Returns the number of steps.
pub fn step(play: &mut Play<'_>) -> usize {
    let variant = play.choices.below(40);
    let hooks = RandomHooks::new(play);
    play.choices.print(|| format!("step {variant}, hooks {}", hooks.behavior));
    let count = if variant == 0 { STEPS } else { 1 };
    let mut completed = true;
    play.isolated_bodies.note_attachments(&play.world);
    for _ in 0..count {
        completed &= completes(|| match variant {
            1 | 2 => play.world.detect_collisions(&hooks, &play.event_checker),
            3 => detect_without_changes(&mut play.world, &hooks, &play.event_checker),
            4 => step_with_new_pipeline(&mut play.world, &hooks, &play.event_checker),
            5 => play.world.step_with_events(&hooks, &PanickingHandler),
            _ => play.world.step_with_events(&hooks, &play.event_checker),
        });
    }
    if !completed || variant == 5 {
        play.event_checker.mark_missed_events(); // some events are lost
    }
    // Without the edits the world is out of date, and an interrupted or rejected step has not processed them.
    let refused =
        play.world.integration_parameters.validate().is_err() || !is_possible(play.world.gravity);
    if completed && !refused && variant != 3 {
        check(&play.world);
    }
    play.event_checker.check();
    play.isolated_bodies.note_attachments(&play.world);
    play.isolated_bodies.check(&play.world);
    if refused {
        play.reset_parameters();
    }
    count
}

fn is_possible(gravity: Vector) -> bool {
    gravity.is_finite() && gravity.abs().max_element() <= 1.0e15
}

fn detect_without_changes(
    world: &mut PhysicsWorld,
    hooks: &dyn PhysicsHooks,
    events: &dyn EventHandler,
) {
    world.collision_pipeline.step(
        &world.integration_parameters,
        &mut world.islands,
        &mut world.broad_phase,
        &mut world.narrow_phase,
        &mut world.bodies,
        &mut world.colliders,
        &world.impulse_joints,
        &world.multibody_joints,
        hooks,
        events,
        false,
    );
}

fn step_with_new_pipeline(
    world: &mut PhysicsWorld,
    hooks: &dyn PhysicsHooks,
    events: &dyn EventHandler,
) {
    let mut pipeline = PhysicsPipeline::new();
    pipeline.set_wide_instructions(false);
    pipeline.step(
        world.gravity,
        &world.integration_parameters,
        &mut world.islands,
        &mut world.broad_phase,
        &mut world.narrow_phase,
        &mut world.bodies,
        &mut world.colliders,
        &mut world.impulse_joints,
        &mut world.multibody_joints,
        hooks,
        events,
    );
}

/// Hooks with different results at every call.
struct RandomHooks {
    calls: AtomicUsize,
    /// Index of the call that panics.
    last: usize,
    behavior: usize,
    number: Real,
}

impl RandomHooks {
    fn new(play: &mut Play<'_>) -> Self {
        let choices = &mut play.choices;
        let behavior = choices.below(24);
        let last = if behavior == 23 { choices.below(20) } else { usize::MAX };
        let number = if behavior > 16 { some_real(choices) } else { 1.0 };
        Self { calls: AtomicUsize::new(0), last, behavior, number }
    }

    fn next(&self) -> usize {
        let call = self.calls.fetch_add(1, Relaxed);
        if call >= self.last {
            panic_deliberately();
        }
        call
    }
}

impl PhysicsHooks for RandomHooks {
    fn filter_contact_pair(&self, context: &PairFilterContext<'_>) -> bool {
        let both_exist = context.colliders.contains(context.collider1)
            && context.colliders.contains(context.collider2)
            && [context.rigid_body1, context.rigid_body2]
                .iter()
                .flatten()
                .all(|&body| context.bodies.contains(body));
        assert!(both_exist, "a hook was called with objects that do not exist");
        !(self.next() + self.behavior).is_multiple_of(3)
    }

    fn filter_intersection_pair(&self, context: &PairFilterContext<'_>) -> bool {
        self.filter_contact_pair(context)
    }

    fn modify_solver_contact(&self, context: &mut ContactModificationContext<'_>) {
        let call = self.next();
        match (call + self.behavior) % 8 {
            0 => context.clear_contacts(),
            1 => context.retain_contacts(|contact| contact.point.x > 0.0),
            2 => context.set_friction(self.number),
            3 => context.set_restitution(self.number),
            4 => context.set_tangent_velocity(Vector::X * self.number),
            5 => context.update_as_oneway_platform(Vector::Y, self.number),
            6 => context.set_user_data(call as u32),
            _ => context.set_solver_flags(SolverFlags::from_bits_retain(call as u32)),
        }
    }
}

/// Handler that panics at the first event.
struct PanickingHandler;

impl EventHandler for PanickingHandler {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        panic_deliberately();
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        _: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
        panic_deliberately();
    }

    fn handle_joint_break_event(&self, _: &JointBreakEvent, _: &RigidBodySet) {
        panic_deliberately();
    }
}
