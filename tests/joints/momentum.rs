//! Joints conserve momentum: their impulses on both bodies are opposite.

use super::stage::bob;
use crate::dim::{about_z, ang_length, hinge, moment, spin_momentum, vec};
use crate::suite::physics::stage::{RATES, steps, weightless};
use rapier::prelude::*;

/// Returns linear and angular momentum about the origin.
pub fn momenta(world: &PhysicsWorld) -> (Vector, AngVector) {
    let mut total = (Vector::ZERO, about_z(0.0));
    for (_, body) in world.bodies.iter() {
        let push = body.linvel() * body.mass();
        total.0 += push;
        total.1 += moment(body.center_of_mass(), push) + spin_momentum(body);
    }
    total
}

fn check(world: &mut PhysicsWorld, what: &str, rate: u32) {
    let (push, spin) = momenta(world);
    for _ in 0..steps(world, 5.0) {
        world.step();
    }
    let (push_after, spin_after) = momenta(world);
    let lost = (push_after - push).length() / push.length().max(1.0);
    let spin_lost = ang_length(spin_after - spin) / ang_length(spin).max(1.0);
    println!("{what} at {rate} Hz: momentum off by {lost:e}, angular momentum by {spin_lost:e}");
    // Rounding alone changes the linear momentum. The moment of an impulse uses the substep's start at one
    // anchor and its end at the other: second order in h ω.
    assert!(lost < 1.0e-4, "{what}: momentum {push} became {push_after}");
    assert!(spin_lost < 1.0e-2, "{what}: angular momentum {spin:?} became {spin_after:?}");
}

#[test]
fn joined_pairs_keep_their_momentum() {
    for rate in RATES {
        let joints: [(&str, GenericJoint); 4] = [
            ("hinge", hinge().local_anchor1(vec(1.0, 0.0)).local_anchor2(vec(-1.0, 0.0)).into()),
            ("fixed", FixedJointBuilder::new().local_anchor1(vec(2.0, 0.0)).into()),
            ("slider", PrismaticJointBuilder::new(Vector::X).limits([1.0, 3.0]).into()),
            ("spring", SpringJoint::new(Vector::ZERO, vec(0.3, 0.3), 1.5, 40.0).into()),
        ];
        for (name, joint) in joints {
            let mut world = weightless(rate);
            let one = world.insert_body(bob(1.0, 0.4).linvel(vec(0.3, -0.5)).angvel(about_z(1.0)));
            let two = bob(3.0, 0.3).translation(vec(2.0, 0.0)).linvel(vec(0.2, 1.0));
            let two = world.insert_body(two);
            world.insert_impulse_joint(one, two, joint);
            check(&mut world, name, rate);
        }
    }
}

#[test]
fn chains_in_space_keep_their_momentum() {
    for rate in RATES {
        let mut world = weightless(rate);
        let mut last = None;
        for k in 0..8_u8 {
            let body = bob(1.0, 0.3).translation(vec(Real::from(k), 0.0));
            let body = world.insert_body(body.linvel(vec(0.0, 0.3 * Real::from(k % 3))));
            if let Some(last) = last {
                let joint = hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
                world.insert_impulse_joint(last, body, joint);
            }
            last = Some(body);
        }
        check(&mut world, "chain", rate);
    }
}
