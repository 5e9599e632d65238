//! Closed systems: their energy may decrease but not increase.
//!
//! Bodies start without overlap, with friction and restitution of at most 1. Fitting joints connect some of
//! them. There are no motors and no kinematic bodies, and no edits after the first step. The energy
//! `Σ m v²/2 + ω I ω/2 + m g y` then stays below its initial value, except for two errors of the time step:
//!
//! * Semi-implicit Euler with step `h` falls `g t h / 2` too far in a time `t`. Its energy oscillates by up
//!   to `m g v h / 2` about the true one. `m v²/2` is taken at the end of a step, and the height assumes the
//!   end velocity for the whole step.
//! * Penetration `d` is corrected with up to [`IntegrationParameters::max_corrective_velocity`], which lifts
//!   by `d`. Penetrations are as deep as the motion of one step, `v h`.
//!
//! Both are fractions of `v h / height` of the total. Together with rounding they may reach [`GAIN_MAX`] of
//! the initial energy, plus a lift of [`LIFT_MAX`] for each body.

use super::dim::{cuboid, shape, spin_energy};
use super::groups::OTHERS;
use super::rapier::prelude::*;
use super::values::within;
use super::world::check;
use crate::Tally;
use crate::choices::Choices;

/// Largest energy gain, as a fraction of the initial energy.
const GAIN_MAX: f64 = 0.1;
/// Largest lift of each body by penetration recovery (length units).
const LIFT_MAX: f64 = 0.1;
const GRAVITY: f64 = 9.81;
/// Number of shape kinds with volume, in both dimensions.
const SOLIDS: usize = 5;

/// Builds a world and steps it without external energy.
pub fn run(choices: &mut Choices<'_>) -> Tally {
    let mut world = PhysicsWorld::new();
    let linked = choices.coin();
    let bodies = fill(&mut world, linked, choices);
    let mut tally = Tally { operations: bodies.len(), steps: 0 };
    world.detect_collisions(&(), &());
    let weight: f64 = world.bodies.iter().map(|(_, body)| f64::from(body.mass()) * GRAVITY).sum();
    let first = energy(&world);
    let most = first + GAIN_MAX * first + LIFT_MAX * weight;
    for _ in 0..60 + choices.below(256) {
        world.step();
        tally.steps += 1;
        check(&world);
        let now = energy(&world);
        choices.print(|| format!("step {}: {now:.2} J of {first:.2} J", tally.steps));
        assert!(
            now <= most,
            "the energy rose from {first} to {now} J within {} steps",
            tally.steps
        );
    }
    tally
}

/// Adds bodies on a grid that is wide enough to prevent overlap.
fn fill(world: &mut PhysicsWorld, linked: bool, choices: &mut Choices<'_>) -> Vec<RigidBodyHandle> {
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y).collision_groups(OTHERS), None);
    let mut bodies: Vec<RigidBodyHandle> = Vec::new();
    for k in 0..choices.below(12) + 1 {
        let (column, row) = ((k % 3) as Real, (k / 3) as Real);
        let place = Vector::X * (1.5 * column) + Vector::Y * (1.0 + 1.5 * row);
        let speed = Vector::from_array(Vector::ZERO.to_array().map(|_| within(choices, -4.0, 4.0)));
        let body = RigidBodyBuilder::dynamic()
            .translation(place)
            .linvel(speed)
            .ccd_enabled(choices.once_in(4));
        let solid = shape(choices.below(SOLIDS), 0.4, choices).unwrap_or_else(|| cuboid(0.4));
        let restitution = if choices.coin() { 0.0 } else { within(choices, 0.0, 1.0) };
        let solid = solid.friction(within(choices, 0.0, 1.0)).restitution(restitution);
        choices.print(|| {
            format!(
                "a body with {:?} of restitution {restitution} at {speed}",
                solid.shape.shape_type()
            )
        });
        let (body, _) = world.insert(body, solid.density(within(choices, 0.5, 3.0)));
        if let Some(&before) = bodies.last().filter(|_| choices.once_in(3)) {
            hold(world, [before, body], linked, choices);
        }
        bodies.push(body);
    }
    bodies
}

/// Joins two bodies at their midpoint, in their present poses.
fn hold(
    world: &mut PhysicsWorld,
    [body1, body2]: [RigidBodyHandle; 2],
    linked: bool,
    choices: &mut Choices<'_>,
) {
    let (at1, at2) = (world.bodies[body1].translation(), world.bodies[body2].translation());
    let middle = (at2 - at1) * 0.5;
    let locked = choices.pick(&[JointAxesMask::LIN_AXES, JointAxesMask::all()]);
    let joint = GenericJointBuilder::new(locked).local_anchor1(middle).local_anchor2(-middle);
    choices.print(|| format!("    held by {locked:?}, linked: {linked}"));
    if linked {
        world.insert_multibody_joint(body1, body2, joint.build());
    } else {
        world.insert_impulse_joint(body1, body2, joint.build());
    }
}

/// Returns the kinetic energy plus the potential energy above the ground.
fn energy(world: &PhysicsWorld) -> f64 {
    let of = |body: &RigidBody| {
        let (mass, speed) = (f64::from(body.mass()), f64::from(body.linvel().length()));
        let height = f64::from(body.center_of_mass().y);
        0.5 * mass * speed * speed + spin_energy(body) + mass * GRAVITY * height
    };
    world.bodies.iter().map(|(_, body)| of(body)).sum()
}
