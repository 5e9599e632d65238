//! "I cannot read the angles of my ball joint."

use rapier::prelude::*;

const AXES: [JointAxis; 3] = [JointAxis::AngX, JointAxis::AngY, JointAxis::AngZ];

/// Components about Y and Z of the rotation vectors of swings.
const SWINGS: [(Real, Real); 7] =
    [(0.0, 0.0), (0.5, 0.0), (0.0, -0.7), (0.8, 1.3), (-1.2, 0.4), (2.0, -1.0), (0.3, 3.1)];

/// Frames of the joint on its bodies, and rotations of the first body.
fn frames() -> [(Rotation, Rotation, Rotation); 2] {
    let rotation = |x, y, z| Rotation::from_scaled_axis(Vector::new(x, y, z));
    let identity = Rotation::IDENTITY;
    [
        (identity, identity, identity),
        (rotation(0.3, -1.1, 0.4), rotation(2.0, 0.2, -0.9), rotation(-0.7, 0.5, 1.6)),
    ]
}

/// The second body's rotation for a relative rotation of the frames.
fn second_body(joint: &GenericJoint, body1: Rotation, between: Rotation) -> Rotation {
    body1 * joint.local_frame1.rotation * between * joint.local_frame2.rotation.inverse()
}

fn close(found: Option<Real>, expected: Real) -> bool {
    found.is_some_and(|found| (found - expected).abs() < 2.0e-5)
}

/// The angles of a ball joint are the twist and the components of the swing's rotation vector, of any swing
/// up to half a turn. Both components together have the length of that vector.
#[test]
fn twist_and_swing_have_their_formulas() {
    for (frame1, frame2, body1) in frames() {
        for (about_y, about_z) in SWINGS {
            for twist in [0.0, 0.9, -2.5] {
                let swing = Rotation::from_scaled_axis(Vector::new(0.0, about_y, about_z));
                let between = swing * Rotation::from_rotation_x(twist);
                let mut joint: GenericJoint = SphericalJoint::new().into();
                joint.local_frame1.rotation = frame1;
                joint.local_frame2.rotation = frame2;
                let body2 = second_body(&joint, body1, between);
                let expected = [twist, about_y, about_z];
                let found = AXES.map(|axis| joint.angle(axis, &body1, &body2));
                let are_close =
                    found.iter().zip(expected).all(|(found, angle)| close(*found, angle));
                assert!(are_close, "{found:?} instead of {expected:?}");

                // One angle for the swing in any direction.
                joint.coupled_axes = JointAxesMask::ANG_Y | JointAxesMask::ANG_Z;
                for axis in [JointAxis::AngY, JointAxis::AngZ] {
                    let (found, size) = (joint.angle(axis, &body1, &body2), about_y.hypot(about_z));
                    assert!(close(found, size), "{found:?} instead of {size}");
                }
            }
        }
    }
}

/// The angles of a joint with two free rotations are the components of its rotation vector.
#[test]
fn two_rotations_are_the_components_of_a_rotation_vector() {
    for (frame1, frame2, body1) in frames() {
        for locked in 0..3 {
            let mask = JointAxesMask::from_bits_truncate(1 << AXES[locked] as u8);
            let mut joint = GenericJoint::new(JointAxesMask::LIN_AXES | mask);
            joint.local_frame1.rotation = frame1;
            joint.local_frame2.rotation = frame2;
            for (first, second) in SWINGS {
                let mut turn = [first, second, second];
                turn[1] = if locked == 0 { first } else { second };
                turn[locked] = 0.0;
                let between = Rotation::from_scaled_axis(turn.into());
                let body2 = second_body(&joint, body1, between);
                for axis in (0..3).filter(|axis| *axis != locked) {
                    let found = joint.angle(AXES[axis], &body1, &body2);
                    assert!(close(found, turn[axis]), "{found:?} of {turn:?}, {axis}");
                }
            }
        }
    }
}

/// A single free rotation has the whole angle. Locked rotations and translations have none.
#[test]
fn single_rotations_have_the_whole_angle() {
    for (frame1, frame2, body1) in frames() {
        for (free, axis) in AXES.into_iter().enumerate() {
            let mask = JointAxesMask::from_bits_truncate(1 << axis as u8);
            let mut joint = GenericJoint::new(JointAxesMask::LOCKED_FIXED_AXES - mask);
            joint.local_frame1.rotation = frame1;
            joint.local_frame2.rotation = frame2;
            for angle in [0.0, 1.2, -3.0] {
                let mut about = Vector::ZERO;
                about[free] = angle;
                let body2 = second_body(&joint, body1, Rotation::from_scaled_axis(about));
                for axis in JointAxis::ALL {
                    let found = joint.angle(axis, &body1, &body2);
                    let is_free = axis == AXES[free];
                    assert_eq!(found.is_some(), is_free, "{axis:?}");
                    assert!(!is_free || close(found, angle), "{found:?} instead of {angle}");
                }
            }
        }
    }
}

/// The angle is that of limits and motors: a servo brings the axis to the angle that the getter reads.
#[test]
fn servos_reach_the_angle_that_is_read() {
    for axis in AXES {
        for target in [0.6, -1.1] {
            let mut world = PhysicsWorld::new();
            world.gravity = Vector::ZERO;
            let base = world.insert_body(RigidBodyBuilder::fixed());
            let body = RigidBodyBuilder::dynamic().can_sleep(false);
            let (body, _) = world.insert(body, ColliderBuilder::cuboid(0.1, 0.2, 0.3));
            let mut joint = SphericalJointBuilder::new();
            for other in AXES {
                let goal = if other == axis { target } else { 0.0 };
                joint = joint.motor_position(other, goal, 400.0, 40.0);
            }
            let joint = world.insert_impulse_joint(base, body, joint);
            for _ in 0..120 {
                world.step();
            }
            let [first, second] = [base, body].map(|body| *world.bodies[body].rotation());
            let angle = world.impulse_joints[joint].data.angle(axis, &first, &second);
            let is_close = angle.is_some_and(|angle| (angle - target).abs() < 1.0e-3);
            assert!(is_close, "{axis:?}: {angle:?} instead of {target}");
        }
    }
}
