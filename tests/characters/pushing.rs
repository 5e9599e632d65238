//! "My character throws crates across the room", "it cannot push them at all."

use super::stage::{CAPSULE, DT, OFFSET, Walker, level};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

const MASS: Real = 80.0;

/// Pushes the obstacles of the last step.
fn push(walker: &mut Walker, dt: Real, mass: Real) {
    let shape = walker.world.colliders[walker.collider].shared_shape().clone();
    let mut queries = walker.world.query_pipeline_mut(QueryFilter::default());
    let (controller, met) = (&walker.controller, &walker.collisions);
    controller.solve_character_collision_impulses(dt, &mut queries, &*shape, mass, met);
}

/// Returns the velocity of a free body of this mass after one push by a character at 3/s.
fn pushed(mass: Real) -> Real {
    let mut world = level();
    world.gravity = Vector::ZERO;
    // The body is at the height of the capsule's middle, so that the push acts through its centre.
    let middle = 0.9 + OFFSET;
    let crate_body = RigidBodyBuilder::dynamic().translation(vec(CAPSULE.1 + OFFSET + 0.5, middle));
    let (crate_body, _) =
        world.insert(crate_body.lock_rotations(), cuboid(0.5, 0.5).density(0.0).mass(mass));
    let mut walker = Walker::new(world, vec(0.0, middle));
    walker.compute(vec(3.0, 0.0) * DT);
    push(&mut walker, DT, MASS);
    walker.world.bodies[crate_body].linvel().x
}

/// The push is the inelastic collision of two masses: `v M / (M + m)`, for any `m`.
#[test]
fn pushes_use_the_mass_of_the_character() {
    for mass in [0.1, 10.0, 80.0, 1.0e5] {
        let velocity = pushed(mass);
        let expected = 3.0 * MASS / (MASS + mass);
        assert!((velocity / expected - 1.0).abs() < 0.02, "{velocity}, not {expected}, at {mass}");
    }
}

/// A walking character pushes a crate no faster than its own speed. A standing one presses on it with at most
/// its weight.
#[test]
fn crates_are_pushed_ahead() {
    let mut world = level();
    let crate_body = RigidBodyBuilder::dynamic().translation(vec(2.0, 0.4));
    let (crate_body, _) = world.insert(crate_body, cuboid(0.4, 0.4).density(30.0));
    let mut walker = Walker::new(world, vec(0.0, 1.2)).settled();
    for _ in 0..180 {
        walker.step(vec(2.0, 0.0));
        push(&mut walker, DT, MASS);
        let velocity = walker.world.bodies[crate_body].linvel();
        assert!(velocity.length() < 2.1, "thrown at {velocity}");
    }
    let x = walker.world.bodies[crate_body].translation().x;
    assert!(x > 4.0 && walker.place().x > 3.0, "crate at {x}, walker at {}", walker.place());
}

/// Each obstacle is reported once, with the normal against the motion and the remainder of the desired
/// translation.
#[test]
fn collisions_are_reported() {
    let mut world = level();
    let wall = world.insert_collider(cuboid(1.0, 5.0).translation(vec(2.0, 5.0)), None);
    let mut walker = Walker::new(world, vec(0.0, 1.2)).settled();
    let desired = vec(1.0, -0.1);
    let movement = walker.compute(desired);
    let of_wall: Vec<_> = walker.collisions.iter().filter(|c| c.handle == wall).collect();
    assert_eq!(
        (of_wall.len(), walker.collisions.len()),
        (1, 2),
        "the wall and the ground, once each"
    );
    let collision = of_wall[0];
    assert!((collision.normal() + Vector::X).length() < 1.0e-3, "{}", collision.normal());
    assert!((collision.translation_applied.x - movement.translation.x).abs() < 1.0e-3);
    let left = collision.translation_remaining.x + collision.translation_applied.x;
    assert!((left - desired.x).abs() < 1.0e-3, "{collision:?}");
    assert!((collision.point().x - (movement.translation.x + CAPSULE.1)).abs() < OFFSET);
    let on_wall = collision.hit.witness1;
    assert!((on_wall.x - 1.0).abs() < OFFSET, "{on_wall}");
    assert_eq!(collision.hit.normal1, collision.normal());
}

#[test]
fn a_character_without_mass_pushes_nothing() {
    let mut world = level();
    let (body, _) = world
        .insert(RigidBodyBuilder::dynamic().translation(vec(0.7, 1.0)), ColliderBuilder::ball(0.3));
    let mut walker = Walker::new(world, vec(0.0, 1.0));
    walker.compute(vec(0.5, 0.0));
    let before = walker.world.bodies[body].vels();
    for (dt, mass) in [(DT, 0.0), (DT, Real::NAN), (DT, -1.0), (0.0, MASS), (Real::INFINITY, MASS)]
    {
        push(&mut walker, dt, mass);
    }
    assert_eq!(walker.world.bodies[body].vels(), before);
}
