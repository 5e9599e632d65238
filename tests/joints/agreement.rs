//! The same mechanism with impulse joints and in reduced coordinates: both must give the same motion.

use super::stage::{bob, post};
use crate::dim::{hinge, vec};
use crate::suite::physics::stage::{RATES, steps, world};
use rapier::prelude::*;

/// Adds a double pendulum of two bobs on rods of length 1, both released from the horizontal. Returns the
/// bobs.
fn double_pendulum(world: &mut PhysicsWorld, is_multibody: bool) -> [RigidBodyHandle; 2] {
    let mut parent = post(world, Vector::ZERO);
    [1.0, 2.0].map(|x| {
        let body = world.insert_body(bob(1.0, 0.1).translation(vec(x, 0.0)));
        let joint = hinge().local_anchor2(vec(-1.0, 0.0));
        if is_multibody {
            world.insert_multibody_joint(parent, body, joint).expect("it fits");
        } else {
            world.insert_impulse_joint(parent, body, joint);
        }
        parent = body;
        body
    })
}

/// In the first second the bobs fall through their lowest points; afterwards chaos magnifies the difference.
/// Both solvers are of about second order: their difference shrinks with the step.
#[test]
fn impulse_joints_and_multibodies_agree_on_a_double_pendulum() {
    let mut last = Real::MAX;
    for rate in RATES {
        let mut worlds = [world(rate), world(rate)];
        let [first, second] = &mut worlds;
        let bodies = [double_pendulum(first, false), double_pendulum(second, true)];
        let mut apart: Real = 0.0;
        for _ in 0..steps(&worlds[0], 1.0) {
            worlds.iter_mut().for_each(PhysicsWorld::step);
            for k in 0..2 {
                let place = |side: usize| worlds[side].bodies[bodies[side][k]].translation();
                apart = apart.max((place(0) - place(1)).length());
            }
        }
        println!("{rate} Hz: {apart:.5} apart after a second");
        // The second bob reaches 7 units per second: at 30 Hz the bound is the motion of half a step.
        assert!(apart < 0.1 && apart < last, "{apart} apart at {rate} Hz, {last} before");
        last = apart;
    }
    assert!(last < 1.0e-2, "{last} apart at the highest rate");
}
