//! Impacts divide a step: no body loses time.

use super::{RADIUS, wall};
use crate::dim::{cuboid, vec};
use crate::suite::api::stage::close;
use crate::suite::physics::stage::{G, weightless};
use rapier::prelude::*;

/// Gap at which colliders stop (m): the position error of an impact is at most twice as large.
const GAP: Real = 0.001;

fn divided(parts: usize) -> PhysicsWorld {
    let mut world = weightless(60);
    world.integration_parameters.max_ccd_substeps = parts;
    world
}

fn add_elastic_ball(world: &mut PhysicsWorld, at: Vector, velocity: Vector) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic().translation(at).linvel(velocity).can_sleep(false);
    world.insert(body, ColliderBuilder::ball(RADIUS).friction(0.0).restitution(1.0)).0
}

/// Adds walls at both ends of the interval in which the centre of a ball moves.
fn add_walls(world: &mut PhysicsWorld, width: Real) {
    for (side, at) in [(-1.0, 0.0), (1.0, width)] {
        let at = vec(at + side * (RADIUS + 0.01), 0.0);
        world.insert_collider(wall().translation(at).restitution(1.0), None);
    }
}

/// Where a ball is that moves to and fro between 0 and `width`, after a way.
fn reflected(way: Real, width: Real) -> Real {
    let way = way.rem_euclid(2.0 * width);
    way.min(2.0 * width - way)
}

/// A ball bounces off a wall that it reaches after any fraction of a step: `x = w - |v t - w|`. With
/// undivided steps it loses the rest of the step. A ball that ends with less than half its thickness in the
/// wall has no impact in this step.
#[test]
fn a_bounce_takes_no_time() {
    for speed in [20.0, 200.0, 1000.0] {
        for fraction in [0.03, 0.2, 0.5, 0.8, 0.97] {
            let way = speed / 60.0;
            if (1.0 - fraction) * way < RADIUS {
                continue;
            }
            let end = |parts| {
                let mut world = divided(parts);
                let width = way * (1.0 + fraction);
                add_walls(&mut world, width);
                let ball =
                    add_elastic_ball(&mut world, vec(width - way * fraction, 0.0), vec(speed, 0.0));
                world.step();
                (world.bodies[ball].translation().x, width - way * (1.0 - fraction))
            };
            let (x, wanted) = end(4);
            close(x, wanted, 2.0 * GAP + 1.0e-5 * way);
            let (x, _) = end(1);
            // Closer walls have a contact when the step begins.
            if fraction * way > 0.03 {
                assert!(x > wanted + 0.9 * (1.0 - fraction) * way, "{speed} m/s, {fraction}: {x}");
            }
        }
    }
}

/// A ball bounces several times a step, for a second.
#[test]
fn several_bounces_a_step_take_no_time() {
    for (speed, width) in [(50.0, 2.0), (150.0, 2.0), (200.0, 1.2)] {
        let mut world = divided(16);
        add_walls(&mut world, width);
        let ball = add_elastic_ball(&mut world, vec(0.5 * width, 0.0), vec(speed, 0.0));
        for step in 1..=60 {
            world.step();
            let way: Real = speed * step as Real / 60.0;
            let bounces = 1.0 + way / width;
            let x = world.bodies[ball].translation().x;
            close(x, reflected(0.5 * width + way, width), 2.0 * GAP * bounces);
        }
        close(world.bodies[ball].linvel().length(), speed, 1.0e-3 * speed);
    }
}

/// A bullet hits a heavier ball at rest after 60 % of a step: both leave with the velocities of an elastic
/// impact, and move for the rest of the step.
#[test]
fn bullets_divide_at_dynamic_bodies() {
    let mut world = divided(4);
    let (speed, way): (Real, Real) = (120.0, 2.0);
    let bullet = add_elastic_ball(&mut world, vec(-0.6 * way - 2.0 * RADIUS, 0.0), vec(speed, 0.0));
    world.bodies[bullet].enable_ccd(true);
    let target = add_elastic_ball(&mut world, Vector::ZERO, Vector::ZERO);
    let added_mass = 2.0 * world.bodies[bullet].mass();
    world.bodies[target].set_additional_mass(added_mass, true);
    world.step();
    let ratio = world.bodies[target].mass() / world.bodies[bullet].mass();
    let (slow, fast) = (speed * (1.0 - ratio) / (1.0 + ratio), speed * 2.0 / (1.0 + ratio));
    close(world.bodies[bullet].linvel().x, slow, 1.0e-3 * speed);
    close(world.bodies[target].linvel().x, fast, 1.0e-3 * speed);
    close(world.bodies[target].translation().x, 0.4 * fast / 60.0, 4.0 * GAP);
}

/// Parts are not shorter than the limit. With a limit of a whole step, bits are those of undivided steps.
#[test]
fn the_shortest_part_is_limited() {
    let end = |parts, min_ccd_dt| {
        let mut world = divided(parts);
        world.integration_parameters.min_ccd_dt = min_ccd_dt;
        add_walls(&mut world, 2.0);
        let ball = add_elastic_ball(&mut world, vec(1.0, 0.0), vec(150.0, 0.0));
        (0..10).for_each(|_| world.step());
        world.bodies[ball].translation()
    };
    assert_eq!(end(8, 1.0), end(1, 1.0));
    assert_ne!(end(8, 0.0), end(1, 0.0));
}

/// A position-based platform lifts a box at constant velocity while impacts elsewhere divide all steps, and
/// arrives at its target in each step.
#[test]
fn platforms_share_their_way_between_the_parts() {
    let mut world = divided(8);
    world.gravity = vec(0.0, -G);
    let (rise, center): (Real, Vector) = (0.01, vec(0.0, -50.0));
    let platform = RigidBodyBuilder::kinematic_position_based().translation(center);
    let (platform, _) = world.insert(platform, cuboid(0.5, 0.1));
    let load = RigidBodyBuilder::dynamic().translation(center + vec(0.0, 0.2)).can_sleep(false);
    let (load, _) = world.insert(load, cuboid(0.1, 0.1));
    add_walls(&mut world, 2.0);
    let ball = add_elastic_ball(&mut world, vec(1.0, 0.0), vec(150.0, 0.0));
    world.bodies[ball].set_gravity_scale(0.0, true);
    for step in 1..=60 {
        let target = center + vec(0.0, step as Real * rise);
        world.bodies[platform].set_next_kinematic_translation(target);
        world.step();
        assert_eq!(world.bodies[platform].translation(), target);
        close(world.bodies[platform].linvel().y, 60.0 * rise, 1.0e-2 * 60.0 * rise);
    }
    close(world.bodies[load].linvel().y, 60.0 * rise, 0.02 * 60.0 * rise);
}

/// Begin and end of a contact within one step are both reported, in this order.
#[test]
fn events_of_all_parts_are_reported() {
    let mut world = divided(4);
    add_walls(&mut world, 10.0);
    let ball = add_elastic_ball(&mut world, vec(9.0, 0.0), vec(100.0, 0.0));
    let collider = world.bodies[ball].colliders()[0];
    world.colliders[collider].set_active_events(ActiveEvents::COLLISION_EVENTS);
    let (send, receive) = std::sync::mpsc::channel();
    let (forces, _) = std::sync::mpsc::channel();
    let events = ChannelEventCollector::new(send, forces);
    (0..2).for_each(|_| world.step_with_events(&(), &events));
    let started: Vec<bool> = receive.try_iter().map(|event| event.started()).collect();
    assert_eq!(started, [true, false]);
}
