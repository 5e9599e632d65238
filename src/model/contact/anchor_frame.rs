//! Where contact points were put into the world, and where they are now: for one pair, and for lanes of pairs.

use crate::base::wide::{Lane, Wide};
use crate::dim::math::{Real, Rotation, Vector};
use crate::dim::state::WidePose;
use crate::dim::wide::{WideRotation, WideVector};
use crate::model::check::is_saved_unit;

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
/// slowly than [`Self::ANGULAR_SPEED_NEAR_REST_MAX`] are held, by no more than [`Self::FROZEN_ANGLE_MAX`], and not where the normal would lag by
/// more than friction hides ([`Self::HELD_BY_FRICTION`]). What is wrong in the end is the load's lever, by a few
/// hundredths of the body's size, on bodies that turn by less than 3 degrees a second.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct AnchorFrame {
    pub rotations: [Rotation; 2],
    /// From the first centre of mass to the second (length units).
    pub centers: Vector,
    /// Did both bodies creep then, and whenever somebody looked since?
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

    /// Dynamic bodies that turn faster than this (rad/s) do not creep. The layers of a pyramid of a hundred rows
    /// that settles stay below it; at 0.02 they did not, and it was seen to lean.
    const ANGULAR_SPEED_NEAR_REST_MAX: Real = 0.05;

    /// The farthest (rad) that contacts are held behind a body that turns: three degrees.
    const FROZEN_ANGLE_MAX: Real = 0.05;

    /// The same, in units of the friction coefficient: the slope that friction can hold is right to a tenth.
    const HELD_BY_FRICTION: Real = 0.1;

    /// Returns whether a body is near rest. One that the user moves, or that cannot move, does only if it
    /// does not turn at all: nothing bends it, so there is nothing to hold straight. What stands on a
    /// platform that tilts is to feel it.
    pub fn near_rest(angular_speed_squared: Real, is_dynamic: bool) -> bool {
        if is_dynamic {
            angular_speed_squared
                < Self::ANGULAR_SPEED_NEAR_REST_MAX * Self::ANGULAR_SPEED_NEAR_REST_MAX
        } else {
            angular_speed_squared == 0.0
        }
    }

    /// How far (rad) contacts are held behind bodies that creep.
    pub fn frozen_angle(friction: Real) -> Real {
        (Self::HELD_BY_FRICTION * friction).clamp(0.0, Self::FROZEN_ANGLE_MAX)
    }
}

/// The placement of a manifold per lane.
#[derive(Clone, Debug)]
pub(crate) struct WideAnchorFrame {
    rotations: [WideRotation<Lane>; 2],
    centers: WideVector<Lane>,
    normal: WideVector<Lane>,
    /// Square of how far (rad) bodies that creep may have turned since, and the contacts are still held. Zero: they follow.
    frozen_angle_squared: Lane,
    /// One where both bodies creep, else zero.
    near_rest: Lane,
}

impl WideAnchorFrame {
    /// Nothing that has a place in any lane.
    pub const NOWHERE: Self = Self {
        rotations: [WideRotation::IDENTITY; 2],
        centers: WideVector::ZERO,
        normal: WideVector::Y,
        frozen_angle_squared: Lane::ZERO,
        near_rest: Lane::ZERO,
    };

    /// Sets one lane: the placement of a pair, a manifold's normal then, and for what turn (rad) it is held while its bodies creep.
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

    /// Nothing that has a place in one lane.
    pub fn clear(&mut self, lane: usize) {
        self.set_lane(lane, &AnchorFrame::NOWHERE, Vector::Y, 0.0);
        self.set_near_rest(lane, false);
    }

    /// Sets whether both bodies of a lane are near rest.
    pub fn set_near_rest(&mut self, lane: usize, near_rest: bool) {
        self.near_rest.0[lane] = if near_rest { 1.0 } else { 0.0 };
    }
}

/// What two bodies moved since their contacts were placed.
pub(crate) struct MotionSince<W: Wide> {
    turns: [WideRotation<W>; 2],
    /// Of the second centre of mass against the first.
    shift: WideVector<W>,
    /// `c = x1 - x2`, which turns levers of the first body into those of the second: as placed, and now.
    ///
    /// The world has no centre of mass. Levers are measured from the other body's then, as short as they
    /// can be, and `c` is zero.
    offsets: [WideVector<W>; 2],
    /// The normal: on the first body, or held.
    pub normal: WideVector<W>,
    /// From where the levers of the first body are measured.
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
        let turn = |side: usize| {
            poses[side].rotation.since(WideRotation::load(&anchor_frame.rotations[side]))
        };
        let turns = [turn(0), turn(1)];
        let limit = W::load(&anchor_frame.frozen_angle_squared) * W::load(&anchor_frame.near_rest);
        let is_frozen = turns[0].chord_squared().lt(limit) & turns[1].chord_squared().lt(limit);
        let (normal, zero) = (WideVector::load(&anchor_frame.normal), WideVector::zero());
        Self {
            shift: (x2 - x1) - centers,
            offsets: [
                WideVector::select(has_world, zero, -centers),
                WideVector::select(has_world, zero, x1 - x2),
            ],
            normal: WideVector::select(is_frozen, normal, turns[0].rotate(normal)),
            origin: WideVector::select(is_world[0], x2, x1),
            turns,
            is_frozen,
            is_second_world: is_world[1],
        }
    }

    /// `c`, or what is held of it.
    #[inline(always)]
    pub fn offset(&self) -> WideVector<W> {
        WideVector::select(self.is_frozen, self.offsets[0], self.offsets[1])
    }

    /// The lever, now, to midway between what was at a lever of the first body then; and how far the second
    /// surface moved against the first there.
    #[inline(always)]
    pub fn at(&self, world_anchors: WideVector<W>) -> (WideVector<W>, WideVector<W>) {
        let placed2 = world_anchors + self.offsets[0];
        let turned1 = self.turns[0].displacement(world_anchors);
        let turned2 = self.turns[1].displacement(placed2);
        let moved = self.shift + turned2 - turned1;
        let half = moved * W::splat(0.5);
        // The surface of the world has not moved; from the other one it is half of the way.
        let from_first = world_anchors + turned1 + half;
        let from_second = placed2 + turned2 - half - self.offsets[1];
        (WideVector::select(self.is_second_world, from_first, from_second), moved)
    }
}
