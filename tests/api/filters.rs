//! Interaction groups and body types: colliding pairs, and pairs without contacts.

use super::stage::{Protocol, add_box, height, plain, steps, with_events, world_with_ground};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// Drops a box onto the ground, both with these groups. Returns whether the box rests on the ground, and the
/// collision events.
fn drop_with(
    set: fn(&mut Collider, InteractionGroups),
    ground_groups: InteractionGroups,
    box_groups: InteractionGroups,
) -> (bool, Vec<CollisionEvent>) {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.6), with_events);
    set(&mut world.colliders[ground], ground_groups);
    set(&mut world.colliders[collider], box_groups);
    let protocol = Protocol::default();
    let events = protocol.of_steps(&mut world, 60);
    (height(&world, body) > 0.4, events)
}

const LEVEL: InteractionGroups = InteractionGroups::new(Group::GROUP_1, Group::GROUP_2);
const PLAYER: InteractionGroups = InteractionGroups::new(Group::GROUP_2, Group::GROUP_1);
const GHOST: InteractionGroups = InteractionGroups::new(Group::GROUP_3, Group::GROUP_1);

#[test]
fn collision_groups_filter_pairs() {
    let set = Collider::set_collision_groups;
    let (held, events) = drop_with(set, LEVEL, PLAYER);
    assert!(held && events.len() == 1);
    let (held, events) = drop_with(set, LEVEL, GHOST);
    assert!(!held && events.is_empty(), "the level rejects ghosts");
    let either = InteractionTestMode::Or;
    let (held, _) = drop_with(set, LEVEL.with_test_mode(either), GHOST.with_test_mode(either));
    assert!(held, "one request is enough if both groups agree");
    let (held, events) = drop_with(set, InteractionGroups::all(), InteractionGroups::none());
    assert!(!held && events.is_empty());
}

#[test]
fn solver_groups_filter_forces_but_not_events() {
    let set = Collider::set_solver_groups;
    let (held, events) = drop_with(set, LEVEL, PLAYER);
    assert!(held && events.len() == 1);
    let (held, events) = drop_with(set, LEVEL, GHOST);
    assert!(!held, "no forces");
    assert_eq!(events.len(), 2, "but it touched, and passed: {events:?}");
    assert!(events[0].started() && events[1].stopped());
}

/// Pairs without contact forces have readable contacts without impulses.
#[test]
fn contacts_without_forces_can_be_read() {
    let (mut world, ground) = world_with_ground();
    let (_, collider) = add_box(&mut world, vec(0.0, 0.4), plain);
    world.colliders[collider].set_solver_groups(InteractionGroups::none());
    steps(&mut world, 2);
    let pair = world.contact_pair(ground, collider).expect("they overlap");
    assert!(pair.has_any_active_contact);
    assert!(pair.find_deepest_contact().is_some_and(|(_, _, depth)| depth > 0.05));
    assert_eq!(pair.total_impulse_magnitude(), 0.0);
    let flags = pair.manifolds[0].data.solver_flags;
    assert!(!flags.contains(SolverFlags::COMPUTE_RIGID_IMPULSES));
}

/// Edits of groups take effect in mid-air, on the ground, and for sleeping bodies.
#[test]
fn group_edits_take_effect_in_the_next_step() {
    let (mut world, _) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
    steps(&mut world, 200);
    assert!(world.bodies[body].is_sleeping());
    world.colliders[collider].set_collision_groups(InteractionGroups::none());
    steps(&mut world, 10);
    assert!(height(&world, body) < 0.45, "a sleeper whose ground is no more falls");
    world.colliders[collider].set_collision_groups(InteractionGroups::all());
    steps(&mut world, 200);
    assert!((height(&world, body) - 0.5).abs() < 0.01, "and is pushed out of it again");
    world.colliders[collider].set_solver_groups(InteractionGroups::none());
    steps(&mut world, 10);
    assert!(height(&world, body) < 0.45, "the same without forces");
}

#[test]
fn fixed_colliders_touch_on_request_only() {
    for types in [ActiveCollisionTypes::default(), ActiveCollisionTypes::FIXED_FIXED] {
        let (mut world, ground) = world_with_ground();
        let wall = with_events(cuboid(0.5, 1.0)).active_collision_types(types);
        let wall = world.insert_collider(wall, None);
        let protocol = Protocol::default();
        let events = protocol.of_steps(&mut world, 2);
        let has_pair = types == ActiveCollisionTypes::FIXED_FIXED;
        assert_eq!(events.len(), usize::from(has_pair), "{types:?}");
        assert_eq!(world.contact_pair(wall, ground).is_some(), has_pair, "{types:?}");

        world.colliders[wall].set_active_collision_types(ActiveCollisionTypes::FIXED_FIXED);
        world.step();
        assert!(world.contact_pair(wall, ground).is_some(), "changed later: {types:?}");
    }
}

/// Active collision types give a kinematic platform and the ground contacts, but no contact forces.
#[test]
fn kinematic_bodies_pass_fixed_colliders() {
    let (mut world, ground) = world_with_ground();
    let body = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(0.0, -1.0));
    let platform =
        with_events(cuboid(0.5, 0.5)).active_collision_types(ActiveCollisionTypes::all());
    let (body, platform) = world.insert(body.translation(vec(0.0, 1.0)), platform);
    let protocol = Protocol::default();
    let events = protocol.of_steps(&mut world, 60);
    assert_eq!(events.len(), 1);
    assert!(world.contact_pair(platform, ground).is_some());
    assert!(height(&world, body) < 0.01, "nothing held it up");
}

#[test]
fn colliders_of_one_body_never_touch() {
    let mut world = PhysicsWorld::new();
    let body = world.insert_body(RigidBodyBuilder::dynamic());
    for _ in 0..3 {
        world.insert_collider(with_events(cuboid(0.5, 0.5)), Some(body));
    }
    let protocol = Protocol::default();
    assert!(protocol.of_steps(&mut world, 5).is_empty());
    assert_eq!(world.contact_pairs().count(), 0);
}
