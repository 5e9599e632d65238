//! A collider: a shape with a pose, a material and interaction settings.

use super::form::ShapeForm;
use super::{
    ActiveCollisionTypes, ActiveEvents, ActiveHooks, CoefficientCombineRule, ColliderChanges,
    ColliderEnabled, ColliderFlags, ColliderMassProps, ColliderMaterial, ColliderParent,
    InteractionGroups, Widths, thickness,
};
use crate::base::fault::{Fault, ensure};
use crate::base::loading::{Loaded, check_when_loaded};
use crate::base::measure::is_margin;
use crate::dim::math::{Pose, Real, Rotation, Vector};
use crate::model::body::{RigidBodyHandle, RigidBodyType};
use crate::model::check::is_saved_pose;
use crate::model::edit_mark::EditMark;
use crate::model::tree::ColliderProxy;
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::mass_properties::MassProperties;
use parry::shape::{Shape, SharedShape};
use std::sync::Arc;

/// A shape with a pose, a material and interaction settings, attached to a rigid body or alone in the world.
///
/// [`ColliderBuilder`](super::ColliderBuilder) makes it, and a [`ColliderSet`](super::ColliderSet) owns it.
/// Setters called between steps take effect in the next step. A setter refuses an unusable value (not finite,
/// or negative where that has no meaning). It keeps the old value, and logs a warning with the refused value.
//
// The order of the fields is fixed (`repr(C)`). The fields that the narrow phase reads for each pair are at
// the front, which is prefetched.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(remote = "Self"))]
#[repr(C)]
pub struct Collider {
    #[cfg_attr(feature = "serde-serialize", serde(with = "super::saved"))]
    pub(crate) shape: SharedShape,
    /// Collider frame → world.
    pub(crate) pose: Pose,
    pub(crate) contact_skin: Real,
    /// Cached data of the shape.
    pub(crate) form: ShapeForm,
    pub(crate) sensor: bool,
    /// The type of the parent, for queries, which do not read the bodies.
    pub(crate) parent_type: Option<RigidBodyType>,
    pub(crate) parent: Option<ColliderParent>,
    pub(crate) material: ColliderMaterial,
    pub(crate) flags: ColliderFlags,
    /// Its place in the trees of boxes.
    pub(crate) proxy: ColliderProxy,
    // From here on: cold.
    pub(crate) mass_props: ColliderMassProps,
    pub(crate) contact_force_event_threshold: Real,
    pub(crate) changes: ColliderChanges,
    /// Mark of a pending edit.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(crate) edit: EditMark,
    /// The widths of the shape's parts, if looking them up is cheaper than computing them. They are not
    /// saved, but computed on loading.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(crate) widths: Option<Arc<[Widths]>>,
    /// User data. The engine never reads it.
    pub user_data: u128,
}

check_when_loaded!(Collider);

/// All numbers are those that the setters accept.
impl Loaded for Collider {
    fn check_loaded(&self) -> Result<(), Fault> {
        let place = self.parent.map_or(Pose::IDENTITY, |parent| parent.pos_wrt_parent);
        for pose in [self.pose, place] {
            ensure!(is_saved_pose(&pose), "a collider is at {pose:?}");
        }
        let ColliderMaterial { friction, restitution, .. } = self.material;
        for number in [friction, restitution] {
            let is_right = number.is_finite() && number >= 0.0;
            ensure!(is_right, "friction or restitution of a collider is {number}");
        }
        let skin = self.contact_skin;
        ensure!(is_margin(skin), "the contact skin of a collider is {skin}");
        ensure!(self.mass_props.is_valid(), "a collider has the mass {:?}", self.mass_props);
        let threshold = self.contact_force_event_threshold;
        ensure!(!threshold.is_nan(), "the force threshold of a collider is {threshold}");
        let ColliderProxy { fat_aabb, tree, clearance, .. } = self.proxy;
        let is_box = fat_aabb.mins.is_finite() && fat_aabb.maxs.is_finite();
        ensure!(tree.is_none() || is_box, "a collider is in the box {fat_aabb:?}");
        ensure!(clearance.is_finite(), "a collider has the clearance {clearance}");
        Ok(())
    }

    #[cfg(feature = "serde-serialize")]
    fn complete_loaded(&mut self) {
        self.widths = super::shape_table::widths_of(&self.shape);
    }
}

impl Collider {
    /// Bytes at the front of a collider that are all that the narrow phase reads of it.
    pub(super) const FRONT: usize = core::mem::offset_of!(Self, mass_props);
}

/// Getters of the configuration.
impl Collider {
    /// The user data. The engine never reads it.
    pub fn user_data(&self) -> u128 {
        self.user_data
    }

    /// The body it is attached to.
    #[inline]
    pub fn parent(&self) -> Option<RigidBodyHandle> {
        self.parent.map(|parent| parent.handle)
    }

    /// Returns whether the collider is a sensor: it reports intersections and has no contact forces.
    #[inline]
    pub fn is_sensor(&self) -> bool {
        self.sensor
    }

    /// Returns whether the collider takes part in the simulation and in queries. It does not if the collider
    /// or its body is disabled.
    #[inline]
    pub fn is_enabled(&self) -> bool {
        self.flags.enabled == ColliderEnabled::Enabled
    }

    /// The hooks for its pairs.
    #[inline]
    pub fn active_hooks(&self) -> ActiveHooks {
        self.flags.active_hooks
    }

    /// The events of its pairs.
    #[inline]
    pub fn active_events(&self) -> ActiveEvents {
        self.flags.active_events
    }

    /// The pairs of body types with which it collides.
    #[inline]
    pub fn active_collision_types(&self) -> ActiveCollisionTypes {
        self.flags.active_collision_types
    }

    /// Groups for contacts.
    #[inline]
    pub fn collision_groups(&self) -> InteractionGroups {
        self.flags.collision_groups
    }

    /// Groups for contact forces.
    #[inline]
    pub fn solver_groups(&self) -> InteractionGroups {
        self.flags.solver_groups
    }

    /// The surface material.
    #[inline]
    pub fn material(&self) -> &ColliderMaterial {
        &self.material
    }

    /// Largest ratio of the tangential to the normal contact force.
    #[inline]
    pub fn friction(&self) -> Real {
        self.material.friction
    }

    /// The combination rule for friction.
    #[inline]
    pub fn friction_combine_rule(&self) -> CoefficientCombineRule {
        self.material.friction_combine_rule
    }

    /// Ratio of the speeds of separation and approach.
    #[inline]
    pub fn restitution(&self) -> Real {
        self.material.restitution
    }

    /// The combination rule for restitution.
    #[inline]
    pub fn restitution_combine_rule(&self) -> CoefficientCombineRule {
        self.material.restitution_combine_rule
    }

    /// Thickness (length units) of an invisible layer around the shape. Contacts keep two shapes apart by the
    /// sum of their skins.
    #[inline]
    pub fn contact_skin(&self) -> Real {
        self.contact_skin
    }

    /// Least total contact force magnitude of a pair (force units) with an event, if
    /// [`ActiveEvents::CONTACT_FORCE_EVENTS`] is set. A force of zero has none.
    #[inline]
    pub fn contact_force_event_threshold(&self) -> Real {
        self.contact_force_event_threshold
    }
}

/// Pose of the collider.
impl Collider {
    /// Collider frame → world.
    #[inline]
    pub fn position(&self) -> &Pose {
        &self.pose
    }

    /// The origin of its frame in world space.
    #[inline]
    pub fn translation(&self) -> Vector {
        self.pose.translation
    }

    /// Its orientation in world space.
    #[inline]
    pub fn rotation(&self) -> Rotation {
        self.pose.rotation
    }

    /// Collider frame → body frame; `None` if it is not attached.
    #[inline]
    pub fn position_wrt_parent(&self) -> Option<&Pose> {
        self.parent.as_ref().map(|parent| &parent.pos_wrt_parent)
    }

    /// The box around the shape in world space, without the contact skin.
    pub fn compute_aabb(&self) -> Aabb {
        self.shape.compute_aabb(&self.pose)
    }

    /// The world-space box around the shape and its contact skin, enlarged by `prediction` on every side
    /// (length units). A negative or NaN `prediction` counts as 0.
    pub fn compute_collision_aabb(&self, prediction: Real) -> Aabb {
        self.compute_aabb().loosened(self.contact_skin + prediction.max(0.0))
    }

    /// The box around the shape at its pose and at `next_position`. It also contains the shape during a
    /// translation between these poses.
    pub fn compute_swept_aabb(&self, next_position: &Pose) -> Aabb {
        self.shape.compute_swept_aabb(&self.pose, next_position)
    }

    /// An upper bound of the distance from a point (in the collider's frame) to any point of the
    /// shape; infinite for half-spaces.
    pub(crate) fn bounding_radius_about(&self, center: Vector) -> Real {
        super::extent::farthest(&*self.shape, center)
    }

    /// Half the minimum width of the shape's thinnest part (length units): see [`Widths`].
    pub(crate) fn thickness(&self) -> Real {
        thickness(&*self.shape, self.widths.as_deref())
    }
}

/// The shape and its mass.
impl Collider {
    /// The shape.
    #[inline]
    pub fn shape(&self) -> &dyn Shape {
        &*self.shape
    }

    /// The reference-counted shape, which other colliders can share.
    #[inline]
    pub fn shared_shape(&self) -> &SharedShape {
        &self.shape
    }

    /// Volume of the shape; area in 2D. Zero for surfaces and for infinite shapes.
    pub fn volume(&self) -> Real {
        ColliderMassProps::Density(1.0).mass_properties(&*self.shape).mass()
    }

    /// Mass per volume (per area in 2D). It is the density that was set, or the mass that was set divided by
    /// the volume. 0 for shapes without volume.
    pub fn density(&self) -> Real {
        let mass = match &self.mass_props {
            ColliderMassProps::Density(density) => return *density,
            ColliderMassProps::Mass(mass) => *mass,
            ColliderMassProps::MassProperties(properties) => properties.mass(),
        };
        let volume = self.volume();
        if volume > 0.0 { mass / volume } else { 0.0 }
    }

    /// Contribution to the mass of its body.
    pub fn mass(&self) -> Real {
        match &self.mass_props {
            ColliderMassProps::Mass(mass) => *mass,
            other => other.mass_properties(&*self.shape).mass(),
        }
    }

    /// Mass, centre of mass and angular inertia in the collider's frame.
    pub fn mass_properties(&self) -> MassProperties {
        self.mass_props.mass_properties(&*self.shape)
    }
}
