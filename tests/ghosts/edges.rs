//! Real steps and gaps stop bodies.

use crate::dim::grounds::{ASIDE, GROUNDS, Ground};
use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::{steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// End of the grounds (m), which is also the displacement of the next one of the same kind.
const END: Real = 45.0;

/// Returns a ground to `END`, another that begins `gap` behind it and is higher by `step`, and a box on the
/// first.
fn before(ground: Ground, gap: Real, step: Real, speed: Real) -> (PhysicsWorld, RigidBodyHandle) {
    let (name, lay) = ground;
    let length = if name == "height field" { 90.0 } else { 48.0 };
    let mut world = world(60);
    lay(&mut world, Pose::IDENTITY, 0.0);
    lay(&mut world, Pose::from_translation(vec(length + gap, step)), 0.0);
    let mut body = RigidBodyBuilder::dynamic()
        .translation(vec(END - 2.0, 0.5) + ASIDE)
        .linvel(vec(speed, 0.0));
    if step > 0.0 {
        body = body.lock_rotations(); // it would trip over the step
    }
    let (body, _) = world.insert(body, cuboid(0.5, 0.5).friction(0.0));
    (world, body)
}

/// A step in the ground stops a box at the step, neither before nor behind it, on grounds of every kind.
#[test]
fn steps_stop_a_box() {
    let columns = ["ground", "step (mm)", "front at (m)", "speed (m/s)", "highest (mm)"];
    let mut table = Table::new("a box at 3 m/s, a step in its way at 45 m", &columns);
    for ground in GROUNDS {
        for step in [0.05, 0.2, 0.9] {
            let (mut world, body) = before(ground, 0.0, step, 3.0);
            let mut highest: Real = 0.0;
            for _ in 0..steps(&world, 1.0) {
                world.step();
                highest = highest.max(world.bodies[body].translation().y - 0.5);
            }
            let body = &world.bodies[body];
            let front = body.translation().x + 0.5;
            table.row([
                ground.0.to_string(),
                format!("{:.0}", 1000.0 * step),
                format!("{front:.4}"),
                format!("{:.4}", body.linvel().x),
                format!("{:.2}", 1000.0 * highest),
            ]);
            table.require(front < END + 0.02, "came over the step");
            table.require(front > END - 0.3, "was stopped before the step");
        }
    }
}

/// A box glides over a gap that is narrower than itself, and falls into a wide one.
#[test]
fn gaps_are_glided_over_or_fallen_into() {
    let columns = ["ground", "gap (m)", "speed before (m/s)", "speed (m/s)", "height (mm)"];
    let mut table = Table::new("a box of 1 m, a gap in its way", &columns);
    for ground in GROUNDS {
        for (gap, speed) in [(0.05, 10.0), (0.3, 10.0), (1.5, 1.0)] {
            let (mut world, body) = before(ground, gap, 0.0, speed);
            for _ in 0..steps(&world, 3.0) {
                world.step();
            }
            let body = &world.bodies[body];
            let height = body.translation().y - 0.5;
            table.row([
                ground.0.to_string(),
                gap.to_string(),
                speed.to_string(),
                format!("{:.4}", body.linvel().x),
                format!("{:.2}", 1000.0 * height),
            ]);
            if gap < 1.0 {
                table.check("the height", height, 0.0, 2.0e-3);
                table.check("the speed", body.linvel().x, speed, 2.0e-3 * speed);
            } else {
                table.require(height < -0.5, "did not fall");
            }
        }
    }
}
