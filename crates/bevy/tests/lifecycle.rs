//! Insertion and removal of components and entities.

use crate::dim::{cube, floor, vector};
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::ecs::entity_disabling::Disabled;
use bevy::prelude::*;

#[test]
fn elements_end_with_their_entity() {
    let mut app = app();
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5))).id();
    let wall = app.world_mut().spawn((floor(), at(0.0, -5.0))).id();
    run(&mut app, 2);
    assert_eq!(counts(&app), [1, 2, 0]);
    app.world_mut().entity_mut(body).despawn();
    run(&mut app, 2);
    assert_eq!(counts(&app), [0, 1, 0]);
    app.world_mut().entity_mut(wall).despawn();
    run(&mut app, 2);
    assert_eq!(counts(&app), [0, 0, 0]);
    assert!(physics(&app).body_handle(body).is_none());
    assert!(physics(&app).collider_handle(wall).is_none());
}

#[test]
fn an_entity_that_lives_for_less_than_a_step_leaves_no_trace() {
    let mut app = app();
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5))).id();
    let joint = app.world_mut().spawn(Joint::rope(body, body, 1.0)).id();
    app.world_mut().entity_mut(body).despawn();
    app.world_mut().entity_mut(joint).despawn();
    run(&mut app, 2);
    assert_eq!(counts(&app), [0, 0, 0]);
}

#[test]
fn a_collider_without_its_body_becomes_scenery() {
    let mut app = app();
    let ground = app.world_mut().spawn((RigidBody::Dynamic, cube(1.0))).id();
    let ball = app.world_mut().spawn((RigidBody::Dynamic, Collider::ball(0.5), at(0.0, 3.0))).id();
    run(&mut app, 4);
    app.world_mut().entity_mut(ground).remove::<RigidBody>();
    let height = position(&app, ground).y;
    run(&mut app, 64 * 3);
    assert_eq!(counts(&app), [1, 2, 0]);
    assert_eq!(position(&app, ground).y, height);
    assert_near(position(&app, ball).y, height + 1.5, 0.01);
    // And back: it falls, with the ball on it.
    app.world_mut().entity_mut(ground).insert(RigidBody::Dynamic);
    run(&mut app, 64);
    assert_eq!(counts(&app), [2, 2, 0]);
    assert!(position(&app, ground).y < height - 4.0);
}

#[test]
fn a_removed_collider_leaves_the_body() {
    let mut app = app();
    app.world_mut().spawn((floor(), at(0.0, -1.0)));
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(0.0, 0.5))).id();
    run(&mut app, 32);
    assert_near(position(&app, body).y, 0.5, 0.01);
    app.world_mut().entity_mut(body).remove::<Collider>();
    run(&mut app, 64);
    assert_eq!(counts(&app), [1, 1, 0]);
    assert!(position(&app, body).y < -3.0);
}

#[test]
fn a_replaced_shape_keeps_the_handle() {
    let mut app = app();
    app.world_mut().spawn((floor(), at(0.0, -1.0)));
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(0.0, 0.5))).id();
    run(&mut app, 16);
    let handle = physics(&app).collider_handle(body);
    app.world_mut().entity_mut(body).insert(cube(0.25));
    run(&mut app, 128);
    assert_eq!(physics(&app).collider_handle(body), handle);
    assert_near(position(&app, body).y, 0.25, 0.01);
}

#[test]
fn materials_and_groups_of_a_collider_can_change() {
    let mut app = app();
    let ground = app.world_mut().spawn((floor(), at(0.0, -1.0))).id();
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(0.0, 0.5))).id();
    run(&mut app, 8);
    edit::<Friction>(&mut app, body).coefficient = 0.9;
    *edit::<ColliderMass>(&mut app, body) = ColliderMass::Mass(7.0);
    run(&mut app, 2);
    let collider = physics(&app).collider(body).expect("a collider");
    assert_near(collider.friction(), 0.9, 1.0e-6);
    assert_near(physics(&app).body(body).expect("a body").mass(), 7.0, 1.0e-5);
    *edit::<CollisionGroups>(&mut app, ground) =
        CollisionGroups::new(Group::GROUP_1, Group::GROUP_2);
    *edit::<CollisionGroups>(&mut app, body) = CollisionGroups::new(Group::GROUP_1, Group::GROUP_1);
    run(&mut app, 64);
    assert!(position(&app, body).y < -3.0);
}

#[test]
fn entities_that_are_older_than_the_plugin_take_part() {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, TransformPlugin));
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5))).id();
    app.add_plugins(PhysicsPlugin::default());
    frame_length(&mut app, 1.0);
    run(&mut app, 8);
    assert_eq!(counts(&app), [1, 1, 0]);
    assert!(physics(&app).body(body).expect("a body").linvel().y < 0.0);
}

#[test]
fn entities_and_handles_map_both_ways() {
    let mut app = app();
    let body = app.world_mut().spawn(RigidBody::Dynamic).id();
    let part = app.world_mut().spawn((cube(0.5), ChildOf(body))).id();
    run(&mut app, 2);
    let world = physics(&app);
    let (handle, collider) =
        (world.body_handle(body).unwrap(), world.collider_handle(part).unwrap());
    assert_eq!(world.entity_of_body(handle), Some(body));
    assert_eq!(world.entity_of_collider(collider), Some(part));
    assert!(world.body_handle(part).is_none() && world.collider_handle(body).is_none());
    assert_eq!(world.collider(part).unwrap().parent(), Some(handle));
}

#[test]
fn a_removed_setting_returns_to_its_default() {
    let mut app = weightless();
    let force = ExternalForce { force: vector(8.0, 0.0), ..default() };
    let settings = (force, Damping { linear: 1.0, angular: 0.0 }, Friction::new(0.9));
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), settings)).id();
    run(&mut app, 8);
    app.world_mut().entity_mut(body).remove::<(ExternalForce, Damping, Friction, Sleeping)>();
    run(&mut app, 2);
    let velocity = *get::<Velocity>(&app, body);
    assert!(velocity.linear.x > 0.1);
    run(&mut app, 8);
    assert_eq!(get::<Velocity>(&app, body).linear, velocity.linear);
    assert_near(physics(&app).collider(body).unwrap().friction(), 0.5, 1.0e-6);
    // Later edits take effect, and transforms follow.
    app.world_mut().entity_mut(body).remove::<Velocity>();
    edit::<Transform>(&mut app, body).translation.x = 7.0;
    app.world_mut().entity_mut(body).insert(cube(0.25));
    run(&mut app, 4);
    assert_near(position(&app, body).x, 7.0, 1.0e-6);
    assert_near(physics(&app).collider(body).unwrap().compute_aabb().maxs.x, 7.25, 1.0e-5);
    // Without its owner, no setting returns.
    app.world_mut().entity_mut(body).remove_with_requires::<RigidBody>();
    run(&mut app, 2);
    assert!(app.world().get::<Damping>(body).is_none());
}

#[test]
fn disabled_entities_leave_the_simulation_until_they_return() {
    let mut app = app();
    let late = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), Disabled)).id();
    let body = app.world_mut().spawn((RigidBody::Dynamic, at(9.0, 0.0))).id();
    let part = app.world_mut().spawn((cube(0.5), ChildOf(body))).id();
    let post = app.world_mut().spawn((RigidBody::Fixed, at(9.0, 5.0))).id();
    app.world_mut().spawn(Joint::rope(post, body, 50.0));
    run(&mut app, 8);
    assert_eq!(counts(&app), [2, 1, 1]);
    app.world_mut().entity_mut(body).insert(Disabled);
    let height = position(&app, body).y;
    run(&mut app, 8);
    // Its collider does not turn into scenery.
    assert_eq!(counts(&app), [1, 0, 0]);
    app.world_mut().entity_mut(body).remove::<Disabled>();
    app.world_mut().entity_mut(late).remove::<Disabled>();
    app.update();
    assert_eq!(counts(&app), [3, 2, 1]);
    assert_near(position(&app, body).y, height, 0.1);
    assert_eq!(physics(&app).collider(part).unwrap().parent(), physics(&app).body_handle(body));
    app.world_mut().entity_mut(part).insert(Disabled);
    app.update();
    assert_eq!(counts(&app), [3, 1, 1]);
}
