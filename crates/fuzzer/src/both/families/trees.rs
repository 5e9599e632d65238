//! Multibodies that are thrown, without motors and springs: their energy does not increase.
//!
//! Trees, tolerance and its reasons are those of `tests/multibody/energy.rs`. Link masses range from 1 to 10
//! kg, and speeds up to 150 m/s in empty space and 30 m/s among walls. A known defect is outside these
//! ranges. Links that rotate at hundreds of rad/s and collide at mass ratios of 1:74 gain energy in one of
//! some thousand trees.

use super::dim::{TREE_LOCKS, cuboid};
use super::groups::OTHERS;
use super::rapier::prelude::*;
use super::room;
use super::thin::turn;
use super::values::within;
use super::world::check;
use crate::Tally;
use crate::choices::Choices;

const STEPS: usize = 60;
/// Largest energy gain, as a fraction of the initial kinetic energy plus `m g L`.
const GAIN_MAX: f64 = 0.06;
/// Largest mass ratio.
const MASS_RATIO_MAX: f64 = 10.0;
/// Largest speed (m/s) among walls, and in empty space.
const SPEED_MAX: [f64; 2] = [30.0, 150.0];
/// Largest component of the angular velocities, as a multiple of the speed (rad/m).
const SPIN: f64 = 0.5;
/// Distance of two links (m).
const SPACING: Real = 0.4;

/// Properties common to all links of a tree.
struct Throw {
    is_among_walls: bool,
    speed: Real,
    direction: Vector,
    mass_ratio: f64,
    restitution: Real,
    has_limits: bool,
}

/// Throws one tree.
pub fn run(choices: &mut Choices<'_>) -> Tally {
    let mut world = PhysicsWorld::new();
    let throw = some_throw(choices);
    if throw.is_among_walls {
        room::build(&mut world, choices);
    }
    if choices.coin() {
        world.gravity = Vector::ZERO;
    }
    let links = fill(&mut world, &throw, choices);
    world.step();
    let mut tally = Tally { operations: links.len(), steps: 1 };
    let scale = scale(&world, &links);
    let mut least = energy(&world, &links);
    for _ in 0..STEPS {
        world.step();
        tally.steps += 1;
        check(&world);
        let now = energy(&world, &links);
        choices.print(|| format!("step {}: {now:.4} J", tally.steps));
        let gain = (now - least) / scale.max(f64::MIN_POSITIVE);
        assert!(
            gain <= GAIN_MAX,
            "the energy of a tree rose by {:.1} % within {} steps",
            100.0 * gain,
            tally.steps
        );
        least = least.min(now);
    }
    tally
}

fn some_throw(choices: &mut Choices<'_>) -> Throw {
    let is_among_walls = choices.coin();
    let speed_max = SPEED_MAX[usize::from(!is_among_walls)];
    let mut aim = || within(choices, -1.0, 1.0);
    let direction = Vector::from_array(Vector::ZERO.to_array().map(|_| aim()));
    Throw {
        is_among_walls,
        speed: within(choices, 0.0, speed_max),
        direction: direction.normalize_or_zero(),
        mass_ratio: choices.pick(&[1.0, MASS_RATIO_MAX]),
        restitution: choices.pick(&[0.0, 0.3, 0.6, 1.0]),
        has_limits: choices.once_in(3),
    }
}

/// Adds a chain or a branched tree in a row, without overlap.
fn fill(
    world: &mut PhysicsWorld,
    throw: &Throw,
    choices: &mut Choices<'_>,
) -> Vec<RigidBodyHandle> {
    let count = 2 + choices.below(11);
    let is_chain = choices.coin();
    let mut links: Vec<RigidBodyHandle> = Vec::new();
    for k in 0..count {
        let x = SPACING * (k as Real - 0.5 * count as Real);
        let at = Vector::X * x + Vector::Y * (2.0 + within(choices, -0.2, 0.2));
        let body = RigidBodyBuilder::dynamic()
            .translation(at)
            .linvel(throw.direction * throw.speed)
            .angvel(turn(choices, SPIN * f64::from(throw.speed)))
            .can_sleep(false);
        let (link, _) = world.insert(body, some_link(throw, choices));
        if k > 0 {
            let parent = if is_chain { k - 1 } else { choices.below(k) };
            join(world, [links[parent], link], throw, choices);
        }
        links.push(link);
    }
    links
}

fn some_link(throw: &Throw, choices: &mut Choices<'_>) -> ColliderBuilder {
    let size = within(choices, 0.05, 0.15);
    let shape = match choices.below(3) {
        0 => ColliderBuilder::ball(size),
        1 => cuboid(size),
        _ => ColliderBuilder::capsule_x(0.5 * size, 0.5 * size),
    };
    let mass = throw.mass_ratio.powf(choices.within(0.0, 1.0)) as Real;
    choices.print(|| format!("a link of {size} m and {mass} kg"));
    let friction = within(choices, 0.0, 1.0);
    let shape = shape.mass(mass).restitution(throw.restitution).friction(friction);
    shape.collision_groups(OTHERS)
}

fn join(
    world: &mut PhysicsWorld,
    [parent, link]: [RigidBodyHandle; 2],
    throw: &Throw,
    choices: &mut Choices<'_>,
) {
    let [from, at] = [parent, link].map(|body| world.bodies[body].translation());
    let middle = (at + from) * 0.5;
    let locks = choices.pick(&TREE_LOCKS);
    choices.print(|| format!("    joined with {locks:?}"));
    let mut joint = GenericJointBuilder::new(locks)
        .local_anchor1(middle - from)
        .local_anchor2(middle - at)
        .contacts_enabled(false);
    if locks == JointAxesMask::LOCKED_PRISMATIC_AXES {
        joint = joint.limits(JointAxis::LinX, [-0.1, 0.1]);
    }
    if throw.has_limits {
        joint = joint.limits(JointAxis::AngX, [-0.5, 0.5]);
    }
    world.insert_multibody_joint(parent, link, joint.build());
}

/// Returns the energy of all links, with heights at the middle of the last substep, in agreement with their
/// velocities.
fn energy(world: &PhysicsWorld, links: &[RigidBodyHandle]) -> f64 {
    let half = 0.5 * world.integration_parameters.substep();
    let of = |&link: &RigidBodyHandle| {
        let body = &world.bodies[link];
        let height = body.center_of_mass().y - half * body.linvel().y;
        f64::from(body.kinetic_energy() + body.mass() * world.gravity.length() * height)
    };
    links.iter().map(of).sum()
}

/// Returns the reference for energy gains: the kinetic energy plus the potential energy of a fall by the
/// tree's length.
fn scale(world: &PhysicsWorld, links: &[RigidBodyHandle]) -> f64 {
    let length = SPACING * links.len() as Real;
    let of = |&link: &RigidBodyHandle| {
        let body = &world.bodies[link];
        f64::from(body.kinetic_energy() + body.mass() * world.gravity.length() * length)
    };
    links.iter().map(of).sum()
}
