//! Conditions of sleep, its effect on cost, and causes of waking.

use super::stage::{G, RATES, add_ground, run, steps, weightless, world};
use crate::dim::{about_z, cuboid, hinge, turned_about_z, vec};
use rapier::prelude::*;

/// Adds a cube with sides of 1 m, with its bottom at this height.
fn add_cube(world: &mut PhysicsWorld, x: Real, bottom: Real) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic().translation(vec(x, bottom + 0.5));
    world.insert(body, cuboid(0.5, 0.5)).0
}

/// Returns ground, a stack of three cubes at 0 and one at 10, all asleep.
fn two_sleeping_stacks(rate: u32) -> (PhysicsWorld, [RigidBodyHandle; 3], [RigidBodyHandle; 3]) {
    let mut world = world(rate);
    add_ground(&mut world, 0.5);
    let stack = |world: &mut PhysicsWorld, x| [0.0, 1.0, 2.0].map(|y| add_cube(world, x, y));
    let (left, right) = (stack(&mut world, 0.0), stack(&mut world, 10.0));
    run(&mut world, 3.0);
    assert_eq!(sleepers(&world, &left) + sleepers(&world, &right), 6, "all sleep after 3 s");
    (world, left, right)
}

fn sleepers(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> usize {
    bodies.iter().filter(|&&body| world.bodies[body].is_sleeping()).count()
}

/// Touching bodies fall asleep in the same step, when the last of them has come to rest.
#[test]
fn an_island_falls_asleep_as_a_unit() {
    for rate in RATES {
        let mut world = world(rate);
        add_ground(&mut world, 0.5);
        let plank = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.1));
        let (plank, _) = world.insert(plank, cuboid(5.0, 0.1));
        // The ball rolls along the plank and stops after three seconds.
        let ball = RigidBodyBuilder::dynamic().translation(vec(-3.0, 0.5)).linvel(vec(1.0, 0.0));
        let ball = ball.linear_damping(0.5).angular_damping(0.5);
        let (ball, _) = world.insert(ball, ColliderBuilder::ball(0.3));
        let mut asleep_at = None;
        for step in 1..=steps(&world, 10.0) {
            world.step();
            let count = sleepers(&world, &[plank, ball]);
            assert!(count != 1, "one of two sleeps at step {step} of {rate} Hz");
            if count == 2 {
                asleep_at = Some(step as Real / rate as Real);
                break;
            }
        }
        let time = asleep_at.unwrap_or(Real::INFINITY);
        assert!((2.0..9.0).contains(&time), "at {rate} Hz they fell asleep after {time} s");
    }
}

/// A sleeping body is not solved, keeps its pose to the bit, and has zero velocity.
#[test]
fn sleep_costs_nothing() {
    for rate in RATES {
        let (mut world, left, _) = two_sleeping_stacks(rate);
        assert!(world.active_bodies().is_empty());
        let pose = *world.bodies[left[2]].position();
        run(&mut world, 1.0);
        let counters = &world.physics_pipeline.counters;
        assert_eq!(counters.solver.nconstraints, 0, "constraints");
        assert_eq!(*world.bodies[left[2]].position(), pose);
        assert_eq!(world.bodies[left[2]].linvel(), Vector::ZERO);
    }
}

/// A body that falls on a sleeping stack wakes all of it, and no other.
#[test]
fn a_falling_body_wakes_the_bodies_that_it_hits() {
    for rate in RATES {
        let (mut world, left, right) = two_sleeping_stacks(rate);
        add_cube(&mut world, 0.0, 4.0);
        let mut woke = 0;
        for _ in 0..steps(&world, 1.0) {
            world.step();
            let count = sleepers(&world, &left);
            assert!(count == 0 || count == 3, "{count} of a stack sleep");
            woke += usize::from(count == 0);
            assert_eq!(sleepers(&world, &right), 3, "the other stack sleeps on");
        }
        assert!(woke > 0, "at {rate} Hz no body woke");
        run(&mut world, 3.0);
        assert!(world.active_bodies().is_empty(), "all sleep again");
    }
}

/// Without its lowest cube, the rest of a stack wakes and falls.
#[test]
fn bodies_without_support_wake_and_fall() {
    for rate in RATES {
        let (mut world, left, right) = two_sleeping_stacks(rate);
        let height = world.bodies[left[2]].translation().y;
        world.remove_body(left[0]);
        world.step();
        assert_eq!(sleepers(&world, &left[1..]), 0, "what stood on it wakes");
        assert_eq!(sleepers(&world, &right), 3, "the other stack sleeps on");
        run(&mut world, 3.0);
        let fallen = height - world.bodies[left[2]].translation().y;
        assert!((fallen - 1.0).abs() < 0.01, "fell by {fallen}");
        assert_eq!(sleepers(&world, &left[1..]), 2);
    }
}

/// The same holds for a support without a body, on a fixed body, or that only moves away.
#[test]
fn bodies_without_ground_wake_and_fall() {
    for how in ["remove the collider", "remove the body", "move the body", "disable the body"] {
        let mut world = world(60);
        let body = RigidBodyBuilder::fixed().translation(vec(0.0, -1.0));
        let (ground, collider) = world.insert(body, cuboid(10.0, 1.0));
        let cube = add_cube(&mut world, 0.0, 0.0);
        run(&mut world, 3.0);
        assert!(world.bodies[cube].is_sleeping());
        match how {
            "remove the collider" => drop(world.remove_collider(collider)),
            "remove the body" => drop(world.remove_body(ground)),
            "move the body" => world.bodies[ground].set_translation(vec(50.0, -1.0), true),
            _ => world.bodies[ground].set_enabled(false),
        }
        run(&mut world, 1.0);
        let y = world.bodies[cube].translation().y;
        assert!(!world.bodies[cube].is_sleeping() && y < -3.0, "{how}: still at {y}");
    }
}

/// A kinematic body that starts to move wakes the bodies on it, and carries them along.
#[test]
fn a_moving_platform_wakes_its_cargo() {
    for rate in RATES {
        let mut world = world(rate);
        let body = RigidBodyBuilder::kinematic_velocity_based().translation(vec(0.0, -1.0));
        let (platform, _) = world.insert(body, cuboid(10.0, 1.0));
        let cube = add_cube(&mut world, 0.0, 0.0);
        run(&mut world, 3.0);
        assert!(world.bodies[cube].is_sleeping(), "a platform at rest lets its cargo sleep");
        world.bodies[platform].set_linvel(vec(0.5, 0.0), true);
        run(&mut world, 2.0);
        let x = world.bodies[cube].translation().x;
        // Friction accelerates the body first: it stays behind by u² / 2µg.
        let formula = 1.0 - 0.5 * 0.5 / (2.0 * 0.5 * G);
        assert!(!world.bodies[cube].is_sleeping(), "it moves");
        assert!((x - formula).abs() < 0.5 / rate as Real, "it came to {x}, not {formula}");
    }
}

/// Pushes wake a body and its neighbours on request.
#[test]
fn pushes_wake_on_request() {
    let pushes: [fn(&mut RigidBody, bool); 4] = [
        |body, wake_up| body.apply_impulse(vec(0.1, 0.0), wake_up),
        |body, wake_up| body.apply_torque_impulse(about_z(0.1), wake_up),
        |body, wake_up| body.add_force(vec(0.1, 0.0), wake_up),
        |body, wake_up| body.set_linvel(vec(0.1, 0.0), wake_up),
    ];
    for push in pushes {
        let (mut world, left, right) = two_sleeping_stacks(60);
        push(&mut world.bodies[left[0]], true);
        world.step();
        assert_eq!((sleepers(&world, &left), sleepers(&world, &right)), (0, 3));
        push(&mut world.bodies[right[0]], false);
        world.step();
        assert_eq!(sleepers(&world, &right), 3, "the push does not wake");
    }
}

/// A drifting body covers the distance of its speed. At 0.3 m/s it was once frozen after half a second.
#[test]
fn a_drifting_body_is_not_frozen() {
    for rate in RATES {
        for speed in [0.06, 0.1, 0.3, 0.39] as [Real; 4] {
            let mut world = weightless(rate);
            let body = RigidBodyBuilder::dynamic().linvel(vec(speed, 0.0));
            let (body, _) = world.insert(body, cuboid(0.5, 0.5));
            run(&mut world, 5.0);
            let x = world.bodies[body].translation().x;
            println!("{rate} Hz, {speed} m/s: came to {x} m in 5 s");
            assert!(!world.bodies[body].is_sleeping(), "{speed} m/s at {rate} Hz");
            assert!((x - 5.0 * speed).abs() < 0.01 * speed, "{x} at {speed} m/s and {rate} Hz");
        }
    }
}

/// The size of a body counts: the tip of a beam of 20 m that rotates at 0.02 rad/s moves at 0.2 m/s.
#[test]
fn a_beam_whose_tip_moves_is_not_frozen() {
    for rate in RATES {
        for spin in [0.02, 0.1, 0.3] as [Real; 3] {
            let mut world = weightless(rate);
            let body = RigidBodyBuilder::dynamic().angvel(about_z(spin));
            let (body, _) = world.insert(body, cuboid(10.0, 0.1));
            run(&mut world, 5.0);
            let angle = turned_about_z(world.bodies[body].rotation());
            assert!(!world.bodies[body].is_sleeping(), "{spin} rad/s at {rate} Hz");
            assert!((angle - 5.0 * spin).abs() < 0.02 * spin, "turned by {angle} at {spin} rad/s");
        }
    }
}

/// A trembling body keeps its place, and may sleep: 0.5 m/s to and fro in alternate steps is 8 mm.
#[test]
fn a_body_that_trembles_sleeps() {
    for rate in [60, 240] {
        let mut world = weightless(rate);
        let (body, _) = world.insert(RigidBodyBuilder::dynamic(), cuboid(0.5, 0.5));
        let slept = (0..steps(&world, 3.0)).any(|step| {
            let speed = if step % 2 == 0 { 0.5 } else { -0.5 };
            world.bodies[body].set_linvel(vec(speed, 0.0), false);
            world.step();
            world.bodies[body].is_sleeping()
        });
        assert!(slept, "it is awake after 3 s of trembling at {rate} Hz");
    }
}

/// A pendulum of 10 m is slow for long at its turning points, and still swings indefinitely.
#[test]
fn a_pendulum_is_not_frozen_where_it_turns() {
    for rate in RATES {
        let mut world = world(rate);
        let (length, angle): (Real, Real) = (10.0, 0.05);
        let pivot = world.insert_body(RigidBodyBuilder::fixed());
        let at = vec(length * angle.sin(), -length * angle.cos());
        let bob = RigidBodyBuilder::dynamic().translation(at).rotation(about_z(angle));
        let (bob, _) = world.insert(bob, ColliderBuilder::ball(0.2));
        world.insert_impulse_joint(pivot, bob, hinge().local_anchor2(vec(0.0, length)));
        // T = 2π √(l / g), within a thousandth at this amplitude; the bob's own inertia adds 8·10⁻⁵.
        let period = std::f64::consts::TAU as Real * (length / G).sqrt();
        run(&mut world, period);
        let x = world.bodies[bob].translation().x;
        assert!(!world.bodies[bob].is_sleeping(), "it stands at {x} at {rate} Hz");
        assert!((x - at.x).abs() < 0.1 * at.x, "after one swing at {x} instead of {}", at.x);
    }
}

/// Ten dominoes, the first slightly out of balance: all of them fall.
#[test]
fn slow_dominoes_do_not_stop_falling() {
    for rate in RATES {
        let mut world = world(rate);
        add_ground(&mut world, 0.6);
        let (half_width, half_height): (Real, Real) = (0.05, 0.5);
        // A domino balances on its edge at this angle.
        let balance = (half_width / half_height).atan();
        let dominoes: Vec<_> = (0..10)
            .map(|k| {
                let lean = if k == 0 { 1.05 * balance } else { 0.0 };
                // The domino has rotated about its lower right edge.
                let edge = 0.4 * k as Real + half_width;
                let (sine, cosine) = lean.sin_cos();
                let x = edge - half_width * cosine + half_height * sine;
                let y = half_width * sine + half_height * cosine;
                let body = RigidBodyBuilder::dynamic().translation(vec(x, y));
                world.insert(body.rotation(about_z(-lean)), cuboid(half_width, half_height)).0
            })
            .collect();
        run(&mut world, 12.0);
        let turned = |body: &RigidBodyHandle| turned_about_z(world.bodies[*body].rotation());
        let angles: Vec<_> = dominoes.iter().map(turned).collect();
        println!("{rate} Hz: {angles:.2?}");
        assert!(angles.iter().all(|angle| *angle < -0.5), "some stand at {rate} Hz: {angles:.2?}");
    }
}

/// Waking one body of a stack wakes all of it, before the next step.
#[test]
fn an_island_wakes_at_once() {
    for strong in [false, true] {
        let (mut world, left, right) = two_sleeping_stacks(60);
        world.islands.wake_up(&mut world.bodies, left[1], strong);
        assert_eq!((sleepers(&world, &left), sleepers(&world, &right)), (0, 3));
        world.step();
        assert_eq!((sleepers(&world, &left), sleepers(&world, &right)), (0, 3));
        run(&mut world, 3.0);
        assert_eq!(sleepers(&world, &left), 3, "it sleeps again");
    }
}

/// A woken island stays awake for the full time until sleep, after a strong or a weak wake-up.
#[test]
fn a_woken_island_stays_awake_for_its_time() {
    for strong in [false, true] {
        let (mut world, left, _) = two_sleeping_stacks(60);
        let time = world.bodies[left[0]].activation().time_until_sleep;
        world.islands.wake_up(&mut world.bodies, left[1], strong);
        run(&mut world, 0.9 * time);
        assert_eq!(sleepers(&world, &left), 0, "asleep before {time} s, strong: {strong}");
        run(&mut world, 0.3 * time);
        assert_eq!(sleepers(&world, &left), 3, "awake after {time} s, strong: {strong}");
    }
}

/// A strong wake-up of an awake body restarts its time until sleep; a weak one does not.
#[test]
fn only_a_strong_wake_up_restarts_the_time_of_an_awake_body() {
    for strong in [false, true] {
        let mut world = world(60);
        add_ground(&mut world, 0.5);
        let cube = add_cube(&mut world, 0.0, 0.0);
        let time = world.bodies[cube].activation().time_until_sleep;
        run(&mut world, 0.7 * time);
        assert!(!world.bodies[cube].is_sleeping());
        world.islands.wake_up(&mut world.bodies, cube, strong);
        run(&mut world, 0.7 * time);
        assert_eq!(world.bodies[cube].is_sleeping(), !strong, "strong: {strong}");
    }
}

/// Returns a ball that bounces without loss, from this height.
fn bouncing_ball(rate: u32, height: Real) -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = world(rate);
    world.integration_parameters.normalized_restitution_velocity_threshold = 0.0;
    add_ground(&mut world, 0.5);
    let ball = ColliderBuilder::ball(0.5).restitution(1.0);
    let ball = ball.restitution_combine_rule(CoefficientCombineRule::Max);
    let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5 + height));
    let (body, _) = world.insert(body, ball);
    (world, body)
}

/// A ball that bounces by less than the drift limit of 12.5 mm stays awake: its mean speed is √(g h / 2), at
/// least 0.16 m/s.
#[test]
fn a_low_bounce_is_not_frozen() {
    for rate in RATES {
        for height in [0.005, 0.01] as [Real; 2] {
            let (mut world, ball) = bouncing_ball(rate, height);
            for step in 0..steps(&world, 5.0) {
                world.step();
                let y = world.bodies[ball].translation().y - 0.5;
                assert!(
                    !world.bodies[ball].is_sleeping(),
                    "{height} m at {rate} Hz: asleep at the height {y} in step {step}"
                );
            }
        }
    }
}

/// Runs a mass on a spring for 4 s. Returns whether it stayed awake.
fn swings_on(rate: u32, amplitude: Real, frequency: Real) -> bool {
    let mut world = weightless(rate);
    let post = world.insert_body(RigidBodyBuilder::fixed());
    let body = RigidBodyBuilder::dynamic().translation(vec(1.0 + amplitude, 0.0));
    let (body, _) = world.insert(body, ColliderBuilder::ball(0.2).mass(1.0));
    let stiffness = (std::f64::consts::TAU as Real * frequency).powi(2);
    let spring = SpringJointBuilder::new(Vector::ZERO, Vector::ZERO, 1.0, stiffness).damping(0.0);
    world.insert_impulse_joint(post, body, spring);
    run(&mut world, 4.0);
    !world.bodies[body].is_sleeping()
}

/// A spring of ±5 mm has the mean speed 4 A f. Above the threshold of 0.05 m/s, which is at 2.5 Hz, it keeps
/// swinging. Below, it may stop like any motion below the threshold.
#[test]
fn a_short_spring_is_not_frozen() {
    for rate in RATES {
        for frequency in [3.0, 4.0, 5.0] as [Real; 3] {
            assert!(swings_on(rate, 0.005, frequency), "{frequency} Hz stopped at {rate} Hz");
        }
    }
}
