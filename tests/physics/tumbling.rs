//! Torque-free rotation. 3D only: in the plane there is one axis of rotation.

use crate::dim::spin_momentum;
use crate::suite::physics::stage::{RATES, rounding, steps, substep, weightless};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A torque-free body has constant energy `½ ω·Iω` and constant angular momentum `Iω`. The test
/// rotates a box about its middle axis, which is unstable: the box flips again and again.
#[test]
fn torque_free_rotation() {
    let columns =
        ["rate", "flips", "largest error of E (%)", "error of E after 60 s (%)", "of L (%)"];
    let mut table = Table::new("box of 2 × 1.2 × 0.4 at 5 rad/s, 60 s", &columns);
    for rate in RATES {
        let mut world = weightless(rate);
        let spin = Vector::new(1.0e-3, 5.0, 1.0e-3);
        let body = RigidBodyBuilder::dynamic().angvel(spin).can_sleep(false);
        let (body, _) = world.insert(body, ColliderBuilder::cuboid(1.0, 0.6, 0.2));
        let energy = world.bodies[body].kinetic_energy();
        let momentum = spin_momentum(&world.bodies[body]);
        let (mut largest, mut error, mut lost): (Real, Real, Real) = (0.0, 0.0, 0.0);
        let (mut flips, mut upward) = (0, true);
        for _ in 0..steps(&world, 60.0) {
            world.step();
            let body = &world.bodies[body];
            error = body.kinetic_energy() / energy - 1.0;
            largest = largest.max(error.abs());
            lost = (spin_momentum(body) - momentum).length() / momentum.length();
            let axis = *body.rotation() * Vector::Y;
            flips += usize::from((axis.dot(momentum) > 0.0) != upward);
            upward = axis.dot(momentum) > 0.0;
        }
        table.row([
            rate.to_string(),
            flips.to_string(),
            format!("{:.5}", largest * 100.0),
            format!("{:+.5}", error * 100.0),
            format!("{:.5}", lost * 100.0),
        ]);
        table.require(flips >= 8, "it does not flip");
        // The error is of second order in the angle of a substep, plus rounding. The velocity is computed
        // from the momentum, and the next step computes the momentum from the velocity.
        let angle = 5.0 * substep(&world);
        let drift = rounding(steps(&world, 60.0), 1.0);
        table.check("the error of the energy", largest, 0.0, 0.5 * angle * angle + 4.0 * drift);
        table.check("the error of the momentum", lost, 0.0, 2.0 * drift);
    }
}

/// Nutation: a disc spins nearly about its axis. The axis circles the angular momentum `L` at the
/// frequency `L / I₁`, faster than the spin of the disc.
#[test]
fn nutation() {
    let columns = ["rate", "turns in 10 s", "formula", "error (%)"];
    let mut table = Table::new("nutation of a disc at 20 rad/s", &columns);
    for rate in RATES {
        let mut world = weightless(rate);
        let body = RigidBodyBuilder::dynamic().angvel(Vector::new(1.0, 20.0, 0.0)).can_sleep(false);
        let (body, _) = world.insert(body, ColliderBuilder::cylinder(0.05, 0.5));
        let inertia = world.bodies[body].mass_properties().local_mprops().principal_inertia();
        let momentum = spin_momentum(&world.bodies[body]);
        let formula = momentum.length() / inertia.x * 10.0 / (2.0 * std::f64::consts::PI as Real);
        let along = momentum.normalize();
        // The axis of the disc, projected along the momentum.
        let seen = |world: &PhysicsWorld| {
            let axis = *world.bodies[body].rotation() * Vector::Y;
            (axis - along * axis.dot(along)).normalize()
        };
        let (mut turned, mut last): (Real, _) = (0.0, seen(&world));
        for _ in 0..steps(&world, 10.0) {
            world.step();
            let now = seen(&world);
            turned += last.cross(now).dot(along).atan2(last.dot(now));
            last = now;
        }
        let turns = turned / (2.0 * std::f64::consts::PI as Real);
        let error = turns / formula - 1.0;
        table.row([
            rate.to_string(),
            format!("{turns:.4}"),
            format!("{formula:.4}"),
            format!("{:+.4}", error * 100.0),
        ]);
        // The error is of second order in the angle of a substep.
        let angle = 20.0 * substep(&world);
        table.check("the error", error, 0.0, 0.2 * angle * angle + 1.0e-4);
    }
}
