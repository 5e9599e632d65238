//! The idioms of upstream's own examples: each name in the form in which the examples use it.

use super::world::{GRAVITY, World};
use rapier::control::{KinematicCharacterController, PidController};
use rapier::data::{Arena, Coarena};
use rapier::math::{SimdPoint, SimdVector};
use rapier::prelude::*;
use rapier::utils::{CrossProduct, DotProduct, OrthonormalBasis, SimdLength};

/// A controller of the vertical axis alone moves a weightless body to a height. It is a damped oscillator,
/// whose error is negligible after 10 s, and it leaves the other axes alone.
#[test]
fn a_controller_with_masked_axes_moves_those_axes_only() {
    let mut world = World::default();
    let body =
        world.bodies.insert(RigidBodyBuilder::dynamic().additional_mass(1.0).gravity_scale(0.0));
    let mut pid = PidController::new(60.0, 0.0, 0.8, AxesMask::LIN_Y);
    pid.set_axes(AxesMask::LIN_Y);
    let target = Pose::from_translation(Vector::X * 3.0 + Vector::Y * 2.0);
    for _ in 0..600 {
        let dt = world.parameters.dt;
        let at_rest = RigidBodyVelocity::zero();
        let correction = pid.rigid_body_correction(dt, &world.bodies[body], target, at_rest);
        let vels = *world.bodies[body].vels();
        world.bodies[body].set_vels(vels + correction, true);
        world.steps(1);
    }
    let at = world.bodies[body].translation();
    assert!((at.y - 2.0).abs() < 0.01, "the controlled axis is at {}", at.y);
    assert_eq!(at.x, 0.0, "the other axis moved");
}

/// `vels` lends the velocity: `v = g t` after a fall of time `t`.
#[test]
fn velocities_are_lent() {
    let mut world = World::default();
    let body = world.bodies.insert(RigidBodyBuilder::dynamic().additional_mass(1.0));
    world.steps(60);
    let vels: &RigidBodyVelocity = world.bodies[body].vels();
    assert!((vels.linvel.y + GRAVITY).abs() < 1.0e-3, "{}", vels.linvel.y);
}

/// Upstream's vectors over any numbers are nalgebra's, and the traits of `utils` agree for both libraries.
#[test]
fn vectors_of_both_libraries_have_the_same_products() {
    let (a, b) = (Vector::X * 3.0 + Vector::Y * 4.0, Vector::X * -1.0 + Vector::Y * 2.0);
    let (na, nb): (SimdVector<Real>, SimdVector<Real>) =
        (rapier::utils::vect_to_na(a), rapier::utils::vect_to_na(b));
    assert_eq!(a.gdot(b), na.gdot(nb));
    assert_eq!((a.simd_length(), na.simd_length()), (5.0, 5.0));
    let tangent = a.normalize().orthonormal_basis()[0];
    assert!(tangent.gdot(a).abs() < 1.0e-6 && (tangent.simd_length() - 1.0).abs() < 1.0e-6);
    let _ = (a.gcross(b), na.gcross(nb));
    let origin: SimdPoint<Real> = SimdPoint::origin();
    let moved = origin + na;
    assert_eq!(moved.coords.x, 3.0);
}

/// Inverse kinematics with a vector of nalgebra puts the tip of a chain of length 2 at a target at distance
/// √2 from its root.
#[test]
fn inverse_kinematics_reaches_a_target() {
    let mut world = World::default();
    let mut last = world.bodies.insert(RigidBodyBuilder::fixed());
    let mut tip = MultibodyJointHandle::invalid();
    for i in 0..3 {
        let body = RigidBodyBuilder::dynamic().additional_mass_properties(unit_mass());
        let body = world.bodies.insert(body.gravity_scale(0.0));
        let at = if i == 0 { Vector::ZERO } else { Vector::Y * 0.5 };
        let mut joint = GenericJointBuilder::new(JointAxesMask::LIN_AXES);
        joint = joint.local_anchor1(at).local_anchor2(Vector::Y * -0.5);
        tip = world.multibody_joints.insert(last, body, joint, true).expect("a joint");
        last = body;
    }
    world.steps(1);
    let target = Pose::from_translation(Vector::X + Vector::Y);
    let mut displacements = DVector::zeros(0);
    let (multibody, link) = world.multibody_joints.get_mut(tip).expect("a multibody");
    if displacements.nrows() < multibody.ndofs() {
        displacements = DVector::zeros(multibody.ndofs());
    }
    displacements[0] = 0.1;
    let options = InverseKinematicsOption {
        constrained_axes: JointAxesMask::LIN_AXES,
        max_iters: 100,
        ..Default::default()
    };
    multibody.inverse_kinematics(
        &world.bodies,
        link,
        &options,
        &target,
        |_| true,
        &mut displacements,
    );
    multibody.apply_displacements(displacements.as_slice());
    multibody.forward_kinematics(&world.bodies, false);
    multibody.update_rigid_bodies(&mut world.bodies, false);
    let error = (world.bodies[last].translation() - target.translation).length();
    assert!(error < 2.0e-3, "the tip is {error} from the target");
    assert_eq!(multibody.generalized_velocity().len(), multibody.ndofs());
    multibody.damping_mut().fill(0.5);
    assert_eq!(multibody.damping()[0], 0.5);

    // Loaders of robots write to the numbers of single degrees of freedom, and weigh these.
    let armature = multibody.armature_mut();
    armature[0] = 1.0;
    let inverse = multibody.dof_inverse_inertia(&world.bodies);
    assert!(inverse[0] > 0.0 && inverse[0] < 1.0, "armature of 1: {inverse}");
}

/// The frame that loaders of robots give both bodies has the joint's axis as its first one.
#[test]
fn frames_have_their_axis_first() {
    let axis = Vector::Y * -2.0;
    let frame = GenericJoint::complete_ang_frame(axis);
    assert!((frame * Vector::X + Vector::Y).length() < 1.0e-6, "{frame:?}");
}

fn unit_mass() -> MassProperties {
    #[cfg(feature = "dim2")]
    return MassProperties::new(Vector::ZERO, 1.0, 0.1);
    #[cfg(feature = "dim3")]
    return MassProperties::new(Vector::ZERO, 1.0, Vector::splat(0.1));
}

/// A joint's softness is a spring, not an option: a mass `m` on a fixed joint of angular frequency `ω` sags
/// by `g / ω²`; the default joint does not.
#[test]
fn softness_is_a_spring() {
    let frequency = 2.0;
    let spring = SpringCoefficients::new(frequency, 1.0);
    for (softness, sag) in [
        (spring, GRAVITY / (2.0 * core::f64::consts::PI as Real * frequency).powi(2)),
        (SpringCoefficients::joint_defaults(), 0.0),
    ] {
        let mut world = World::default();
        let wall = world.bodies.insert(RigidBodyBuilder::fixed());
        let body = RigidBodyBuilder::dynamic().additional_mass_properties(unit_mass());
        let body = world.bodies.insert(body.can_sleep(false));
        let mut joint = FixedJointBuilder::new().softness(softness).build();
        joint.set_softness(softness);
        assert_eq!(joint.data.softness.natural_frequency, softness.natural_frequency);
        world.impulse_joints.insert(wall, body, joint, true);
        world.steps(600);
        let at = -world.bodies[body].translation().y;
        assert!((at - sag).abs() < 0.05 * sag + 1.0e-3, "the mass sags by {at}, formula {sag}");
    }
}

/// A `match` over the rules of Rapier 0.32 has five branches.
#[cfg(not(rapier036))]
#[test]
fn five_rules_are_all_rules() {
    let combine = |rule: CoefficientCombineRule, a: Real, b: Real| match rule {
        CoefficientCombineRule::Average => 0.5 * (a + b),
        CoefficientCombineRule::Min => a.min(b),
        CoefficientCombineRule::Multiply => a * b,
        CoefficientCombineRule::Max => a.max(b),
        CoefficientCombineRule::ClampedSum => (a + b).min(1.0),
    };
    assert_eq!(combine(CoefficientCombineRule::default(), 0.25, 0.75), 0.5);
}

/// The counters have upstream's fields and functions, and a step fills the fields.
#[test]
fn counters_have_the_names_of_upstream() {
    let mut world = World::default();
    world.bodies.insert(RigidBodyBuilder::dynamic().additional_mass(1.0));
    world.pipeline.counters.enable();
    world.steps(1);
    let counters = &world.pipeline.counters;
    assert!(counters.enabled && counters.step_time_ms() > 0.0);
    let parts = counters.stages.solver_time.time_ms() + counters.stages.update_time.time_ms();
    assert!(parts <= counters.step_time_ms());
    for unused in [
        counters.cd.final_broad_phase_time,
        counters.solver.velocity_update_time,
        counters.ccd.solver_time,
        counters.stages.island_constraints_collection_time,
        counters.custom,
    ] {
        assert_eq!(unused.time_ms(), 0.0);
    }
    world.pipeline.counters.disable();
    world.steps(1);
    assert_eq!(world.pipeline.counters.step_time_ms(), 0.0);
}

/// An arena keeps the elements of its indices, and refuses stale ones; data beside it follow.
#[test]
fn arenas_refuse_stale_indices() {
    let mut arena = Arena::new();
    let first = arena.insert("first");
    let second = arena.insert("second");
    let mut beside = Coarena::new();
    beside.insert(second, 7);
    assert_eq!(arena.remove(first), Some("first"));
    let third = arena.insert("third");
    assert_eq!((arena.get(first), arena[second], arena.len()), (None, "second", 2));
    assert_eq!(first.into_raw_parts().0, third.into_raw_parts().0, "the hole is filled");
    assert_eq!(beside.get(second), Some(&7));
    assert_eq!(beside.get(third), None);
    arena.retain(|index, _| index == second);
    assert_eq!(arena.iter().map(|(_, element)| *element).collect::<Vec<_>>(), ["second"]);
}

/// A character that is built as the examples do walks on flat ground without a change of its height.
#[test]
fn a_character_walks() {
    let mut world = World::default();
    world.colliders.insert(ColliderBuilder::new(SharedShape::halfspace(Vector::Y)));
    world.steps(1);
    let controller = KinematicCharacterController { slide: true, ..Default::default() };
    let shape = SharedShape::ball(0.5);
    let queries = world.broad_phase.as_query_pipeline(
        world.narrow_phase.query_dispatcher(),
        &world.bodies,
        &world.colliders,
        QueryFilter::default(),
    );
    let mut pose = Pose::from_translation(Vector::Y * 0.51);
    for _ in 0..60 {
        let moved =
            controller.move_shape(1.0 / 60.0, &queries, &*shape, &pose, Vector::X / 60.0, |_| {});
        pose.translation += moved.translation;
    }
    let (x, y) = (pose.translation.x, pose.translation.y);
    assert!((x - 1.0).abs() < 0.02 && (y - 0.51).abs() < 0.02, "the character is at {x}, {y}");
}

/// The names of Rapier 0.36.
#[cfg(rapier036)]
mod version036 {
    use crate::suite::world::assert_near;
    use rapier::prelude::*;

    /// A world with all of its parts lets a ball fall and finds it.
    #[test]
    fn worlds_have_all_parts() {
        let mut world = PhysicsWorld::new();
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 10.0);
        let (body, collider) = world.insert(body, ColliderBuilder::ball(0.5));
        let ground = SharedShape::halfspace(Vector::Y);
        let ground = world.insert_collider(ColliderBuilder::new(ground), None);
        (0..60).for_each(|_| world.step());
        let fallen = 10.0 - world.bodies[body].translation().y;
        assert_near(fallen, 0.5 * 9.81, 0.05);
        let ray = Ray::new(Vector::Y * 20.0, -Vector::Y);
        let hit = world.cast_ray(&ray, 100.0, true, QueryFilter::exclude_fixed());
        let (found, time) = hit.expect("a hit");
        assert_eq!(found, collider);
        assert_near(time, 20.0 - (10.0 - fallen) - 0.5, 1.0e-3);
        (0..240).for_each(|_| world.step());
        let pair: &ContactPair = world.contact_pairs().next().expect("a pair");
        assert!(pair.has_any_active_contact());
        let PairContacts::Rigid(rigid) = &pair.contacts else { panic!("soft contacts") };
        let weight = world.bodies[body].mass() * 9.81 * world.integration_parameters.dt;
        assert_near(pair.total_impulse_magnitude(), weight, 0.01 * weight);
        let contact: &SolverContact = &rigid.solver_manifolds()[0].data.solver_contacts[0];
        let gap = (contact.anchor2 - contact.anchor1).length();
        assert_near(gap, contact.dist.abs(), 1.0e-5);
        assert!([pair.collider1, pair.collider2].contains(&ground));
        assert!(world.remove_body(body).is_some());
        assert!(world.quarantine().bodies().is_empty() && world.query_pipeline().bodies.is_empty());
    }

    /// A sixth rule takes the root of the product.
    #[test]
    fn six_rules_are_all_rules() {
        let rule = CoefficientCombineRule::GeometricMean;
        match rule {
            CoefficientCombineRule::Average
            | CoefficientCombineRule::Min
            | CoefficientCombineRule::Multiply
            | CoefficientCombineRule::Max
            | CoefficientCombineRule::ClampedSum
            | CoefficientCombineRule::GeometricMean => {}
        }
        assert_near(CoefficientCombineRule::combine(0.25, 1.0, rule, rule), 0.5, 1.0e-6);
    }

    #[test]
    fn parameters_have_the_fields_of_version_036() {
        let parameters = IntegrationParameters {
            contact_clustering: false,
            contact_recycling: false,
            warmstart_joints: true,
            friction_in_bias_pass: true,
            normalized_max_linear_velocity: 20.0,
            length_unit: 10.0,
            ..IntegrationParameters::default()
        };
        assert_near(parameters.max_linear_velocity(), 200.0, 1.0e-4);
        assert_near(parameters.contact_recycle_distance(), 0.5, 1.0e-6);
        assert_eq!(parameters.soft_bodies, SoftBodiesSettings::default());
    }

    /// The graph of contacts and the tree of boxes contain the same colliders as the world.
    #[test]
    fn graphs_and_trees_are_readable() {
        let mut world = PhysicsWorld::new();
        world.insert_collider(ColliderBuilder::new(SharedShape::halfspace(Vector::Y)), None);
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 0.5);
        let (_, ball) = world.insert(body, ColliderBuilder::ball(0.5));
        (0..3).for_each(|_| world.step());
        let graph: &InteractionGraph<ColliderHandle, ContactPair> =
            world.narrow_phase.contact_graph();
        assert_eq!(graph.interactions().count(), 1);
        let (one, other, pair) = graph.interactions_with_endpoints().next().expect("a pair");
        assert!([one, other].contains(&ball) && pair.has_any_active_contact());
        let queries = world.query_pipeline();
        let leaves: Vec<_> = queries.bvh.leaves(|_| true).collect();
        assert_eq!(leaves.len(), 2);
        assert!(leaves.iter().all(|leaf| world.colliders.get_unknown_gen(*leaf).is_some()));
    }

    /// A coupling with the ratio 2 rotates the second wheel twice as fast. The Jacobian of that wheel is
    /// a unit rotation about its own axis.
    #[test]
    fn couplings_are_gears() {
        let mut world = PhysicsWorld::new();
        let frame = world.insert_body(RigidBodyBuilder::fixed());
        let mut wheel = |x: Real| {
            let wheel = RigidBodyBuilder::dynamic().translation(Vector::X * x).gravity_scale(0.0);
            let (wheel, _) = world.insert(wheel, ColliderBuilder::ball(0.3));
            let locked = JointAxesMask::LIN_AXES;
            #[cfg(feature = "dim3")]
            let locked = locked | JointAxesMask::ANG_Y | JointAxesMask::ANG_Z;
            let axle = GenericJointBuilder::new(locked).local_anchor1(Vector::X * x);
            world.insert_multibody_joint(frame, wheel, axle).expect("a joint")
        };
        let (first, second) = (wheel(0.0), wheel(2.0));
        let axis = JointAxis::AngX as usize;
        let (_, link2) = world.multibody_joints.get(second).expect("a link");
        let (multibody, link1) = world.multibody_joints.get_mut(first).expect("a link");
        let coupling = MultibodyDofCoupling {
            link1,
            dof1: 0,
            axis1: axis,
            link2,
            dof2: 0,
            axis2: axis,
            coeff: 2.0,
            offset: 0.0,
        };
        multibody.add_dof_coupling(coupling);
        assert_eq!(multibody.couplings(), [coupling]);
        multibody.generalized_velocity_mut()[0] = 1.0;
        (0..60).for_each(|_| world.step());
        let (multibody, _) = world.multibody_joints.get(first).expect("a link");
        let speeds = multibody.generalized_velocity();
        assert!(speeds[0] > 0.05, "the first wheel rotates at {} rad/s", speeds[0]);
        assert_near(speeds[1], 2.0 * speeds[0], 0.02 * speeds[0].abs());
        let jacobian: &Jacobian<Real> = multibody.body_jacobian(link2);
        assert_near(jacobian.column(1).norm(), 1.0, 1.0e-5);
        assert_near(jacobian.column(0).norm(), 0.0, 1.0e-5);
    }

    /// The engine has no soft bodies: an insertion leaves the set empty, and the world goes on.
    #[test]
    fn soft_bodies_are_ignored() {
        let mut world = PhysicsWorld::new();
        let rope = SoftBodyBuilder::rope(Vector::ZERO, Vector::X, 10)
            .material(SoftBodyMaterial { tear_strain: Some(2.0), ..Default::default() });
        let handle = world.insert_soft_body(rope);
        assert!(handle.is_invalid() && world.soft_bodies.is_empty());
        assert!(world.soft_bodies.get(handle).is_none());
        let body = world.insert_body(RigidBodyBuilder::dynamic().additional_mass(1.0));
        (0..10).for_each(|_| world.step());
        assert!(world.bodies[body].translation().y < 0.0);
        assert!(!world.bodies[body].is_soft_frame() && world.bodies[body].soft_body().is_none());
    }
}
