//! Pairs of colliders whose boxes overlap, from the first overlap to the last.

use super::manifold::ContactManifold;
use super::store::Pair;
use crate::dim::math::{Pose, Real, Rotation, Vector};
use crate::model::collider::ColliderHandle;
use smallvec::SmallVec;

/// Two colliders that are close enough to touch, and their contact manifolds.
///
/// A pair lives as long as the colliders' enlarged boxes overlap. Its manifolds persist from step to
/// step: they carry the impulses with which the next step starts.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactPair {
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    /// Where the two touch or nearly touch; one manifold for each pair of convex parts.
    pub manifolds: SmallVec<[ContactManifold; 1]>,
    /// Is any contact close enough that the solver handled it in the last step?
    pub has_any_active_contact: bool,

    /// Was the pair reported as started (and not yet as stopped)?
    pub(crate) start_event_emitted: bool,
    /// Is the pair part of the structure of the world: do its bodies share an island because of it?
    pub(crate) attached: bool,
    /// Pose of the second collider in the frame of the first when the manifolds were computed.
    pub(crate) pose12: Pose,
    /// How the bodies stood when the contact points were put into the world.
    pub(crate) placement: Placement,
}

/// How two bodies stood when their contact points were put into the world. Where the points are later follows
/// from what the bodies moved since.
///
/// A fixed body, or none, stands at the origin and is not turned.
///
/// # Contacts that are held in place
///
/// While both bodies *creep*, normal and levers are what they were then, and only the separations follow. Else piles
/// would buckle that cannot. The faces of two rigid boxes on each other do not give way, but the soft contacts of the
/// solver do: under a moment they yield like a hinge with a spring. A tower of `n` unit cubes of mass `m` is then an
/// elastic column, and under its own weight it buckles (Greenhill 1881) when the stiffness `k` of its hinges is less
/// than
///
/// ```text
/// k  <  n³ m g / 7.84        k = β m / (8 σ h²)        (β, σ, h: see `model/params/softness`)
/// ```
///
/// which for our contacts are towers of some twenty cubes. What tips a column is the moment of its load about the
/// leaning part below: the load times how far the levers have turned. With levers that are held in place that moment
/// is zero, as it is between faces that cannot give way, and the column is a beam without a load along it, which is
/// stable whatever its height. The alternative, stiffer contacts, would have to be a hundred times as stiff for a
/// pile of a hundred layers, and one visit per substep does not converge for these. Box3D keeps its anchors for the
/// same reason, for up to seven degrees and at any speed.
///
/// The price: that moment is real. Without it, action and reaction of a contact do not act along one line, and the
/// angular momentum of a pair that is pressed together is not conserved. So only bodies that have weight and turn more
/// slowly than [`Self::SLOW`] are held, by no more than [`Self::HELD_TURN_MAX`], and not where the normal would lag by
/// more than friction hides ([`Self::HELD_BY_FRICTION`]). What is wrong in the end is the load's lever, by a few
/// hundredths of the body's size, on bodies that turn by less than 3 degrees a second.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Placement {
    pub rotations: [Rotation; 2],
    /// From the first centre of mass to the second (length units).
    pub centers: Vector,
    /// Did both bodies creep then, and whenever somebody looked since?
    pub may_hold: bool,
}

impl Placement {
    /// Both bodies at the origin.
    pub const NOWHERE: Self =
        Self { rotations: [Rotation::IDENTITY; 2], centers: Vector::ZERO, may_hold: false };

    /// Dynamic bodies that turn faster than this (rad/s) do not creep. The layers of a pyramid of a hundred rows
    /// that settles stay below it; at 0.02 they did not, and it was seen to lean.
    const SLOW: Real = 0.05;

    /// The farthest (rad) that contacts are held behind a body that turns: three degrees.
    const HELD_TURN_MAX: Real = 0.05;

    /// The same, in units of the friction coefficient: the slope that friction can hold is right to a tenth.
    const HELD_BY_FRICTION: Real = 0.1;

    /// Does a body creep? One that the user moves, or that cannot move, does only if it does not turn at all: nothing
    /// bends it, so there is nothing to hold straight. What stands on a platform that tilts is to feel it.
    pub fn creeps(angular_speed_squared: Real, is_dynamic: bool) -> bool {
        if is_dynamic {
            angular_speed_squared < Self::SLOW * Self::SLOW
        } else {
            angular_speed_squared == 0.0
        }
    }

    /// How far (rad) contacts are held behind bodies that creep.
    pub fn held_turn(friction: Real) -> Real {
        (Self::HELD_BY_FRICTION * friction).clamp(0.0, Self::HELD_TURN_MAX)
    }
}

impl Default for ContactPair {
    fn default() -> Self {
        Self::new(ColliderHandle::invalid(), ColliderHandle::invalid())
    }
}

impl ContactPair {
    /// A pair of which nothing is known yet.
    pub(crate) fn new(collider1: ColliderHandle, collider2: ColliderHandle) -> Self {
        Self {
            collider1,
            collider2,
            manifolds: SmallVec::new(),
            has_any_active_contact: false,
            start_event_emitted: false,
            attached: false,
            pose12: Pose::IDENTITY,
            placement: Placement::NOWHERE,
        }
    }

    /// Do the two touch (within the prediction distance)?
    pub(crate) fn is_touching(&self) -> bool {
        !self.manifolds.is_empty()
    }

    /// Sum of the impulses of all contacts during the last step, in world space: what the first
    /// collider's body did to the second's along the normals (friction is not counted).
    pub fn total_impulse(&self) -> Vector {
        self.manifolds.iter().map(|m| m.data.normal * m.impulse()).sum()
    }

    /// Sum of the magnitudes of all normal impulses during the last step.
    pub fn total_impulse_magnitude(&self) -> Real {
        self.manifolds.iter().map(ContactManifold::impulse).sum()
    }

    /// The largest normal impulse of one contact during the last step, and its direction in world
    /// space. Zero if nothing touched.
    pub fn max_impulse(&self) -> (Real, Vector) {
        let mut result = (0.0, Vector::ZERO);
        for manifold in &self.manifolds {
            for contact in &manifold.data {
                if contact.impulse > result.0 {
                    result = (contact.impulse, manifold.data.normal);
                }
            }
        }
        result
    }

    /// The deepest contact as (normal, point, depth): the unit normal from the first collider to the
    /// second, the point midway between the two surfaces, and how far they overlap (negative: how
    /// far they are apart). All in world space as of the last step. `None` if there is no contact.
    pub fn find_deepest_contact(&self) -> Option<(Vector, Vector, Real)> {
        let manifold = self
            .manifolds
            .iter()
            .filter(|m| !m.contacts().is_empty())
            .min_by(|a, b| a.deepest_dist().total_cmp(&b.deepest_dist()))?;
        let contact = manifold.find_deepest_contact()?;
        Some((manifold.data.normal, contact.point, -contact.dist))
    }
}

/// Two colliders, at least one of them a sensor, whose boxes overlap.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct IntersectionPair {
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    /// Do the shapes intersect?
    pub intersecting: bool,
    /// Was the pair reported as started (and not yet as stopped)?
    pub(crate) start_event_emitted: bool,
}

impl IntersectionPair {
    /// A pair of which nothing is known yet.
    pub(crate) fn new(collider1: ColliderHandle, collider2: ColliderHandle) -> Self {
        Self { collider1, collider2, intersecting: false, start_event_emitted: false }
    }
}

impl Pair for ContactPair {
    fn colliders(&self) -> [ColliderHandle; 2] {
        [self.collider1, self.collider2]
    }
}

impl Pair for IntersectionPair {
    fn colliders(&self) -> [ColliderHandle; 2] {
        [self.collider1, self.collider2]
    }
}
