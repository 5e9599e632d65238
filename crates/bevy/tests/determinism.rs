//! Equal bits: of two runs, of the plugin and of the engine alone, and with unrelated components.

use crate::dim::{cube, engine_cube, engine_vector, floor};
use crate::plugin::prelude::*;
use crate::plugin::rapier::prelude as engine;
use crate::scene::*;
use bevy::prelude::*;

const STEPS: usize = 120;

/// Places of a heap: dyadic numbers, so that single and double precision hold the same ones.
fn places() -> impl Iterator<Item = (f32, f32)> {
    (0..24).map(|i| ((i % 3) as f32 * 0.875 - 0.5 + (i % 5) as f32 * 0.0625, 0.5 + i as f32 * 0.75))
}

/// A component that moves its entity to another archetype.
#[derive(Component)]
struct Unrelated;

fn hashes(decorate: impl Fn(usize) -> bool) -> Vec<u64> {
    let mut app = app();
    app.world_mut().spawn((RigidBody::Fixed, floor(), at(0.0, -1.0)));
    for (i, (x, y)) in places().enumerate() {
        let mut entity = app.world_mut().spawn((RigidBody::Dynamic, cube(0.375), at(x, y)));
        if decorate(i) {
            entity.insert(Unrelated);
        }
    }
    let mut hashes = Vec::new();
    for _ in 0..STEPS {
        app.update();
        hashes.push(physics(&app).engine.hash());
    }
    hashes
}

#[test]
fn two_runs_have_equal_bits() {
    let first = hashes(|_| false);
    assert_eq!(first, hashes(|_| false));
    assert_ne!(first[0], first[STEPS - 1]);
}

#[test]
fn unrelated_components_do_not_change_the_order() {
    assert_eq!(hashes(|_| false), hashes(|i| i % 3 == 1));
}

/// The hash after edits of several joints in one step.
fn hash_of_edited_joints(decorate: impl Fn(usize) -> bool) -> u64 {
    let mut app = app();
    let [first, second] =
        [0.0, 4.0].map(|x| app.world_mut().spawn((RigidBody::Fixed, at(x, 0.0))).id());
    let joints: Vec<_> = places()
        .enumerate()
        .map(|(i, (x, y))| {
            let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.375), at(x, -y))).id();
            let mut joint = app.world_mut().spawn(Joint::rope(first, body, 20.0));
            if decorate(i) {
                joint.insert(Unrelated);
            }
            joint.id()
        })
        .collect();
    run(&mut app, 4);
    for joint in joints {
        edit::<Joint>(&mut app, joint).body1 = second;
    }
    run(&mut app, 4);
    physics(&app).engine.hash()
}

#[test]
fn unrelated_components_do_not_change_the_order_of_edits() {
    assert_eq!(hash_of_edited_joints(|_| false), hash_of_edited_joints(|i| i % 3 == 1));
}

#[test]
fn the_plugin_has_the_bits_of_the_engine() {
    let mut world = engine::PhysicsWorld::new();
    world.integration_parameters.dt = DT;
    let ground = engine::RigidBodyBuilder::fixed().translation(engine_vector(0.0, -1.0));
    let ground = world.insert_body(ground);
    let boxes: Vec<_> = places()
        .map(|(x, y)| {
            let place = engine_vector(x.into(), y.into());
            world.insert_body(engine::RigidBodyBuilder::dynamic().translation(place))
        })
        .collect();
    let shape = crate::dim::floor().shape().expect("a box").clone();
    world.insert_collider(engine::ColliderBuilder::new(shape), Some(ground));
    for body in boxes {
        world.insert_collider(engine_cube(0.375), Some(body));
    }
    let mut expected = Vec::new();
    for _ in 0..STEPS {
        world.step();
        expected.push(world.hash());
    }
    assert_eq!(hashes(|_| false), expected);
}

#[test]
fn interpolation_does_not_change_the_bits() {
    let simulate = |plugin: PhysicsPlugin, frame: f64| {
        let mut app = app_with(plugin);
        app.world_mut().spawn((RigidBody::Fixed, floor(), at(0.0, -1.0)));
        for (x, y) in places() {
            app.world_mut().spawn((RigidBody::Dynamic, cube(0.375), at(x, y)));
        }
        frame_length(&mut app, frame);
        run(&mut app, (60.0 / frame) as usize);
        physics(&app).engine.hash()
    };
    let exact = simulate(PhysicsPlugin::default().without_interpolation(), 1.0);
    for frame in [0.25, 0.5, 1.5, 4.0] {
        assert_eq!(simulate(PhysicsPlugin::default(), frame), exact, "frames of {frame} steps");
    }
}
