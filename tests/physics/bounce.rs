//! Restitution.

use super::stage::{RATES, add_ground, run, steps, world};
use super::table::Table;
use crate::dim::vec;
use rapier::prelude::*;

/// A ball that falls from the height `H` rises to `e² H` after the bounce.
#[test]
fn bounce_height() {
    let columns = ["rate", "restitution", "apex (m)", "formula", "error"];
    let mut table = Table::new("bounce from 2 m", &columns);
    for rate in RATES {
        for restitution in [0.3, 0.5, 0.8, 1.0] {
            let apex = apex(rate, restitution);
            let formula = restitution * restitution * 2.0;
            table.row([
                rate.to_string(),
                restitution.to_string(),
                format!("{apex:.4}"),
                format!("{formula:.4}"),
                format!("{:+.4}", apex - formula),
            ]);
            // The error is below 2.5 % at 60 steps per second, and proportional to the step.
            let tolerance = formula * 1.5 / rate as Real + 0.01;
            table.check("the apex", apex, formula, tolerance);
        }
    }
}

/// Returns the apex of a ball after its first bounce.
fn apex(rate: u32, restitution: Real) -> Real {
    let mut world = world(rate);
    add_ground(&mut world, 0.5);
    let ball = ColliderBuilder::ball(0.5).restitution(restitution);
    let ball = ball.restitution_combine_rule(CoefficientCombineRule::Max);
    let (body, _) = world.insert(RigidBodyBuilder::dynamic().translation(vec(0.0, 2.5)), ball);
    run(&mut world, 0.5);
    let (mut apex, mut rose): (Real, bool) = (0.0, false);
    for _ in 0..steps(&world, 2.0) {
        world.step();
        let body = &world.bodies[body];
        rose |= body.linvel().y > 0.0;
        if rose {
            apex = apex.max(body.translation().y - 0.5);
            if body.linvel().y < 0.0 {
                return apex;
            }
        }
    }
    panic!("it did not bounce: apex {apex}");
}
