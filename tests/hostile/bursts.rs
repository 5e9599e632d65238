//! Bodies created inside each other separate at bounded speeds.

use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::Dice;
use rapier::prelude::*;

/// Name of a shape, and its collider.
type Named = (&'static str, ColliderBuilder);

/// Returns shapes of about one unit.
fn shapes() -> [Named; 3] {
    [
        ("box", cuboid(0.5, 0.5)),
        ("ball", ColliderBuilder::ball(0.5)),
        ("capsule", ColliderBuilder::capsule_x(0.4, 0.3)),
    ]
}

/// Returns weightless bodies with their centres within `spread` of one point.
fn heap(shape: &ColliderBuilder, count: usize, spread: Real) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let mut dice = Dice(count as u64);
    for _ in 0..count {
        let at = vec(dice.within(-spread, spread), dice.within(-spread, spread));
        world.insert(RigidBodyBuilder::dynamic().translation(at), shape.clone());
    }
    world
}

fn largest(world: &PhysicsWorld, length: impl Fn(&RigidBody) -> Real) -> Real {
    world.bodies.iter().map(|(_, body)| length(body)).fold(0.0, Real::max)
}

/// Bodies at rest have no energy, contacts without restitution add none, and there are no other forces. The
/// correction of overlap moves bodies and must leave them at rest. The relax pass does not converge on
/// thousands of contacts: 50 coincident boxes separated at 49 m/s and 1000 balls at 302 m/s. No body may
/// exceed three times the push-out speed of a contact. (The last, shallow overlaps of a heap are not checked:
/// ten bodies separate at 1 to 8 m/s.)
fn require_bounded_speeds(counts: &[usize]) {
    println!("{:>8} {:>8} {:>8} {:>10} {:>10}", "shape", "spread", "bodies", "fastest", "radius");
    for (name, shape) in shapes() {
        for spread in [0.0, 0.3] {
            for &count in counts {
                let mut world = heap(&shape, count, spread);
                let mut fastest: Real = 0.0;
                for _ in 0..60 {
                    world.step();
                    fastest = fastest.max(largest(&world, |body| body.linvel().length()));
                }
                let radius = largest(&world, |body| body.translation().length());
                println!("{name:>8} {spread:>8} {count:>8} {fastest:>10.3} {radius:>10.2}");
                let limit = 3.0 * world.integration_parameters.max_corrective_velocity();
                assert!(fastest < limit, "{count} of {name} leave with {fastest}");
                // Capsules with coincident axes have no direction of separation.
                let parts = spread > 0.0 || name != "capsule";
                assert!(radius > 1.0 || !parts, "{count} of {name} stay within {radius}");
            }
        }
    }
}

#[test]
fn coincident_bodies_are_not_thrown() {
    require_bounded_speeds(&[10, 50, 150]);
}

/// Bodies are removed before others are created inside each other. The step must not read constraints of
/// removed bodies.
#[test]
fn coincident_bodies_may_replace_a_crowd() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(cuboid(50.0, 0.5), None);
    let drop = |world: &mut PhysicsWorld, at: Vector| {
        world.insert(RigidBodyBuilder::dynamic().translation(at), cuboid(0.5, 0.5)).0
    };
    let crowd: Vec<_> = (0..80_u8)
        .map(|k| drop(&mut world, vec(Real::from(k % 40) * 1.1 - 22.0, 1.0 + Real::from(k / 40))))
        .collect();
    (0..10).for_each(|_| world.step());
    for body in crowd {
        world.remove_body(body);
    }
    let newcomers: Vec<_> = (0..8).map(|_| drop(&mut world, vec(0.0, 1.0))).collect();
    (0..60).for_each(|_| world.step());
    let is_near = |body: &RigidBody| body.translation().length() < 20.0;
    assert!(newcomers.iter().all(|&body| is_near(&world.bodies[body])));
}

#[test]
#[ignore = "half a minute"]
fn crowds_of_coincident_bodies_are_not_thrown() {
    require_bounded_speeds(&[500, 1000, 2000]);
}
