//! Algorithms of multibodies against each other and against definitions, for random trees and random states.

use super::stage::{chain, slab};
use crate::dim::{about_z_of, loose_joint, vec};
use crate::suite::physics::stage::Dice;
use rapier::prelude::*;

/// Returns a tree of nine links with branches, sliders and armature, in a random configuration with random
/// velocities.
fn tree(seed: u64, is_fixed: bool) -> (PhysicsWorld, MultibodyJointHandle) {
    let mut world = PhysicsWorld::new();
    let mut dice = Dice(seed);
    let root = if is_fixed { RigidBodyBuilder::fixed() } else { slab(Vector::ZERO) };
    let mut bodies = vec![world.insert_body(root)];
    let mut last = MultibodyJointHandle::invalid();
    for k in 0..8 {
        let parent = bodies[dice.within(0.0, bodies.len() as Real - 0.01) as usize];
        let body = world.insert_body(slab(vec(dice.within(-2.0, 2.0), dice.within(-2.0, 2.0))));
        let anchors = [vec(0.5, dice.within(-0.2, 0.2)), vec(-0.4, 0.1)];
        let mut joint = loose_joint(k, anchors[0], anchors[1]);
        if k % 3 == 2 {
            joint.locked_axes = JointAxesMask::LOCKED_PRISMATIC_AXES;
        }
        last = world.multibody_joints.insert(parent, body, joint, true).expect("a tree");
        bodies.push(body);
    }
    let PhysicsWorld { bodies, multibody_joints, .. } = &mut world;
    let (multibody, _) = multibody_joints.get_mut(last).expect("it is there");
    multibody.forward_kinematics(bodies, true);
    for velocity in multibody.generalized_velocity_mut() {
        *velocity = dice.within(-2.0, 2.0);
    }
    let turn: Vec<_> = (0..multibody.ndofs()).map(|_| dice.within(-1.0, 1.0)).collect();
    multibody.apply_displacements(&turn);
    let last_dof = multibody.ndofs() - 1;
    multibody.armature_mut()[last_dof] = 0.3;
    (world, last)
}

fn near(a: &[Real], b: &[Real], size: Real) -> bool {
    let error = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, Real::max);
    a.len() == b.len() && error <= 300.0 * Real::EPSILON * size
}

fn largest(numbers: &[Real]) -> Real {
    numbers.iter().fold(1.0, |largest, number| largest.max(number.abs()))
}

/// `½ q̇ᵀ M q̇` equals the energy of all links, for all `q̇`: `M = Σ Jᵀ diag(m, I) J`.
#[test]
fn the_mass_matrix_agrees_with_the_links() {
    for seed in 0..10 {
        let (world, joint) = tree(seed, seed % 2 == 0);
        let (multibody, _) = world.multibody_joints.get(joint).expect("it is there");
        let n = multibody.ndofs();
        let mut expected = SquareMatrix::zeros(n);
        for link in multibody.links().skip(usize::from(seed % 2 == 0)) {
            let jacobian = multibody.body_jacobian(link.link_id());
            let mut posed = world.bodies[link.rigid_body_handle()].clone();
            posed.set_position(*link.local_to_world(), false);
            let momenta: Vec<_> =
                jacobian.iter().map(|j| crate::dim::momentum_of(&posed, j)).collect();
            for row in 0..n {
                for column in 0..n {
                    let product: Real =
                        jacobian[row].iter().zip(&momenta[column]).map(|(a, b)| a * b).sum();
                    expected[(row, column)] += product;
                }
            }
        }
        expected[(n - 1, n - 1)] += 0.3;
        let matrix = multibody.mass_matrix();
        for row in 0..n {
            for column in 0..n {
                let (found, expected) = (matrix[(row, column)], expected[(row, column)]);
                let size = (matrix[(row, row)] * matrix[(column, column)]).sqrt();
                assert!(
                    near(&[found], &[expected], size),
                    "{seed} {row} {column}: {found} {expected}"
                );
            }
        }
    }
}

/// The articulated-body algorithm inverts the mass matrix: `M (M⁻¹ τ) = τ`.
#[test]
fn articulated_bodies_invert_the_mass_matrix() {
    for seed in 0..10 {
        let (world, joint) = tree(seed, seed % 2 == 0);
        let (multibody, _) = world.multibody_joints.get(joint).expect("it is there");
        let mut dice = Dice(seed + 100);
        let forces: Vec<_> = (0..multibody.ndofs()).map(|_| dice.within(-3.0, 3.0)).collect();
        let accelerations = multibody.accelerations_of(&forces);
        let matrix = multibody.mass_matrix();
        let back = matrix.mul(&accelerations);
        assert!(near(&back, &forces, 100.0 * largest(&accelerations)), "{back:?} for {forces:?}");
        let direct = matrix.solve_symmetric(&forces);
        assert!(near(&direct, &accelerations, 100.0 * largest(&accelerations)), "{direct:?}");
    }
}

/// Without forces `M q̈ = -C q̇`. A very short step must agree with it.
#[test]
fn free_links_follow_newton_and_euler() {
    for seed in 0..10 {
        let (mut world, joint) = tree(seed, seed % 2 == 0);
        world.gravity = Vector::ZERO;
        world.integration_parameters.dt = 1.0e-4;
        let (multibody, _) = world.multibody_joints.get(joint).expect("it is there");
        let bias: Vec<_> = multibody.bias_forces().iter().map(|force| -force).collect();
        let expected = multibody.accelerations_of(&bias);
        world.step();
        let (multibody, _) = world.multibody_joints.get(joint).expect("it is there");
        let found = multibody.generalized_acceleration();
        let error = found.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, Real::max);
        assert!(error < 0.02 * largest(&expected), "{found:?} for {expected:?}");
    }
}

/// A Jacobian is the derivative of the pose by the coordinates.
#[test]
fn jacobians_are_derivatives() {
    let step: Real = if Real::EPSILON < 1.0e-10 { 1.0e-6 } else { 4.0e-3 };
    for seed in 0..6 {
        let (world, joint) = tree(seed, seed % 2 == 0);
        let (multibody, _) = world.multibody_joints.get(joint).expect("it is there");
        let tip = multibody.num_links() - 1;
        let jacobian = multibody.body_jacobian(tip);
        for dof in 0..multibody.ndofs() {
            let at = |by: Real| {
                let mut moved = multibody.clone();
                let mut displacements = vec![0.0; multibody.ndofs()];
                displacements[dof] = by;
                moved.apply_displacements(&displacements);
                moved.link(tip).expect("the tip").local_to_world().translation
            };
            let measured = (at(step) - at(-step)) / (2.0 * step);
            for axis in 0..DIM {
                let error = (measured[axis] - jacobian[dof][axis]).abs();
                assert!(error < 2.0e-3 * largest(&jacobian[dof]), "{seed} {dof}: {error}");
            }
        }
    }
}

/// An impulse `p` on the last link of a hanging chain acts through all hinges. At a free end of a rod it
/// changes the velocity there by `4 p / m` (rod of length `L`, `I = m L²/12`). If the other end is fixed, the
/// change is `3 p / m`.
#[test]
fn impulses_act_through_joints() {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let post = world.insert_body(RigidBodyBuilder::fixed());
    let rod = chain(&mut world, Some(post), 1).bodies[0];
    let (mass, inertia) = {
        let body = &world.bodies[rod];
        (body.mass(), about_z_of(body.mass_properties().local_mprops()))
    };
    world.step();
    world.bodies[rod].apply_impulse_at_point(vec(0.0, 0.2), vec(1.0, 0.0), true);
    world.step();
    let expected = 0.2 / (inertia + mass * 0.25);
    let found = crate::dim::z_of(world.bodies[rod].angvel());
    assert!((found / expected - 1.0).abs() < 1.0e-3, "{found} instead of {expected}");
}

/// The inverse inertia of a degree of freedom is its acceleration by a force of 1 on it.
#[test]
fn inverse_inertias_are_responses_to_unit_forces() {
    for seed in 0..20 {
        let (world, joint) = tree(seed, seed % 2 == 0);
        let (multibody, _) = world.multibody_joints.get(joint).expect("it is there");
        for (dof, inverse) in multibody.dof_inverse_inertia().into_iter().enumerate() {
            let mut forces = vec![0.0; multibody.ndofs()];
            forces[dof] = 1.0;
            let expected = multibody.accelerations_of(&forces)[dof];
            let error = (inverse - expected).abs();
            assert!(error <= 1.0e-3 * expected, "{seed}, {dof}: {inverse} for {expected}");
        }
    }
}
