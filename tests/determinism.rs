//! Bitwise determinism: from run to run, on any number of threads, with any instructions, and beside
//! unrelated bodies.
//!
//! The scene falls, collides, piles up and comes to rest. Removals and insertions on the way reorder every
//! list of the engine. The comparison covers every bit of every pose and velocity. Without the feature
//! `parallel` all thread counts are one; the gate runs this with the feature as well.

use crate::dim::grounds::GROUNDS;
use crate::dim::{self, cuboid, vec};
use rapier::prelude::*;

const STEPS: usize = 150;

/// Returns all numbers of all bodies.
fn bits(world: &PhysicsWorld) -> Vec<u64> {
    let mut bits = Vec::new();
    let mut push = |value: Real| bits.push(f64::from(value).to_bits());
    for (_, body) in world.bodies.iter() {
        let (at, velocity) = (body.translation(), body.linvel());
        for k in 0..DIM {
            push(at[k]);
            push(velocity[k]);
        }
        push(dim::angle(body.rotation()));
        push(dim::z_of(body.angvel()));
    }
    bits
}

/// Adds a floor and a heap of balls, boxes and capsules above it.
fn heap(world: &mut PhysicsWorld, center: Vector) {
    let floor = RigidBodyBuilder::fixed().translation(center - dim::vec(0.0, 1.0));
    world.insert(floor, dim::cuboid(30.0, 1.0));
    for k in 0..160_u8 {
        let (column, row) = (Real::from(k % 8), Real::from(k / 8));
        let at = center + dim::vec(column * 0.9 + row * 0.07 - 4.0, 1.0 + row * 1.1);
        let collider = match k % 3 {
            0 => ColliderBuilder::ball(0.4),
            1 => dim::cuboid(0.4, 0.3),
            _ => ColliderBuilder::capsule_y(0.3, 0.2),
        };
        let body = RigidBodyBuilder::dynamic().translation(at).rotation(dim::about_z(row));
        world.insert(body, collider.restitution(0.2));
    }
}

/// Runs the heap, with removals and insertions of bodies.
fn run(mut world: PhysicsWorld) -> Vec<u64> {
    for step in 0..STEPS {
        if step % 25 == 24 {
            let oldest =
                world.bodies.iter().find(|(_, body)| body.is_dynamic()).map(|(handle, _)| handle);
            world.bodies.remove(oldest.expect("the heap is not that small"));
            let at = dim::vec(0.3, 14.0);
            world.insert(RigidBodyBuilder::dynamic().translation(at), ColliderBuilder::ball(0.5));
        }
        world.step();
    }
    bits(&world)
}

fn world() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    heap(&mut world, Vector::ZERO);
    world
}

/// Returns a world with all features that the heap lacks. These are chains and nets of joints (some break),
/// links, bullets, a mesh, and sleeping bodies.
fn workshop() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    GROUNDS[1].1(&mut world, Pose::IDENTITY, 0.5);
    let bob = |at: Vector| RigidBodyBuilder::dynamic().translation(at);
    let ball = |radius| ColliderBuilder::ball(radius).restitution(0.1);
    for k in 0..40_u8 {
        let column = Real::from(k);
        world.insert(bob(vec(column - 1.0, 0.2)), cuboid(0.3, 0.2));
        let bullet = bob(vec(column - 1.0, 4.0 + 0.3 * column)).ccd_enabled(k % 2 == 0);
        world.insert(bullet.linvel(vec(20.0 - column, -200.0)), ball(0.1));
    }
    for k in 0..20_usize {
        let hook = vec(2.0 * k as Real, 6.0);
        let mut last = world.insert_body(RigidBodyBuilder::fixed().translation(hook));
        for link in 0..6 {
            let at = hook + vec(0.4 * (link + 1) as Real, 0.0);
            let (next, _) = world.insert(bob(at), ball(0.12));
            let mut joint = dim::loose_joint(k, vec(0.2, 0.0), vec(-0.2, 0.0));
            if k % 3 == 0 && world.insert_multibody_joint(last, next, joint).is_some() {
                last = next;
                continue;
            }
            if k % 3 == 1 {
                joint.set_motor_velocity(JointAxis::AngX, 3.0, 0.1);
                joint.set_break_thresholds(2.0 + k as Real, Real::INFINITY);
            }
            world.insert_impulse_joint(last, next, joint);
            last = next;
        }
    }
    net(&mut world, vec(10.0, 9.0));
    hub(&mut world, vec(-30.0, 5.0));
    world
}

/// Adds a net of point-to-point joints that hangs on two of its corners.
fn net(world: &mut PhysicsWorld, corner: Vector) {
    const SIDE: usize = 14;
    let mut knots: Vec<RigidBodyHandle> = Vec::new();
    for k in 0..SIDE * SIDE {
        let (i, j) = (k % SIDE, k / SIDE);
        let at = corner + vec(0.3 * i as Real, 0.3 * j as Real);
        let hangs = j == 0 && (i == 0 || i == SIDE - 1);
        let kind = if hangs { RigidBodyType::Fixed } else { RigidBodyType::Dynamic };
        let knot = RigidBodyBuilder::new(kind).translation(at);
        let (knot, _) = world.insert(knot, ColliderBuilder::ball(0.05));
        let mut tie = |other: usize, along: Vector| {
            let joint = dim::loose_joint(0, along * 0.15, along * -0.15);
            world.insert_impulse_joint(knots[other], knot, joint);
        };
        if i > 0 {
            tie(k - 1, vec(1.0, 0.0));
        }
        if j > 0 {
            tie(k - SIDE, vec(0.0, 1.0));
        }
        knots.push(knot);
    }
}

/// Steps the workshop on some threads, and removes the suspended bodies on the way.
fn run_workshop() -> Vec<u64> {
    let mut world = workshop();
    let (mut slept, mut stopped) = (false, 0);
    world.physics_pipeline.counters.enable();
    for step in 0..STEPS {
        if step % 10 == 9 {
            let body = world.bodies.iter().filter(|(_, body)| body.is_dynamic());
            let body = body.map(|(handle, _)| handle).nth(7 * step / 10);
            world.remove_body(body.expect("there are hundreds"));
        }
        world.step();
        slept |= world.bodies.iter().any(|(_, body)| body.is_sleeping());
        stopped += world.physics_pipeline.counters.ccd.num_substeps;
    }
    let broke = world.impulse_joints.iter().any(|(_, joint)| !joint.data.is_enabled());
    assert!(slept && stopped > 0 && broke, "{slept} {stopped} {broke}");
    bits(&world)
}

#[test]
fn determinism_of_joints_links_and_bullets_on_any_number_of_threads() {
    let expected = run_workshop();
    for threads in [1, 2, 3, 8, 80] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let found = pool.expect("a pool of threads").install(run_workshop);
        assert_eq!(expected, found, "{threads} threads");
    }
}

/// Worlds are stepped at the same time in one pool, each by one of its threads and all idle ones.
#[test]
fn determinism_of_worlds_that_share_a_pool() {
    use rayon::prelude::*;
    let expected = run(world());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("a pool of threads");
    let found: Vec<_> = pool.install(|| (0..8).into_par_iter().map(|_| run(world())).collect());
    assert!(found.iter().all(|bits| *bits == expected));
}

#[test]
fn determinism_from_run_to_run() {
    assert_eq!(run(world()), run(world()));
}

#[test]
fn determinism_on_any_number_of_threads() {
    let expected = run(world());
    for threads in [1, 2, 3, 8] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let found = pool.expect("a pool of threads").install(|| run(world()));
        assert_eq!(expected, found, "{threads} threads");
    }
}

/// The pipeline has its own threads, or those of a pool, from inside and outside the pool.
#[test]
fn determinism_with_threads_of_the_pipeline() {
    let expected = run(world());
    let run_on = |threads: &Threads| {
        let mut world = world();
        world.physics_pipeline.set_threads(threads.clone());
        run(world)
    };
    for count in [0, 1, 2, 5, 80] {
        let threads = Threads::new(count).expect("threads");
        assert_eq!(expected, run_on(&threads), "{count} threads");
    }
    #[cfg(feature = "parallel")]
    {
        let pool =
            rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("a pool of threads");
        let pool = std::sync::Arc::new(pool);
        let threads = Threads::of_pool(std::sync::Arc::clone(&pool));
        assert_eq!(expected, run_on(&threads), "from outside");
        assert_eq!(expected, pool.install(|| run_on(&threads)), "from within");
    }
}

#[test]
fn determinism_with_any_instructions() {
    let mut plain = world();
    plain.physics_pipeline.set_wide_instructions(false);
    assert_eq!(run(world()), run(plain));
}

#[test]
fn determinism_next_to_strangers() {
    let mut crowded = world();
    heap(&mut crowded, dim::vec(1000.0, 0.0));
    let (alone, among_others) = (run(world()), run(crowded));
    // The heap's own bodies come first: those of the second heap have later slots. The last inserted body
    // takes the slot of the last removed one in both worlds.
    assert_eq!(alone[..], among_others[..alone.len()]);
}

/// Returns the bits of some bodies.
fn bits_of(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> Vec<u64> {
    bodies.iter().map(|&body| world.bodies[body].hash()).collect()
}

/// Returns the bodies that a function adds to a world.
fn added(world: &mut PhysicsWorld, add: impl FnOnce(&mut PhysicsWorld)) -> Vec<RigidBodyHandle> {
    let before: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
    add(world);
    let all = world.bodies.iter().map(|(handle, _)| handle);
    all.filter(|handle| !before.contains(handle)).collect()
}

/// A heap that falls far away changes no bit of another heap. It is inserted and removed, sleeps and wakes
/// while the other heap moves.
#[test]
fn determinism_among_strangers() {
    let run = |has_unrelated: bool| {
        let mut world = PhysicsWorld::new();
        let watched = added(&mut world, |world| heap(world, Vector::ZERO));
        let mut others = Vec::new();
        let mut hashes = Vec::new();
        for step in 0..STEPS {
            if has_unrelated && step == 20 {
                others = added(&mut world, |world| heap(world, vec(2000.0, 0.0)));
            }
            if has_unrelated && step > 60 && step % 10 == 0 {
                others.drain(..5).for_each(|body| drop(world.remove_body(body)));
                let ball = RigidBodyBuilder::dynamic().translation(vec(2000.0, 20.0));
                world.insert(ball.linvel(vec(0.0, -90.0)), ColliderBuilder::ball(0.5));
            }
            world.step();
            hashes.push(bits_of(&world, &watched));
        }
        hashes
    };
    let (alone, among) = (run(false), run(true));
    let first = (0..STEPS).find(|&step| alone[step] != among[step]);
    assert_eq!(first, None, "the first step that differs");
}

/// Steps the workshop beside unrelated bodies, and compares its bodies with those of a workshop alone.
fn compare_workshops(add_unrelated: impl Fn(&mut PhysicsWorld)) {
    let run = |add: &dyn Fn(&mut PhysicsWorld)| {
        let mut world = workshop();
        let watched: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
        add(&mut world);
        let run = |_| {
            world.step();
            bits_of(&world, &watched)
        };
        (0..STEPS).map(run).collect::<Vec<_>>()
    };
    let (alone, among) = (run(&|_| {}), run(&add_unrelated));
    let first = (0..STEPS).find(|&step| alone[step] != among[step]);
    let bodies = first.map(|step| {
        let pairs = alone[step].iter().zip(&among[step]).enumerate();
        pairs.filter(|(_, (one, two))| one != two).map(|(body, _)| body).collect::<Vec<_>>()
    });
    assert_eq!(first, None, "the first step that differs, in the bodies {bodies:?}");
}

/// Adds bodies around a heavy one that they hardly move, with more contacts and joints than colours.
fn hub(world: &mut PhysicsWorld, center: Vector) {
    world.insert(RigidBodyBuilder::fixed().translation(center - vec(0.0, 6.0)), cuboid(9.0, 1.0));
    let hub = RigidBodyBuilder::dynamic().translation(center).angvel(dim::about_z(1.5));
    let (hub, _) = world.insert(hub, ColliderBuilder::ball(3.0).density(5.0).restitution(0.3));
    for k in 0..120_u8 {
        let (sin, cos) = (Real::from(k) * 0.2).sin_cos();
        let arm = vec(cos, sin) * if k % 2 == 0 { 3.04 } else { 3.6 };
        let satellite = RigidBodyBuilder::dynamic().translation(center + arm).linvel(arm * -0.5);
        let ball = ColliderBuilder::ball(0.05).restitution(0.5);
        let (satellite, _) = world.insert(satellite, ball);
        if k % 2 == 1 {
            let joint = dim::loose_joint(0, arm * 0.95, arm * -0.05);
            world.insert_impulse_joint(hub, satellite, joint);
        }
    }
}

#[test]
fn determinism_of_bullets_and_chains_among_strangers() {
    compare_workshops(|world| heap(world, vec(2000.0, 0.0)));
    compare_workshops(|world| net(world, vec(-2000.0, 9.0)));
    compare_workshops(|world| hub(world, vec(2000.0, 9.0)));
}
