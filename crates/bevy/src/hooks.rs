//! Hooks: decisions of the user about single pairs and contacts.

use crate::dim::{Vector, to_bevy};
use crate::precision::Scalar;
use crate::world::entity_of;
use bevy::ecs::entity::Entity;
use rapier::math as engine;
use rapier::prelude::{
    ColliderHandle, ColliderSet, ContactModificationContext, PairFilterContext, PhysicsHooks,
    RigidBodyHandle, RigidBodySet,
};

/// Decisions about pairs and contacts, by a type that is a system parameter of Bevy.
///
/// The hooks are called for pairs with a collider that has [`HookedPairs`](crate::HookedPairs), from several
/// threads at once and in any order. Their results should depend on their input alone. The parameter may
/// read the world, except [`PhysicsWorld`](crate::PhysicsWorld), which the step owns.
pub trait CollisionHooks: Send + Sync {
    /// Returns whether the two solid colliders touch.
    fn filter_contacts(&self, pair: &ContactPair) -> bool {
        let _ = pair;
        true
    }

    /// Returns whether the two colliders, one of them a sensor, intersect.
    fn filter_intersection(&self, pair: &ContactPair) -> bool {
        let _ = pair;
        true
    }

    /// Changes the contacts of a pair before they are solved.
    fn modify_contacts(&self, pair: &ContactPair, contacts: &mut ModifiedContacts<'_, '_>) {
        let _ = (pair, contacts);
    }
}

/// All pairs collide, with unchanged contacts.
impl CollisionHooks for () {}

/// The entities of a pair.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct ContactPair {
    /// Entity of the first collider.
    pub collider1: Entity,
    /// Entity of the second collider.
    pub collider2: Entity,
    /// Entity of the first body, if there is one.
    pub body1: Option<Entity>,
    /// Entity of the second body, if there is one.
    pub body2: Option<Entity>,
}

impl ContactPair {
    /// Returns whether one of the colliders or bodies is this entity.
    pub fn contains(&self, entity: Entity) -> bool {
        let entity = Some(entity);
        [Some(self.collider1), Some(self.collider2), self.body1, self.body2].contains(&entity)
    }
}

/// The contacts of one manifold before they are solved.
pub struct ModifiedContacts<'a, 'b> {
    /// The engine's interface.
    pub engine: &'a mut ContactModificationContext<'b>,
}

impl ModifiedContacts<'_, '_> {
    /// The normal, from the first collider to the second.
    pub fn normal(&self) -> Vector {
        to_bevy(self.engine.normal())
    }

    /// Sets the friction of the contacts.
    pub fn set_friction(&mut self, friction: Scalar) {
        self.engine.set_friction(friction);
    }

    /// Sets the restitution of the contacts.
    pub fn set_restitution(&mut self, restitution: Scalar) {
        self.engine.set_restitution(restitution);
    }

    /// Sets the velocity that friction gives the surfaces relative to each other: a conveyor belt.
    pub fn set_tangent_velocity(&mut self, velocity: Vector) {
        self.engine.set_tangent_velocity(crate::dim::to_engine(velocity));
    }

    /// Removes the contacts of this step.
    pub fn clear(&mut self) {
        self.engine.clear_contacts();
    }

    /// Keeps only the contacts of a platform that is solid from one side. The direction is the normal of its
    /// solid side in the frame of the first collider.
    pub fn keep_one_way(&mut self, local_normal1: Vector, angle: Scalar) {
        let normal: engine::Vector = crate::dim::to_engine(local_normal1);
        self.engine.update_as_oneway_platform(normal, angle);
    }
}

/// The user's hooks as the engine's.
pub(crate) struct EngineHooks<'a, H>(pub &'a H);

impl<H: CollisionHooks> PhysicsHooks for EngineHooks<'_, H> {
    fn filter_contact_pair(&self, context: &PairFilterContext) -> bool {
        filter_pair(context).is_none_or(|pair| self.0.filter_contacts(&pair))
    }

    fn filter_intersection_pair(&self, context: &PairFilterContext) -> bool {
        filter_pair(context).is_none_or(|pair| self.0.filter_intersection(&pair))
    }

    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        let handles =
            ([context.collider1, context.collider2], [context.rigid_body1, context.rigid_body2]);
        if let Some(pair) = entities(context.bodies, context.colliders, handles) {
            self.0.modify_contacts(&pair, &mut ModifiedContacts { engine: context });
        }
    }
}

fn filter_pair(context: &PairFilterContext) -> Option<ContactPair> {
    let handles =
        ([context.collider1, context.collider2], [context.rigid_body1, context.rigid_body2]);
    entities(context.bodies, context.colliders, handles)
}

/// The entities of a pair; `None` if one of its colliders has no entity.
fn entities(
    bodies: &RigidBodySet,
    colliders: &ColliderSet,
    (pair, owners): ([ColliderHandle; 2], [Option<RigidBodyHandle>; 2]),
) -> Option<ContactPair> {
    let collider = |handle| entity_of(colliders.get(handle)?.user_data);
    let body = |handle: Option<_>| entity_of(bodies.get(handle?)?.user_data);
    Some(ContactPair {
        collider1: collider(pair[0])?,
        collider2: collider(pair[1])?,
        body1: body(owners[0]),
        body2: body(owners[1]),
    })
}
