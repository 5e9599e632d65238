//! The world of a step: the sets and parameters that the caller of the pipeline passed.
//!
//! Only [`Step`](super::Step), the synchronisation of sets and the quarantine see all of it. Other stages get
//! the sets that their signatures list.

use crate::dim::math::Vector;
use crate::model::event::EventHandler;
use crate::model::hooks::PhysicsHooks;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;
use crate::model::params::IntegrationParameters;
use crate::model::state_hash::WorldSets;
use crate::model::structure::Structure;
use crate::model::tree::BroadPhaseBvh;

/// The sets and parameters of a world. The sets of the structure refer to each other.
pub(crate) struct World<'a> {
    pub gravity: Vector,
    pub params: &'a IntegrationParameters,
    pub structure: Structure<'a>,
    pub broad_phase: &'a mut BroadPhaseBvh,
    /// Empty in collision detection, which reads joints only.
    pub joints: &'a mut ImpulseJointSet,
    pub multibodies: &'a mut MultibodyJointSet,
    pub hooks: &'a dyn PhysicsHooks,
    pub events: &'a dyn EventHandler,
}

impl World<'_> {
    /// The sets that a hash covers.
    pub fn hashed_sets(&self) -> WorldSets<'_> {
        WorldSets {
            bodies: self.structure.bodies,
            colliders: self.structure.colliders,
            impulse_joints: self.joints,
            multibody_joints: self.multibodies,
            narrow_phase: self.structure.narrow_phase,
        }
    }
}
