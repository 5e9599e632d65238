//! What users read from a multibody, and write to it, between an edit and the next step.

use super::stage::slab;
use crate::dim::{about_z, angle, hinge, vec};
use crate::suite::physics::stage::{run, weightless};
use rapier::prelude::*;

/// Bodies of which the first is a root, and each later one the child of the one before. Hinges are half a
/// metre from both centres.
struct Arm {
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
    joints: Vec<MultibodyJointHandle>,
}

/// How a joint is inserted: by the world, or by the set of joints, which has no access to bodies.
#[derive(Copy, Clone, Debug, PartialEq)]
enum By {
    World,
    Set,
}

const ROOTS: [RigidBodyType; 4] = [
    RigidBodyType::Fixed,
    RigidBodyType::KinematicPositionBased,
    RigidBodyType::KinematicVelocityBased,
    RigidBodyType::Dynamic,
];

fn joint() -> RevoluteJointBuilder {
    hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0))
}

impl Arm {
    /// Bodies whose joints have these coordinates (rad).
    fn new(root: RigidBodyType, coordinates: &[Real], by: By) -> Self {
        let mut world = weightless(60);
        let mut arm = {
            let root = RigidBodyBuilder::new(root).additional_mass_properties(crate::dim::slab());
            let bodies = vec![world.insert_body(root.can_sleep(false))];
            Self { world, bodies, joints: Vec::new() }
        };
        for pose in poses(Pose::IDENTITY, coordinates).into_iter().skip(1) {
            let body = slab(pose.translation).rotation(about_z(angle(&pose.rotation)));
            let body = arm.world.insert_body(body);
            arm.add(body, by);
        }
        arm
    }

    fn add(&mut self, body: RigidBodyHandle, by: By) {
        let parent = *self.bodies.last().expect("a root");
        let joint = match by {
            By::World => self.world.insert_multibody_joint(parent, body, joint()),
            By::Set => self.world.multibody_joints.insert(parent, body, joint(), true),
        };
        self.joints.push(joint.expect("a tree"));
        self.bodies.push(body);
    }

    fn multibody(&mut self) -> &mut Multibody {
        self.world.multibody_joints.get_mut(self.joints[0]).expect("a joint").0
    }

    /// Displaces the joints alone, after the degrees of freedom of the root.
    fn displace(&mut self, displacements: &[Real]) {
        let root = self.multibody().root().expect("a root").ndofs();
        let all: Vec<_> =
            core::iter::repeat_n(0.0, root).chain(displacements.iter().copied()).collect();
        self.multibody().apply_displacements(&all);
    }

    /// The largest error of coordinates and poses, with the root at a pose.
    fn error(&mut self, root: Pose, coordinates: &[Real]) -> Real {
        let coords = |link: &MultibodyLink| link.joint().coords()[JointAxis::AngX as usize];
        let found: Vec<_> = self.multibody().links().skip(1).map(coords).collect();
        assert_eq!(found.len(), coordinates.len());
        let errors =
            found.iter().zip(coordinates).map(|(found, expected)| (found - expected).abs());
        let places = self.bodies.iter().zip(poses(root, coordinates)).map(|(&body, pose)| {
            let here = self.world.bodies[body].position();
            let turn = angle(&(here.rotation * pose.rotation.inverse())).abs();
            (here.translation - pose.translation).length().max(turn)
        });
        errors.chain(places).fold(0.0, Real::max)
    }
}

/// The poses of the bodies at these coordinates.
fn poses(root: Pose, coordinates: &[Real]) -> Vec<Pose> {
    let mut poses = vec![root];
    for coordinate in coordinates {
        let rotation = Pose::from_parts(Vector::ZERO, turn(*coordinate));
        let half = Pose::from_translation(vec(0.5, 0.0));
        let parent = *poses.last().expect("the root");
        poses.push(parent * half * rotation * half);
    }
    poses
}

/// A rotation about the axis out of the plane.
fn turn(angle: Real) -> Rotation {
    *RigidBodyBuilder::dynamic().rotation(about_z(angle)).build().rotation()
}

/// Rounding of a few poses of size 3.
const ERROR_MAX: Real = 64.0 * f32::EPSILON as Real;

/// Displacements of coordinates are kept until the bodies follow: before the first step, after more joints,
/// and with bodies that are moved before or after. Before, those before the first step were lost, and those
/// of moved bodies.
#[test]
fn displacements_stay_until_bodies_follow() {
    type Edit = fn(&mut Arm);
    let edits: [(&str, Edit); 4] = [
        ("no edit", |_| {}),
        ("forward kinematics", |arm| {
            let Arm { world, joints, .. } = arm;
            let (multibody, _) = world.multibody_joints.get_mut(joints[0]).expect("a joint");
            multibody.forward_kinematics(&world.bodies, false);
        }),
        ("bodies updated", |arm| {
            let Arm { world, joints, .. } = arm;
            let (multibody, _) = world.multibody_joints.get_mut(joints[0]).expect("a joint");
            multibody.update_rigid_bodies(&mut world.bodies, true);
        }),
        ("another joint", |arm| {
            let body = arm.world.insert_body(slab(vec(0.0, 9.0)));
            let joint = hinge().local_anchor1(vec(0.0, 9.0));
            arm.world.insert_multibody_joint(arm.bodies[0], body, joint).expect("a tree");
        }),
    ];
    let (start, by_user) = ([0.3, -0.4, 0.5], [0.2, 0.7, -0.6]);
    let sum: Vec<_> = start.iter().zip(by_user).map(|(a, b)| a + b).collect();
    for (root, by) in ROOTS.into_iter().flat_map(|root| [(root, By::World), (root, By::Set)]) {
        for (name, edit) in edits {
            for steps in [0, 3] {
                let mut arm = Arm::new(root, &start, by);
                (0..steps).for_each(|_| arm.world.step());
                arm.displace(&by_user);
                edit(&mut arm);
                run(&mut arm.world, 0.05);
                let coordinates =
                    if name == "another joint" { [&sum[..], &[0.0]].concat() } else { sum.clone() };
                let place = *arm.world.bodies[arm.bodies[0]].position();
                let error = match name {
                    "another joint" => {
                        let coords =
                            |link: &MultibodyLink| link.joint().coords()[JointAxis::AngX as usize];
                        let found: Vec<_> = arm.multibody().links().skip(1).map(coords).collect();
                        found
                            .iter()
                            .zip(&coordinates)
                            .map(|(a, b)| (a - b).abs())
                            .fold(0.0, Real::max)
                    }
                    _ => arm.error(place, &coordinates),
                };
                println!("{root:?}, by {by:?}, {steps} steps, {name}: {error:e}");
                assert!(error < ERROR_MAX, "{root:?}, by {by:?}, {steps} steps, {name}: {error}");
                let shift = place.translation.length();
                assert!(shift < ERROR_MAX, "the root stays");
            }
        }
    }
}

/// A body that the user moves and a displacement of its coordinates add up, in either order, before the first
/// step and later.
#[test]
fn displacements_and_moved_bodies_add_up() {
    for (steps, by) in [(0, By::World), (0, By::Set), (3, By::World)] {
        for displaces_first in [true, false] {
            for moved in 0..4 {
                let start = [0.3, -0.4, 0.5];
                let mut arm = Arm::new(RigidBodyType::Dynamic, &start, by);
                (0..steps).for_each(|_| arm.world.step());
                if displaces_first {
                    arm.displace(&[0.1, 0.2, 0.3]);
                }
                // The root alone, or a link with all its descendants.
                let (mut root, mut coordinates) = (Pose::IDENTITY, start);
                match moved {
                    0 => root = Pose::from_parts(vec(3.0, 1.0), turn(0.8)),
                    link => coordinates[link - 1] += 0.6,
                }
                for (&body, pose) in arm.bodies.iter().zip(poses(root, &coordinates)).skip(moved) {
                    arm.world.bodies[body].set_position(pose, true);
                }
                if !displaces_first {
                    arm.displace(&[0.1, 0.2, 0.3]);
                }
                run(&mut arm.world, 0.05);
                let expected: Vec<_> =
                    coordinates.iter().zip([0.1, 0.2, 0.3]).map(|(a, b)| a + b).collect();
                let error = arm.error(root, &expected);
                println!("{steps} steps, by {by:?}, body {moved}: {error:e}");
                assert!(error < 4.0 * ERROR_MAX, "{steps} steps, by {by:?}, body {moved}: {error}");
            }
        }
    }
}

/// All readings of a multibody that follow from its bodies.
fn readings(multibody: &Multibody) -> (usize, Vec<Real>) {
    let ndofs = multibody.ndofs();
    let matrix = multibody.mass_matrix();
    let entries = (0..ndofs).flat_map(|i| (0..ndofs).map(move |j| (i, j)));
    let mut numbers: Vec<Real> = entries.map(|place| matrix[place]).collect();
    numbers.extend(multibody.accelerations_of(&vec![1.0; ndofs]));
    for id in 0..multibody.num_links() {
        numbers.extend(multibody.body_jacobian(id).iter().flatten());
        let link = multibody.link(id).expect("a link");
        numbers.extend(link.local_to_world().translation.to_array());
        numbers.extend(link.joint().coords());
        numbers.push(link.assembly_id() as Real);
    }
    (ndofs, numbers)
}

/// After each insertion and removal of a joint by the world, a multibody has the degrees of freedom, masses
/// and poses that it has after the next step. Before, those of roots were missing, and all masses were zero.
#[test]
fn multibodies_are_up_to_date_after_edits_of_joints() {
    let check = |arm: &mut Arm, joint: usize, case: &str| {
        let read = |arm: &Arm| {
            let (multibody, _) =
                arm.world.multibody_joints.get(arm.joints[joint]).expect("a joint");
            readings(multibody)
        };
        let before = read(arm);
        arm.world.step();
        let after = read(arm);
        assert_eq!(before.0, after.0, "{case}");
        let difference =
            before.1.iter().zip(&after.1).map(|(a, b)| (a - b).abs()).fold(0.0, Real::max);
        println!("{case}: {} degrees of freedom, {difference:e}", before.0);
        assert!(
            before.1.len() == after.1.len() && difference < 16.0 * ERROR_MAX,
            "{case}: {difference}"
        );
    };
    for root in ROOTS {
        for locked in
            [LockedAxes::empty(), LockedAxes::ROTATION_LOCKED, LockedAxes::TRANSLATION_LOCKED_X]
        {
            let make = || {
                let mut arm = Arm::new(root, &[], By::World);
                let body = arm.bodies[0];
                arm.world.bodies[body].set_locked_axes(locked, true);
                for pose in poses(Pose::IDENTITY, &[0.3, -0.4, 0.5]).into_iter().skip(1) {
                    let body = slab(pose.translation).rotation(about_z(angle(&pose.rotation)));
                    let body = arm.world.insert_body(body);
                    arm.add(body, By::World);
                }
                arm
            };
            let case = |what: &str| format!("{root:?}, {locked:?}, {what}");
            check(&mut make(), 0, &case("new"));
            let mut arm = make();
            arm.world.step();
            arm.world.remove_multibody_joint(arm.joints[1]).expect("a joint");
            check(&mut arm, 0, &case("the part of the root"));
            let mut arm = make();
            arm.world.remove_multibody_joint(arm.joints[1]).expect("a joint");
            check(&mut arm, 2, &case("the other part"));
            // Two parts are joined, of which the second has a root of its own.
            let [parent, child] = [arm.bodies[1], arm.bodies[2]];
            arm.joints[1] =
                arm.world.insert_multibody_joint(parent, child, joint()).expect("a tree");
            check(&mut arm, 0, &case("merged"));
        }
    }
}

/// After edits of bodies, forward kinematics brings a multibody up to date, before the first step and later.
#[test]
fn forward_kinematics_follows_edits_of_bodies() {
    type Edit = fn(&mut RigidBody);
    let edits: [(&str, usize, Edit); 6] = [
        ("root made fixed", 0, |body| body.set_body_type(RigidBodyType::Fixed, true)),
        ("root made dynamic", 0, |body| body.set_body_type(RigidBodyType::Dynamic, true)),
        ("root locked", 0, |body| body.set_locked_axes(LockedAxes::TRANSLATION_LOCKED_X, true)),
        ("root moved", 0, |body| {
            body.set_position(Pose::from_parts(vec(2.0, 1.0), turn(0.7)), true)
        }),
        ("link moved", 2, |body| body.set_rotation(turn(0.9), true)),
        ("link heavier", 2, |body| body.set_additional_mass(3.0, true)),
    ];
    for (root, by) in ROOTS.into_iter().flat_map(|root| [(root, By::World), (root, By::Set)]) {
        for (name, body, edit) in edits {
            for steps in [0, 3] {
                let mut arm = Arm::new(root, &[0.3, -0.4, 0.5], by);
                (0..steps).for_each(|_| arm.world.step());
                edit(&mut arm.world.bodies[arm.bodies[body]]);
                let PhysicsWorld { multibody_joints, bodies, .. } = &mut arm.world;
                let (multibody, _) = multibody_joints.get_mut(arm.joints[0]).expect("a joint");
                multibody.forward_kinematics(bodies, false);
                let before = readings(multibody);
                arm.world.step();
                let after = readings(arm.multibody());
                let case = format!("{root:?}, by {by:?}, {steps} steps, {name}");
                assert_eq!((before.0, before.1.len()), (after.0, after.1.len()), "{case}");
                let numbers = before.1.iter().zip(&after.1);
                let difference = numbers.map(|(a, b)| (a - b).abs()).fold(0.0, Real::max);
                println!("{case}: {difference:e}");
                assert!(difference < 16.0 * ERROR_MAX, "{case}: {difference}");
            }
        }
    }
}

/// A velocity that the user sets for a joint, and an impulse on its body, add up: `ω + τ / I`. Before, the
/// impulse discarded the velocity.
#[test]
fn joint_velocities_and_impulses_add_up() {
    for (steps, by) in [(0, By::World), (0, By::Set), (3, By::World)] {
        for sets_first in [true, false] {
            let mut arm = Arm::new(RigidBodyType::Fixed, &[0.3], by);
            (0..steps).for_each(|_| arm.world.step());
            let body = arm.bodies[1];
            let push = |arm: &mut Arm, is_set: bool| match is_set {
                true => arm.multibody().generalized_velocity_mut()[0] = 2.0,
                false => arm.world.bodies[body].apply_torque_impulse(about_z(0.7), true),
            };
            push(&mut arm, sets_first);
            push(&mut arm, !sets_first);
            arm.world.step();
            let mass = arm.world.bodies[body].mass_properties().local_mprops();
            let inertia = crate::dim::about_z_of(mass) + mass.mass() * 0.5 * 0.5;
            let (found, expected) =
                (arm.multibody().generalized_velocity()[0], 2.0 + 0.7 / inertia);
            println!("{steps} steps, by {by:?}: {found}, {expected}");
            assert!(
                (found / expected - 1.0).abs() < 1.0e-4,
                "{steps} steps, by {by:?}: {found}, not {expected}"
            );
        }
    }
}

/// Inverse kinematics before the first step moves the tip of a free arm to its target.
#[test]
fn inverse_kinematics_works_before_the_first_step() {
    for root in ROOTS {
        let mut arm = Arm::new(root, &[0.3, 0.4, 0.5], By::World);
        let tip = *arm.bodies.last().expect("a tip");
        let target = Pose::from_translation(vec(1.2, 1.0));
        let options = InverseKinematicsOption {
            damping: 0.1,
            max_iters: 100,
            constrained_axes: JointAxesMask::LIN_X | JointAxesMask::LIN_Y,
            ..Default::default()
        };
        let PhysicsWorld { multibody_joints, bodies, .. } = &mut arm.world;
        let (multibody, _) = multibody_joints.get_mut(arm.joints[0]).expect("a joint");
        let mut displacements = Vec::new();
        multibody.inverse_kinematics(bodies, 3, &options, &target, |_| true, &mut displacements);
        assert_eq!(displacements.len(), multibody.ndofs());
        multibody.apply_displacements(&displacements);
        arm.world.step();
        let error = (arm.world.bodies[tip].translation() - target.translation).length();
        println!("{root:?}: {error}");
        assert!(error < 2.0 * options.epsilon_linear, "{root:?}: {error}");
    }
}
