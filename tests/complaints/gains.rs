//! "The same gains give another motion at another frame rate."

use crate::dim::{angle, hinge};
use crate::suite::joints::stage::{bob, inertia, post};
use crate::suite::physics::stage::{RATES, run, substep, weightless};
use rapier::prelude::*;

/// Returns the angle after this time of a wheel that starts at 0 with the target 1 rad: `I θ'' = k (1 - θ) -
/// c θ'`, underdamped.
fn exact(stiffness: Real, damping: Real, inertia: Real, time: Real) -> Real {
    let natural = (stiffness / inertia).sqrt();
    let decay = damping / (2.0 * inertia);
    let swing = (natural * natural - decay * decay).sqrt();
    let (phase, left) = (swing * time, (-decay * time).exp());
    1.0 - left * (phase.cos() + decay / swing * phase.sin())
}

/// A motor is a spring and a damper with physical units: the motion follows the formula at any rate and for
/// any inertia. Implicit integration with substeps of `h` adds `ω h / 2` to the damping ratio, `ω² h t / 2`
/// of the amplitude in the time `t`. Positions and velocities are half a substep apart, `ω h / 2` at the
/// start and at the end.
#[test]
fn motor_gains_do_not_depend_on_the_rate() {
    let (stiffness, damping) = (8.0, 0.6);
    for rate in RATES {
        for mass in [1.0, 4.0] {
            let mut world = weightless(rate);
            let post = post(&mut world, Vector::ZERO);
            let wheel = world.insert_body(bob(mass, 1.0));
            let motor =
                hinge().motor_position(1.0, stiffness, damping).motor_model(MotorModel::ForceBased);
            world.insert_impulse_joint(post, wheel, motor);
            let inertia = inertia(mass, 1.0);
            let (natural, h) = ((stiffness / inertia).sqrt(), substep(&world));
            for k in 1..=6_u8 {
                run(&mut world, 0.2);
                let time = 0.2 * Real::from(k);
                let found = angle(world.bodies[wheel].rotation());
                let off = (found - exact(stiffness, damping, inertia, time)).abs();
                let bound = natural * h * (1.0 + 0.5 * natural * time);
                assert!(off < bound, "{off} rad off after {time} s at {rate} Hz, mass {mass}");
            }
        }
    }
}
