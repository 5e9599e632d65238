//! Free fall.

use super::stage::{G, RATES, rounding, run, steps, substep, world};
use super::table::Table;
use crate::dim::vec;
use rapier::prelude::*;

/// Semi-implicit Euler (velocity first) with the substep `h`: in the time `t` a body drops by
/// `g t (t + h) / 2`. The exact drop is `g t² / 2`.
#[test]
fn free_fall() {
    let time = 2.0;
    let columns = ["rate", "drop (m)", "formula", "exact", "error (m)"];
    let mut table = Table::new("free fall for 2 s", &columns);
    for rate in RATES {
        let mut world = world(rate);
        let body = RigidBodyBuilder::dynamic().additional_mass(1.0);
        let body = world.insert_body(body);
        run(&mut world, time);
        let drop = -world.bodies[body].translation().y;
        let formula = 0.5 * G * time * (time + substep(&world));
        let exact = 0.5 * G * time * time;
        table.row([
            rate.to_string(),
            format!("{drop:.5}"),
            format!("{formula:.5}"),
            format!("{exact:.5}"),
            format!("{:+.5}", drop - exact),
        ]);
        // The velocity is a sum over substeps, and is itself summed over the duration of the fall.
        let substeps = 4 * steps(&world, time);
        let tolerance = rounding(substeps, G * time) * time + rounding(substeps, exact);
        table.check("the drop", drop, formula, tolerance);
        table.check("the drift", world.bodies[body].translation().x, 0.0, 0.0);
    }
}

/// Gravity with the scale `s` is `s g`; at 0 a body floats.
#[test]
fn gravity_scale() {
    for rate in RATES {
        let mut world = world(rate);
        let scales: [Real; 4] = [1.0, 0.5, 0.0, -2.0];
        let bodies = scales.map(|scale| {
            world.insert_body(RigidBodyBuilder::dynamic().additional_mass(1.0).gravity_scale(scale))
        });
        run(&mut world, 1.0);
        for (scale, body) in scales.into_iter().zip(bodies) {
            let speed = -world.bodies[body].linvel().y;
            let tolerance = rounding(4 * steps(&world, 1.0), G * 2.0);
            assert!((speed - scale * G).abs() <= tolerance, "{speed} at scale {scale}");
        }
    }
}

/// A thrown body keeps its velocity: `x = v t`.
#[test]
fn throw() {
    for rate in RATES {
        let mut world = world(rate);
        let body = RigidBodyBuilder::dynamic().additional_mass(1.0).linvel(vec(3.0, 4.0));
        let body = world.insert_body(body);
        run(&mut world, 1.0);
        let at = world.bodies[body].translation();
        let tolerance = rounding(4 * steps(&world, 1.0), 10.0);
        let height = 4.0 - 0.5 * G * (1.0 + substep(&world));
        assert!((at.x - 3.0).abs() <= tolerance && (at.y - height).abs() <= tolerance, "{at}");
    }
}
