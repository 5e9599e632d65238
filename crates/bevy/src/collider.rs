//! Components of a collider.

use crate::body::RigidBody;
use crate::dim::{Vector, to_engine};
use crate::precision::Scalar;
use crate::scale::scaled;
use bevy::ecs::component::Component;
use bevy::ecs::entity::Entity;
use bevy::ecs::hierarchy::ChildOf;
use bevy::ecs::query::{Changed, Has, Or, QueryData, With};
use bevy::ecs::reflect::ReflectComponent;
use bevy::reflect::Reflect;
use bevy::transform::components::Transform;
use rapier::math as engine;
use rapier::prelude::{
    ActiveEvents, ActiveHooks, CoefficientCombineRule, ColliderBuilder, Group, InteractionGroups,
    InvalidCollider, SharedShape,
};

/// A shape that collides. It belongs to the body of its entity or of the nearest ancestor with one; without
/// such a body it is immovable scenery.
///
/// Constructors have the names of the engine's `ColliderBuilder` and accept any numbers. An invalid shape is
/// [reported](crate::Refused) and left out. `Collider::from` accepts the engine's builder for all other
/// shapes.
#[derive(Component, Clone)]
#[require(Transform, Friction, Restitution, ColliderMass, CollisionGroups, ColliderState)]
pub struct Collider(Result<SharedShape, InvalidCollider>);

impl core::fmt::Debug for Collider {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match &self.0 {
            Ok(shape) => write!(f, "Collider({:?})", shape.shape_type()),
            Err(reason) => write!(f, "Collider({reason})"),
        }
    }
}

/// The builder's shape. Its other values are ignored: they have components.
impl From<ColliderBuilder> for Collider {
    fn from(builder: ColliderBuilder) -> Self {
        Self(builder.try_shape())
    }
}

impl From<SharedShape> for Collider {
    fn from(shape: SharedShape) -> Self {
        ColliderBuilder::new(shape).into()
    }
}

/// Shapes of both dimensions.
impl Collider {
    /// The shape.
    ///
    /// # Errors
    /// If the constructor's numbers were invalid.
    pub fn shape(&self) -> Result<&SharedShape, InvalidCollider> {
        self.0.as_ref().map_err(Clone::clone)
    }

    /// A ball around the origin.
    pub fn ball(radius: Scalar) -> Self {
        ColliderBuilder::ball(radius).into()
    }

    /// The half-space below a plane through the origin. The unit normal points out of the solid side.
    pub fn halfspace(outward_normal: Vector) -> Self {
        ColliderBuilder::halfspace(to_engine(outward_normal)).into()
    }

    /// A capsule along the x axis.
    pub fn capsule_x(half_height: Scalar, radius: Scalar) -> Self {
        ColliderBuilder::capsule_x(half_height, radius).into()
    }

    /// A capsule along the y axis.
    pub fn capsule_y(half_height: Scalar, radius: Scalar) -> Self {
        ColliderBuilder::capsule_y(half_height, radius).into()
    }

    /// A capsule between two points.
    pub fn capsule_from_endpoints(a: Vector, b: Vector, radius: Scalar) -> Self {
        ColliderBuilder::capsule_from_endpoints(to_engine(a), to_engine(b), radius).into()
    }

    /// A segment. It has no volume and so no mass from a density.
    pub fn segment(a: Vector, b: Vector) -> Self {
        ColliderBuilder::segment(to_engine(a), to_engine(b)).into()
    }

    /// A triangle.
    pub fn triangle(a: Vector, b: Vector, c: Vector) -> Self {
        ColliderBuilder::triangle(to_engine(a), to_engine(b), to_engine(c)).into()
    }

    /// A chain of segments. Without indices, each vertex is joined to the next one.
    pub fn polyline(vertices: &[Vector], indices: Option<Vec<[u32; 2]>>) -> Self {
        ColliderBuilder::polyline(engine_points(vertices), indices).into()
    }

    /// A surface of triangles.
    pub fn trimesh(vertices: &[Vector], indices: Vec<[u32; 3]>) -> Self {
        Self::from_result(ColliderBuilder::trimesh(engine_points(vertices), indices))
    }

    /// The smallest convex shape around some points.
    pub fn convex_hull(points: &[Vector]) -> Self {
        Self::from_result(ColliderBuilder::try_convex_hull(&engine_points(points)))
    }

    fn from_result(builder: Result<ColliderBuilder, InvalidCollider>) -> Self {
        Self(builder.and_then(|builder| builder.try_shape()))
    }
}

fn engine_points(points: &[Vector]) -> Vec<engine::Vector> {
    points.iter().copied().map(to_engine).collect()
}

/// Largest ratio of the tangential to the normal contact force. 0.5 by default.
#[derive(Component, Copy, Clone, Debug, PartialEq)]
pub struct Friction {
    /// The ratio, 0 or more.
    pub coefficient: Scalar,
    /// The rule that combines it with that of another collider.
    pub combine_rule: CoefficientCombineRule,
}

impl Friction {
    /// Friction with the default rule, the average.
    pub fn new(coefficient: Scalar) -> Self {
        Self { coefficient, combine_rule: CoefficientCombineRule::Average }
    }
}

impl Default for Friction {
    fn default() -> Self {
        Self::new(ColliderBuilder::default_friction())
    }
}

/// Ratio of the speeds of separation and approach. 0 by default.
#[derive(Component, Copy, Clone, Debug, PartialEq)]
pub struct Restitution {
    /// The ratio, 0 or more.
    pub coefficient: Scalar,
    /// The rule that combines it with that of another collider.
    pub combine_rule: CoefficientCombineRule,
}

impl Restitution {
    /// Restitution with the default rule, the average.
    pub fn new(coefficient: Scalar) -> Self {
        Self { coefficient, combine_rule: CoefficientCombineRule::Average }
    }
}

impl Default for Restitution {
    fn default() -> Self {
        Self::new(0.0)
    }
}

/// Source of a collider's mass. Density 1 by default.
#[derive(Component, Reflect, Copy, Clone, Debug, PartialEq)]
#[reflect(Component)]
pub enum ColliderMass {
    /// Mass per volume (per area in 2D).
    Density(Scalar),
    /// Mass, spread evenly over the shape.
    Mass(Scalar),
}

impl Default for ColliderMass {
    fn default() -> Self {
        Self::Density(ColliderBuilder::default_density())
    }
}

/// Groups of a collider: its memberships, and the groups with which it collides. All by default.
#[derive(Component, Copy, Clone, Debug, PartialEq, Eq)]
pub struct CollisionGroups(pub InteractionGroups);

impl CollisionGroups {
    /// Groups from memberships and filter.
    pub fn new(memberships: Group, filter: Group) -> Self {
        Self(InteractionGroups::all().with_memberships(memberships).with_filter(filter))
    }
}

impl Default for CollisionGroups {
    fn default() -> Self {
        Self(InteractionGroups::all())
    }
}

/// Marker: the collider reports intersections and exerts no forces.
#[derive(Component, Reflect, Copy, Clone, Debug, Default)]
#[reflect(Component)]
pub struct Sensor;

/// Marker: pairs of the collider trigger [`CollisionStarted`](crate::CollisionStarted) and
/// [`CollisionStopped`](crate::CollisionStopped).
#[derive(Component, Reflect, Copy, Clone, Debug, Default)]
#[reflect(Component)]
pub struct CollisionEvents;

/// Pairs of the collider trigger [`ContactForce`](crate::ContactForce) in steps with large contact forces.
#[derive(Component, Reflect, Copy, Clone, Debug, Default, PartialEq)]
#[reflect(Component)]
pub struct ContactForceEvents {
    /// Sum of the contact forces of a pair above which the event is triggered.
    pub threshold: Scalar,
}

/// The [hooks](crate::CollisionHooks) that are called for pairs of the collider.
#[derive(Component, Copy, Clone, Debug, PartialEq, Eq)]
pub struct HookedPairs(pub ActiveHooks);

/// State of a collider as of its last synchronisation.
#[derive(Component, Copy, Clone, Debug, Default)]
pub(crate) struct ColliderState {
    /// The entity of its body.
    pub body: Option<Entity>,
    /// Pose and scale, relative to the body or to the world. They may be refused ones.
    pub relative: Transform,
}

/// Changes after which a collider may have another body, pose or scale. Below a parent, these depend on all
/// ancestors.
pub(crate) type ColliderMoves = Or<(Changed<Transform>, Changed<RigidBody>, With<ChildOf>)>;

/// Edits after which the engine's collider is described anew.
pub(crate) type ColliderEdits = Or<(
    Changed<Collider>,
    Changed<Friction>,
    Changed<Restitution>,
    Changed<ColliderMass>,
    Changed<CollisionGroups>,
    Changed<Sensor>,
    Changed<CollisionEvents>,
    Changed<ContactForceEvents>,
    Changed<HookedPairs>,
)>;

/// All components that describe a collider.
#[derive(QueryData)]
pub(crate) struct ColliderDescription {
    entity: Entity,
    collider: &'static Collider,
    friction: &'static Friction,
    restitution: &'static Restitution,
    mass: &'static ColliderMass,
    groups: &'static CollisionGroups,
    is_sensor: Has<Sensor>,
    has_events: Has<CollisionEvents>,
    forces: Option<&'static ContactForceEvents>,
    hooks: Option<&'static HookedPairs>,
}

impl ColliderDescriptionItem<'_, '_> {
    /// The engine's description of the collider with a scaled shape.
    pub fn builder(&self, scale: engine::Vector) -> Result<ColliderBuilder, InvalidCollider> {
        let shape = scaled(self.collider.shape()?, scale)?;
        let mut events = ActiveEvents::empty();
        events.set(ActiveEvents::COLLISION_EVENTS, self.has_events);
        events.set(ActiveEvents::CONTACT_FORCE_EVENTS, self.forces.is_some());
        let builder = ColliderBuilder::new(shape)
            .user_data(u128::from(self.entity.to_bits()))
            .friction(self.friction.coefficient)
            .friction_combine_rule(self.friction.combine_rule)
            .restitution(self.restitution.coefficient)
            .restitution_combine_rule(self.restitution.combine_rule)
            .collision_groups(self.groups.0)
            .sensor(self.is_sensor)
            .active_events(events)
            .active_hooks(self.hooks.map_or(ActiveHooks::empty(), |hooks| hooks.0))
            .contact_force_event_threshold(self.forces.map_or(0.0, |forces| forces.threshold));
        Ok(match *self.mass {
            ColliderMass::Density(density) => builder.density(density),
            ColliderMass::Mass(mass) => builder.mass(mass),
        })
    }
}
