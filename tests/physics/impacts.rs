//! Impacts of several bodies at once: cradles, rows, piles that bounce.

use super::stage::{G, RATES, add_ground, penetration, run, steps, weightless, world};
use super::table::Table;
use crate::dim::{about_z, cuboid, hinge, loose_joint, vec, z_of};
use rapier::prelude::*;

const RADIUS: Real = 0.25;

/// A ball that bounces as it came, without friction.
fn ball(mass: Real) -> ColliderBuilder {
    elastic(ColliderBuilder::ball(RADIUS)).mass(mass)
}

fn elastic(collider: ColliderBuilder) -> ColliderBuilder {
    let collider = collider.restitution(1.0).friction(0.0);
    let collider = collider.restitution_combine_rule(CoefficientCombineRule::Max);
    collider.friction_combine_rule(CoefficientCombineRule::Min)
}

/// The kinetic energy of all bodies (J).
fn kinetic_energy(world: &PhysicsWorld) -> Real {
    world.bodies.iter().map(|(_, body)| body.kinetic_energy()).sum()
}

/// How the balls of a cradle hang.
#[derive(Copy, Clone, Debug)]
enum Strings {
    /// On rods that are part of them.
    Rods,
    /// On strings of light links, at their centres.
    Links,
}

const LENGTH: Real = 2.0;
const LINKS: usize = 4;

/// Hangs a touching row of `count` balls, the first `moving` of which come in at 2 m/s from a tenth of a radian.
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

/// Newton's cradle: as many balls leave as came in, as fast; the others stay.
#[test]
fn newtons_cradle() {
    let columns = ["rate", "strings", "in", "speeds a tenth of a second after the blow"];
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
                // A tenth of a second later a ball has climbed by 2 cm, which takes 0.1 m/s off its speed.
                for (k, speed) in speeds.into_iter().enumerate() {
                    let formula = if k + moving >= balls.len() { 1.9 } else { 0.0 };
                    table.check("the speed", speed, formula, 0.1);
                }
            }
        }
    }
}
