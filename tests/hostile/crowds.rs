//! Extreme numbers of bodies, or many bodies at one point.

use super::listener::listen;
use super::world::check;
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// Returns bodies at one point, above a ground.
fn heap(count: usize, shape: &ColliderBuilder, most: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.integration_parameters.max_neighbors_per_collider = most;
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    for _ in 0..count {
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y);
        world.insert(body, shape.clone());
    }
    world
}

/// Fifty million pairs of boxes overlap. The step creates as many as the parameters allow, with each body in
/// some of them. (With the default of 128, a step takes two to four seconds in a release build, and 2.3 GB.)
#[test]
fn ten_thousand_bodies_at_one_point() {
    const COUNT: usize = 10_000;
    const PAIRS_MAX: usize = 8;
    for shape in [ColliderBuilder::ball(0.5), cuboid(0.5, 0.5)] {
        let mut world = heap(COUNT, &shape, PAIRS_MAX);
        let ((), logged) = listen(|| world.step());
        assert!(
            logged.iter().any(|text| text.contains("max_neighbors_per_collider")),
            "{logged:?}"
        );
        let counters = world.physics_pipeline.counters;
        // All but the first few own the maximum number of pairs, and all touch the ground.
        assert_eq!(counters.cd.ncrowded, COUNT - 1 - PAIRS_MAX);
        let owned = PAIRS_MAX * (COUNT - 1 - PAIRS_MAX) + PAIRS_MAX * (PAIRS_MAX + 1) / 2;
        assert_eq!(counters.cd.ncontact_pairs, owned + COUNT);
        world.step();
        let positions = || world.bodies.iter().map(|(_, body)| body.translation());
        assert!(positions().all(|at| at.is_finite() && at.length() < 100.0));
        let apart = positions().filter(|at| (*at - Vector::Y).length() > 1.0e-3).count();
        assert!(apart > COUNT / 2, "{apart} of {COUNT} moved");
    }
}

/// Deferred pairs get contacts later: at the end no body is inside another.
#[test]
fn a_crowd_separates_without_a_trace_of_the_limit() {
    let mut world = heap(0, &cuboid(0.5, 0.5), 6);
    for k in 0..60_u8 {
        // Bodies at exactly equal heights and widths would balance on each other for a long time.
        let body = RigidBodyBuilder::dynamic().translation(vec(0.001 * Real::from(k), 1.0));
        world.insert(body, ColliderBuilder::ball(0.2));
    }
    world.step();
    assert!(world.physics_pipeline.counters.cd.ncrowded > 0);
    for _ in 0..600 {
        world.step();
    }
    check(&world);
    assert_eq!(world.physics_pipeline.counters.cd.ncrowded, 0);
    let places: Vec<_> = world.bodies.iter().map(|(_, body)| body.translation()).collect();
    for (k, a) in places.iter().enumerate() {
        assert!(a.y > 0.15, "one is at {a}");
        for b in &places[..k] {
            assert!((*a - *b).length() > 0.35, "one at {a}, one at {b}, both of radius 0.2");
        }
    }
}

/// A collider with the maximum number of pairs searches again when another one arrives. A collider that
/// arrives in the same step, and is found by its own motion, is not found twice.
#[test]
fn repeated_searches_find_no_pair_twice() {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    world.integration_parameters.max_neighbors_per_collider = 1;
    let body = |x: Real| RigidBodyBuilder::dynamic().translation(vec(x, 0.0)).can_sleep(false);
    let big = cuboid(2.0, 2.0);
    let [_, crowded] = [0.0, 0.0].map(|x| world.insert(body(x), cuboid(0.5, 0.5)).1);
    (0..3).for_each(|_| world.step());
    // The small body would own the pair with the large body. The bodies beside them do not count.
    world.insert(body(1.0), big.clone());
    let (_, sensor) = world.insert(body(-1.0), big.clone().sensor(true));
    let wall = world.insert_collider(big.translation(vec(-2.2, 0.0)), None);
    world.step();
    let sensed = world.narrow_phase.intersection_pairs_with(crowded);
    assert_eq!(sensed.filter(|&(one, two, _)| [one, two].contains(&sensor)).count(), 1);
    let touched = world.narrow_phase.contact_pairs_with(crowded);
    let with_wall = touched.filter(|pair| [pair.collider1, pair.collider2].contains(&wall));
    assert_eq!(with_wall.count(), 1);
}

/// A sensor in a crowd, and a later sensor, detect all bodies inside them.
#[test]
fn sensors_detect_all_of_a_crowd() {
    for slot in [0, 30, 59] {
        let mut world = heap(0, &cuboid(0.5, 0.5), 4);
        let mut sensor = None;
        for k in 0..60 {
            let body = RigidBodyBuilder::dynamic().translation(Vector::Y);
            let is_sensor = k == slot;
            let (_, collider) = world.insert(body, cuboid(0.5, 0.5).sensor(is_sensor));
            sensor = if is_sensor { Some(collider) } else { sensor };
        }
        world.step();
        let detected =
            sensor.map(|sensor| world.narrow_phase.intersection_pairs_with(sensor).count());
        assert_eq!(detected, Some(60), "the sensor was made as number {slot}"); // and of the ground
    }
}

/// A body under many small ones is not crowded: it has contacts with all of them, and with bodies of its
/// size.
#[test]
fn the_limit_excludes_large_bodies_under_small_ones() {
    let mut world = PhysicsWorld::new();
    world.integration_parameters.max_neighbors_per_collider = 4;
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let mut small = Vec::new();
    for level in [0.5, 1.9] {
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y * level);
        world.insert(body, cuboid(10.0, 0.5).density(1.0));
        for k in 0..30_u8 {
            let at = vec(0.6 * Real::from(k) - 9.0, level + 0.7);
            let body = RigidBodyBuilder::dynamic().translation(at);
            small.push((level, world.insert(body, cuboid(0.2, 0.2).density(0.1)).0));
        }
    }
    for _ in 0..120 {
        world.step();
        assert_eq!(world.physics_pipeline.counters.cd.ncrowded, 0);
    }
    for (level, body) in small {
        let height = world.bodies[body].translation().y;
        assert!(height > level + 0.6, "what lay at {} is at {height}", level + 0.7);
    }
}

/// A million fixed colliders take no time in a step, and bodies rest on them.
#[test]
fn a_million_colliders() {
    const SIDE: usize = 1000;
    let mut world = PhysicsWorld::new();
    let brick = cuboid(0.5, 0.5);
    for k in 0..SIDE * SIDE {
        let at = vec((k % SIDE) as Real, -0.5 - (k / SIDE) as Real);
        world.insert_collider(brick.clone().translation(at), None);
    }
    let bodies: [_; 10] = core::array::from_fn(|k| {
        let body = RigidBodyBuilder::dynamic().translation(vec(100.0 * k as Real + 50.2, 0.6));
        world.insert(body, cuboid(0.5, 0.5)).0
    });
    for _ in 0..60 {
        world.step();
    }
    for body in bodies {
        let height = world.bodies[body].translation().y;
        assert!((height - 0.5).abs() < 0.02, "a body is at {height}");
    }
    assert_eq!(world.colliders.len(), SIDE * SIDE + bodies.len());
}

/// A million sleeping bodies take no time in a step; an impact wakes one body and its neighbours only.
#[test]
fn a_million_sleeping_bodies() {
    const COUNT: usize = 1_000_000;
    let mut world = PhysicsWorld::new();
    world.bodies = RigidBodySet::with_capacity(COUNT + 1);
    world.gravity = Vector::ZERO;
    let ball = ColliderBuilder::ball(0.5);
    for k in 0..COUNT {
        let at = vec(2.0 * (k % 1000) as Real, 2.0 * (k / 1000) as Real);
        world.insert(RigidBodyBuilder::dynamic().translation(at).sleeping(true), ball.clone());
    }
    world.step();
    assert_eq!(world.active_bodies().len(), 0);
    let at = RigidBodyBuilder::dynamic().translation(vec(500.0, -2.0)).linvel(vec(0.0, 60.0));
    world.insert(at, ball);
    for _ in 0..3 {
        world.step();
    }
    let awake = world.active_bodies().len();
    assert!((2..=20).contains(&awake), "{awake} are awake");
}
