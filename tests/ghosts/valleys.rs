//! The valleys of a gently curved ground cause no bumps.

use crate::dim::grounds::{ASIDE, gutter};
use crate::dim::vec;
use crate::suite::physics::stage::{steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A frictionless ball moves down one side of a shallow V of the slope angle `θ`. At the corner it
/// loses the velocity component normal to the other side: `v sin 2θ`, a fraction `1 - cos 2θ` of its
/// speed.
#[test]
fn valleys_are_no_bumps() {
    let columns = ["slope", "radius (m)", "speed before (m/s)", "behind (m/s)", "formula"];
    let mut table = Table::new("a ball through a valley", &columns);
    for slope in [0.01, 0.03, 0.1] {
        for radius in [0.5, 0.2] {
            let mut world = world(60);
            world.gravity = Vector::ZERO;
            gutter(&mut world, slope);
            let (angle, speed) = (Real::atan(slope), 4.0);
            let (sin, cos) = angle.sin_cos();
            // The ball touches the left side, 2 m from the corner.
            let start = vec(-2.0 * cos + radius * sin, 2.0 * sin + radius * cos);
            let body = RigidBodyBuilder::dynamic()
                .translation(start + ASIDE)
                .linvel(vec(cos, -sin) * speed);
            let (body, _) = world.insert(body, ColliderBuilder::ball(radius).friction(0.0));
            for _ in 0..steps(&world, 0.9) {
                world.step();
            }
            let found = world.bodies[body].linvel();
            let formula = speed * (2.0 * angle).cos();
            table.row([
                slope.to_string(),
                radius.to_string(),
                speed.to_string(),
                format!("{:.4}", found.length()),
                format!("{formula:.4}"),
            ]);
            // The correction of the penetration at the corner may change the speed slightly.
            table.check("the speed", found.length(), formula, 2.0e-3 * speed);
            table.require(found.y > 0.0, "does not go up the other side");
        }
    }
}
