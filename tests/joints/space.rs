//! Joints in 3D only: swing, twist, hinges about any axis.

use crate::suite::joints::stage::{bob, post};
use crate::suite::physics::stage::{G, RATES, run, steps, weightless, world};
use rapier::prelude::*;

/// Half a degree: the tolerance of limits.
const TOLERANCE: Real = 0.5 * core::f64::consts::PI as Real / 180.0;

/// Returns the angle between the X axes of two bodies.
fn swing(world: &PhysicsWorld, [one, two]: [RigidBodyHandle; 2]) -> Real {
    let [a, b] = [one, two].map(|body| *world.bodies[body].rotation() * Vector::X);
    a.cross(b).length().atan2(a.dot(b))
}

#[test]
fn the_swing_stays_in_its_cone() {
    for rate in RATES {
        for degrees in [25.0, 90.0, 170.0] {
            let cone = Real::to_radians(degrees);
            for direction in [Vector::Y, Vector::Z, Vector::new(0.0, -0.6, 0.8)] {
                let mut world = weightless(rate);
                let post = post(&mut world, Vector::ZERO);
                let spin = Vector::X.cross(direction) * 3.0;
                let arm = world.insert_body(bob(1.0, 0.5).angvel(spin));
                world.insert_impulse_joint(
                    post,
                    arm,
                    SphericalJointBuilder::new().swing_limit(cone),
                );
                let mut widest: Real = 0.0;
                for _ in 0..steps(&world, 3.0) {
                    world.step();
                    widest = widest.max(swing(&world, [post, arm]));
                }
                assert!((widest - cone).abs() < TOLERANCE, "{widest} of {cone} at {rate} Hz");
            }
        }
    }
}

/// A rod that revolves at the limit of its cone without friction stays in the cone, and keeps its speed.
#[test]
fn a_rod_on_its_cone_limit_stays_there_and_keeps_its_speed() {
    for rate in RATES {
        for speed in [2.0, 4.0, 8.0] {
            for is_multibody in [false, true] {
                let (cone, spin) = (0.7, Vector::X * speed);
                let start = Vector::Z * cone;
                let mut world = weightless(rate);
                let post = post(&mut world, Vector::ZERO);
                let rod = bob(1.0, 0.3).rotation(start).angvel(spin);
                let at = Rotation::from_scaled_axis(start) * Vector::X;
                let rod = world.insert_body(rod.translation(at).linvel(spin.cross(at)));
                let joint = SphericalJointBuilder::new().local_anchor2(-Vector::X);
                let joint = joint.swing_limit(cone);
                if is_multibody {
                    world.insert_multibody_joint(post, rod, joint).expect("the joint fits");
                } else {
                    world.insert_impulse_joint(post, rod, joint);
                }
                let before = world.bodies[rod].kinetic_energy();
                let (mut narrowest, mut widest): (Real, Real) = (cone, 0.0);
                for _ in 0..steps(&world, 5.0) {
                    world.step();
                    let now = swing(&world, [post, rod]);
                    (narrowest, widest) = (narrowest.min(now), widest.max(now));
                }
                let what = format!("{speed} rad/s at {rate} Hz, {is_multibody}");
                assert!(widest - cone < TOLERANCE, "{widest}, {what}");
                assert!(cone - narrowest < TOLERANCE, "{narrowest}, {what}");
                // Half a revolution at 30 Hz has 47 substeps, each a chord of the circle.
                let kept = world.bodies[rod].kinetic_energy() / before;
                assert!((kept - 1.0).abs() < 0.02, "{kept} of the energy, {what}");
            }
        }
    }
}

#[test]
fn the_twist_stays_in_its_range() {
    for rate in RATES {
        let mut world = weightless(rate);
        let post = post(&mut world, Vector::ZERO);
        let arm = world.insert_body(bob(1.0, 0.5).angvel(Vector::X * 2.0));
        let joint = SphericalJointBuilder::new().limits(JointAxis::AngX, [-0.3, 0.7]);
        world.insert_impulse_joint(post, arm, joint.swing_limit(0.5));
        run(&mut world, 2.0);
        let twist = world.bodies[arm].rotation().to_scaled_axis().x;
        assert!((twist - 0.7).abs() < TOLERANCE, "{twist} at {rate} Hz");
    }
}

#[test]
fn each_axis_of_the_swing_has_its_own_limits() {
    for (axis, direction) in [(JointAxis::AngY, Vector::Y), (JointAxis::AngZ, Vector::Z)] {
        let mut world = weightless(60);
        let post = post(&mut world, Vector::ZERO);
        let arm = world.insert_body(bob(1.0, 0.5).angvel(direction * -2.0));
        let joint = SphericalJointBuilder::new().limits(axis, [-0.4, 0.1]);
        world.insert_impulse_joint(post, arm, joint);
        run(&mut world, 2.0);
        let found = world.bodies[arm].rotation().to_scaled_axis().dot(direction);
        assert!((found + 0.4).abs() < TOLERANCE, "{found} about {direction}");
    }
}

#[test]
fn spherical_motors_reach_their_pose() {
    let mut world = weightless(60);
    let post = post(&mut world, Vector::ZERO);
    let arm = world.insert_body(bob(1.0, 0.5));
    let mut joint = SphericalJoint::new();
    for (axis, target) in [(JointAxis::AngX, 0.3), (JointAxis::AngY, 0.0), (JointAxis::AngZ, -0.5)]
    {
        joint.set_motor_position(axis, target, 200.0, 30.0);
    }
    world.insert_impulse_joint(post, arm, joint);
    run(&mut world, 3.0);
    let rotation = *world.bodies[arm].rotation();
    // The rotation is the swing about Z after the twist about X.
    let exact = Rotation::from_rotation_z(-0.5) * Rotation::from_rotation_x(0.3);
    assert!(rotation.angle_between(exact) < 2.0e-2, "{rotation} instead of {exact}");
}

#[test]
fn hinges_turn_about_their_axis_alone() {
    for rate in RATES {
        let mut world = world(rate);
        let post = post(&mut world, Vector::ZERO);
        let axis = Vector::new(0.48, 0.6, 0.64);
        let moment_arm = axis.cross(Vector::Y).normalize();
        let (door, _) = world.insert(
            RigidBodyBuilder::dynamic().translation(moment_arm).can_sleep(false),
            ColliderBuilder::cuboid(0.2, 0.6, 0.4),
        );
        let joint = RevoluteJointBuilder::new(axis).local_anchor2(-moment_arm);
        world.insert_impulse_joint(post, door, joint);
        let mut worst: Real = 0.0;
        for _ in 0..steps(&world, 5.0) {
            world.step();
            let body = &world.bodies[door];
            let tilt = (*body.rotation() * axis).cross(axis).length();
            worst =
                worst.max(tilt).max((body.translation() - *body.rotation() * moment_arm).length());
        }
        println!("an askew hinge at {rate} Hz is off by {worst:e}");
        assert!(worst < 1.0e-3, "{worst} at {rate} Hz");
    }
}

#[test]
fn universal_joints_lock_the_twist_alone() {
    let mut world = weightless(60);
    let post = post(&mut world, Vector::ZERO);
    let arm = world.insert_body(bob(1.0, 0.5).angvel(Vector::new(1.0, 0.5, -0.8)));
    let locked = JointAxesMask::LIN_AXES | JointAxesMask::ANG_X;
    world.insert_impulse_joint(post, arm, GenericJoint::new(locked));
    for _ in 0..120 {
        world.step();
        assert!(world.bodies[arm].rotation().x.abs() < 2.0e-3);
    }
    assert!(swing(&world, [post, arm]) > 0.5);
}

/// Returns forces of three hinges on one line of a door, as fractions of the weight: each force along `axis`,
/// and the largest transverse one.
fn hinges_of_a_door(rate: u32, axis: Vector) -> ([Real; 2], Real) {
    const MASS: Real = 20.0;
    let mut world = world(rate);
    let wall = post(&mut world, Vector::ZERO);
    let shape = ColliderBuilder::cuboid(0.45, 1.0, 0.02).mass(MASS);
    let turn = Rotation::from_rotation_arc(Vector::Y, axis);
    let pose = Pose::from_parts(turn * (Vector::X * 0.45), turn);
    let (door, _) = world.insert(RigidBodyBuilder::dynamic().pose(pose).can_sleep(false), shape);
    let share = MASS * G / 3.0;
    let mut joints = Vec::new();
    for height in [-0.9, 0.0, 0.9] {
        let mut joint: GenericJoint = RevoluteJointBuilder::new(Vector::Y).build().into();
        joint.set_local_anchor2(Vector::new(-0.45, height, 0.0));
        joint.local_frame1 = pose * joint.local_frame2;
        // The upper and lower joints also carry the moment: a quarter of the weight each.
        joint.set_break_thresholds(3.0 * share, Real::INFINITY);
        joints.push(world.insert_impulse_joint(wall, door, joint));
    }
    let [mut least, mut most, mut across] = [Real::INFINITY, 0.0, 0.0];
    for _ in 0..steps(&world, 5.0) {
        world.step();
        for &joint in &joints {
            let force = world.impulse_joints[joint].force() / share;
            (least, most) = (force.dot(axis).min(least), force.dot(axis).max(most));
            across = (force - axis * force.dot(axis)).length().max(across);
        }
    }
    assert!(joints.iter().all(|&joint| world.impulse_joints[joint].data.is_enabled()));
    ([least, most], across)
}

/// One hinge would suffice against sliding along the axis, and any two against tipping. All three share the
/// load.
#[test]
fn three_hinges_of_a_door_carry_a_third_each() {
    for rate in RATES {
        let ([least, most], across) = hinges_of_a_door(rate, Vector::Y);
        println!(
            "door at {rate} Hz: each hinge bears {least} to {most} of its share, {across} across"
        );
        assert!(least > 0.95 && most < 1.05, "{least} to {most} at {rate} Hz");
        // The moment m g b/2 on the two outer hinges alone, 1.8 m apart, is a transverse force of m g / 4:
        // 0.75 of a hinge's fraction. The hinges' own torques reduce it.
        assert!(across < 0.8, "{across} at {rate} Hz");
    }
}

/// A four-bar linkage of two cranks and a coupler has four hinges with parallel axes: three of its twenty
/// equations are redundant. It hangs like a swing, and each crank carries half of the coupler.
#[test]
fn a_four_bar_linkage_of_hinges_has_no_internal_forces() {
    for rate in RATES {
        let mut world = world(rate);
        let bar = |world: &mut PhysicsWorld, at: Vector, half: Vector, mass: Real| {
            let shape = ColliderBuilder::cuboid(half.x, half.y, half.z).mass(mass);
            let shape = shape.collision_groups(InteractionGroups::none());
            let body = RigidBodyBuilder::dynamic().translation(at).can_sleep(false);
            world.insert(body, shape).0
        };
        let frame = post(&mut world, Vector::ZERO);
        let axis = Vector::new(0.36, 0.48, 0.8);
        let (along, down) = (axis.cross(Vector::Y).normalize(), Vector::Y * -1.0);
        let coupler = bar(&mut world, down, Vector::splat(0.05), 4.0);
        let mut hinges = Vec::new();
        for side in [-0.7, 0.7] {
            let top = along * side;
            let crank = bar(&mut world, top + down * 0.5, Vector::splat(0.04), 0.5);
            let hinge = |from: Vector, to: Vector| {
                RevoluteJointBuilder::new(axis).local_anchor1(from).local_anchor2(to)
            };
            let upper = hinge(top, down * -0.5);
            hinges.push((world.insert_impulse_joint(frame, crank, upper), 2.5));
            let lower = hinge(down * 0.5, top);
            hinges.push((world.insert_impulse_joint(crank, coupler, lower), 2.0));
        }
        let mut worst: Real = 0.0;
        for _ in 0..steps(&world, 5.0) {
            world.step();
            for &(joint, mass) in &hinges {
                let force = world.impulse_joints[joint].force();
                // The axis is not level, so some of the force is along it.
                worst = worst.max((force.length() - mass * G).abs() / (mass * G));
            }
        }
        println!("four-bar at {rate} Hz: forces off by {worst}");
        assert!(worst < 0.02, "{worst} at {rate} Hz");
    }
}
