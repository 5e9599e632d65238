//! Bodies with `ccd_enabled` do not pass through other bodies, nor through each other.

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

/// Number of bullets that pass through another ball: zero.
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
#[test]
fn bullets_in_file_stop_behind_each_other() {
    for speed in SPEEDS {
        for phase in 0..PHASES {
            let x = throw_file([1.0; 4], speed, 60, phase);
            for x in x {
                assert!(x[0] < 0.0 && x.is_sorted_by(|a, b| a > b), "{speed} m/s: at {x:?}");
            }
        }
    }
}

/// A column of bullets of unequal masses hits a wall: no bullet passes, whatever follows it.
#[test]
fn files_of_unlike_bullets_do_not_pass_walls() {
    let columns = ["densities", "rate", "50", "100", "400", "1000"];
    let mut table = Table::new("files in which one passes a wall of 2 cm, of 20", &columns);
    let files = [[1.0, 3.0, 10.0, 30.0], [1.0, 1.0, 1.0, 100.0], [1.0, 100.0, 1.0, 1.0]];
    for densities in files {
        for rate in [60, 30] {
            let passes = |speed: Real, phase: &usize| {
                let places = throw_file(densities, speed, rate, *phase);
                places.iter().flatten().any(|&x| x > 0.0)
            };
            let count = |speed| (0..PHASES).filter(|phase| passes(speed, phase)).count();
            let counts = SPEEDS.map(count);
            let [a, b, c, d] = counts.map(|count| count.to_string());
            table.row([format!("{densities:?}"), rate.to_string(), a, b, c, d]);
            table.require(counts == [0; 4], "bullets passed");
        }
    }
}

/// Where four bullets are that are thrown at a wall one behind the other, step by step.
fn throw_file(densities: [Real; 4], speed: Real, rate: u32, phase: usize) -> Vec<[Real; 4]> {
    let mut world = weightless(rate);
    world.insert_collider(wall(), None);
    let way = speed / rate as Real * (2.0 + phase as Real / PHASES as Real);
    let mut place = -way;
    let file = densities.map(|density| {
        let bullet = add_bullet(&mut world, vec(place, 0.0), vec(speed, 0.0));
        let collider = world.bodies[bullet].colliders()[0];
        world.colliders[collider].set_density(density);
        place -= 3.0 * RADIUS;
        bullet
    });
    let mut step = || {
        world.step();
        file.map(|bullet| world.bodies[bullet].translation().x)
    };
    (0..20).map(|_| step()).collect()
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
