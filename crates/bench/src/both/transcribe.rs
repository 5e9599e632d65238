//! Transcription of a scene into another engine with this engine's interface. The file is compiled twice: for
//! Rapier and for double precision. Each parent module binds the names `engine` (the crate) and `numbers`
//! (the conversions).

use super::super::ours::prelude as ours;
use super::super::template::{DT, SUBSTEPS, Template};
use super::engine::prelude::*;
use super::numbers;
use crate::engine::Unsupported;

/// Creates the scene at its start, and returns its bodies in the template's order.
pub fn world(template: &Template) -> Result<(PhysicsWorld, Vec<RigidBodyHandle>), Unsupported> {
    let mut world = PhysicsWorld::new();
    world.gravity = numbers::vector(template.world.gravity);
    world.integration_parameters.dt = numbers::real(DT);
    world.integration_parameters.num_solver_iterations = SUBSTEPS;
    world.integration_parameters.max_ccd_substeps = usize::from(template.rules.is_continuous);
    let mut shapes = numbers::Shapes::new();
    let mut bodies = Vec::with_capacity(template.bodies.len());
    for (body, colliders) in template.parts() {
        let handle = world.insert_body(transcribe_body(body, template.lets_sleep(body)));
        for collider in colliders {
            world.insert_collider(transcribe_collider(collider, &mut shapes)?, Some(handle));
        }
        bodies.push(handle);
    }
    for collider in template.loose_colliders() {
        world.insert_collider(transcribe_collider(collider, &mut shapes)?, None);
    }
    for (ends, joint) in &template.joints {
        let [body1, body2] = ends.map(|body| bodies[body]);
        world.impulse_joints.insert(body1, body2, transcribe_joint(joint), true);
    }
    Ok((world, bodies))
}

fn transcribe_body(body: &ours::RigidBody, may_sleep: bool) -> RigidBody {
    let body_type = match body.body_type() {
        ours::RigidBodyType::Dynamic => RigidBodyType::Dynamic,
        ours::RigidBodyType::Fixed => RigidBodyType::Fixed,
        ours::RigidBodyType::KinematicPositionBased => RigidBodyType::KinematicPositionBased,
        ours::RigidBodyType::KinematicVelocityBased => RigidBodyType::KinematicVelocityBased,
    };
    let mut transcribed = RigidBodyBuilder::new(body_type)
        .pose(numbers::pose(body.position()))
        .linvel(numbers::vector(body.linvel()))
        .angvel(numbers::angular(body.angvel()))
        .linear_damping(numbers::real(body.linear_damping()))
        .angular_damping(numbers::real(body.angular_damping()))
        .gravity_scale(numbers::real(body.gravity_scale()))
        .dominance_group(body.dominance_group())
        .locked_axes(LockedAxes::from_bits_truncate(body.locked_axes().bits()))
        .can_sleep(may_sleep)
        .enabled(body.is_enabled())
        .build();
    let time_until_sleep = numbers::real(body.activation().time_until_sleep);
    transcribed.activation_mut().time_until_sleep = time_until_sleep;
    transcribed
}

fn transcribe_collider(
    collider: &ours::Collider,
    shapes: &mut numbers::Shapes,
) -> Result<Collider, Unsupported> {
    // The pose is relative to the body, or to the world if there is no body.
    let pose = collider.position_wrt_parent().unwrap_or(collider.position());
    let transcribed = ColliderBuilder::new(shapes.shape(collider.shared_shape())?)
        .position(numbers::pose(pose))
        .mass_properties(numbers::mass(collider.mass_properties()))
        .friction(numbers::real(collider.friction()))
        .friction_combine_rule(transcribe_rule(collider.friction_combine_rule()))
        .restitution(numbers::real(collider.restitution()))
        .restitution_combine_rule(transcribe_rule(collider.restitution_combine_rule()))
        .collision_groups(transcribe_groups(collider.collision_groups()))
        .solver_groups(transcribe_groups(collider.solver_groups()))
        .sensor(collider.is_sensor())
        .contact_skin(numbers::real(collider.contact_skin()))
        .enabled(collider.is_enabled())
        .build();
    Ok(transcribed)
}

/// Transcribes a joint without motors and springs, which no scene here has.
fn transcribe_joint(joint: &ours::GenericJoint) -> GenericJoint {
    let mask = |axes: ours::JointAxesMask| JointAxesMask::from_bits_truncate(axes.bits());
    let mut transcribed = GenericJoint {
        local_frame1: numbers::pose(&joint.local_frame1),
        local_frame2: numbers::pose(&joint.local_frame2),
        locked_axes: mask(joint.locked_axes),
        limit_axes: mask(joint.limit_axes),
        coupled_axes: mask(joint.coupled_axes),
        contacts_enabled: joint.contacts_enabled,
        ..GenericJoint::default()
    };
    for (limits, from) in transcribed.limits.iter_mut().zip(&joint.limits) {
        (limits.min, limits.max) = (numbers::real(from.min), numbers::real(from.max));
    }
    transcribed
}

fn transcribe_rule(rule: ours::CoefficientCombineRule) -> CoefficientCombineRule {
    match rule {
        ours::CoefficientCombineRule::Average => CoefficientCombineRule::Average,
        ours::CoefficientCombineRule::Min => CoefficientCombineRule::Min,
        ours::CoefficientCombineRule::Multiply => CoefficientCombineRule::Multiply,
        ours::CoefficientCombineRule::Max => CoefficientCombineRule::Max,
        ours::CoefficientCombineRule::ClampedSum => CoefficientCombineRule::ClampedSum,
        ours::CoefficientCombineRule::GeometricMean => CoefficientCombineRule::GeometricMean,
    }
}

fn transcribe_groups(groups: ours::InteractionGroups) -> InteractionGroups {
    InteractionGroups {
        memberships: Group::from_bits_truncate(groups.memberships.bits()),
        filter: Group::from_bits_truncate(groups.filter.bits()),
        ..InteractionGroups::all()
    }
}
