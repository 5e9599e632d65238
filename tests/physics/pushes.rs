//! Forces, torques, impulses, damping, locked axes.

use super::stage::{RATES, rounding, run, steps, substep, weightless};
use super::table::Table;
use crate::dim::{about_z, cuboid, vec, z_of};
use rapier::prelude::*;

/// Returns a cube of side 1 and mass 2, with equal inertia about all axes.
fn cube() -> ColliderBuilder {
    cuboid(0.5, 0.5).mass(2.0)
}

/// `v = F t / m`, `ω = τ t / I`: exact for Euler's method with any step.
#[test]
fn force_and_torque() {
    for rate in RATES {
        let mut world = weightless(rate);
        let (body, _) = world.insert(RigidBodyBuilder::dynamic(), cube());
        // A cube (and a square) has I = m a² / 6 about its middle.
        let inertia = 2.0 / 6.0;
        world.bodies[body].add_force(vec(3.0, -1.0), true);
        world.bodies[body].add_torque(about_z(0.5), true);
        run(&mut world, 2.0);
        let body = &world.bodies[body];
        let tolerance = rounding(4 * steps(&world, 2.0), 3.0);
        assert!((body.linvel() - vec(3.0, -1.0)).length() <= tolerance, "{}", body.linvel());
        let spin = z_of(body.angvel());
        assert!((spin - 0.5 * 2.0 / inertia).abs() <= tolerance, "{spin}");
        let reached = 0.5 * 3.0 / 2.0 * 2.0 * (2.0 + substep(&world));
        let x = body.translation().x;
        assert!((x - reached).abs() <= 4.0 * tolerance, "{x} instead of {reached}");
    }
}

/// A force beside the centre accelerates and rotates: `F` at the moment arm `r` is `F` and the torque `r ×
/// F`.
#[test]
fn force_beside_the_centre() {
    let mut world = weightless(60);
    let (body, _) = world.insert(RigidBodyBuilder::dynamic(), cube());
    world.bodies[body].apply_impulse_at_point(vec(0.0, 1.0), vec(0.5, 0.0), true);
    let body = &world.bodies[body];
    let tolerance = rounding(4, 1.5);
    assert!((body.linvel() - vec(0.0, 0.5)).length() <= tolerance);
    assert!((z_of(body.angvel()) - 0.5 / (2.0 / 6.0)).abs() <= tolerance);
}

/// Damping at the rate `c` gives `v = v₀ exp(-c t)`. Each substep divides the velocity by `1 + h c`.
#[test]
fn damping() {
    let columns = ["rate", "damping (1/s)", "speed (m/s)", "formula", "exact", "error (%)"];
    let mut table = Table::new("speed after 2 s of damping, from 10 m/s", &columns);
    for rate in RATES {
        for damping in [0.1, 1.0, 20.0] {
            let mut world = weightless(rate);
            let body = RigidBodyBuilder::dynamic()
                .linvel(vec(10.0, 0.0))
                .angvel(about_z(10.0))
                .linear_damping(damping)
                .angular_damping(damping)
                .can_sleep(false);
            let (body, _) = world.insert(body, cube());
            run(&mut world, 2.0);
            let speed = world.bodies[body].linvel().x;
            let substeps = 4 * steps(&world, 2.0);
            let formula = 10.0 / (1.0 + substep(&world) * damping).powi(substeps as i32);
            let exact = 10.0 * (-2.0 * damping).exp();
            table.row([
                rate.to_string(),
                damping.to_string(),
                format!("{speed:.4e}"),
                format!("{formula:.4e}"),
                format!("{exact:.4e}"),
                format!("{:+.2}", (speed / exact - 1.0) * 100.0),
            ]);
            // Each division rounds by ε / 2 of the value, and so does powi.
            let tolerance = rounding(2 * substeps, formula);
            table.check("the speed", speed, formula, tolerance);
            table.check("the spin", z_of(world.bodies[body].angvel()), formula, tolerance);
        }
    }
}

/// Locked axes do not move under forces and collisions; the others are free.
#[test]
fn locked_axes() {
    for rate in RATES {
        let mut world = weightless(rate);
        let rail = RigidBodyBuilder::dynamic().locked_axes(LockedAxes::TRANSLATION_LOCKED_Y);
        let (on_rail, _) = world.insert(rail, cube());
        let upright = RigidBodyBuilder::dynamic().translation(vec(10.0, 0.0)).lock_rotations();
        let (upright, _) = world.insert(upright, cube());
        for (x, body) in [(0.0, on_rail), (10.0, upright)] {
            world.bodies[body].add_force(vec(1.0, 1.0), true);
            world.bodies[body].add_torque(about_z(0.1), true);
            // The bullet hits from below, beside the middle.
            let bullet =
                RigidBodyBuilder::dynamic().translation(vec(x + 0.2, -2.0)).linvel(vec(0.0, 5.0));
            world.insert(bullet, ColliderBuilder::ball(0.2));
        }
        run(&mut world, 1.0);
        let (on_rail, upright) = (&world.bodies[on_rail], &world.bodies[upright]);
        assert_eq!((on_rail.linvel().y, on_rail.translation().y), (0.0, 0.0), "at {rate} Hz");
        assert!(on_rail.linvel().x > 0.3 && z_of(on_rail.angvel()) != 0.0);
        assert_eq!(z_of(upright.angvel()), 0.0);
        assert_eq!(crate::dim::angle(upright.rotation()), 0.0);
        assert!(upright.linvel().y > 0.5 && upright.linvel().x > 0.3);
    }
}

/// A body of a higher dominance group acts with infinite mass on the other. Collisions do not change its
/// velocity, whatever the masses.
#[test]
fn dominance() {
    for rate in RATES {
        let mut world = weightless(rate);
        let strong = RigidBodyBuilder::dynamic().dominance_group(1).linvel(vec(1.0, 0.0));
        let (strong, _) = world.insert(strong, cube());
        let weak = RigidBodyBuilder::dynamic().translation(vec(2.0, 0.3)).linvel(vec(-3.0, 0.0));
        let (weak, _) = world.insert(weak, cuboid(0.5, 0.5).mass(1000.0));
        run(&mut world, 2.0);
        let (strong, weak) = (&world.bodies[strong], &world.bodies[weak]);
        assert_eq!((strong.linvel(), z_of(strong.angvel())), (vec(1.0, 0.0), 0.0), "at {rate} Hz");
        assert!((strong.translation().x - 2.0).abs() <= rounding(4 * steps(&world, 2.0), 2.0));
        assert!(weak.linvel().x > 0.9, "pushed along: {}", weak.linvel());
    }
}
