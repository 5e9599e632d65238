//! Edits between steps take effect in the next step.

use super::stage::{add_box, close, height, plain, steps, world_with_ground};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// Returns a box asleep on a shelf above the ground.
fn asleep_on_shelf() -> (PhysicsWorld, RigidBodyHandle, ColliderHandle) {
    let (mut world, _) = world_with_ground();
    let shelf = world.insert_collider(cuboid(2.0, 0.5).translation(vec(0.0, 4.5)), None);
    let (body, _) = add_box(&mut world, vec(0.0, 5.5), plain);
    steps(&mut world, 200);
    assert!(world.bodies[body].is_sleeping());
    close(height(&world, body), 5.5, 0.01);
    (world, body, shelf)
}

/// Every edit that removes the support of a sleeping body wakes it.
#[test]
fn a_sleeping_body_without_support_falls() {
    type Loss = (&'static str, fn(&mut PhysicsWorld, ColliderHandle));
    let losses: [Loss; 9] = [
        ("moved away", |w, shelf| w.colliders[shelf].set_translation(vec(9.0, 4.5))),
        ("lowered", |w, shelf| w.colliders[shelf].set_translation(vec(0.0, 2.0))),
        ("shrunk", |w, shelf| w.colliders[shelf].set_shape(SharedShape::ball(0.1))),
        ("disabled", |w, shelf| w.colliders[shelf].set_enabled(false)),
        ("removed", |w, shelf| drop(w.remove_collider(shelf))),
        ("a sensor", |w, shelf| w.colliders[shelf].set_sensor(true)),
        ("of other groups", |w, shelf| {
            w.colliders[shelf].set_collision_groups(InteractionGroups::none());
        }),
        ("of other solver groups", |w, shelf| {
            w.colliders[shelf].set_solver_groups(InteractionGroups::none());
        }),
        ("edited in passing", |w, shelf| {
            for (handle, collider) in w.colliders.iter_mut() {
                if handle == shelf {
                    collider.set_translation(vec(9.0, 4.5));
                }
            }
        }),
    ];
    for (name, lose) in losses {
        let (mut world, body, shelf) = asleep_on_shelf();
        lose(&mut world, shelf);
        steps(&mut world, 20);
        assert!(height(&world, body) < 5.2, "shelf {name}: it hangs in the air");
    }
}

/// The same holds for a support with a body.
#[test]
fn a_sleeping_body_without_supporting_body_falls() {
    type Loss = (&'static str, fn(&mut PhysicsWorld, RigidBodyHandle));
    let losses: [Loss; 5] = [
        ("moved", |w, body| w.bodies[body].set_translation(vec(9.0, 4.5), true)),
        ("moved without waking itself", |w, body| {
            w.bodies[body].set_translation(vec(9.0, 4.5), false);
        }),
        ("disabled", |w, body| w.bodies[body].set_enabled(false)),
        ("removed", |w, body| drop(w.remove_body(body))),
        ("dynamic", |w, body| w.bodies[body].set_body_type(RigidBodyType::Dynamic, true)),
    ];
    for body_type in [RigidBodyType::Fixed, RigidBodyType::KinematicPositionBased] {
        for (name, lose) in losses {
            let (mut world, _) = world_with_ground();
            let shelf = RigidBodyBuilder::new(body_type).translation(vec(0.0, 4.5));
            let (shelf, _) = world.insert(shelf, cuboid(2.0, 0.5));
            let (body, _) = add_box(&mut world, vec(0.0, 5.5), plain);
            steps(&mut world, 200);
            assert!(world.bodies[body].is_sleeping());
            lose(&mut world, shelf);
            steps(&mut world, 20);
            assert!(height(&world, body) < 5.2, "{body_type:?} {name}: it hangs in the air");
        }
    }
}

/// Edits through `iter_mut` and `get_pair_mut` take effect.
#[test]
fn edits_through_iterators_take_effect() {
    let (mut world, body, _) = asleep_on_shelf();
    for (_, body) in world.bodies.iter_mut() {
        body.set_linvel(vec(0.0, 3.0), true);
    }
    steps(&mut world, 10);
    assert!(height(&world, body) > 5.7);

    let (mut world, body, _) = asleep_on_shelf();
    let (other, _) = add_box(&mut world, vec(5.0, 0.5), plain);
    let (first, second) = world.bodies.get_pair_mut(body, other);
    let (first, second) = (first.expect("it is there"), second.expect("it is there"));
    first.set_translation(second.translation() + Vector::Y * 3.0, true);
    steps(&mut world, 10);
    assert!(world.bodies[body].translation().x == 5.0 && height(&world, body) < 3.5);
}

#[test]
fn a_collider_moves_from_body_to_body() {
    let (mut world, ground) = world_with_ground();
    let (left, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
    let right = RigidBodyBuilder::dynamic().translation(vec(5.0, 0.5)).gravity_scale(0.0);
    let right = world.insert_body(right);
    steps(&mut world, 30);
    let mass = world.bodies[left].mass();
    world.colliders.set_parent(collider, Some(right), &mut world.bodies);
    steps(&mut world, 1);
    assert_eq!((world.bodies[left].mass(), world.bodies[right].mass()), (0.0, mass));
    assert_eq!(world.bodies[left].colliders(), []);
    assert_eq!(world.bodies[right].colliders(), [collider]);
    assert_eq!(world.colliders[collider].parent(), Some(right));
    close(world.colliders[collider].translation().x, 5.0, 1.0e-3);
    steps(&mut world, 60);
    close(height(&world, left), 0.5, 0.01);
    assert!(world.contact_pair(ground, collider).is_some());

    let place = *world.colliders[collider].position();
    world.colliders.set_parent(collider, None, &mut world.bodies);
    steps(&mut world, 30);
    assert_eq!(world.colliders[collider].position(), &place, "on its own it stays");
    assert_eq!(world.bodies[right].mass(), 0.0);
}

#[test]
fn a_disabled_body_stays_as_it_was() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 3.0), plain);
    steps(&mut world, 10);
    let (pose, velocity) = (*world.bodies[body].position(), world.bodies[body].linvel());
    world.bodies[body].set_enabled(false);
    steps(&mut world, 30);
    assert!(!world.colliders[collider].is_enabled());
    assert_eq!((world.bodies[body].position(), world.bodies[body].linvel()), (&pose, velocity));
    assert!(!world.active_bodies().contains(&body));
    world.bodies[body].set_enabled(true);
    steps(&mut world, 200);
    assert!(world.colliders[collider].is_enabled());
    close(height(&world, body), 0.5, 0.01);
    assert!(world.contact_pair(ground, collider).is_some());
}

/// A collider that the user disabled stays disabled when its body is enabled.
#[test]
fn a_disabled_collider_is_not_enabled_with_its_body() {
    let (mut world, _) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
    world.colliders[collider].set_enabled(false);
    for enabled in [false, true] {
        world.bodies[body].set_enabled(enabled);
        steps(&mut world, 1);
    }
    assert!(!world.colliders[collider].is_enabled());
    assert_eq!(world.bodies[body].mass(), 0.0, "nor does it weigh anything");
}

#[test]
fn a_body_changes_its_type() {
    let (mut world, _) = world_with_ground();
    let (body, _) = add_box(&mut world, vec(0.0, 3.0), plain);
    let set = |world: &mut PhysicsWorld, body_type| {
        world.bodies[body].set_body_type(body_type, true);
    };
    set(&mut world, RigidBodyType::Fixed);
    steps(&mut world, 30);
    assert_eq!(height(&world, body), 3.0);
    set(&mut world, RigidBodyType::KinematicVelocityBased);
    world.bodies[body].set_linvel(vec(0.0, 1.0), true);
    steps(&mut world, 60);
    close(height(&world, body), 4.0, 1.0e-3);
    set(&mut world, RigidBodyType::KinematicPositionBased);
    world.bodies[body].set_next_kinematic_translation(vec(0.0, 2.0));
    steps(&mut world, 1);
    assert_eq!(height(&world, body), 2.0);
    steps(&mut world, 10);
    assert_eq!(height(&world, body), 2.0, "it has arrived");
    set(&mut world, RigidBodyType::Dynamic);
    world.bodies[body].set_vels(RigidBodyVelocity::zero(), true);
    steps(&mut world, 200);
    close(height(&world, body), 0.5, 0.01);
}

/// A support that grows lifts the sleeping body on it.
#[test]
fn a_growing_support_lifts_a_sleeping_body() {
    let (mut world, body, shelf) = asleep_on_shelf();
    world.colliders[shelf].set_shape(cuboid(2.0, 1.0).shape);
    steps(&mut world, 200);
    close(height(&world, body), 6.0, 0.01);
}
