//! Worlds that are left alone: what is in them may lose energy, but not gain any.
//!
//! Bodies without overlap, with friction and restitution of at most 1, some of them held by joints that fit, no
//! motors, nothing kinematic: once the first step begins, nobody touches them. Their kinetic and potential energy
//! `Σ m v²/2 + ω I ω/2 + m g y` is then at most what it was at the beginning, but for what the engine does
//! wrong on purpose or by its finite step:
//!
//! * Semi-implicit Euler with step `h` falls `g t h / 2` too far in a time `t`: its energy swings by up to `m g v h / 2`
//!   about the true one (`m v²/2` is taken at the end of a step, the height as if the end velocity had held during all of it).
//! * Overlap `d` is pushed out with up to [`IntegrationParameters::max_corrective_velocity`], which lifts by `d`.
//!   Overlaps are as deep as one step goes, `v h`.
//!
//! Both are shares of `v h / height` of the whole; together with rounding they are allowed [`SLACK`] of the energy
//! that was there, and the energy of a fall over [`LIFT`] for each body.

use super::colliders::OTHERS;
use super::dim::{cuboid, shape, spin_energy};
use super::rapier::prelude::*;
use super::values::within;
use super::world::check;
use crate::Tally;
use crate::choices::Choices;

/// The share of the first energy that may come on top of it.
const SLACK: f64 = 0.1;
/// Each body may be lifted so high for nothing (length units).
const LIFT: f64 = 0.1;
const GRAVITY: f64 = 9.81;
/// Kinds of shapes that have a volume, in both dimensions.
const SOLIDS: usize = 5;

/// Builds a world and steps it while no energy comes in.
pub fn run(choices: &mut Choices<'_>) -> Tally {
    let mut world = PhysicsWorld::new();
    let linked = choices.coin();
    let bodies = fill(&mut world, linked, choices);
    let mut tally = Tally { operations: bodies.len(), steps: 0 };
    world.detect_collisions(&(), &());
    let weight: f64 = world.bodies.iter().map(|(_, body)| f64::from(body.mass()) * GRAVITY).sum();
    let first = energy(&world);
    let most = first + SLACK * first + LIFT * weight;
    for _ in 0..60 + choices.below(256) {
        world.step();
        tally.steps += 1;
        check(&world);
        let now = energy(&world);
        choices.tell(|| format!("step {}: {now:.2} J of {first:.2} J", tally.steps));
        assert!(
            now <= most,
            "the energy rose from {first} to {now} J within {} steps",
            tally.steps
        );
    }
    tally
}

/// Bodies on a grid, wide enough that none overlaps another.
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
        choices.tell(|| {
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

/// Joins two bodies at the middle between them, where they are.
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
    choices.tell(|| format!("    held by {locked:?}, linked: {linked}"));
    if linked {
        world.insert_multibody_joint(body1, body2, joint.build());
    } else {
        world.insert_impulse_joint(body1, body2, joint.build());
    }
}

/// Kinetic energy, and potential energy above the ground.
fn energy(world: &PhysicsWorld) -> f64 {
    let of = |body: &RigidBody| {
        let (mass, speed) = (f64::from(body.mass()), f64::from(body.linvel().length()));
        let height = f64::from(body.center_of_mass().y);
        0.5 * mass * speed * speed + spin_energy(body) + mass * GRAVITY * height
    };
    world.bodies.iter().map(|(_, body)| of(body)).sum()
}
