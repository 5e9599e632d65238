//! Simultaneous impacts of several bodies: cradles, rows, elastic piles.

use super::stage::{G, RATES, add_ground, penetration, run, steps, substep, weightless, world};
use super::table::Table;
use crate::dim::{about_z, cuboid, hinge, loose_joint, vec, z_of};
use rapier::prelude::*;

const RADIUS: Real = 0.25;

/// Returns a frictionless elastic ball of this mass.
fn ball(mass: Real) -> ColliderBuilder {
    elastic(ColliderBuilder::ball(RADIUS)).mass(mass)
}

fn elastic(collider: ColliderBuilder) -> ColliderBuilder {
    let collider = collider.restitution(1.0).friction(0.0);
    let collider = collider.restitution_combine_rule(CoefficientCombineRule::Max);
    collider.friction_combine_rule(CoefficientCombineRule::Min)
}

/// Returns the kinetic energy of all bodies (J).
fn kinetic_energy(world: &PhysicsWorld) -> Real {
    world.bodies.iter().map(|(_, body)| body.kinetic_energy()).sum()
}

/// Suspension of a cradle's balls.
#[derive(Copy, Clone, Debug)]
enum Strings {
    /// Rods that belong to the balls.
    Rods,
    /// Strings of light links, at the balls' centres.
    Links,
}

const LENGTH: Real = 2.0;
const LINKS: usize = 4;

/// Hangs a touching row of `count` balls. The first `moving` of them arrive at 2 m/s from a tenth of a
/// radian.
fn cradle(
    world: &mut PhysicsWorld,
    count: usize,
    moving: usize,
    strings: Strings,
) -> Vec<RigidBodyHandle> {
    let hang = |k: usize| {
        let angle: Real = if k < moving { -0.1 } else { 0.0 };
        let fallen = 2.0 * G * LENGTH * (1.0 - angle.cos());
        let spin = if k < moving { (4.0 - fallen).sqrt() / LENGTH } else { 0.0 };
        let post = vec(2.0 * RADIUS * k as Real, LENGTH);
        let along = vec(angle.sin(), -angle.cos());
        let tangent = vec(angle.cos(), angle.sin());
        let body = |distance: Real| {
            RigidBodyBuilder::dynamic()
                .translation(post + along * distance)
                .rotation(about_z(angle))
                .linvel(tangent * (spin * distance))
                .angvel(about_z(spin))
                .can_sleep(false)
        };
        let mut last = world.insert_body(RigidBodyBuilder::fixed().translation(post));
        let (bob, _) = world.insert(body(LENGTH), ball(1.0));
        match strings {
            Strings::Rods => {
                let joint = hinge().local_anchor2(vec(0.0, LENGTH));
                world.insert_impulse_joint(last, bob, joint);
            }
            Strings::Links => {
                let half = 0.5 * LENGTH / LINKS as Real;
                let mut anchor = Vector::ZERO;
                for link in 0..LINKS {
                    let shape = cuboid(0.02, half).mass(0.01);
                    let shape = shape.collision_groups(InteractionGroups::none());
                    let (next, _) = world.insert(body((2 * link + 1) as Real * half), shape);
                    let joint = hinge().local_anchor1(anchor).local_anchor2(vec(0.0, half));
                    world.insert_impulse_joint(last, next, joint);
                    (last, anchor) = (next, vec(0.0, -half));
                }
                world.insert_impulse_joint(last, bob, loose_joint(0, anchor, Vector::ZERO));
            }
        }
        bob
    };
    (0..count).map(hang).collect()
}

/// Newton's cradle: the number of outgoing balls and their speed equal those of the incoming ones.
/// The other balls stay.
#[test]
fn newtons_cradle() {
    let columns = ["rate", "strings", "in", "speeds a tenth of a second after the impact"];
    let mut table = Table::new("cradle of 5 balls at 2 m/s", &columns);
    for rate in RATES {
        for strings in [Strings::Rods, Strings::Links] {
            for moving in [1, 2] {
                let mut world = world(rate);
                let balls = cradle(&mut world, 5, moving, strings);
                run(&mut world, 0.2);
                let speeds: Vec<_> =
                    balls.iter().map(|&ball| world.bodies[ball].linvel().length()).collect();
                let listed: Vec<_> = speeds.iter().map(|speed| format!("{speed:.3}")).collect();
                table.row([
                    rate.to_string(),
                    format!("{strings:?}"),
                    moving.to_string(),
                    listed.join(" "),
                ]);
                // After a tenth of a second a ball has risen by 2 cm, which reduces its speed by 0.1 m/s.
                for (k, speed) in speeds.into_iter().enumerate() {
                    let formula = if k + moving >= balls.len() { 1.9 } else { 0.0 };
                    table.check("the speed", speed, formula, 0.1);
                }
            }
        }
    }
}

/// Adds a row of touching balls at rest, except for the first, which arrives from a ball's width away. They
/// float, or lie on elastic ground.
fn row(rate: u32, masses: &[Real], on_ground: bool) -> (PhysicsWorld, Vec<RigidBodyHandle>) {
    let mut world = if on_ground { world(rate) } else { weightless(rate) };
    if on_ground {
        let ground = add_ground(&mut world, 0.0);
        world.colliders[ground].set_restitution(1.0);
    }
    let insert = |(k, &mass): (usize, &Real)| {
        let first = k == 0;
        let place = 2.0 * RADIUS * k as Real - if first { 2.0 * RADIUS } else { 0.0 };
        let body = RigidBodyBuilder::dynamic()
            .translation(vec(place, RADIUS))
            .linvel(vec(if first { 3.0 } else { 0.0 }, 0.0));
        world.insert(body, ball(mass)).0
    };
    let balls = masses.iter().enumerate().map(insert).collect();
    (world, balls)
}

/// An impact travels along a row of balls of different masses. Each pair separates like an isolated
/// pair: `v' = 2 m v / (m + m')`. Momentum and energy are constant.
#[test]
fn rows_transmit_an_impact() {
    let columns = ["rate", "masses", "ground", "last (m/s)", "formula", "momentum", "energy"];
    let mut table = Table::new("row of balls hit at 3 m/s", &columns);
    let rows: [&[Real]; 4] =
        [&[1.0; 5], &[1.0; 12], &[1.0, 1.0, 1.0, 3.0], &[8.0, 4.0, 2.0, 1.0, 0.5]];
    for rate in RATES {
        for masses in rows {
            for on_ground in [false, true] {
                let (mut world, balls) = row(rate, masses, on_ground);
                let (energy, momentum) = (kinetic_energy(&world), 3.0 * masses[0]);
                run(&mut world, 0.3);
                let passed = |v: Real, pair: &[Real]| v * 2.0 * pair[0] / (pair[0] + pair[1]);
                let formula = masses.windows(2).fold(3.0, passed);
                let velocity = |k: usize| world.bodies[balls[k]].linvel().x;
                let momenta = masses.iter().enumerate().map(|(k, mass)| mass * velocity(k));
                let (momenta, kept) = (momenta.sum::<Real>(), kinetic_energy(&world) / energy);
                let last = velocity(balls.len() - 1);
                table.row([
                    rate.to_string(),
                    format!("{masses:?}"),
                    on_ground.to_string(),
                    format!("{last:.4}"),
                    format!("{formula:.4}"),
                    format!("{:+.2e}", momenta / momentum - 1.0),
                    format!("{:+.2e}", kept - 1.0),
                ]);
                // An approach below one centimetre per second stops without a bounce.
                table.check("the last one's speed", last, formula, 0.01 * formula);
                table.check("the momentum", momenta, momentum, 1.0e-4 * momentum);
                table.check("the share of energy", kept, 1.0, 0.002);
            }
        }
    }
}

/// Returns the energy of all bodies (J), with heights at the middle of the last substep, in agreement with
/// the velocities.
fn energy(world: &PhysicsWorld) -> Real {
    let half = 0.5 * substep(world);
    let height = |body: &RigidBody| body.translation().y - half * body.linvel().y;
    let fallen = world.bodies.iter().map(|(_, body)| body.mass() * G * height(body));
    kinetic_energy(world) + fallen.sum::<Real>()
}

/// Returns the largest energy gain and the remaining energy, as fractions of the energy of the fall.
fn gain(world: &mut PhysicsWorld, seconds: Real, fall: Real) -> [Real; 2] {
    let (first, mut most) = (energy(world), energy(world));
    for _ in 0..steps(world, seconds) {
        world.step();
        most = most.max(energy(world));
    }
    [(most - first) / fall, 1.0 + (energy(world) - first) / fall]
}

/// Elastic piles: impacts between moving and resting bodies do not increase the energy.
#[test]
fn piles_do_not_gain_energy() {
    let mut table = Table::new("elastic piles, 4 s", &["rate", "pile", "gain", "left"]);
    for rate in RATES {
        for (name, shape, places) in [
            ("ball on ball", ball(1.0), vec![RADIUS, 2.0]),
            ("three balls", ball(1.0), vec![1.0, 1.6, 2.2]),
            ("two boxes", elastic(cuboid(0.25, 0.25)).mass(1.0), vec![1.25, 1.75]),
        ] {
            let mut world = world(rate);
            add_ground(&mut world, 0.0);
            let mut fall = 0.0;
            for (k, &y) in places.iter().enumerate() {
                let body = RigidBodyBuilder::dynamic().translation(vec(0.0, y)).can_sleep(false);
                let (body, _) = world.insert(body, shape.clone());
                fall += world.bodies[body].mass() * G * (y - RADIUS - 2.0 * RADIUS * k as Real);
            }
            let [gain, left] = gain(&mut world, 4.0, fall);
            table.row([
                rate.to_string(),
                name.to_string(),
                format!("{gain:+.4}"),
                format!("{left:.4}"),
            ]);
            // A bounce is accurate to second order: `g² h²`, for each of some bounces.
            let tolerance = 0.001 + 10.0 * (G * substep(&world)).powi(2) / fall;
            table.require(gain < tolerance, &format!("gains {gain}, more than {tolerance}"));
        }
    }
}

/// Elastic balls in a closed box without gravity: the energy does not grow.
#[test]
fn gases_do_not_gain_energy() {
    let mut table = Table::new("elastic gas, 2 s", &["rate", "highest", "left", "overlap"]);
    for rate in RATES {
        let mut world = weightless(rate);
        let mut dice = super::stage::Dice(7);
        for (x, y, across, up) in [
            (3.0, 0.0, 0.5, 4.0),
            (-3.0, 0.0, 0.5, 4.0),
            (0.0, 3.0, 4.0, 0.5),
            (0.0, -3.0, 4.0, 0.5),
        ] {
            world.insert_collider(elastic(cuboid(across, up)).translation(vec(x, y)), None);
        }
        for k in 0..64 {
            let place = vec((k % 8) as Real * 0.56 - 1.96, (k / 8) as Real * 0.56 - 1.96);
            let velocity = vec(dice.within(-5.0, 5.0), dice.within(-5.0, 5.0));
            let body = RigidBodyBuilder::dynamic().translation(place).linvel(velocity);
            world.insert(body, ball(1.0));
        }
        let first = kinetic_energy(&world);
        let mut most: Real = 0.0;
        for _ in 0..steps(&world, 2.0) {
            world.step();
            most = most.max(kinetic_energy(&world) / first);
        }
        let left = kinetic_energy(&world) / first;
        let overlap = penetration(&world);
        table.row([
            rate.to_string(),
            format!("{most:.5}"),
            format!("{left:.4}"),
            format!("{overlap:.3}"),
        ]);
        // Contacts below 1 m/s are pushed apart softly, with a small error.
        table.check("the highest energy", most, 1.0, 1.0e-3);
        table.require(left > 0.8, "approaches faster than 1 m/s keep their energy");
    }
}

/// A box that lands on a face rises without rotation at `e` times its speed, on every ground.
#[test]
fn flat_landings_rise_flat() {
    let columns = ["rate", "e", "ground", "apex (m)", "formula", "turning (rad/s)"];
    let mut table = Table::new("box that falls by 1 m", &columns);
    for rate in RATES {
        for restitution in [0.5, 1.0] {
            for tiles in [1, 2, 3] {
                let mut world = world(rate);
                let wide = 4.0 / tiles as Real;
                for tile in 0..tiles {
                    let x = (tile as Real + 0.5) * wide - 2.0;
                    let body = RigidBodyBuilder::fixed().translation(vec(x, -0.5));
                    world.insert(body, cuboid(0.5 * wide, 0.5));
                }
                let shape = cuboid(0.75, 0.25).restitution(restitution);
                let shape = shape.restitution_combine_rule(CoefficientCombineRule::Max);
                let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 1.25));
                let (body, _) = world.insert(body, shape);
                let (mut apex, mut turning, mut rose): (Real, Real, bool) = (0.0, 0.0, false);
                for _ in 0..steps(&world, 1.5) {
                    world.step();
                    let body = &world.bodies[body];
                    rose |= body.linvel().y > 0.0;
                    if rose && body.linvel().y < 0.0 {
                        break;
                    }
                    if rose {
                        apex = apex.max(body.translation().y - 0.25);
                        turning = turning.max(z_of(body.angvel()).abs());
                    }
                }
                let formula = restitution * restitution;
                table.row([
                    rate.to_string(),
                    restitution.to_string(),
                    tiles.to_string(),
                    format!("{apex:.4}"),
                    format!("{formula:.4}"),
                    format!("{turning:.4}"),
                ]);
                table.check("the apex", apex, formula, 0.01);
                table.check("its turning", turning, 0.0, 0.01);
            }
        }
    }
}

/// Friction acts during an impact: a spinning ball that falls vertically leaves sideways. Sufficient
/// friction stops the slip `ω r`, and `v = ω r / (1 + m r² / I)`. Otherwise `v = µ (1 + e) u`, with
/// the normal speed `u`.
#[test]
fn impacts_have_friction() {
    let columns = ["rate", "friction", "sideways", "formula"];
    let mut table = Table::new("spinning ball, 20 rad/s, that falls at 4 m/s", &columns);
    for rate in RATES {
        for friction in [0.1, 1.0] {
            let mut world = weightless(rate);
            add_ground(&mut world, friction);
            let shape = ColliderBuilder::ball(RADIUS).restitution(0.5).friction(friction);
            let shape = shape.restitution_combine_rule(CoefficientCombineRule::Max);
            let body = RigidBodyBuilder::dynamic()
                .translation(vec(0.0, 0.6))
                .linvel(vec(0.0, -4.0))
                .angvel(about_z(-20.0));
            let (body, _) = world.insert(body, shape);
            run(&mut world, 0.3);
            let body = &world.bodies[body];
            // The ball rolls off: `I ω = (I + m r²) ω'`; the fraction of the ball's inertia is 1 -
            // ROLLING_BALL.
            let rolls = 20.0 * RADIUS * (1.0 - crate::dim::ROLLING_BALL);
            let formula = rolls.min(friction * 1.5 * 4.0);
            let sideways = body.linvel().x;
            table.row([
                rate.to_string(),
                friction.to_string(),
                format!("{sideways:.4}"),
                format!("{formula:.4}"),
            ]);
            // The moment arm of the impact ends midway between the surfaces. They are up to a substep's
            // motion apart, or overlap by up to a step's motion.
            let tolerance = 0.5 * 4.0 / rate as Real / RADIUS;
            table.check("the speed sideways", sideways, formula, tolerance * formula);
        }
    }
}
