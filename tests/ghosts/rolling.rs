//! Balls roll down a divided slope like on a single piece.

use crate::dim::grounds::{ASIDE, GROUNDS};
use crate::dim::{ROLLING_BALL, about_z, turned_about_z, vec};
use crate::suite::physics::stage::{G, steps, substep, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Duration of rolling (s).
const TIME: Real = 3.0;

/// `a = k g sin θ`, with `k` of a solid ball (3D) or disc (2D). Semi-implicit Euler adds `a h T / 2`
/// to the distance.
#[test]
fn balls_roll_down() {
    let mut table = Table::new(
        "a ball rolls down 20°, 3 s",
        &[
            "ground",
            "radius (m)",
            "acceleration (m/s²)",
            "formula",
            "off (%)",
            "turn × radius / way",
        ],
    );
    let (sin, cos) = (20.0 as Real).to_radians().sin_cos();
    for (ground, lay) in GROUNDS {
        for radius in [0.5, 0.1] {
            let mut world = world(60);
            let tilt = about_z(-(20.0 as Real).to_radians());
            lay(&mut world, Pose::new(Vector::ZERO, tilt), 1.0);
            let start = vec(radius * sin, radius * cos) + ASIDE;
            let body = RigidBodyBuilder::dynamic().translation(start);
            let (body, _) = world.insert(body, ColliderBuilder::ball(radius).friction(1.0));
            let mut turned = 0.0;
            let mut last = *world.bodies[body].rotation();
            for _ in 0..steps(&world, TIME) {
                world.step();
                let rotation = *world.bodies[body].rotation();
                turned -= turned_about_z(&(rotation * last.inverse()));
                last = rotation;
            }
            let way = (world.bodies[body].translation() - start).dot(vec(cos, -sin));
            let found = 2.0 * way / (TIME * (TIME + substep(&world)));
            let formula = ROLLING_BALL * G * sin;
            table.row([
                ground.to_string(),
                radius.to_string(),
                format!("{found:.4}"),
                format!("{formula:.4}"),
                format!("{:+.3}", 100.0 * (found / formula - 1.0)),
                format!("{:.4}", turned * radius / way),
            ]);
            table.check("the acceleration", found, formula, 5.0e-3 * formula);
        }
    }
}
