//! The settings of a character in lengths and cosines, for one shape at one place.

use super::length::CharacterLength;
use super::settings::{CharacterSlopeSpeed, KinematicCharacterController};
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::shape::Shape;

/// Slopes whose cosine differs by less than this are equally steep: a slope of exactly the largest angle can
/// be climbed.
const COS_TOLERANCE: Real = 1.0e-4;
/// Rounding error of a gap, as a fraction of the shape's coordinates.
const ROUNDING: Real = 32.0 * Real::EPSILON;

/// Stepping up, in lengths.
#[derive(Copy, Clone, Debug)]
pub(super) struct StepUp {
    pub max_height: Real,
    pub min_width: Real,
    pub include_dynamic_bodies: bool,
}

/// The settings of a character in lengths and cosines.
#[derive(Copy, Clone, Debug)]
pub(super) struct ResolvedSettings {
    /// Unit length.
    pub up: Vector,
    pub offset: Real,
    /// Gaps that differ by less than this from the offset are right.
    pub tolerance: Real,
    pub slide: bool,
    /// Cosine of the steepest slope that can be climbed.
    pub climb_cos: Real,
    /// Cosine of the least steep slope that does not hold.
    pub slide_cos: Real,
    /// Zero if the character does not snap to the ground.
    pub snap: Real,
    pub step_up: Option<StepUp>,
    pub slope_speed: CharacterSlopeSpeed,
    /// Half of the shape's largest extent across the up direction.
    pub half_width: Real,
    /// Half of the shape's smallest extent.
    pub half_thickness: Real,
    /// From the shape's origin to its lowest point, along the up direction.
    pub foot: Real,
}

impl ResolvedSettings {
    /// `None` if a number is invalid.
    pub fn of(
        settings: &KinematicCharacterController,
        shape: &dyn Shape,
        pose: &Pose,
    ) -> Option<Self> {
        let up = direction(settings.up)?;
        let size = Size::of(shape, pose, up)?;
        let length = |length: CharacterLength, size| {
            let length = length.of(size);
            (length.is_finite() && length >= 0.0).then_some(length)
        };
        let offset = length(settings.offset, size.height)?;
        let rounding = ROUNDING * size.farthest;
        let tolerance = length(CharacterLength::Absolute(settings.normal_nudge_factor), 0.0)?;
        let offset = offset.max(4.0 * rounding);
        let step_up = match settings.autostep {
            None => None,
            Some(autostep) => Some(StepUp {
                max_height: length(autostep.max_height, size.height)?,
                min_width: length(autostep.min_width, size.width)?,
                include_dynamic_bodies: autostep.include_dynamic_bodies,
            }),
        };
        let snap = settings.snap_to_ground.map_or(Some(0.0), |snap| length(snap, size.height))?;
        Some(Self {
            up,
            offset,
            tolerance: tolerance.min(0.25 * offset).max(rounding),
            slide: settings.slide,
            climb_cos: cosine(settings.max_slope_climb_angle)?,
            slide_cos: cosine(settings.min_slope_slide_angle)?,
            snap,
            step_up,
            slope_speed: settings.slope_speed,
            half_width: 0.5 * size.width,
            half_thickness: size.half_thickness,
            foot: size.foot,
        })
    }

    /// The part of a vector along the up direction, and the rest.
    pub fn split(&self, vector: Vector) -> (Real, Vector) {
        let rise = vector.dot(self.up);
        (rise, vector - self.up * rise)
    }

    /// Gaps up to this length count as touching.
    pub fn reach(&self) -> Real {
        1.1 * self.offset
    }

    /// Translations shorter than this are rounding errors.
    pub fn nothing(&self) -> Real {
        1.0e-3 * self.tolerance
    }
}

/// The vector with unit length.
fn direction(vector: Vector) -> Option<Vector> {
    // In two steps, so that no square leaves the range of numbers.
    let size = vector.abs().max_element();
    (size.is_finite() && size > 0.0).then(|| (vector / size).normalize())
}

/// The cosine of an angle between level and upright, a little smaller.
fn cosine(angle: Real) -> Option<Real> {
    let quarter_turn = core::f64::consts::FRAC_PI_2 as Real;
    (!angle.is_nan()).then(|| angle.clamp(0.0, quarter_turn).cos() - COS_TOLERANCE)
}

struct Size {
    height: Real,
    width: Real,
    half_thickness: Real,
    foot: Real,
    farthest: Real,
}

impl Size {
    fn of(shape: &dyn Shape, pose: &Pose, up: Vector) -> Option<Self> {
        let aabb = shape.compute_aabb(pose);
        let (half, center) = (aabb.half_extents(), aabb.center());
        if !(half.is_finite() && center.is_finite() && half.max_element() > 0.0) {
            return None;
        }
        // Along a tilted up direction, boxes are higher than their contents.
        let foot = |down: Vector| match shape.as_support_map() {
            Some(map) => (map.support_point(pose, down) - pose.translation).dot(down),
            None => (center - pose.translation).dot(down) + half.dot(down.abs()),
        };
        let (foot, head) = (foot(-up), foot(up));
        if !(foot + head).is_finite() {
            return None;
        }
        let mut width: Real = 0.0;
        for axis in 0..DIM {
            // An axis across the up direction counts in full, the one along it not at all.
            width = width.max(half[axis] * (1.0 - up[axis] * up[axis]).max(0.0).sqrt());
        }
        Some(Self {
            height: foot + head,
            width: 2.0 * width,
            half_thickness: half.min_element(),
            foot,
            farthest: aabb.mins.abs().max(aabb.maxs.abs()).max_element(),
        })
    }
}
