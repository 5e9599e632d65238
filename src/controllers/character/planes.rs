//! A plane that the character must stay in front of, and its kind for walking.

use super::polyhedron::HalfSpace;
use super::resolved::ResolvedSettings;
use crate::base::parry_version::shape_cast_hit;
use crate::dim::math::{MAX_MANIFOLD_POINTS, Pose, Real, Vector};
use crate::model::collider::ColliderHandle;
use arrayvec::ArrayVec;
use parry::query::{ShapeCastHit, ShapeCastStatus};

/// Largest overhang of a wall (sine of the angle). A plane that overhangs more is a ceiling.
pub(super) const WALL_LEAN_MAX: Real = 0.05;

/// Kind of a plane for walking, standing and support.
#[derive(Copy, Clone, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    /// Not too steep to walk up.
    Floor,
    /// The edge or riser of a low step, up or down: it supports the character, and blocks the way up until
    /// the step is taken.
    Step,
    /// Too steep to walk up.
    Wall,
    /// Leans over.
    Ceiling,
}

/// A contact manifold between an obstacle and the character, as a plane.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    pub collider: ColliderHandle,
    pub subshapes: [u32; 2],
    pub is_dynamic: bool,
    /// Unit normal in world space, from the obstacle to the character.
    pub normal: Vector,
    /// Smallest distance of the two along the normal; negative if they overlap.
    pub gap: Real,
    /// The contact points on the obstacle, in world space. At least one.
    pub points: ArrayVec<Vector, MAX_MANIFOLD_POINTS>,
    pub kind: Kind,
    /// Normal times up direction.
    pub rise: Real,
}

impl Plane {
    /// Kind of a plane with this normal, before steps are detected.
    pub fn kind_of(rise: Real, settings: &ResolvedSettings) -> Kind {
        if rise >= settings.climb_cos {
            Kind::Floor
        } else if rise < -WALL_LEAN_MAX {
            Kind::Ceiling
        } else {
            Kind::Wall
        }
    }

    /// Returns whether it blocks horizontal motion.
    pub fn is_upright(&self) -> bool {
        matches!(self.kind, Kind::Wall | Kind::Step)
    }

    /// Returns whether it supports the character against gravity.
    pub fn holds(&self, settings: &ResolvedSettings) -> bool {
        match self.kind {
            Kind::Floor => true,
            Kind::Step => self.rise > WALL_LEAN_MAX,
            Kind::Wall => self.rise > WALL_LEAN_MAX && self.rise >= settings.slide_cos,
            Kind::Ceiling => false,
        }
    }

    /// Returns whether it is a floor that holds without sliding.
    pub fn is_firm(&self, settings: &ResolvedSettings) -> bool {
        self.kind == Kind::Floor && !self.is_slippery(settings)
    }

    /// Returns whether gravity makes the character slide on it.
    pub fn is_slippery(&self, settings: &ResolvedSettings) -> bool {
        self.kind != Kind::Step && self.rise < settings.slide_cos
    }

    /// The admissible approach, as a translation along the normal: 0, or less. Gaps about as wide as the
    /// offset leave exactly nothing.
    pub fn approach_limit(&self, settings: &ResolvedSettings) -> Real {
        let approach_limit = settings.offset - self.gap;
        if approach_limit > -settings.tolerance { 0.0 } else { approach_limit }
    }

    /// Missing distance; 0 if the character is far enough.
    pub fn excess(&self, settings: &ResolvedSettings) -> Real {
        let excess = settings.offset - self.gap;
        if excess > settings.tolerance { excess } else { 0.0 }
    }

    /// The half space of admissible translations.
    pub fn half_space(&self, settings: &ResolvedSettings) -> HalfSpace {
        HalfSpace { normal: self.normal, at_least: self.approach_limit(settings) }
    }

    /// The half space of admissible translations for an upright plane; `None` for a level one.
    pub fn upright_half_space(&self, settings: &ResolvedSettings) -> Option<HalfSpace> {
        let (_, across) = settings.split(self.normal);
        let length = across.length();
        (length > WALL_LEAN_MAX).then(|| HalfSpace {
            normal: across / length,
            at_least: self.approach_limit(settings) / length,
        })
    }

    /// The height of its lowest contact point, as a coordinate along the up direction.
    pub fn lowest(&self, settings: &ResolvedSettings) -> Real {
        self.points.iter().map(|point| point.dot(settings.up)).fold(Real::INFINITY, Real::min)
    }

    /// Returns whether all of its contact points lie behind another plane.
    ///
    /// In this case the character, which stays in front of that plane, cannot come closer to this obstacle
    /// than to that one.
    pub fn is_behind(&self, other: &Self, tolerance: Real) -> bool {
        self.points.iter().all(|point| (*point - other.points[0]).dot(other.normal) <= tolerance)
    }

    /// The plane as the hit of a shape at `pose`: side 1 is the collider, in world space.
    pub fn hit(&self, pose: &Pose) -> ShapeCastHit {
        // Between two faces, a push in their middle causes no rotation.
        let middle = self.points.iter().sum::<Vector>() / self.points.len() as Real;
        let witnesses = [middle, pose.inverse() * (middle + self.normal * self.gap)];
        let normals = [self.normal, pose.rotation.inverse() * -self.normal];
        shape_cast_hit(0.0, witnesses, normals, ShapeCastStatus::Converged, self.subshapes)
    }
}
