//! Thin shapes that are thrown in a closed room: no shape tunnels through the floor.
//!
//! The shapes are at least 2 cm wide along their narrowest axis, and have no thinner tips. The floor is thin
//! and of any kind. Speeds range from 0 to 600 m/s, and most bodies tumble. `docs/guide/fast-bodies.md` lists
//! the cases without a guarantee: slivers, spikes, grounds a thousand times as large, pairs that hooks
//! filter, and bodies under pressure from others. The shapes here avoid these cases, and each room holds one
//! body.

use super::rapier::prelude::*;
use super::room::{self, SIZE, is_outside};
use super::thin::{thin_shape, turn};
use super::values::within;
use super::world::check;
use crate::Tally;
use crate::choices::Choices;

/// Number of steps of 1/60 s: the fastest bodies cross the room about a hundred times.
const STEPS: usize = 90;
/// Largest depth of a body's middle below the surface (m). The floors are 2 cm thick, so a deeper body has
/// passed.
const DEPTH_MAX: Real = 0.03;
/// Ranges of speed (m/s).
const SPEEDS: [[f64; 2]; 3] = [[0.0, 5.0], [5.0, 40.0], [40.0, 600.0]];

/// Throws one body.
pub fn run(choices: &mut Choices<'_>) -> Tally {
    let mut world = PhysicsWorld::new();
    room::build(&mut world, choices);
    let body = throw(&mut world, choices);
    let mut tally = Tally { operations: 1, steps: 0 };
    for _ in 0..STEPS {
        world.step();
        tally.steps += 1;
        check(&world);
        let at = world.bodies[body].center_of_mass();
        choices.print(|| {
            let body = &world.bodies[body];
            format!("step {}: at {at}, {:?}", tally.steps, body.vels())
        });
        assert!(!is_outside(at, DEPTH_MAX), "a body left the room: it is at {at}");
    }
    tally
}

fn throw(world: &mut PhysicsWorld, choices: &mut Choices<'_>) -> RigidBodyHandle {
    let shape = thin_shape(choices);
    let [slow, fast] = choices.pick(&SPEEDS);
    let speed = within(choices, slow, fast);
    let mut aside = || within(choices, -0.7, 0.7);
    let direction = Vector::from_array(Vector::ZERO.to_array().map(|_| aside()));
    let direction = (direction - Vector::Y).normalize_or_zero();
    // The body overlaps nothing at the start: no shape reaches farther than 2.1 m.
    let mut place = || within(choices, -1.5, 1.5);
    let place = Vector::from_array(Vector::ZERO.to_array().map(|_| place()));
    let spin = choices.pick(&[0.0, 12.0]);
    let body = RigidBodyBuilder::dynamic()
        .translation(place + Vector::Y * SIZE)
        .rotation(turn(choices, 3.0))
        .linvel(direction * speed)
        .angvel(turn(choices, spin))
        .ccd_enabled(choices.once_in(4));
    choices.print(|| format!("{:?} at {speed} m/s along {direction}", shape.shape.shape_type()));
    let shape = shape.restitution(within(choices, 0.0, 1.0)).friction(within(choices, 0.0, 1.0));
    world.insert(body, shape).0
}
