//! Steps are bounded: the work of a step grows linearly with the scene, not quadratically.
//!
//! The tests count work (pairs, contact points) as scenes double. `cargo run --release -p rapier3d --example
//! crowds` measures time and memory of the same and larger scenes.

use super::listener::listen;
use crate::dim::{cuboid, hostile::rough_ground, vec};
use rapier::prelude::*;

/// Returns sensors of dynamic bodies at one point.
fn sensors(count: usize, most: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.integration_parameters.max_sensor_neighbors_per_collider = most;
    for _ in 0..count {
        world.insert(RigidBodyBuilder::dynamic(), cuboid(0.5, 0.5).sensor(true));
    }
    world
}

/// Without a limit, the pairs of sensors at one point were half the square of their number: 12.5 million for
/// 5000.
#[test]
fn pairs_of_sensors_grow_with_their_number() {
    const PAIRS_MAX: usize = 16;
    println!("{:>8} {:>8} {:>8}", "sensors", "pairs", "crowded");
    for count in [250, 500, 1000, 2000] {
        let mut world = sensors(count, PAIRS_MAX);
        let ((), heard) = listen(|| world.step());
        let named = heard.iter().filter(|text| text.contains("max_sensor_neighbors_per_collider"));
        assert_eq!(named.count(), 1, "{heard:?}");
        let counters = world.physics_pipeline.counters.cd;
        println!("{count:>8} {:>8} {:>8}", counters.nintersection_pairs, counters.ncrowded_sensors);
        assert_eq!(counters.ncrowded_sensors, count - 1 - PAIRS_MAX);
        // All but the first few sensors own the maximum number of pairs.
        assert_eq!(
            counters.nintersection_pairs,
            PAIRS_MAX * (count - PAIRS_MAX) + PAIRS_MAX * (PAIRS_MAX - 1) / 2
        );
        assert!(world.narrow_phase.intersection_pairs().all(|(.., intersect)| intersect));
        let ((), heard) = listen(|| world.step());
        assert!(heard.is_empty(), "the warning is logged once: {heard:?}");
    }
}

/// A sensor reports any number of bodies of its size or smaller, inserted before or after it.
#[test]
fn a_sensor_reports_any_number_of_bodies() {
    const COUNT: usize = 200;
    for size in [0.5, 0.1] {
        for place in [0, COUNT / 2, COUNT] {
            let mut world = sensors(0, 4);
            world.gravity = Vector::ZERO;
            world.integration_parameters.max_neighbors_per_collider = 4;
            let mut sensor = None;
            for k in 0..=COUNT {
                let body = RigidBodyBuilder::dynamic();
                if k == place {
                    sensor = Some(world.insert(body, cuboid(0.5, 0.5).sensor(true)).1);
                } else {
                    world.insert(body, cuboid(size, size));
                }
            }
            world.step();
            let reported = sensor.map(|it| world.narrow_phase.intersection_pairs_with(it).count());
            assert_eq!(reported, Some(COUNT), "size {size}, sensor in place {place}");
            assert_eq!(world.physics_pipeline.counters.cd.ncrowded_sensors, 0);
        }
    }
}

/// A plate nearly touches every piece of an equally large rough ground. The internal-edge filter compares
/// contacts with each other, so without culling a step takes quadratic time in the number of pieces. Only the
/// deepest contacts of each region are kept.
#[test]
fn a_plate_rests_on_a_ground_of_thousands_of_pieces() {
    println!("{:>8} {:>8} {:>8} {:>10} {:>8}", "pieces", "points", "culled", "height", "tilt");
    for pieces in [500, 2000, 8000] {
        let mut world = PhysicsWorld::new();
        // Heights are from 0 to 2 mm, less than the prediction distance.
        world.insert_collider(rough_ground(pieces, 40.0, 0.002), None);
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 0.51).can_sleep(false);
        let (body, _) = world.insert(body, cuboid(20.0, 0.5));
        let mut culled = 0;
        for _ in 0..40 {
            world.step();
            // Contacts of a body at rest are not recomputed in each step.
            culled = culled.max(world.physics_pipeline.counters.cd.nculled_pairs);
        }
        let points = world.physics_pipeline.counters.solver.ncontacts;
        let body = &world.bodies[body];
        let height = body.translation().y;
        let up = body.position().rotation * Vector::Y;
        let tilt = (up - Vector::Y).length();
        println!("{pieces:>8} {points:>8} {culled:>8} {height:>10.5} {tilt:>8.5}");
        // The plate rests on the highest pieces, minus the allowed overlap and that of its weight.
        assert!((0.498..0.5045).contains(&height), "{pieces} pieces: the plate is at {height}");
        assert!(tilt < 2.0e-3, "{pieces} pieces: the plate leans by {tilt}");
        assert!(body.linvel().length() < 0.02, "{pieces} pieces: {}", body.linvel());
        assert!(points <= 64, "{pieces} pieces: {points} contact points");
        assert_eq!(culled, usize::from(pieces > 1024), "{pieces} pieces");
    }
}

/// Joints pull bodies together at a bounded speed, whatever their initial distance. Each link of a chain adds
/// at most the limit to the speed of the next one. Without the bound, ten kilometres gave 165 km/s.
#[test]
fn badly_placed_joints_do_not_throw_bodies() {
    println!("{:>8} {:>10} {:>12}", "links", "apart", "fastest");
    for count in [1, 3, 10] {
        for apart in [10.0, 1.0e3, 1.0e5] {
            let mut world = PhysicsWorld::new();
            world.gravity = Vector::ZERO;
            let limit = world.integration_parameters.max_joint_corrective_velocity();
            let mut last = world.insert_body(RigidBodyBuilder::fixed());
            for k in 1..=count {
                let at = vec(apart * Real::from(k as u8), apart * Real::from((k % 2) as u8));
                let body = RigidBodyBuilder::dynamic().translation(at).can_sleep(false);
                let (body, _) = world.insert(body, ColliderBuilder::ball(0.1));
                let joint = crate::dim::hinge().local_anchor2(Vector::X);
                world.insert_impulse_joint(last, body, joint);
                last = body;
            }
            let mut fastest: Real = 0.0;
            for _ in 0..20 {
                world.step();
                let speeds = world.bodies.iter().map(|(_, body)| body.linvel().length());
                fastest = speeds.fold(fastest, Real::max);
            }
            println!("{count:>8} {apart:>10.0} {fastest:>12.1}");
            // A light body rotates about an anchor at ten times its size, so its middle is faster than the
            // anchor.
            let bound = 10.0 * limit * Real::from(count as u8);
            assert!(fastest < bound, "{count} links {apart} apart reach {fastest}");
        }
    }
}
