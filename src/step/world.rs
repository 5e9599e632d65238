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
    /// In a divided step, those of the present part.
    pub params: IntegrationParameters,
    pub structure: Structure<'a>,
    pub broad_phase: &'a mut BroadPhaseBvh,
    /// Empty in collision detection, which reads joints only.
    pub joints: &'a mut ImpulseJointSet,
    pub multibodies: &'a mut MultibodyJointSet,
    pub hooks: &'a dyn PhysicsHooks,
    pub events: &'a dyn EventHandler,
}

impl World<'_> {
    /// The world for a part of the step.
    pub fn reborrow(&mut self) -> World<'_> {
        World {
            gravity: self.gravity,
            params: self.params,
            structure: self.structure.reborrow(),
            broad_phase: self.broad_phase,
            joints: self.joints,
            multibodies: self.multibodies,
            hooks: self.hooks,
            events: self.events,
        }
    }

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
