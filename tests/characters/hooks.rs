//! "My one-way platforms do not work for characters", "it bumps into what it should pass."

use super::stage::{CAPSULE, DT, FOOT, GAP_TOLERANCE, OFFSET, Walker, level};
use crate::dim::{cuboid, vec};
use rapier::control::*;
use rapier::prelude::*;

/// One-way platform. The same hook acts on bodies: see `api::hooks`.
struct OneWay {
    platform: ColliderHandle,
}

impl PhysicsHooks for OneWay {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        let up = if context.collider1 == self.platform { Vector::Y } else { -Vector::Y };
        context.update_as_oneway_platform(up, 0.2);
    }

    fn filter_contact_pair(&self, context: &PairFilterContext) -> bool {
        assert_eq!(context.rigid_body2, context.colliders[context.collider2].parent());
        context.colliders[context.collider1].user_data != 7
    }
}

/// Moves the character with hooks, and records whether it is grounded.
fn step(walker: &mut Walker, hooks: &OneWay, contacts: &mut CharacterContacts, velocity: Vector) {
    let filter = QueryFilter::default().exclude_rigid_body(walker.body);
    let collider = &walker.world.colliders[walker.collider];
    let movement = walker.controller.move_shape_with_hooks(
        DT,
        &walker.world.query_pipeline_with_filter(filter),
        collider.shape(),
        collider.position(),
        velocity * DT,
        CharacterHooks {
            hooks,
            bodies: &walker.world.bodies,
            character: walker.collider,
            contacts,
        },
        |_| (),
    );
    walker.grounded = movement.grounded;
    let next = walker.place() + movement.translation;
    walker.world.bodies[walker.body].set_next_kinematic_translation(next);
    walker.world.step();
}

fn with_platform(hooks: ActiveHooks) -> (Walker, OneWay) {
    let mut world = level();
    let platform = cuboid(2.0, 0.1).translation(vec(0.0, 2.5)).active_hooks(hooks);
    let platform = world.insert_collider(platform, None);
    (Walker::new(world, vec(0.0, 1.0)), OneWay { platform })
}

#[test]
fn one_way_platforms_are_jumped_through_and_stood_on() {
    let (mut walker, hooks) = with_platform(ActiveHooks::MODIFY_SOLVER_CONTACTS);
    let mut contacts = CharacterContacts::new();
    let mut velocity = 9.0;
    let mut last = walker.place().y;
    for _ in 0..180 {
        velocity = if walker.grounded { 0.0 } else { velocity } - 9.81 * DT;
        step(&mut walker, &hooks, &mut contacts, vec(0.3, velocity));
        let moved = walker.place().y - last;
        // Inside the platform, the character is neither pushed out nor stopped.
        assert!(
            (moved - velocity * DT).abs() < OFFSET + GAP_TOLERANCE || walker.grounded,
            "{moved}"
        );
        last = walker.place().y;
    }
    let feet = walker.feet() - 2.6;
    assert!(walker.grounded && (feet - OFFSET).abs() < GAP_TOLERANCE, "feet at {feet}");
}

#[test]
fn a_platform_without_hooks_is_solid() {
    let (mut walker, hooks) = with_platform(ActiveHooks::empty());
    let mut contacts = CharacterContacts::new();
    for _ in 0..10 {
        step(&mut walker, &hooks, &mut contacts, vec(0.0, 9.0));
    }
    let head = walker.place().y + FOOT;
    assert!((head - 2.4 + OFFSET).abs() < GAP_TOLERANCE, "head at {head}");
}

/// A jump that is too low does not stop halfway at the platform: the character falls back.
#[test]
fn a_jump_that_is_too_low_falls_back() {
    let (mut walker, hooks) = with_platform(ActiveHooks::MODIFY_SOLVER_CONTACTS);
    let mut contacts = CharacterContacts::new();
    let mut velocity = 5.5;
    for _ in 0..120 {
        velocity = if walker.grounded { 0.0 } else { velocity } - 9.81 * DT;
        step(&mut walker, &hooks, &mut contacts, vec(0.0, velocity));
    }
    assert!((walker.feet() - OFFSET).abs() < GAP_TOLERANCE, "feet at {}", walker.feet());
}

#[test]
fn pairs_that_a_hook_rejects_do_not_touch() {
    for hooked in [true, false] {
        let mut world = level();
        let ghost = cuboid(0.5, 2.0).translation(vec(2.0, 2.0)).user_data(7);
        let flags = if hooked { ActiveHooks::FILTER_CONTACT_PAIRS } else { ActiveHooks::empty() };
        world.insert_collider(ghost.active_hooks(flags), None);
        let mut walker = Walker::new(world, vec(0.0, FOOT + OFFSET));
        let hooks = OneWay { platform: ColliderHandle::invalid() };
        let mut contacts = CharacterContacts::new();
        for _ in 0..120 {
            step(&mut walker, &hooks, &mut contacts, vec(2.0, -0.1));
        }
        let expected = if hooked { 4.0 } else { 1.5 - CAPSULE.1 - OFFSET };
        assert!((walker.place().x - expected).abs() < 0.01, "{}", walker.place());
    }
}

#[test]
fn filters_groups_and_sensors_are_respected() {
    let mut world = level();
    let group = |n| InteractionGroups::new(Group::from_bits_retain(n), Group::ALL);
    world.insert_collider(cuboid(0.5, 2.0).translation(vec(2.0, 2.0)).sensor(true), None);
    let red = cuboid(0.5, 2.0).translation(vec(4.0, 2.0)).collision_groups(group(1));
    world.insert_collider(red, None);
    let blue = cuboid(0.5, 2.0).translation(vec(7.0, 2.0)).collision_groups(group(2));
    world.insert_collider(blue.user_data(5), None);
    let mut walker = Walker::new(world, vec(0.0, FOOT + OFFSET));
    for (filter, stop) in [
        (QueryFilter::default(), 3.5),
        (QueryFilter::from(InteractionGroups::new(Group::ALL, Group::from_bits_retain(2))), 6.5),
    ] {
        for _ in 0..300 {
            let filter = filter.exclude_rigid_body(walker.body);
            let collider = &walker.world.colliders[walker.collider];
            let movement = walker.controller.move_shape(
                DT,
                &walker.world.query_pipeline_with_filter(filter),
                collider.shape(),
                collider.position(),
                vec(0.05, 0.0),
                |_| (),
            );
            let next = walker.place() + movement.translation;
            walker.world.bodies[walker.body].set_next_kinematic_translation(next);
            walker.world.step();
        }
        let x = walker.place().x + CAPSULE.1 + OFFSET;
        assert!((x - stop).abs() < 0.01, "stops at {x}, not {stop}");
    }
}
