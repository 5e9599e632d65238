//! How free bodies tumble. 3D only: in the plane there is but one axis to turn about.

use crate::dim::spin_momentum;
use crate::suite::physics::stage::{RATES, rounding, steps, substep, weightless};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A body that nothing acts on keeps its energy `½ ω·Iω` and its angular momentum `Iω`, however wildly
/// it tumbles: here a box that turns about its middle axis, which is unstable, so that it flips over
/// again and again.
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
        // Second order in the angle of a substep, and what rounding does in each step: the velocity is
        // made of the momentum, and the next step makes the momentum of the velocity.
        let angle = 5.0 * substep(&world);
        let drift = rounding(steps(&world, 60.0), 1.0);
        table.check("the error of the energy", largest, 0.0, 0.05 * angle * angle + 4.0 * drift);
        table.check("the error of the momentum", lost, 0.0, 2.0 * drift);
    }
}

/// What thrown things look like: half extents of boxes, flat, long, nearly round, and thin.
const BOXES: [[Real; 3]; 6] = [
    [0.5, 0.1, 0.05],
    [0.1, 0.05, 0.5],
    [0.05, 0.5, 0.1],
    [0.5, 0.5, 0.02],
    [1.0, 0.6, 0.2],
    [0.02, 0.4, 0.02],
];
/// How fast they turn (rad/s): up to 3 rad in a substep at 30 Hz, and by many beyond.
const SPINS: [[Real; 3]; 6] = [
    [10.0, 60.0, 5.0],
    [60.0, 3.0, 9.0],
    [5.0, 10.0, 100.0],
    [20.0, 240.0, 30.0],
    [300.0, 120.0, 200.0],
    [1.0e3, 1.0e4, 2.0e3],
];

/// However fast a body turns, it keeps its angular momentum to rounding, and its energy but for what goes up and down within a
/// substep's error: 0.6 % (see `dim3/spin.rs`).
#[test]
fn whatever_turns_fast_keeps_its_momentum_and_its_energy() {
    let columns = ["box", "rad/s", "rate", "E least (%)", "E most (%)", "E after 10 s (%)", "of L"];
    let mut table = Table::new("thrown boxes that turn fast, 10 s", &columns);
    for [x, y, z] in BOXES {
        for spin in SPINS {
            for rate in RATES {
                let mut world = weightless(rate);
                let body = RigidBodyBuilder::dynamic().angvel(spin.into()).can_sleep(false);
                let (body, _) = world.insert(body, ColliderBuilder::cuboid(x, y, z));
                let energy = world.bodies[body].kinetic_energy();
                let momentum = spin_momentum(&world.bodies[body]);
                let (mut least, mut most, mut end, mut lost): (Real, Real, Real, Real) =
                    (1.0, 1.0, 1.0, 0.0);
                for _ in 0..steps(&world, 10.0) {
                    world.step();
                    let body = &world.bodies[body];
                    end = body.kinetic_energy() / energy;
                    (least, most) = (least.min(end), most.max(end));
                    let error = (spin_momentum(body) - momentum).length() / momentum.length();
                    lost = lost.max(error);
                }
                table.row([
                    format!("{x} {y} {z}"),
                    format!("{spin:?}"),
                    rate.to_string(),
                    format!("{:.4}", least * 100.0),
                    format!("{:.4}", most * 100.0),
                    format!("{:.4}", end * 100.0),
                    format!("{lost:.1e}"),
                ]);
                // Each step begins with the velocity, whose last digit is worth more, the more the moments differ.
                let drift = rounding(steps(&world, 10.0), 1.0);
                let inertia =
                    world.bodies[body].mass_properties().local_mprops().principal_inertia();
                let worth = (inertia.max_element() / inertia.min_element()).sqrt();
                table.check("the least energy", least, 1.0, 0.006 + 4.0 * drift * worth);
                table.check("the most energy", most, 1.0, 0.006 + 4.0 * drift * worth);
                table.check("the error of the momentum", lost, 0.0, 2.0 * drift * worth);
            }
        }
    }
}

/// The complete elliptic integral of the first kind with the complementary modulus `k'`: `π / 2` over the arithmetic-geometric
/// mean of 1 and `k'`.
fn quarter_period(complementary: f64) -> f64 {
    let (mut a, mut b) = (1.0, complementary);
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    core::f64::consts::FRAC_PI_2 / a
}

/// The time between two flips of a body that turns about nearly its middle axis, by Jacobi's solution: the momentum about that
/// axis is a sine of amplitude `sn λt`, with `λ² = (d₂ - d₃)(d₁ L² - 2E)` and `k² λ² = (d₁ - d₂)(2E - d₃ L²)` for inverse moments
/// `d₁ > d₂ > d₃`, or the two exchanged if `k` would be more than 1.
fn time_between_flips(inv_moments: Vector, momentum: Vector) -> f64 {
    let mut d = inv_moments.to_array().map(f64::from);
    let squares = momentum.to_array().map(|m| f64::from(m) * f64::from(m));
    let twice_energy: f64 = squares.iter().zip(d).map(|(square, d)| square * d).sum();
    let square: f64 = squares.iter().sum();
    d.sort_by(f64::total_cmp);
    let [d3, d2, d1] = d;
    let first = (d2 - d3) * (d1 * square - twice_energy);
    let second = (d1 - d2) * (twice_energy - d3 * square);
    let (rate, complementary) = if first > second {
        (first.sqrt(), (1.0 - second / first).sqrt())
    } else {
        (second.sqrt(), (1.0 - first / second).sqrt())
    };
    2.0 * quarter_period(complementary) / rate
}

/// A racket that is thrown with a turn about its middle axis flips over in the air, again and again: after the time that Jacobi's
/// elliptic functions say.
#[test]
fn rackets_flip_over_when_they_should() {
    let columns = ["rate", "rad/s", "flips", "seconds each", "formula", "error (%)"];
    let mut table = Table::new("box of 2 × 1.2 × 0.4 about its middle axis, 20 s", &columns);
    for rate in RATES {
        for speed in [2.0, 5.0, 10.0, 20.0] {
            let mut world = weightless(rate);
            let spin = Vector::new(0.1, 1.0, 0.1) * speed;
            let body = RigidBodyBuilder::dynamic().angvel(spin).can_sleep(false);
            let (body, _) = world.insert(body, ColliderBuilder::cuboid(1.0, 0.6, 0.2));
            let local = world.bodies[body].mass_properties().local_mprops().clone();
            let frame = local.principal_inertia_local_frame.inverse();
            let moments = local.principal_inertia();
            let exact = time_between_flips(moments.recip(), frame * spin * moments);
            let momentum = spin_momentum(&world.bodies[body]).normalize();
            let upward = |world: &PhysicsWorld| {
                f64::from((*world.bodies[body].rotation() * Vector::Y).dot(momentum))
            };
            let dt = f64::from(world.integration_parameters.dt);
            let (mut times, mut last) = (Vec::new(), upward(&world));
            for step in 0..steps(&world, 20.0) {
                world.step();
                let now = upward(&world);
                if (now > 0.0) != (last > 0.0) {
                    times.push((step as f64 + last / (last - now)) * dt);
                }
                last = now;
            }
            let flips = times.len();
            let found = (times[flips - 1] - times[0]) / (flips - 1) as f64;
            let error = found / exact - 1.0;
            table.row([
                rate.to_string(),
                speed.to_string(),
                flips.to_string(),
                format!("{found:.4}"),
                format!("{exact:.4}"),
                format!("{:+.4}", error * 100.0),
            ]);
            // Second order in the angle of a substep, which is cut in two beyond 0.8 rad or so.
            let angle = (f64::from(speed) * f64::from(substep(&world))).min(0.8);
            table.check("the error", error as Real, 0.0, (0.2 * angle * angle + 2.0e-3) as Real);
        }
    }
}

/// A top without weight: the axis of a disc that spins about nearly that axis goes around the angular
/// momentum `L` with the frequency `L / I₁`, faster than the disc itself.
#[test]
fn nutation() {
    let columns = ["rate", "rad/s", "turns in 10 s", "formula", "error (%)"];
    let mut table = Table::new("nutation of a disc", &columns);
    let cases = RATES.into_iter().flat_map(|rate| [20.0, 40.0].map(|speed| (rate, speed)));
    for (rate, speed) in cases {
        let mut world = weightless(rate);
        let spin = Vector::new(0.05 * speed, speed, 0.0);
        let body = RigidBodyBuilder::dynamic().angvel(spin).can_sleep(false);
        let (body, _) = world.insert(body, ColliderBuilder::cylinder(0.05, 0.5));
        let inertia = world.bodies[body].mass_properties().local_mprops().principal_inertia();
        let momentum = spin_momentum(&world.bodies[body]);
        let formula = momentum.length() / inertia.x * 10.0 / (2.0 * std::f64::consts::PI as Real);
        let along = momentum.normalize();
        // The axis of the disc, seen along the momentum.
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
            speed.to_string(),
            format!("{turns:.4}"),
            format!("{formula:.4}"),
            format!("{:+.4}", error * 100.0),
        ]);
        // The method is exact for bodies with an axis; the step at which the last turn is seen is a whole one.
        table.check("the error", error, 0.0, 1.0e-4);
    }
}
