//! Small machines and hard cases of both dimensions: each function builds a scene in the plane of the
//! picture.

use super::Scene;
use crate::kit::{add, add_fixed, add_post, brick, flat, hinge, world_with_floor};
use crate::rapier::prelude::*;
use gallery::View;

/// Half the depth of boxes in 3D.
const DEPTH: Real = 0.5;
/// Half the side of the floor.
const FLOOR: Real = 60.0;

fn slab(x: Real, y: Real) -> ColliderBuilder {
    ColliderBuilder::new(brick(x, y, DEPTH))
}

/// Hangs a chain of links on a post, in a direction, and returns the last link.
fn hang_chain(
    world: &mut PhysicsWorld,
    post: RigidBodyHandle,
    links: usize,
    half: Real,
    along: Vector,
) -> (RigidBodyHandle, Vector) {
    let mut end = world.bodies[post].translation();
    let (mut last, mut anchor) = (post, Vector::ZERO);
    for _ in 0..links {
        let place = end + along * half;
        let link = add(world, place, ColliderBuilder::ball(0.35 * half).density(4.0));
        world.insert_impulse_joint(
            last,
            link,
            hinge().local_anchor1(anchor).local_anchor2(-along * half),
        );
        (last, anchor, end) = (link, along * half, place + along * half);
    }
    (last, anchor)
}

/// Builds a heavy ball on a chain that swings into a wall of boxes.
pub fn wrecking_ball(view: View) -> Scene {
    let mut world = world_with_floor(FLOOR);
    for row in 0..8 {
        for column in 0..3 {
            let place = flat(1.05 * column as Real + 0.6, row as Real + 0.5);
            add(&mut world, place, slab(0.5, 0.5));
        }
    }
    let post = add_post(&mut world, flat(-1.5, 12.0));
    let along = flat(-0.94, 0.34).normalize();
    let (last, anchor) = hang_chain(&mut world, post, 8, 0.5, along);
    let radius = 1.1;
    let place = world.bodies[last].translation() + anchor + along * radius;
    let ball = add(&mut world, place, ColliderBuilder::ball(radius).density(8.0));
    let joint = hinge().local_anchor1(anchor).local_anchor2(-along * radius);
    world.insert_impulse_joint(last, ball, joint);
    Scene::new(world, view).focusing(flat(-11.0, 0.0), flat(7.0, 13.0))
}

/// Builds pendulums of graded lengths: the row loses its phase, and regains it after a minute.
pub fn pendulum_wave(view: View, towards_eye: impl Fn(Real) -> Vector) -> Scene {
    let mut world = PhysicsWorld::new();
    for i in 0..12 {
        // Swings per minute: 24 for the longest, one more for each of the others. T = 2π √(l / g).
        let period = 60.0 / (24.0 + i as Real);
        let length = 9.81 * (period / std::f64::consts::TAU as Real).powi(2);
        let post = add_post(&mut world, towards_eye(i as Real));
        let at = world.bodies[post].translation() + flat(0.6, -0.8) * length;
        let body = RigidBodyBuilder::dynamic().translation(at).can_sleep(false);
        let (ball, _) = world.insert(body, ColliderBuilder::ball(0.16));
        world.insert_impulse_joint(post, ball, hinge().local_anchor2(flat(-0.6, 0.8) * length));
    }
    Scene::new(world, view)
}

/// Builds three planks on pivots: equal weights, unequal ones on unequal arms, and a falling weight that
/// throws another.
pub fn seesaw(view: View) -> Scene {
    let mut world = world_with_floor(FLOOR);
    for (i, loads) in
        [[(-2.5, 1.0), (2.5, 1.0)], [(-2.6, 1.0), (1.3, 2.0)], [(-2.6, 0.4), (2.6, 6.0)]]
            .into_iter()
            .enumerate()
    {
        let foot = flat(8.0 * (i as Real - 1.0), 0.0);
        let post = add_fixed(&mut world, foot + flat(0.0, 0.5), slab(0.25, 0.5));
        let plank = add(&mut world, foot + flat(0.0, 1.2), slab(3.2, 0.1));
        let pivot = hinge().local_anchor1(flat(0.0, 0.7)).contacts_enabled(false);
        world.insert_impulse_joint(post, plank, pivot);
        for (x, density) in loads {
            // The heaviest box falls from above.
            let height = if density > 5.0 { 7.0 } else { 1.7 };
            add(&mut world, foot + flat(x, height), slab(0.4, 0.4).density(density).friction(0.9));
        }
    }
    Scene::new(world, view).focusing(flat(-12.0, 0.0), flat(12.0, 6.0))
}

/// Builds a row of planks on springs, and balls that bounce on them.
pub fn trampoline(view: View) -> Scene {
    let mut world = world_with_floor(FLOOR);
    for i in 0..9 {
        let x = 2.0 * (i as Real - 4.0);
        let plank = add(&mut world, flat(x, 2.0), slab(0.9, 0.12));
        // The joint is free along y, on a spring, and locks all other axes.
        let (stiffness, damping) = (60.0 + 30.0 * i as Real, 1.0);
        let rail = PrismaticJointBuilder::new(Vector::Y)
            .local_anchor1(flat(0.0, 2.0))
            .motor_position(0.0, stiffness, damping);
        let post = add_post(&mut world, flat(x, 0.0));
        world.insert_impulse_joint(post, plank, rail);
        add(&mut world, flat(x, 5.0), ColliderBuilder::ball(0.5).restitution(0.6));
    }
    Scene::new(world, view).focusing(flat(-9.5, 0.0), flat(9.5, 6.0))
}

/// Builds light chains that carry balls of 10, 100 and 500 times the mass of a link.
pub fn heavy_chain(view: View) -> Scene {
    let mut world = PhysicsWorld::new();
    for (i, ratio) in [10.0, 100.0, 500.0].into_iter().enumerate() {
        let post = add_post(&mut world, flat(5.0 * (i as Real - 1.0), 0.0));
        let along = flat(0.5, -0.87).normalize();
        let (last, anchor) = hang_chain(&mut world, post, 10, 0.25, along);
        let (radius, mass) = (0.8, world.bodies[last].mass() * ratio);
        let place = world.bodies[last].translation() + anchor + along * radius;
        let ball = add(&mut world, place, ColliderBuilder::ball(radius).mass(mass));
        let joint = hinge().local_anchor1(anchor).local_anchor2(-along * radius);
        world.insert_impulse_joint(last, ball, joint);
    }
    Scene::new(world, view).focusing(flat(-8.5, -7.0), flat(8.5, 0.5))
}

/// Builds boxes inside each other, which push apart at a limited speed.
pub fn deep_overlap(view: View) -> Scene {
    let mut world = world_with_floor(FLOOR);
    for i in 0..48 {
        let [column, row] = [i % 8, i / 8].map(|n| n as Real);
        add(&mut world, flat(0.35 * (column - 3.5), 0.5 + 0.45 * row), slab(0.5, 0.5));
    }
    Scene::new(world, view).focusing(flat(-9.0, 0.0), flat(9.0, 6.0))
}
