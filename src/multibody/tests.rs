//! The algorithms one by one, on chains small enough to be solved by hand.

use super::factor::{Factor, Resistance};
use super::kinematics::Kinematics;
use super::spatial::{ZERO, dot};
use crate::dim::joint_axes::JointAxesMask;
use crate::dim::math::{DIM, Pose, Real, SpatialVector, Vector};
use crate::dim::spatial::{angular, join, linear};
use crate::model::body::{RigidBodyBuilder, RigidBodyHandle, RigidBodySet};
use crate::model::joint::GenericJoint;
use crate::model::multibody::{Multibody, MultibodyJointSet};
use parry::mass_properties::MassProperties;

/// Returns whether two numbers of about this size are equal within rounding.
fn near(a: Real, b: Real, size: Real) -> bool {
    (a - b).abs() < 64.0 * Real::EPSILON * size
}

/// Sliders along x, each on the one before, the first on the world; masses 1, 2, 3, …
fn sliders(count: usize) -> (RigidBodySet, Multibody) {
    let mut bodies = RigidBodySet::new();
    let mut joints = MultibodyJointSet::new();
    let mut parent = bodies.insert(RigidBodyBuilder::fixed());
    let rail = GenericJoint::new(JointAxesMask::LOCKED_PRISMATIC_AXES);
    let mut last = None;
    for k in 0..count {
        let mass = MassProperties {
            inv_mass: 1.0 / (k as Real + 1.0),
            ..MassProperties::from_ball(1.0, 0.1)
        };
        let body = bodies.insert(RigidBodyBuilder::dynamic().additional_mass_properties(mass));
        last = joints.insert(parent, body, rail, true);
        parent = body;
    }
    let (multibody, _) = last.and_then(|last| joints.get_mut(last)).expect("a chain of sliders");
    multibody.forward_kinematics(&bodies, true);
    (bodies, multibody.clone())
}

/// Everything beyond a slider moves with it: `M_ij` is the mass from the later of both on.
#[test]
fn the_mass_matrix_of_sliders_adds_up_masses() {
    let (_, multibody) = sliders(3);
    let matrix = multibody.mass_matrix();
    let beyond = [6.0, 5.0, 3.0];
    for row in 0..3 {
        for column in 0..3 {
            let expected = beyond[row.max(column)];
            assert!(near(matrix[(row, column)], expected, 10.0), "{row} {column}");
        }
    }
}

/// A force on a slider among free ones moves its own body, and pushes back the one before it: `1/m₁ + 1/m₀`.
#[test]
fn sliders_push_back_the_one_before() {
    let (_, multibody) = sliders(3);
    let expected = [1.0, 1.0 + 1.0 / 2.0, 1.0 / 2.0 + 1.0 / 3.0];
    for (inverse, expected) in multibody.dof_inverse_inertia().into_iter().zip(expected) {
        assert!(near(inverse, expected, 10.0), "{inverse} instead of {expected}");
    }
}

/// A force on the last slider moves it alone, one on the first all of them together; wrenches act like
/// forces.
#[test]
fn forces_accelerate_bodies() {
    let (_, multibody) = sliders(3);
    let alone = multibody.accelerations_of(&[0.0, 0.0, 6.0]);
    // The second slider is pushed back by the load of the third one's rail: nothing, since it is free to
    // slide.
    assert!(near(alone[2] + alone[1] + alone[0], 2.0, 10.0), "{alone:?}");
    assert!(near(alone[0], 0.0, 10.0) && near(alone[1], -3.0, 10.0), "{alone:?}");

    let kinematics = Kinematics::of(&multibody);
    let mut factor = Factor::default();
    factor.update(&kinematics, Resistance { armature: &[0.0; 3], drag: &[] });
    let mut rates = vec![0.0; 3];
    let push: SpatialVector = join(Vector::X * 6.0, angular(&ZERO));
    factor.solve(&kinematics, &[ZERO, ZERO, ZERO, push], &mut rates);
    assert!(near(rates[0], 0.0, 10.0) && near(rates[2], 2.0, 10.0), "{rates:?}");
}

/// A prescribed degree of freedom takes no part: its ancestors carry its subtree as one body.
#[test]
fn held_degrees_of_freedom_take_no_part() {
    let (_, multibody) = sliders(3);
    let kinematics = Kinematics::of(&multibody);
    let mut factor = Factor::default();
    let armature = [0.0, Real::INFINITY, 0.0];
    factor.update(&kinematics, Resistance { armature: &armature, drag: &[] });
    let mut forces = vec![3.0, 100.0, 0.0];
    factor.solve(&kinematics, &[], &mut forces);
    assert!(near(forces[0], 1.0, 10.0) && forces[1] == 0.0, "{forces:?}");
    assert!(near(forces[2], -1.0, 10.0), "the last one stays where it is: {forces:?}");
}

/// `Jᵀ f` by going up the chain, and by the columns of `J`.
#[test]
fn generalized_forces_are_those_of_the_jacobian() {
    let (_, mut multibody) = sliders(4);
    multibody.apply_displacements(&[0.3, -0.2, 0.5, 0.1]);
    let kinematics = Kinematics::of(&multibody);
    let wrench: SpatialVector = core::array::from_fn(|k| 1.0 + k as Real);
    let mut forces = vec![0.0; 4];
    kinematics.add_generalized_force(3, &wrench, &mut forces);
    for (force, column) in forces.iter().zip(kinematics.jacobian(3)) {
        assert!(near(*force, dot(&column, &wrench), 10.0));
    }
    assert_eq!(forces[3], 0.0, "joints beyond the third link get no force");
}

/// Coordinates are computed from the poses of the bodies, and poses from the coordinates.
#[test]
fn bodies_and_coordinates_follow_each_other() {
    let (mut bodies, mut multibody) = sliders(2);
    let handle = |multibody: &Multibody, id: usize| -> RigidBodyHandle {
        multibody.link(id).expect("a link").rigid_body_handle()
    };
    let (first, second) = (handle(&multibody, 1), handle(&multibody, 2));
    let along = |x: Real| Pose::from_parts(Vector::X * x + Vector::Y * 5.0, Default::default());
    bodies[first].set_position(along(2.0), true);
    multibody.forward_kinematics(&bodies, true);
    let slide = |multibody: &Multibody, id: usize| multibody.links[id].joint.coords()[0];
    assert!(near(slide(&multibody, 1), 2.0, 10.0) && near(slide(&multibody, 2), 0.0, 10.0));
    multibody.apply_displacements(&[0.5, -1.0]);
    multibody.update_rigid_bodies(&mut bodies, true);
    assert!((bodies[first].translation() - Vector::X * 2.5).length() < 1.0e-5, "Y is locked");
    assert!((bodies[second].translation() - Vector::X * 1.5).length() < 1.0e-5);
    multibody.forward_kinematics(&bodies, true);
    assert!(near(slide(&multibody, 2), -1.0, 10.0), "nothing was moved since");
    assert_eq!(linear(&multibody.body_jacobian(2)[1]), Vector::X);
    assert_eq!(multibody.body_jacobian(2).len(), 2);
    assert_eq!(DIM + crate::dim::math::ANG_DIM, multibody.body_jacobian(2)[0].len());
}
