//! The contact manifold: up to [`MAX_MANIFOLD_POINTS`] points with one normal.

use crate::base::measure::is_point;
use crate::dim::math::{DIM, MAX_MANIFOLD_POINTS, Real, Vector, tangents};
use crate::model::body::RigidBodyHandle;
use crate::model::check::is_saved_unit;
use crate::model::constraint_graph::ColorSlot;
use arrayvec::ArrayVec;
use parry::shape::PackedFeatureId;

bitflags::bitflags! {
    /// Constraints that the solver makes of a manifold.
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Hash)]
    pub struct SolverFlags: u32 {
        /// Compute impulses that keep the two bodies apart. Without it the contact is detected and
        /// reported, but the bodies pass through each other.
        const COMPUTE_RIGID_IMPULSES = 0b01;
    }
}

impl Default for SolverFlags {
    fn default() -> Self {
        Self::COMPUTE_RIGID_IMPULSES
    }
}

/// One contact point.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Contact {
    /// The point on the first collider, in that collider's frame (length units).
    pub local_p1: Vector,
    /// The point on the second collider, in that collider's frame (length units).
    pub local_p2: Vector,
    /// From the first body's centre of mass to the point midway between the two surfaces, in world
    /// space, when the anchors were [transformed](super::AnchorFrame).
    pub(crate) arm: Vector,
    /// [`Self::dist`] when the anchors were transformed.
    pub(crate) anchor_dist: Real,
    /// Distance of the two points along the normal; negative when the colliders overlap.
    pub dist: Real,
    /// The point midway between the two surfaces, in world space, as of the last step.
    pub point: Vector,
    /// The feature (vertex, edge, face) of the first collider that the point lies on.
    pub fid1: PackedFeatureId,
    /// The feature (vertex, edge, face) of the second collider that the point lies on.
    pub fid2: PackedFeatureId,
    /// Impulse along the normal during the last step: the sum over its substeps (mass·velocity).
    pub impulse: Real,
    /// Normal impulse with which the next step starts: that of the last substep, if steps are equal. After a
    /// shorter step, it is the impulse of a longer substep.
    pub warmstart_impulse: Real,
    /// Friction impulse at this point of the last substep, along the manifold's tangents. Only points with
    /// friction of their own have it: see [`ContactManifoldData::friction_impulse`].
    pub warmstart_tangent_impulse: [Real; DIM - 1],
}

impl Contact {
    /// A new contact without impulses.
    pub fn new(
        local_p1: Vector,
        local_p2: Vector,
        fid1: PackedFeatureId,
        fid2: PackedFeatureId,
        dist: Real,
    ) -> Self {
        Self {
            local_p1,
            local_p2,
            arm: Vector::ZERO,
            anchor_dist: dist,
            dist,
            point: Vector::ZERO,
            fid1,
            fid2,
            impulse: 0.0,
            warmstart_impulse: 0.0,
            warmstart_tangent_impulse: [0.0; DIM - 1],
        }
    }

    /// Returns whether all numbers are usable.
    fn is_sound(&self) -> bool {
        let vectors = [self.local_p1, self.local_p2, self.arm, self.point];
        let numbers = [self.anchor_dist, self.dist, self.impulse, self.warmstart_impulse];
        vectors.iter().all(|vector| vector.is_finite())
            && numbers.iter().chain(&self.warmstart_tangent_impulse).all(|it| it.is_finite())
    }

    /// Takes over the impulses of an earlier contact of the same two features.
    pub(crate) fn inherit(&mut self, earlier: &Contact) {
        self.impulse = earlier.impulse;
        self.warmstart_impulse = earlier.warmstart_impulse;
        self.warmstart_tangent_impulse = earlier.warmstart_tangent_impulse;
    }
}

/// The points of one manifold.
pub type ContactPoints = ArrayVec<Contact, MAX_MANIFOLD_POINTS>;

/// The solver's data of a manifold.
///
/// Iteration over `&ContactManifoldData` returns its [`Contact`]s.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactManifoldData {
    /// Body of the first collider; `None` without a body.
    pub rigid_body1: Option<RigidBodyHandle>,
    /// Body of the second collider; `None` without a body.
    pub rigid_body2: Option<RigidBodyHandle>,
    /// Flags that select the constraints of a manifold.
    pub solver_flags: SolverFlags,
    /// Unit normal in world space, from the first collider to the second.
    pub normal: Vector,
    /// [`Self::normal`] when the anchors were [transformed](super::AnchorFrame).
    pub(crate) anchor_normal: Vector,
    /// Combined friction coefficient.
    pub friction: Real,
    /// Combined restitution coefficient.
    pub restitution: Real,
    /// Target velocity of friction: the velocity of the second body relative to the first along the contact
    /// plane, in world space (length/s). For a conveyor belt as the first body, it is the velocity of the
    /// belt's surface; as the second body, the opposite. Set by
    /// [`PhysicsHooks`](crate::model::hooks::PhysicsHooks).
    pub tangent_velocity: Vector,
    /// Dominance group of the first body minus that of the second. Positive: the first body moves
    /// the second as if it had infinite mass.
    pub relative_dominance: i16,
    /// User data of the hooks. It persists as long as the manifold.
    pub user_data: u32,
    /// Friction impulse of the last substep in world space, at the manifold's friction centre.
    pub(crate) last_friction: Vector,
    /// Friction impulse with which the next step starts: see [`Contact::warmstart_impulse`].
    pub(crate) warmstart_friction: Vector,
    /// Torsional-friction impulse of the last substep about the normal (3D).
    pub(crate) warmstart_torsion: Real,
    /// The points, all within the prediction distance. They are read-only in a contact pair and a manifold.
    pub points: ContactPoints,
}

impl Default for ContactManifoldData {
    fn default() -> Self {
        Self {
            rigid_body1: None,
            rigid_body2: None,
            solver_flags: SolverFlags::default(),
            normal: Vector::ZERO,
            anchor_normal: Vector::ZERO,
            friction: 0.0,
            restitution: 0.0,
            tangent_velocity: Vector::ZERO,
            relative_dominance: 0,
            user_data: 0,
            last_friction: Vector::ZERO,
            warmstart_friction: Vector::ZERO,
            warmstart_torsion: 0.0,
            points: ContactPoints::new(),
        }
    }
}

impl ContactManifoldData {
    /// Number of points that the solver handles.
    pub fn num_active_contacts(&self) -> usize {
        self.points.len()
    }

    /// The points.
    pub fn contacts(&self) -> &[Contact] {
        &self.points
    }

    /// The points that the solver handles: all of them.
    pub fn solver_contacts(&self) -> &[Contact] {
        &self.points
    }

    /// Friction impulse at a contact point during the last substep, on the second body, in world space
    /// (mass·velocity). Zero for a point that does not exist.
    ///
    /// The default model ([`FrictionModel::Standard`](crate::model::params::FrictionModel)) has one friction
    /// impulse per manifold. Friction is distributed in proportion to the normal impulses: the largest
    /// friction of a point is proportional to its normal impulse. The sum over the points is exact. The
    /// torsional friction of a manifold is not included.
    ///
    /// Points of multibody links have friction of their own. In 3D,
    /// [`FrictionModel::Coulomb`](crate::model::params::FrictionModel) gives every point its own friction.
    /// The impulse is then the stored one of the point, with which the next step starts.
    pub fn friction_impulse(&self, point: usize) -> Vector {
        let Some(contact) = self.points.get(point) else { return Vector::ZERO };
        // A manifold with a friction impulse may still store old impulses of points. They are from steps
        // before a change of the model or the removal of a multibody joint, and no longer act.
        if self.last_friction == Vector::ZERO {
            let own = tangents(self.normal).into_iter().zip(contact.warmstart_tangent_impulse);
            return own.map(|(tangent, impulse)| tangent * impulse).sum();
        }
        let sum: Real = self.points.iter().map(|contact| contact.warmstart_impulse).sum();
        let fraction = if sum > 0.0 { contact.warmstart_impulse / sum } else { 0.0 };
        self.last_friction * fraction
    }

    /// Clears the impulses, as for a new contact.
    pub(crate) fn clear_impulses(&mut self) {
        self.clear_friction();
        for point in &mut self.points {
            point.impulse = 0.0;
            point.warmstart_impulse = 0.0;
            point.warmstart_tangent_impulse = [0.0; DIM - 1];
        }
    }

    /// Removes the friction impulses of the manifold as a whole.
    pub(crate) fn clear_friction(&mut self) {
        (self.last_friction, self.warmstart_friction) = (Vector::ZERO, Vector::ZERO);
        self.warmstart_torsion = 0.0;
    }
}

impl<'a> IntoIterator for &'a ContactManifoldData {
    type Item = &'a Contact;
    type IntoIter = core::slice::Iter<'a, Contact>;

    fn into_iter(self) -> Self::IntoIter {
        self.points.iter()
    }
}

/// Contact points between two convex parts of two colliders, with one normal.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactManifold {
    /// The normal in the frame of the first collider, pointing away from it.
    pub local_n1: Vector,
    /// The normal in the frame of the second collider, pointing away from it.
    pub local_n2: Vector,
    /// Part of the first collider's shape (a triangle of a mesh, a child of a compound).
    pub subshape1: u32,
    /// Part of the second collider's shape.
    pub subshape2: u32,
    /// The points, materials and impulses.
    pub data: ContactManifoldData,
    /// Position in the constraint graph; `None` for a manifold that the solver does not handle.
    pub(crate) slot: Option<ColorSlot>,
}

/// A manifold dereferences to its data: `manifold.points` are its points, `manifold.normal` is its normal.
impl core::ops::Deref for ContactManifold {
    type Target = ContactManifoldData;

    fn deref(&self) -> &ContactManifoldData {
        &self.data
    }
}

impl ContactManifold {
    /// The contact points.
    pub fn contacts(&self) -> &[Contact] {
        &self.data.points
    }

    /// The solver's colour, from 0 to 64. Constraints with a common dynamic body have different colours. The
    /// exception is colour 64, whose constraints the solver processes one by one. `None` without a
    /// constraint, as between sleeping bodies.
    pub fn solver_color(&self) -> Option<u32> {
        self.slot.map(|slot| slot.color)
    }

    /// Returns whether the solver keeps the two colliders apart here.
    pub(crate) fn is_solved(&self) -> bool {
        !self.data.points.is_empty()
            && self.data.solver_flags.contains(SolverFlags::COMPUTE_RIGID_IMPULSES)
    }

    /// Returns whether the manifold is usable for the solver, or unread.
    pub(crate) fn is_solvable(&self) -> bool {
        let are_finite = self.data.points.iter().all(|point| point.dist.is_finite());
        !self.is_solved() || is_point(self.data.normal) && are_finite
    }

    /// Returns whether all numbers are usable, and all normals are unit vectors. (The step computes the
    /// current normal from the anchors' normal.) A manifold that never had a point has no normals yet.
    pub(crate) fn is_sound(&self) -> bool {
        let data = &self.data;
        let directions = [self.local_n1, self.local_n2, data.normal, data.anchor_normal];
        let vectors = [data.tangent_velocity, data.last_friction, data.warmstart_friction];
        let numbers = [data.friction, data.restitution, data.warmstart_torsion];
        let is_empty = data.points.is_empty();
        let is_direction = |direction: &Vector| {
            is_saved_unit(direction.length_squared()) || is_empty && *direction == Vector::ZERO
        };
        directions.iter().all(is_direction)
            && vectors.iter().all(|vector| vector.is_finite())
            && numbers.iter().all(|number| number.is_finite())
            && data.points.iter().all(Contact::is_sound)
    }

    /// Sum of the normal impulses of the last step.
    pub(crate) fn impulse(&self) -> Real {
        self.data.points.iter().map(|contact| contact.impulse).sum()
    }

    /// Distance at the deepest point; infinite if there is none.
    pub(crate) fn deepest_dist(&self) -> Real {
        self.data.points.iter().map(|contact| contact.dist).fold(Real::INFINITY, Real::min)
    }

    /// The point with the largest overlap, or with the smallest distance if none overlaps.
    pub fn find_deepest_contact(&self) -> Option<&Contact> {
        self.data.points.iter().min_by(|a, b| a.dist.total_cmp(&b.dist))
    }
}
