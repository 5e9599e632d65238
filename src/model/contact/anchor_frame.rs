//! Transformation of contact points into the world, and their current position: for one pair, and for lanes
//! of pairs.

use crate::base::wide::{Lane, Wide};
use crate::dim::math::{Real, Rotation, Vector};
use crate::dim::state::WidePose;
use crate::dim::wide::{WideRotation, WideVector};
use crate::model::check::is_saved_unit;

/// World orientation of two bodies when their contact points were transformed. Later positions follow from
/// the motion of the bodies since.
///
/// For a fixed body or the world, the position is the origin and the rotation is the identity.
///
/// # Frozen anchors
///
/// While both bodies are *near rest*, normal and moment arms stay constant, and only the separations are
/// updated. Otherwise stable piles would buckle. The faces of two rigid boxes on each other are rigid. The
/// soft contacts of the solver are compliant: under a moment they rotate like a hinge with a spring. A
/// tower of `n` unit cubes of mass `m` is then an elastic column. It buckles under its own weight (Greenhill
/// 1881) when the stiffness `k` of its hinges is less than
///
/// ```text
/// k  <  n³ m g / 7.84        k = β m / (8 σ h²)        (β, σ, h: see `model/params/softness`)
/// ```
///
/// which for the default contacts are towers of some twenty cubes. A column tips by the moment of its load
/// about the leaning part below: the load times the rotation of the moment arms. With frozen moment arms that
/// moment is zero, as between rigid faces. The column is then a beam without axial load, which is stable at
/// any height. Stiffer contacts are the alternative. A pile of a hundred layers needs a hundred times the
/// stiffness, for which one iteration per substep does not converge. Box3D keeps its anchors for the same
/// reason, for up to seven degrees and at any speed.
///
/// The price: that moment is real. Without it, action and reaction of a contact are not collinear, and the
/// angular momentum of a compressed pair is not conserved. The rule therefore applies only to bodies under
/// gravity that rotate more slowly than [`Self::ANGULAR_SPEED_NEAR_REST_MAX`]. It ends at an angle of
/// [`Self::FROZEN_ANGLE_MAX`], or where the error of the normal exceeds the friction
/// ([`Self::FROZEN_FRICTION_FRACTION_MAX`]). The remaining error is in the load's moment arm. It is a few
/// hundredths of the body's size, on bodies that rotate by less than 3 degrees a second.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct AnchorFrame {
    pub rotations: [Rotation; 2],
    /// From the first centre of mass to the second (length units).
    pub centers: Vector,
    /// Whether both bodies were near rest then, and at each check since.
    pub may_freeze: bool,
}

impl AnchorFrame {
    /// Both bodies at the origin.
    pub const NOWHERE: Self =
        Self { rotations: [Rotation::IDENTITY; 2], centers: Vector::ZERO, may_freeze: false };

    /// Returns whether all numbers can be computed with.
    pub fn is_sound(&self) -> bool {
        let are_units =
            self.rotations.iter().all(|rotation| is_saved_unit(rotation.length_squared()));
        are_units && self.centers.is_finite()
    }

    /// Dynamic bodies that rotate faster than this (rad/s) are not near rest. The layers of a pyramid of a
    /// hundred rows that settles stay below it; at 0.02 they did not, and it was seen to lean.
    const ANGULAR_SPEED_NEAR_REST_MAX: Real = 0.05;

    /// The largest angle (rad) of a body relative to its frozen anchors: three degrees.
    const FROZEN_ANGLE_MAX: Real = 0.05;

    /// The same, in units of the friction coefficient: the slope that friction can hold is right to a tenth.
    const FROZEN_FRICTION_FRACTION_MAX: Real = 0.1;

    /// Returns whether a body is near rest. A body that is not dynamic is near rest only if it does not
    /// rotate at all: it does not buckle. Bodies on a tilting platform must follow it.
    pub fn near_rest(angular_speed_squared: Real, is_dynamic: bool) -> bool {
        if is_dynamic {
            angular_speed_squared
                < Self::ANGULAR_SPEED_NEAR_REST_MAX * Self::ANGULAR_SPEED_NEAR_REST_MAX
        } else {
            angular_speed_squared == 0.0
        }
    }

    /// Largest angle (rad) of frozen anchors relative to bodies near rest.
    pub fn frozen_angle(friction: Real) -> Real {
        (Self::FROZEN_FRICTION_FRACTION_MAX * friction).clamp(0.0, Self::FROZEN_ANGLE_MAX)
    }
}

/// The anchor frame of a manifold per lane.
#[derive(Clone, Debug)]
pub(crate) struct WideAnchorFrame {
    rotations: [WideRotation<Lane>; 2],
    centers: WideVector<Lane>,
    normal: WideVector<Lane>,
    /// Square of the largest angle (rad) up to which anchors stay frozen. Zero: they follow.
    frozen_angle_squared: Lane,
    /// One where both bodies are near rest, else zero.
    near_rest: Lane,
}

impl WideAnchorFrame {
    /// The value of empty lanes.
    pub const NOWHERE: Self = Self {
        rotations: [WideRotation::IDENTITY; 2],
        centers: WideVector::ZERO,
        normal: WideVector::Y,
        frozen_angle_squared: Lane::ZERO,
        near_rest: Lane::ZERO,
    };

    /// Sets one lane: the anchor frame of a pair, and a manifold's normal at that time. Up to `frozen_angle`
    /// (rad), it is frozen near rest.
    pub fn set_lane(
        &mut self,
        lane: usize,
        anchor_frame: &AnchorFrame,
        normal: Vector,
        frozen_angle: Real,
    ) {
        for (lanes, rotation) in self.rotations.iter_mut().zip(&anchor_frame.rotations) {
            lanes.set_lane(lane, rotation);
        }
        self.centers.set_lane(lane, anchor_frame.centers);
        self.normal.set_lane(lane, normal);
        self.frozen_angle_squared.0[lane] = frozen_angle * frozen_angle;
    }

    /// Clears one lane.
    pub fn clear(&mut self, lane: usize) {
        self.set_lane(lane, &AnchorFrame::NOWHERE, Vector::Y, 0.0);
        self.set_near_rest(lane, false);
    }

    /// Sets whether both bodies of a lane are near rest.
    pub fn set_near_rest(&mut self, lane: usize, near_rest: bool) {
        self.near_rest.0[lane] = if near_rest { 1.0 } else { 0.0 };
    }
}

/// Motion of two bodies since their anchors were transformed.
pub(crate) struct MotionSince<W: Wide> {
    rotations: [WideRotation<W>; 2],
    /// The second centre of mass relative to the first.
    shift: WideVector<W>,
    /// `c = x1 - x2`, which converts moment arms of the first body into those of the second: at the
    /// transformation, and now.
    ///
    /// The world has no centre of mass. Its moment arms are measured from the centre of the other body, which
    /// makes them as short as possible, and `c` is zero.
    offsets: [WideVector<W>; 2],
    /// The normal: on the first body, or frozen.
    pub normal: WideVector<W>,
    /// Reference point of the moment arms of the first body.
    pub origin: WideVector<W>,
    pub is_frozen: W::Mask,
    is_second_world: W::Mask,
}

impl<W: Wide> MotionSince<W> {
    /// `is_world` is one for bodies that are the world.
    #[inline(always)]
    pub fn new(
        anchor_frame: &WideAnchorFrame,
        is_world: &[Lane; 2],
        poses: &[WidePose<W>; 2],
    ) -> Self {
        let half = W::splat(0.5);
        let is_world = [half.lt(W::load(&is_world[0])), half.lt(W::load(&is_world[1]))];
        let has_world = is_world[0] | is_world[1];
        let (x1, x2) = (poses[0].center_of_mass, poses[1].center_of_mass);
        let centers = WideVector::load(&anchor_frame.centers);
        let rotation = |side: usize| {
            poses[side].rotation.since(WideRotation::load(&anchor_frame.rotations[side]))
        };
        let rotations = [rotation(0), rotation(1)];
        let limit = W::load(&anchor_frame.frozen_angle_squared) * W::load(&anchor_frame.near_rest);
        let is_frozen =
            rotations[0].chord_squared().lt(limit) & rotations[1].chord_squared().lt(limit);
        let (normal, zero) = (WideVector::load(&anchor_frame.normal), WideVector::zero());
        Self {
            shift: (x2 - x1) - centers,
            offsets: [
                WideVector::select(has_world, zero, -centers),
                WideVector::select(has_world, zero, x1 - x2),
            ],
            normal: WideVector::select(is_frozen, normal, rotations[0].rotate(normal)),
            origin: WideVector::select(is_world[0], x2, x1),
            rotations,
            is_frozen,
            is_second_world: is_world[1],
        }
    }

    /// `c`, or its frozen value.
    #[inline(always)]
    pub fn offset(&self) -> WideVector<W> {
        WideVector::select(self.is_frozen, self.offsets[0], self.offsets[1])
    }

    /// The current moment arm to the middle of the contact with the original moment arm `arm`, and the
    /// relative motion of the second surface there.
    #[inline(always)]
    pub fn at(&self, arm: WideVector<W>) -> (WideVector<W>, WideVector<W>) {
        let arm2 = arm + self.offsets[0];
        let turned1 = self.rotations[0].displacement(arm);
        let turned2 = self.rotations[1].displacement(arm2);
        let moved = self.shift + turned2 - turned1;
        let half = moved * W::splat(0.5);
        // The surface of the world has not moved; from the other one it is half of the distance.
        let from_first = arm + turned1 + half;
        let from_second = arm2 + turned2 - half - self.offsets[1];
        (WideVector::select(self.is_second_world, from_first, from_second), moved)
    }
}

/// A contact point per lane, between manifold and row.
#[derive(Copy, Clone)]
pub(crate) struct WidePoint<W> {
    /// In the contact frame, from the first centre of mass.
    pub local: WideVector<W>,
    pub separation: W,
    /// One for points that exist, else zero.
    pub present: W,
    pub impulse: W,
}

impl<W: Wide> WidePoint<W> {
    /// No point in any lane.
    #[inline(always)]
    pub fn absent() -> Self {
        let zero = W::zero();
        Self { local: WideVector::zero(), separation: zero, present: zero, impulse: zero }
    }
}
