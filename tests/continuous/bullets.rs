//! Bodies with `ccd_enabled` pass nothing, not even each other.

use super::{PHASES, RADIUS, SPEEDS, wall};
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

/// A file of bullets at one speed: the first hits a wall and stops, and the others do not go on through it.
///
/// At 1000 m/s the second can press the first, which touches the wall, through it: what one visit of the contacts leaves of that
/// speed is a way of centimetres in a substep.
#[test]
fn bullets_in_file_stop_behind_each_other() {
    for speed in SPEEDS.into_iter().filter(|speed| *speed <= 400.0) {
        for phase in 0..PHASES {
            let mut world = weightless(60);
            world.insert_collider(wall(), None);
            let way = speed / 60.0 * (2.0 + phase as Real / PHASES as Real);
            let place = |k: usize| vec(-way - 3.0 * RADIUS * k as Real, 0.0);
            let file: Vec<_> =
                (0..4).map(|k| add_bullet(&mut world, place(k), vec(speed, 0.0))).collect();
            for _ in 0..20 {
                world.step();
                let x: Vec<Real> = file.iter().map(|&b| world.bodies[b].translation().x).collect();
                assert!(
                    x[0] < 0.0 && x.is_sorted_by(|a, b| a > b),
                    "{speed} m/s: they are at {x:?}"
                );
            }
        }
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
