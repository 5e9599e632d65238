//! Steps, and what the user does during them: hooks and handlers that refuse, change things, and panic.

use super::play::Play;
use super::rapier::prelude::*;
use super::values::some_real;
use super::world::check;
use crate::farewell::{comes_to_its_end, leave};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Steps in a row.
const MANY: usize = 40;

/// A step, of whichever kind, and a look at the world afterwards. Returns how many steps were taken.
pub fn step(play: &mut Play<'_>) -> usize {
    let manner = play.choices.below(40);
    let hooks = Moody::new(play);
    play.choices.tell(|| format!("step {manner} in mood {}", hooks.mood));
    let count = if manner == 0 { MANY } else { 1 };
    let mut in_order = true;
    play.bystanders.look(&play.world);
    for _ in 0..count {
        in_order &= comes_to_its_end(|| match manner {
            1 | 2 => play.world.detect_collisions(&hooks, &play.witness),
            3 => detect_without_changes(&mut play.world, &hooks, &play.witness),
            4 => step_with_new_pipeline(&mut play.world, &hooks, &play.witness),
            5 => play.world.step_with_events(&hooks, &Leaver),
            _ => play.world.step_with_events(&hooks, &play.witness),
        });
    }
    if !in_order || manner == 5 {
        play.witness.lose_track(); // of the events that nobody heard
    }
    // Without the edits nothing is up to date, and a step that was left early or refused has not seen them.
    let refused =
        play.world.integration_parameters.validate().is_err() || !is_possible(play.world.gravity);
    if in_order && !refused && manner != 3 {
        check(&play.world);
    }
    play.witness.check();
    play.bystanders.look(&play.world);
    play.bystanders.check(&play.world);
    if refused {
        play.calm_down();
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

/// Hooks that do something else at every call.
struct Moody {
    calls: AtomicUsize,
    /// The call that is left early.
    last: usize,
    mood: usize,
    number: Real,
}

impl Moody {
    fn new(play: &mut Play<'_>) -> Self {
        let choices = &mut play.choices;
        let mood = choices.below(24);
        let last = if mood == 23 { choices.below(20) } else { usize::MAX };
        let number = if mood > 16 { some_real(choices) } else { 1.0 };
        Self { calls: AtomicUsize::new(0), last, mood, number }
    }

    fn next(&self) -> usize {
        let call = self.calls.fetch_add(1, Relaxed);
        if call >= self.last {
            leave();
        }
        call
    }
}

impl PhysicsHooks for Moody {
    fn filter_contact_pair(&self, context: &PairFilterContext<'_>) -> bool {
        let both_exist = context.colliders.contains(context.collider1)
            && context.colliders.contains(context.collider2)
            && [context.rigid_body1, context.rigid_body2]
                .iter()
                .flatten()
                .all(|&body| context.bodies.contains(body));
        assert!(both_exist, "a hook is asked about what does not exist");
        !(self.next() + self.mood).is_multiple_of(3)
    }

    fn filter_intersection_pair(&self, context: &PairFilterContext<'_>) -> bool {
        self.filter_contact_pair(context)
    }

    fn modify_solver_contact(&self, context: &mut ContactModificationContext<'_>) {
        let call = self.next();
        match (call + self.mood) % 8 {
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

/// Leaves at the first event.
struct Leaver;

impl EventHandler for Leaver {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        leave();
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        _: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
        leave();
    }

    fn handle_joint_break_event(&self, _: &JointBreakEvent, _: &RigidBodySet) {
        leave();
    }
}
