//! Rapier from its published crates.
//!
//! Its defaults are what its authors recommend and what its own benchmarks use: 4 solver iterations,
//! contact recycling and clustering, friction in the relax pass only. Geometry, mathematics and the
//! numbers of the collision groups are the same types as ours, so shapes are shared.

#[path = "common.rs"]
mod common;

use super::ours::prelude as ours;
use super::peer as engine;
use super::template::{DT, SUBSTEPS, Template};
use crate::engine::{Engine, Probes, Stats};
use common::{count_hits, note_bodies};
use engine::prelude::*;

/// A world in Rapier.
pub struct Rapier<'t> {
    template: &'t Template,
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
}

impl<'t> Rapier<'t> {
    /// The scene at its start.
    pub fn new(template: &'t Template) -> Self {
        let mut world = PhysicsWorld::new();
        world.gravity = template.world.gravity;
        world.integration_parameters.dt = DT;
        world.integration_parameters.num_solver_iterations = SUBSTEPS;
        world.integration_parameters.max_ccd_substeps = 0;
        let mut bodies = Vec::with_capacity(template.bodies.len());
        for (body, colliders) in template.parts() {
            let handle = world.insert_body(transcribe_body(body));
            for collider in colliders {
                world.insert_collider(transcribe_collider(collider), Some(handle));
            }
            bodies.push(handle);
        }
        for collider in template.loose_colliders() {
            world.insert_collider(transcribe_collider(collider), None);
        }
        for (ends, joint) in &template.joints {
            let [body1, body2] = ends.map(|body| bodies[body]);
            world.impulse_joints.insert(body1, body2, transcribe_joint(joint), true);
        }
        Self { template, world, bodies }
    }
}

impl Engine for Rapier<'_> {
    fn step(&mut self) {
        self.world.step();
    }

    fn cast(&self, probes: &Probes, radius: Option<f32>) -> Option<usize> {
        Some(count_hits(&self.world, probes, radius))
    }

    fn stats(&self) -> Stats {
        let mut stats = Stats::default();
        for pair in self.world.contact_pairs().filter(|pair| pair.has_any_active_contact()) {
            stats.pairs += 1;
            stats.points +=
                pair.manifolds().iter().map(|m| m.data.num_active_contacts()).sum::<usize>();
        }
        let bodies: Vec<&RigidBody> =
            self.bodies.iter().map(|&handle| &self.world.bodies[handle]).collect();
        note_bodies(self.template, &bodies, &mut stats);
        stats
    }
}

fn transcribe_body(body: &ours::RigidBody) -> RigidBody {
    let body_type = match body.body_type() {
        ours::RigidBodyType::Dynamic => RigidBodyType::Dynamic,
        ours::RigidBodyType::Fixed => RigidBodyType::Fixed,
        ours::RigidBodyType::KinematicPositionBased => RigidBodyType::KinematicPositionBased,
        ours::RigidBodyType::KinematicVelocityBased => RigidBodyType::KinematicVelocityBased,
    };
    RigidBodyBuilder::new(body_type)
        .pose(*body.position())
        .linvel(body.linvel())
        .angvel(body.angvel())
        .linear_damping(body.linear_damping())
        .angular_damping(body.angular_damping())
        .gravity_scale(body.gravity_scale())
        .dominance_group(body.dominance_group())
        .locked_axes(LockedAxes::from_bits_truncate(body.locked_axes().bits()))
        .can_sleep(false)
        .enabled(body.is_enabled())
        .build()
}

fn transcribe_collider(collider: &ours::Collider) -> Collider {
    // Where the collider is: on its body, or in the world if it has none.
    let pose = collider.position_wrt_parent().unwrap_or(collider.position());
    ColliderBuilder::new(collider.shared_shape().clone())
        .position(*pose)
        .mass_properties(collider.mass_properties())
        .friction(collider.friction())
        .friction_combine_rule(transcribe_rule(collider.friction_combine_rule()))
        .restitution(collider.restitution())
        .restitution_combine_rule(transcribe_rule(collider.restitution_combine_rule()))
        .collision_groups(transcribe_groups(collider.collision_groups()))
        .solver_groups(transcribe_groups(collider.solver_groups()))
        .sensor(collider.is_sensor())
        .contact_skin(collider.contact_skin())
        .enabled(collider.is_enabled())
        .build()
}

/// Without motors and springs, which no scene here has.
fn transcribe_joint(joint: &ours::GenericJoint) -> GenericJoint {
    let mask = |axes: ours::JointAxesMask| JointAxesMask::from_bits_truncate(axes.bits());
    let mut transcribed = GenericJoint {
        local_frame1: joint.local_frame1,
        local_frame2: joint.local_frame2,
        locked_axes: mask(joint.locked_axes),
        limit_axes: mask(joint.limit_axes),
        coupled_axes: mask(joint.coupled_axes),
        contacts_enabled: joint.contacts_enabled,
        ..GenericJoint::default()
    };
    for (limits, from) in transcribed.limits.iter_mut().zip(&joint.limits) {
        (limits.min, limits.max) = (from.min, from.max);
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
    InteractionGroups::new(
        Group::from_bits_truncate(groups.memberships.bits()),
        Group::from_bits_truncate(groups.filter.bits()),
        InteractionTestMode::And,
    )
}
