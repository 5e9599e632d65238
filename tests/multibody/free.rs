//! Free tumbling conserves energy and momentum.

use super::stage::{angular_momentum, chain, kinetic_energy, momentum};
use crate::dim::{about_z, ang_length, tumble, vec};
use crate::suite::physics::stage::{Dice, RATES, rounding, run, steps, substep, weightless};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A chain of six links without gravity starts with arbitrary velocities: it coils, uncoils and
/// tumbles. Energy and momentum are constant.
#[test]
fn a_tumbling_chain_keeps_energy_and_momentum() {
    let columns = ["rate", "largest error of E (%)", "after 10 s (%)", "of P (%)", "of L (%)"];
    let mut table = Table::new("chain of 6 links, tumbling for 10 s", &columns);
    for rate in RATES {
        let mut world = weightless(rate);
        let chain = chain(&mut world, None, 6);
        let mut dice = Dice(7);
        for (k, &body) in chain.bodies.iter().enumerate() {
            let spin = tumble(2.0 + k as Real * 0.3, dice.within(-1.0, 1.0));
            world.bodies[body].set_angvel(spin, true);
            let drift = vec(0.5, (k as Real - 2.5) * 2.0 + dice.within(-0.5, 0.5));
            world.bodies[body].set_linvel(drift, true);
        }
        world.step();
        let bodies = &chain.bodies;
        let (energy, linear) = (kinetic_energy(&world, bodies), momentum(&world, bodies));
        let angular = angular_momentum(&world, bodies);
        let (mut largest, mut error): (Real, Real) = (0.0, 0.0);
        let mut fastest: Real = 0.0;
        for _ in 0..steps(&world, 10.0) {
            world.step();
            error = kinetic_energy(&world, bodies) / energy - 1.0;
            largest = largest.max(error.abs());
            for &body in bodies {
                fastest = fastest.max(ang_length(world.bodies[body].angvel()));
            }
        }
        let lost = (momentum(&world, bodies) - linear).length() / linear.length();
        let turned = ang_length(angular_momentum(&world, bodies) - angular) / ang_length(angular);
        table.row([
            rate.to_string(),
            format!("{:.5}", largest * 100.0),
            format!("{:+.5}", error * 100.0),
            format!("{:.6}", lost * 100.0),
            format!("{:.6}", turned * 100.0),
        ]);
        // Of second order in the angle of a substep, for the fastest link there was.
        let angle = fastest * substep(&world);
        table.check("the error of the energy", largest, 0.0, Real::max(0.01, angle * angle));
        if rate >= 60 {
            table.check("the error of the energy", largest, 0.0, 0.01);
        }
        // Kept by construction: what is left is rounding, in each substep, of speeds several times the mean.
        // About the axis along which the chain is thin, what a flight misses, in third order, is made up for
        // slowly, by a tenth in a substep: that of ten may be open.
        let drift = rounding(steps(&world, 10.0) * 4, 8.0);
        table.check("the error of the momentum", lost, 0.0, drift);
        let open = 10.0 * angle.powi(3) / 12.0;
        table.check("the error of the angular momentum", turned, 0.0, drift + open);
    }
}

/// A chain that falls is a chain without gravity, seen from something that falls: its centre of mass falls as
/// a ball does.
#[test]
fn a_chain_falls_like_a_ball() {
    let mut world = crate::suite::physics::stage::world(60);
    let chain = chain(&mut world, None, 4);
    let ball = world.insert_body(crate::suite::joints::stage::bob(1.0, 0.1));
    world.bodies[chain.bodies[1]].set_angvel(about_z(3.0), true);
    world.step();
    let mass: Real = chain.bodies.iter().map(|&body| world.bodies[body].mass()).sum();
    let center = |world: &PhysicsWorld| {
        let of = |&body: &RigidBodyHandle| {
            world.bodies[body].center_of_mass() * world.bodies[body].mass()
        };
        chain.bodies.iter().map(of).sum::<Vector>() / mass
    };
    let velocity = momentum(&world, &chain.bodies) / mass - world.bodies[ball].linvel();
    let apart = center(&world) - world.bodies[ball].translation();
    run(&mut world, 2.0);
    let moved = center(&world) - world.bodies[ball].translation() - apart - velocity * 2.0;
    // Fifty metres of fall have this much rounding, and the flight of the links is of second order.
    assert!(moved.length() < 2.0e-3, "the chain is {moved} from where the ball would be");
}
