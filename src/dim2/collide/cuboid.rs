//! Two boxes: separating axes, then the overlap of the two faces that meet.
//!
//! Boxes are apart exactly if they are apart along a face normal of one of them. If they are not, the normal
//! of least overlap is the contact normal. Of nearly equal normals, the last one is preferred, so that a
//! resting box does not alternate between them.

use super::features::box_feature;
use super::{RawManifold, RawPoint};
use crate::dim::math::{Matrix, Pose, Real, Vector};

/// Tolerance on the overlap within which an axis is preferred, as a fraction of the smallest half extent.
const TOLERANCE: Real = 0.01;
/// Preference of the first box among equal faces, as a fraction of the tolerance.
const FIRST_FACE_FRACTION: Real = 0.1;
/// Least cosine of an axis and the last normal at which the axis counts as the last one.
const AXIS_COSINE_MIN: Real = 0.98;
/// Corners outside the other face by up to this fraction of the shorter face still count as inside. Boxes of
/// equal size are stacked often, and rounding must not decide what their corners are.
const RIM_FRACTION_MAX: Real = 5.0e-3;

/// Computes the contacts of two boxes into `raw`, whose `local_n1` is the normal of last time, or zero.
///
/// Returns a lower bound of the distance, 0 if there are contacts. Boxes that are apart and meet with
/// corners alone have no contacts here.
pub fn cuboid_cuboid(
    pos12: &Pose,
    half1: Vector,
    half2: Vector,
    prediction: Real,
    raw: &mut RawManifold,
) -> Real {
    let rotation = pos12.rotation.to_mat();
    let center1 = pos12.translation;
    let center2 = rotation.transpose() * center1;
    let absolute = Matrix::from_cols(rotation.x_axis.abs(), rotation.y_axis.abs());
    let gaps1 = center1.abs() - half1 - absolute * half2;
    let gaps2 = center2.abs() - half2 - absolute.transpose() * half1;
    let (face1, face2) = (gaps1.max_position(), gaps2.max_position());
    // Along several axes at once the boxes are farther apart than along one.
    let outside = |gaps: Vector| gaps.max(Vector::ZERO).length();
    let distance = outside(gaps1).max(outside(gaps2));
    if distance > prediction {
        return distance;
    }
    let tolerance = TOLERANCE * half1.min(half2).min_element();
    let oriented = |axis: Vector| if axis.dot(center1) < 0.0 { -axis } else { axis };
    let normals = [oriented(Vector::AXES[face1]), oriented(rotation.col(face2))];
    let hint = raw.local_n1;
    let bonus = normals.map(|n| if n.dot(hint) > AXIS_COSINE_MIN { tolerance } else { 0.0 });
    let is_first =
        gaps1[face1] + bonus[0] >= gaps2[face2] + bonus[1] - FIRST_FACE_FRACTION * tolerance;
    let pair = if is_first {
        let sign = if center1[face1] < 0.0 { -1.0 } else { 1.0 };
        FacePair {
            half: half1,
            axis: face1,
            sign,
            other_half: half2,
            rotation,
            center: center1,
            flipped: false,
        }
    } else {
        let (sign, rotation) =
            (if center2[face2] < 0.0 { 1.0 } else { -1.0 }, rotation.transpose());
        FacePair {
            half: half2,
            axis: face2,
            sign,
            other_half: half1,
            rotation,
            center: -center2,
            flipped: true,
        }
    };
    raw.local_n1 = normals[usize::from(!is_first)];
    pair.add_points(prediction, raw);
    if raw.points.is_empty() { distance } else { 0.0 }
}

/// A reference face, whose normal is the contact normal, and the box that it meets.
struct FacePair {
    /// Half extents of the box with the reference face.
    half: Vector,
    /// The normal's axis in its frame.
    axis: usize,
    /// The normal's direction along that axis: 1 or -1.
    sign: Real,
    /// Half extents of the other box.
    other_half: Vector,
    /// Rotation from the other box's frame to this one.
    rotation: Matrix,
    /// The other box's centre in this frame.
    center: Vector,
    /// Whether the reference face is on the second box.
    flipped: bool,
}

impl FacePair {
    /// A vector seen along the normal: the component in the face, and the height above it.
    fn seen(&self, vector: Vector) -> Vector {
        Vector::new(vector[1 - self.axis], self.sign * vector[self.axis])
    }

    /// Adds the ends of the overlap that are within `prediction` above the reference face.
    fn add_points(&self, prediction: Real, raw: &mut RawManifold) {
        let normal = self.rotation.transpose() * (Vector::AXES[self.axis] * self.sign);
        let axis = normal.abs().max_position();
        let face = Vector::AXES[axis] * if normal[axis] < 0.0 { 1.0 } else { -1.0 };
        let mut middle = self.seen(self.center + self.rotation * (face * self.other_half));
        middle.y -= self.half[self.axis];
        let edge = self.seen(self.rotation.col(1 - axis) * self.other_half[1 - axis]);
        let size = self.half[1 - self.axis];
        let rim = (size * (1.0 + RIM_FRACTION_MAX))
            .min(size + RIM_FRACTION_MAX * self.other_half[1 - axis]);
        let ends = [middle - edge, middle + edge];
        if ends[0].x.min(ends[1].x) > size || ends[0].x.max(ends[1].x) < -size {
            return; // The projections are disjoint.
        }
        for (end, sign) in ends.into_iter().zip([-1.0, 1.0]) {
            let (point, side, end) = if end.x.abs() <= rim {
                (end, 0.0, sign) // a corner of the other box
            } else {
                // The face of the other box passes a corner of this one.
                let side = Real::signum(end.x);
                let fraction = (side * size - middle.x) / edge.x;
                (middle + edge * fraction, side, 0.0)
            };
            if point.y <= prediction {
                let other_signs = face + Vector::AXES[1 - axis] * end;
                raw.points.push(self.point(point, side, other_signs));
            }
        }
    }

    /// A point of the other box's face, given relative to the normal; `side` is its end of the reference
    /// face, or 0.
    fn point(&self, seen: Vector, side: Real, other_signs: Vector) -> RawPoint {
        let (normal, along) = (Vector::AXES[self.axis] * self.sign, Vector::AXES[1 - self.axis]);
        let on_face = along * seen.x + normal * self.half[self.axis];
        let on_other = self.rotation.transpose() * (on_face + normal * seen.y - self.center);
        let (id, other_id) = (box_feature(normal + along * side), box_feature(other_signs));
        RawPoint::flipped(on_face, on_other, id, other_id, seen.y, self.flipped)
    }
}
