//! Frictionless bodies slide over a divided level ground like on a single piece.

use crate::dim::grounds::{ASIDE, GROUNDS, sliders};
use crate::dim::vec;
use crate::suite::physics::stage::{steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// How fast the bodies start (m/s).
const SPEED: Real = 10.0;

/// The least and the greatest that was seen.
struct Range([Real; 2]);

impl Range {
    fn new() -> Self {
        Self([Real::INFINITY, Real::NEG_INFINITY])
    }

    fn see(&mut self, value: Real) {
        let Self([least, greatest]) = self;
        (*least, *greatest) = (least.min(value), greatest.max(value));
    }
}

/// A frictionless body keeps its height and its speed on grounds of many pieces.
#[test]
fn bodies_glide() {
    let columns =
        ["ground", "body", "lowest (mm)", "highest (mm)", "slowest", "fastest", "aside", "turning"];
    let mut table = Table::new("frictionless at 10 m/s, 4 s", &columns);
    for (ground, lay) in GROUNDS {
        for (name, height, pose, collider) in sliders() {
            let mut world = world(60);
            lay(&mut world, Pose::IDENTITY, 0.0);
            let mut body = RigidBodyBuilder::dynamic()
                .pose(Pose::from_translation(vec(-1.5, height) + ASIDE) * pose)
                .linvel(vec(SPEED, 0.0));
            if name.contains("upright") {
                body = body.lock_rotations(); // on its tip it would fall over
            }
            let (body, _) = world.insert(body, collider.friction(0.0));
            let [mut heights, mut speeds, mut turns, mut asides] =
                [Range::new(), Range::new(), Range::new(), Range::new()];
            for _ in 0..steps(&world, 4.0) {
                world.step();
                let body = &world.bodies[body];
                heights.see(1000.0 * (body.translation().y - height));
                speeds.see(body.linvel().x);
                let aside = body.linvel() - vec(body.linvel().x, body.linvel().y);
                asides.see(aside.length());
                turns.see(crate::dim::ang_length(body.angvel()));
            }
            table.row([
                ground.to_string(),
                name.to_string(),
                format!("{:.2}", heights.0[0]),
                format!("{:.2}", heights.0[1]),
                format!("{:.4}", speeds.0[0]),
                format!("{:.4}", speeds.0[1]),
                format!("{:.4}", asides.0[1]),
                format!("{:.4}", turns.0[1]),
            ]);
            table.require(heights.0[1] < 1.0, "hops");
            table.require(heights.0[0] > -5.0, "sinks");
            // A thousandth of the speed, and what a tilt of some thousandths makes of a round bottom.
            table.require(asides.0[1] < 5.0e-3 * SPEED, "is led to the side");
            table.require(turns.0[1] < 0.5, "turns");
            // On each new tile the body tilts by some thousandths, and is pushed along its own bottom.
            table.check("the lowest speed", speeds.0[0], SPEED, 2.0e-3 * SPEED);
            table.check("the highest speed", speeds.0[1], SPEED, 2.0e-3 * SPEED);
        }
    }
}
