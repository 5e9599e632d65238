//! Degenerate shapes: empty, flat, self-intersecting, and with invalid indices.

use super::listener::listen;
use super::scene::Scene;
use super::world::check;
use crate::dim::hostile::{degenerate_shapes, huge_shapes, shapes};
use crate::dim::vec;
use rapier::prelude::*;

/// Result of a rejected shape: `None` by constructors that return an option, or a message.
type Refusal = Option<String>;

/// Tries to create a degenerate shape.
fn refusal(made: Result<Option<ColliderBuilder>, InvalidCollider>) -> Result<Refusal, String> {
    match made {
        Err(error) => Ok(Some(error.to_string())),
        Ok(None) => Ok(None),
        Ok(Some(builder)) => match builder.try_build() {
            Ok(collider) => Err(format!("{:?} was built", collider.shape().shape_type())),
            Err(error) => Ok(Some(error.to_string())),
        },
    }
}

#[test]
fn degenerate_shapes_are_rejected_with_a_reason() {
    for (name, expected, make) in degenerate_shapes() {
        match refusal(make()) {
            Ok(Some(text)) => assert!(text.contains(expected), "{name}: {text}"),
            Ok(None) => assert_eq!(expected, "", "{name} is refused without a reason"),
            Err(built) => panic!("{name}: {built}"),
        }
    }
}

/// A pile continues beneath an invalid collider, which exists but takes part in no collision.
#[test]
fn degenerate_shapes_affect_no_other_body() {
    let untouched = Scene::new().all_in_the_end();
    let distant = Scene::new().distant_in_the_end();
    for (name, _, make) in degenerate_shapes() {
        let Ok(Some(builder)) = make() else { continue };
        let mut scene = Scene::new();
        let (ghost, heard) = listen(|| builder.translation(vec(0.0, 1.0)).build());
        assert!(!heard.is_empty(), "{name} is built in silence");
        scene.world.insert_collider(ghost.clone(), None);
        assert!(scene.all_in_the_end() == untouched, "{name} affects other bodies");

        let mut scene = Scene::new();
        let mass = scene.body().mass();
        scene.world.insert_collider(ghost, Some(scene.body));
        assert!(scene.distant_in_the_end() == distant, "{name} affects distant bodies");
        assert_eq!(scene.body().mass(), mass, "{name} has a mass");
    }
}

/// Shapes of every kind, deep inside each other, many of them at the same place.
#[test]
fn overlapping_shapes_keep_the_invariants() {
    for size in [0.5, 1.0e-3, 100.0] {
        let mut world = PhysicsWorld::new();
        world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
        for (i, shape) in shapes(size).into_iter().enumerate() {
            let body = if i % 3 == 0 {
                RigidBodyBuilder::kinematic_velocity_based().linvel(vec(size, 0.0))
            } else {
                RigidBodyBuilder::dynamic()
            };
            world.insert(body, shape.density(1.0));
        }
        for _ in 0..60 {
            world.step();
            check(&world);
        }
    }
}

/// Each kind of shape falls onto each other one, from a tiny distance.
#[test]
fn each_shape_collides_with_each_other() {
    let kinds = shapes(0.5).len();
    for first in 0..kinds {
        let mut world = PhysicsWorld::new();
        for second in 0..kinds {
            let x = 20.0 * second as Real;
            let ground = shapes(0.5).remove(first).translation(vec(x, 0.0));
            world.insert_collider(ground, None);
            let body = RigidBodyBuilder::dynamic().translation(vec(x, 0.8)).additional_mass(1.0);
            world.insert(body, shapes(0.5).remove(second));
        }
        for _ in 0..60 {
            world.step();
            check(&world);
        }
    }
}

#[test]
fn large_shapes_are_harmless() {
    for builder in huge_shapes() {
        let mut world = PhysicsWorld::new();
        world.insert_collider(builder, None);
        for i in 0..5_u8 {
            let body = RigidBodyBuilder::dynamic().translation(vec(Real::from(i) * 3.0, 1.0));
            world.insert(body, ColliderBuilder::ball(0.5));
        }
        for _ in 0..10 {
            world.step();
            check(&world);
        }
    }
}
