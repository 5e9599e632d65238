//! Continuous collision detection: bodies do not pass through others.
//!
//! Balls of 10 cm move by up to 330 times their size in a step of 1/60 s. Each case runs from 20
//! initial positions, a twentieth of the motion of one step apart, so that no single phase hides a
//! gap.

mod bullets;
mod chains;
mod divided;
mod drives;
mod links;
mod paths;
mod presses;
mod rotations;
mod sensors;
mod settings;
mod surfaces;
mod throws;

use crate::dim::grounds::GROUNDS;
use crate::dim::{about_z, cuboid, vec};
use crate::suite::physics::stage::weightless;
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Speeds of the balls (m/s).
pub const SPEEDS: [Real; 4] = [50.0, 100.0, 400.0, 1000.0];
/// Number of initial positions of each ball.
pub const PHASES: usize = 20;
/// Radius of the balls (m).
pub const RADIUS: Real = 0.05;

/// Returns a wall of 2 cm in the plane x = 0, wide enough that no ball goes round it.
pub fn wall() -> ColliderBuilder {
    cuboid(500.0, 0.01).rotation(about_z(core::f64::consts::FRAC_PI_2 as Real))
}

/// Adds a ball without friction and restitution.
pub fn add_ball(world: &mut PhysicsWorld, at: Vector, velocity: Vector) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic().translation(at).linvel(velocity);
    world.insert(body, ColliderBuilder::ball(RADIUS).friction(0.0)).0
}

/// Returns the number of balls that are beyond `passed` after some steps at this speed. `shoot` adds a ball
/// to a world.
fn count_passed(
    speed: Real,
    shoot: impl Fn(&mut PhysicsWorld, Real) -> RigidBodyHandle,
    passed: impl Fn(Vector) -> bool,
) -> usize {
    let in_one_step = speed / 60.0;
    let passes = |phase: usize| {
        let mut world = weightless(60);
        let way = in_one_step * (2.0 + phase as Real / PHASES as Real);
        let ball = shoot(&mut world, way);
        (0..10).any(|_| {
            world.step();
            passed(world.bodies[ball].translation())
        })
    };
    (0..PHASES).filter(|&phase| passes(phase)).count()
}

/// Number of balls that pass through a wall: zero.
#[test]
fn walls_are_not_passed() {
    let mut table =
        Table::new("balls that pass a wall of 2 cm, of 20", &["speed", "straight", "aslant"]);
    for speed in SPEEDS {
        let through = |direction: Vector| {
            let shoot = |world: &mut PhysicsWorld, way: Real| {
                world.insert_collider(wall(), None);
                add_ball(world, direction * -(way + RADIUS), direction * speed)
            };
            count_passed(speed, shoot, |at| at.x > 0.0)
        };
        let counts = [through(vec(1.0, 0.0)), through(vec(0.6, 0.8))];
        table.row([format!("{speed}"), counts[0].to_string(), counts[1].to_string()]);
        table.require(counts == [0, 0], "balls passed");
    }
}

/// Number of balls that pass through a ground of each kind: zero.
#[test]
fn grounds_are_not_passed() {
    let mut table =
        Table::new("balls that pass a ground, of 20", &["ground", "50", "100", "400", "1000"]);
    for (name, lay) in GROUNDS {
        let counts = SPEEDS.map(|speed| {
            let shoot = |world: &mut PhysicsWorld, way: Real| {
                lay(world, Pose::IDENTITY, 0.0);
                add_ball(world, vec(7.3, way + RADIUS), vec(0.0, -speed))
            };
            count_passed(speed, shoot, |at| at.y < -RADIUS)
        });
        let [a, b, c, d] = counts.map(|count| count.to_string());
        table.row([name.to_owned(), a, b, c, d]);
        table.require(counts == [0; 4], "balls passed");
    }
}
