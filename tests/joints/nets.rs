//! Nets, which are solved iteratively, come to rest and do not stretch.

use super::stage::{bob, post};
use crate::dim::vec;
use crate::suite::physics::stage::{G, RATES, run, world};
use rapier::prelude::*;

const SIDE: usize = 30;

/// Adds bodies of mass 1, half a metre apart, each joined to its left and its upper neighbour. The upper ones
/// hang on posts.
fn net(world: &mut PhysicsWorld) {
    let mut knots = Vec::new();
    for row in 0..SIDE {
        for column in 0..SIDE {
            let at = vec(0.5 * column as Real, -0.5 * row as Real);
            let knot = world.insert_body(bob(1.0, 0.2).translation(at));
            let above =
                if row > 0 { knots[knots.len() - SIDE] } else { post(world, at + vec(0.0, 0.5)) };
            let (up, left) = (vec(0.0, 0.25), vec(-0.25, 0.0));
            world.insert_impulse_joint(above, knot, pin(-up, up));
            if column > 0 {
                let beside = knots[knots.len() - 1];
                world.insert_impulse_joint(beside, knot, pin(-left, left));
            }
            knots.push(knot);
        }
    }
}

/// Returns a point-to-point joint.
fn pin(anchor1: Vector, anchor2: Vector) -> GenericJointBuilder {
    let pin = GenericJointBuilder::new(JointAxesMask::LIN_AXES);
    pin.local_anchor1(anchor1).local_anchor2(anchor2)
}

#[test]
fn nets_hang_still() {
    for rate in RATES {
        let mut world = world(rate);
        net(&mut world);
        run(&mut world, 10.0);
        let gaps = world.impulse_joints().map(|(_, joint)| {
            let [one, two] = [joint.body1(), joint.body2()].map(|body| &world.bodies[body]);
            let anchor1 = *one.position() * joint.data.local_anchor1();
            (anchor1 - *two.position() * joint.data.local_anchor2()).length()
        });
        let gap = gaps.fold(0.0, Real::max);
        let speeds = world.bodies.iter().map(|(_, body)| body.linvel().length());
        let speed = speeds.fold(0.0, Real::max);
        println!("net at {rate} Hz: gaps up to {gap:e} m, speeds up to {speed:e} m/s");
        // The upper joints carry a whole column. A soft constraint yields by σ g h²/β for each carried body,
        // with σ/β at most a half here.
        let h = 1.0 / (4 * rate) as Real;
        let sag = SIDE as Real * 0.5 * G * h * h;
        assert!(gap < 2.0 * sag + 1.0e-4, "{gap} m at {rate} Hz");
        assert!(speed < 0.02, "{speed} m/s at {rate} Hz");
    }
}
