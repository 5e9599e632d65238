//! Bodies with `ccd_enabled` pass nothing, not even each other.

use super::{PHASES, RADIUS, SPEEDS};
use crate::dim::vec;
use crate::suite::physics::stage::{Dice, weightless};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

fn add_bullet(world: &mut PhysicsWorld, at: Vector, velocity: Vector) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic().translation(at).linvel(velocity).ccd_enabled(true);
    world.insert(body, ColliderBuilder::ball(RADIUS).friction(0.0)).0
}

/// How many of 20 bullets pass what `add_target` puts at the origin, which is hit at this speed.
fn count_passed(
    speed: Real,
    add_target: impl Fn(&mut PhysicsWorld, Real) -> RigidBodyHandle,
) -> usize {
    let passes = |phase: usize| {
        let mut world = weightless(60);
        let way = speed / 60.0 * (2.0 + phase as Real / PHASES as Real);
        let bullet = add_bullet(&mut world, vec(-way, 0.0), vec(speed, 0.0));
        let target = add_target(&mut world, way);
        (0..10).any(|_| {
            world.step();
            let place = |body: RigidBodyHandle| world.bodies[body].translation().x;
            place(bullet) > place(target)
        })
    };
    (0..PHASES).filter(|&phase| passes(phase)).count()
}

#[test]
fn bullets_do_not_pass_each_other() {
    let columns = ["speed", "resting", "head-on", "head-on, one marked", "from behind"];
    let mut table = Table::new("bullets that pass another ball, of 20", &columns);
    for speed in SPEEDS {
        let resting =
            |world: &mut PhysicsWorld, _: Real| add_bullet(world, Vector::ZERO, Vector::ZERO);
        let head_on = |world: &mut PhysicsWorld, way: Real| {
            add_bullet(world, vec(way, 0.0), vec(-speed, 0.0))
        };
        let unmarked = |world: &mut PhysicsWorld, way: Real| {
            super::add_ball(world, vec(way, 0.0), vec(-speed, 0.0))
        };
        let behind = |world: &mut PhysicsWorld, _: Real| {
            add_bullet(world, vec(0.0, 0.0), vec(0.5 * speed, 0.0))
        };
        let counts = [
            count_passed(speed, resting),
            count_passed(speed, head_on),
            count_passed(speed, unmarked),
            count_passed(speed, behind),
        ];
        let [a, b, c, d] = counts.map(|count| count.to_string());
        table.row([format!("{speed}"), a, b, c, d]);
        table.require(counts == [0; 4], "bullets passed");
    }
}

/// Momentum is the same before and after: stopping a body loses time and nothing else.
#[test]
fn bullets_keep_their_momentum() {
    let mut world = weightless(60);
    let mut dice = Dice(7);
    let mut bodies = Vec::new();
    for k in 0..40 {
        let side = if k % 2 == 0 { 1.0 } else { -1.0 };
        let at = vec(side * dice.within(2.0, 12.0), dice.within(-0.5, 0.5));
        bodies.push(add_bullet(&mut world, at, vec(-side * dice.within(50.0, 400.0), 0.0)));
    }
    let momentum = |world: &PhysicsWorld| -> Vector {
        bodies.iter().map(|&b| world.bodies[b].linvel() * world.bodies[b].mass()).sum()
    };
    let before = momentum(&world);
    let scale: Real = bodies.iter().map(|&b| world.bodies[b].mass() * 400.0).sum();
    for _ in 0..60 {
        world.step();
    }
    let off = (momentum(&world) - before).length() / scale;
    assert!(off < 1.0e-4, "{off} of the momentum is gone");
}
