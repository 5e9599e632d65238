//! Stacks: stability, mass ratios, sleep.

use super::stage::{G, RATES, add_ground, penetration, run, steps, world};
use super::table::Table;
use crate::dim::{CORNER_YIELD, cuboid, vec};
use rapier::prelude::*;

/// Steps until all bodies sleep. Returns the number of steps, or `None` if they stay awake for this time (s),
/// and the largest penetration.
fn settle(world: &mut PhysicsWorld, seconds: Real) -> (Option<usize>, Real) {
    let mut deepest: Real = 0.0;
    for step in 1..=steps(world, seconds) {
        world.step();
        deepest = deepest.max(penetration(world));
        if world.active_bodies().is_empty() {
            return (Some(step), deepest);
        }
    }
    (None, deepest)
}

fn asleep_at(step: Option<usize>) -> String {
    step.map_or("never".to_string(), |step| step.to_string())
}

/// Adds a cube with sides of 1 m, with its bottom at this height.
fn add_cube(world: &mut PhysicsWorld, x: Real, bottom: Real) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic().translation(vec(x, bottom + 0.5));
    world.insert(body, cuboid(0.5, 0.5)).0
}

/// Returns the shortening of a tower of `n` cubes (m) with the usual substeps: each face has the allowed
/// penetration, and contact springs yield by `σ g h² / β` for each cube above. Towers get more substeps.
fn sag(world: &PhysicsWorld, n: usize) -> Real {
    let params = &world.integration_parameters;
    let h = params.substep();
    let softness = params.contact_softness(h);
    let (share, yielding) = (softness.bias_rate * h, softness.impulse_scale / softness.mass_scale);
    let loads = (n * (n + 1) / 2) as Real;
    let springs = CORNER_YIELD * yielding * G * h * h / share * loads;
    springs + n as Real * params.allowed_linear_error()
}

/// A tower of thirty cubes stands and falls asleep.
#[test]
fn tower() {
    let columns = ["rate", "asleep at step", "after (s)", "top", "of", "deepest (mm)", "lean (mm)"];
    let mut table = Table::new("tower of 30 cubes", &columns);
    for rate in RATES {
        let mut world = world(rate);
        add_ground(&mut world, 0.5);
        let cubes: Vec<_> = (0..30).map(|k| add_cube(&mut world, 0.0, k as Real)).collect();
        let (step, deepest) = settle(&mut world, 10.0);
        let top = world.bodies[cubes[29]].translation();
        let lean = vec(top.x, 0.0).length();
        let sag = sag(&world, 30);
        table.row([
            rate.to_string(),
            asleep_at(step),
            format!("{:.2}", step.unwrap_or(0) as Real / rate as Real),
            format!("{:.4}", top.y),
            format!("{:.4} to 29.5", 29.5 - sag),
            format!("{:.2}", deepest * 1.0e3),
            format!("{:.2}", lean * 1.0e3),
        ]);
        table.require(step.is_some(), "does not sleep");
        // The tower may fall asleep slightly before it stands still.
        table.check("the top", top.y, 29.5 - 0.5 * sag, 0.5 * sag + 0.01);
        // The bound is a fifth of a percent of the height: at 30 steps per second the tower sways for longer
        // before it sleeps.
        table.check("the lean", lean, 0.0, 0.06);
    }
}

/// A tower of thirty cubes, the topmost slightly off centre, stands for a minute without sleeping.
///
/// With soft contacts alone it would fall: like any elastic column, it buckles under its own weight
/// from some height on (`AnchorFrame`). A rigid tower stands until the top leans by a whole width.
#[test]
fn tower_kept_awake() {
    let mut table =
        Table::new("tower of 30 cubes, awake for 60 s", &["rate", "top", "of", "lean (mm)"]);
    for rate in RATES {
        let mut world = world(rate);
        add_ground(&mut world, 0.5);
        let cubes: Vec<_> = (0..30)
            .map(|k| add_cube(&mut world, if k == 29 { 0.01 } else { 0.0 }, k as Real))
            .collect();
        for &cube in &cubes {
            *world.bodies[cube].activation_mut() = RigidBodyActivation::cannot_sleep();
        }
        run(&mut world, 60.0);
        let top = world.bodies[cubes[29]].translation();
        let lean = vec(top.x, 0.0).length();
        let sag = sag(&world, 30);
        table.row([
            rate.to_string(),
            format!("{:.4}", top.y),
            format!("{:.4} to 29.5", 29.5 - sag),
            format!("{:.2}", lean * 1.0e3),
        ]);
        table.check("the top", top.y, 29.5 - 0.5 * sag, 0.5 * sag);
        table.check("the lean", lean, 0.0, 0.5);
    }
}

/// Adds a stack of `n` boxes with these half sides on the ground; returns them from bottom to top.
fn add_stack(
    world: &mut PhysicsWorld,
    n: usize,
    [width, height]: [Real; 2],
) -> Vec<RigidBodyHandle> {
    let boxes = (0..n).map(|k| {
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, (2 * k + 1) as Real * height));
        world.insert(body, cuboid(width, height).friction(1.0)).0
    });
    boxes.collect()
}

/// Towers of cubes from 5 cm to 3 m stand at seven tenths of the slope at which a rigid tower tips, and those
/// from 30 cm at nine tenths. The direction of gravity makes the slope of the ground.
#[test]
fn towers_on_slopes() {
    let columns = ["rate", "cubes", "side (m)", "tips at (°)", "slope (°)", "top", "of", "lean"];
    let mut table = Table::new("towers of cubes on slopes, 10 s", &columns);
    for (rate, n, side) in [60, 240].into_iter().flat_map(|rate| {
        let numbers = [3, 5, 8, 12, 20, 30].into_iter();
        numbers.flat_map(move |n| [0.05, 0.1, 0.3, 1.0, 3.0].map(|side| (rate, n, side)))
    }) {
        let mut world = world(rate);
        add_ground(&mut world, 1.0);
        let cubes = add_stack(&mut world, n, [0.5 * side; 2]);
        let tipping = (1.0 / n as Real).atan();
        let slope = if side < 0.3 { 0.7 } else { 0.9 } * tipping;
        world.gravity = vec(G * slope.sin(), -G * slope.cos());
        run(&mut world, 10.0);
        let (top, height) = (world.bodies[cubes[n - 1]].translation(), side * (n as Real - 0.5));
        table.row([
            rate.to_string(),
            n.to_string(),
            side.to_string(),
            format!("{:.2}", tipping.to_degrees()),
            format!("{:.2}", slope.to_degrees()),
            format!("{:.4}", top.y),
            format!("{height:.4}"),
            format!("{:.4}", top.x),
        ]);
        table.check("the top", top.y, height, 0.01 * height);
        // Each layer rotates by the overlap at its edge, relative to its side, and all above follow.
        table.check("the lean", top.x, 0.0, 0.04 * height);
    }
}

/// Stacks of thin plates keep their height to two percent.
#[test]
fn plates() {
    let columns = ["rate", "plates", "width (m)", "thickness (mm)", "top (mm)", "of", "share lost"];
    let mut table = Table::new("stacks of plates", &columns);
    for rate in [60, 240] {
        for (n, width, height) in
            [(20, 0.1, 0.01), (16, 0.06, 0.006), (10, 0.05, 0.001), (30, 0.5, 0.05)]
        {
            let mut world = world(rate);
            add_ground(&mut world, 1.0);
            let plates = add_stack(&mut world, n, [width, height]);
            let (asleep, _) = settle(&mut world, 10.0);
            let top = world.bodies[plates[n - 1]].translation().y + height;
            let expected = 2.0 * height * n as Real;
            table.row([
                rate.to_string(),
                n.to_string(),
                format!("{}", 2.0 * width),
                format!("{:.0}", 2.0e3 * height),
                format!("{:.2}", top * 1.0e3),
                format!("{:.1}", expected * 1.0e3),
                format!("{:.4}", 1.0 - top / expected),
            ]);
            table.require(asleep.is_some(), "does not sleep");
            table.check("the height", top, expected, 0.02 * expected);
        }
    }
}

/// A pyramid of twenty rows stands and falls asleep. At 30 steps a second, and at 60 in double precision, it
/// stands. But soft contacts let it sway by more than the drift of a sleeping body
/// (`docs/decisions/0013-bodies-sleep-by-drift.md`).
#[test]
fn pyramid() {
    let columns =
        ["rate", "asleep at step", "after (s)", "top", "of", "deepest (mm)", "moved (mm)"];
    let mut table = Table::new("pyramid of 20 rows", &columns);
    for rate in RATES {
        let mut world = world(rate);
        add_ground(&mut world, 0.5);
        let mut cubes = Vec::new();
        for row in 0..20 {
            for column in 0..20 - row {
                let x = (column as Real - 0.5 * (19 - row) as Real) * 1.05;
                cubes.push((x, add_cube(&mut world, x, row as Real)));
            }
        }
        let (step, deepest) = settle(&mut world, 10.0);
        let top = world.bodies[cubes[209].1].translation();
        let moved = cubes.iter().map(|&(x, cube)| (world.bodies[cube].translation().x - x).abs());
        let moved = moved.fold(0.0, Real::max);
        table.row([
            rate.to_string(),
            asleep_at(step),
            format!("{:.2}", step.unwrap_or(0) as Real / rate as Real),
            format!("{:.4}", top.y),
            "19.5".to_string(),
            format!("{:.2}", deepest * 1.0e3),
            format!("{:.2}", moved * 1.0e3),
        ]);
        table.require(step.is_some() || rate < 240, "does not sleep");
        table.check("the top", top.y, 19.5, 0.2);
        table.check("the farthest move", moved, 0.0, 0.07);
    }
}

/// Returns the sag of a soft contact relative to that at 60 steps per second: it grows with the square of the
/// step.
fn longer(rate: u32) -> Real {
    (60.0 / rate as Real) * (60.0 / rate as Real)
}

/// Four cubes carry a fifth cube of a multiple of their mass.
///
/// At 60 steps a second and default settings, another engine penetrates by 7 mm at the ratio 10 and by 68 mm
/// at 100. At 1000 the stack collapses. Here the penetration never exceeds 2 cm: islands get shorter substeps
/// where light bodies carry heavy ones.
#[test]
fn heavy_top() {
    let columns =
        ["rate", "times as heavy", "deepest (mm)", "at rest (mm)", "asleep at step", "top"];
    let mut table = Table::new("four cubes under a heavy one", &columns);
    for rate in RATES {
        for (mass, limit) in [(10.0, 0.007), (100.0, 0.02), (1000.0, 0.02), (3000.0, 0.02)] {
            let mut world = world(rate);
            add_ground(&mut world, 0.5);
            let cubes: Vec<_> = (0..5).map(|k| add_cube(&mut world, 0.0, k as Real)).collect();
            let top = world.bodies[cubes[4]].colliders()[0];
            world.colliders[top].set_density(mass);
            let (step, deepest) = settle(&mut world, 10.0);
            let body = &world.bodies[cubes[4]];
            table.row([
                rate.to_string(),
                mass.to_string(),
                format!("{:.2}", deepest * 1.0e3),
                format!("{:.2}", penetration(&world) * 1.0e3),
                asleep_at(step),
                format!("{:.4}", body.translation().y),
            ]);
            let limit = limit * longer(rate) + world.integration_parameters.allowed_linear_error();
            table.check("the overlap", deepest, 0.0, limit);
            table.check("the top", body.translation().y, 4.5, 5.0 * limit);
        }
    }
}

/// A separate stack moves as if it were alone, to the last bit, for any number of substeps of another island.
/// A lift under both carries both, wherever its origin is.
#[test]
fn substeps_of_an_island_are_its_own() {
    for origin in [0.0, -0.5, -1.0] {
        check_two_stacks(origin);
    }
}

/// Compares two stacks on a lift whose top is at height 0, and whose origin is at another height.
fn check_two_stacks(origin: Real) {
    let stacks = |is_heavy: bool| {
        let mut world = world(60);
        let lift = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(0.0, 0.5));
        let lift = lift.translation(vec(0.0, origin));
        world.insert(lift, cuboid(20.0, 0.5).translation(vec(0.0, -0.5 - origin)));
        let light: Vec<_> = (0..3).map(|k| add_cube(&mut world, -3.0, 1.001 * k as Real)).collect();
        let other: Vec<_> = (0..3).map(|k| add_cube(&mut world, 3.0, 1.001 * k as Real)).collect();
        let top = world.bodies[other[2]].colliders()[0];
        world.colliders[top].set_density(if is_heavy { 1000.0 } else { 1.0 });
        run(&mut world, 2.0);
        let place = |handle: &RigidBodyHandle| *world.bodies[*handle].position();
        (light.iter().map(place).collect::<Vec<_>>(), world.bodies[other[2]].translation().y)
    };
    let ((alone, equal), (beside, heavy)) = (stacks(false), stacks(true));
    assert_eq!(alone, beside);
    for height in [equal, heavy] {
        assert!(
            (height - 3.5).abs() < 0.03,
            "the lift rose by a metre, the top of three is at {height}"
        );
    }
}

/// Impulses of long steps are too large as warm starts of short ones: steps of changing length must not
/// disturb a stack.
#[test]
fn steps_of_changing_length_do_not_disturb_a_stack() {
    let mut world = world(60);
    add_ground(&mut world, 0.5);
    let cubes: Vec<_> = (0..6).map(|k| add_cube(&mut world, 0.0, k as Real)).collect();
    run(&mut world, 0.25);
    let settled = world.bodies[cubes[5]].translation().y;
    let mut fastest: Real = 0.0;
    for step in 0..60 {
        world.bodies[cubes[0]].wake_up(true);
        world.integration_parameters.dt = if step % 2 == 0 { 1.0 / 240.0 } else { 1.0 / 30.0 };
        world.step();
        let speeds = cubes.iter().map(|cube| world.bodies[*cube].linvel().length());
        fastest = speeds.fold(fastest, Real::max);
    }
    // The sag changes with the step, and gravity alone gives 0.33 m/s in a step of 1/30 s.
    assert!(fastest < 0.5 * G / 30.0, "up to {fastest} m/s");
    assert!((world.bodies[cubes[5]].translation().y - settled).abs() < 0.01);
}
