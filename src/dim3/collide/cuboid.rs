//! Two boxes: separating axes, then the overlap of the two faces that meet, or the two edges.
//!
//! Boxes are apart exactly if they are separated along one of 15 axes: three face normals of each, and nine
//! products of edges. (Gottschalk, Lin, Manocha 1996, "OBBTree", section 5.) If they are not, the axis of
//! least overlap is the contact normal. Of nearly equal axes, a face is preferred to a pair of edges, and the
//! last axis to another. A resting box therefore does not alternate between them.

use super::cuboid_faces::{FacePair, face_points};
use super::features::box_feature;
use super::{RawManifold, RawPoint};
use crate::dim::math::{Matrix, Pose, Real, Vector};

/// Tolerance on the overlap within which an axis is preferred, as a fraction of the smallest half extent.
const TOLERANCE: Real = 0.01;
/// Preference of the first box among equal faces, as a fraction of the tolerance.
const FIRST_FACE_FRACTION: Real = 0.1;
/// Least cosine of an axis and the last normal at which the axis counts as the last one.
const AXIS_COSINE_MIN: Real = 0.98;
/// Edges whose directions have a smaller sine (squared) than this are parallel: their product equals a face
/// normal.
const PARALLEL_SINE_SQUARED_MAX: Real = 1.0e-4;

/// Two boxes, seen from both.
pub(super) struct Boxes {
    /// Half extents of the first.
    pub half1: Vector,
    /// Half extents of the second.
    pub half2: Vector,
    /// Rotation from the second frame to the first.
    pub rotation: Matrix,
    /// The centre of the second box in the first frame.
    pub center1: Vector,
    /// The same vector, turned into the second frame.
    pub center2: Vector,
}

/// An axis that may separate the boxes.
#[derive(Copy, Clone)]
enum Axis {
    Face1(usize),
    Face2(usize),
    Edges(usize, usize),
}

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
    let rotation = Matrix::from_quat(pos12.rotation);
    let center1 = pos12.translation;
    let center2 = rotation.transpose() * center1;
    let boxes = Boxes { half1, half2, rotation, center1, center2 };
    let [gaps1, gaps2] = boxes.face_gaps();
    let (face1, face2) = (gaps1.max_position(), gaps2.max_position());
    // Along several axes at once the boxes are farther apart than along one.
    let outside = |gaps: Vector| gaps.max(Vector::ZERO).length();
    let distance = outside(gaps1).max(outside(gaps2));
    if distance > prediction {
        return distance;
    }
    let (edge_gap, edges) = boxes.edge_gap();
    if edge_gap > prediction {
        return edge_gap;
    }
    let tolerance = TOLERANCE * half1.min(half2).min_element();
    let hint = raw.local_n1;
    let mut best = (Real::NEG_INFINITY, Axis::Face1(face1), Vector::ZERO);
    let candidates = [
        (gaps1[face1], Axis::Face1(face1)),
        (gaps2[face2] - FIRST_FACE_FRACTION * tolerance, Axis::Face2(face2)),
        (edge_gap - tolerance, Axis::Edges(edges.0, edges.1)),
    ];
    for (gap, axis) in candidates {
        if gap < best.0 - tolerance {
            continue;
        }
        let normal = boxes.normal(axis);
        let bonus = if normal.dot(hint) > AXIS_COSINE_MIN { tolerance } else { 0.0 };
        if gap + bonus > best.0 {
            best = (gap + bonus, axis, normal);
        }
    }
    raw.local_n1 = best.2;
    match best.1 {
        Axis::Face1(axis) => face_points(&FacePair::of_first(&boxes, axis), prediction, raw),
        Axis::Face2(axis) => face_points(&FacePair::of_second(&boxes, axis), prediction, raw),
        Axis::Edges(axis1, axis2) => boxes.edge_point(axis1, axis2, raw),
    }
    if raw.points.is_empty() { distance } else { 0.0 }
}

impl Boxes {
    /// Distances of the boxes along the face normals of each.
    fn face_gaps(&self) -> [Vector; 2] {
        let (columns, rows) = (abs(self.rotation), abs(self.rotation.transpose()));
        [
            self.center1.abs() - self.half1 - columns * self.half2,
            self.center2.abs() - self.half2 - rows * self.half1,
        ]
    }

    /// Distance of the boxes along the best product of two edges, and these edges.
    fn edge_gap(&self) -> (Real, (usize, usize)) {
        let rows = self.rotation.transpose();
        let rows = [rows.x_axis, rows.y_axis, rows.z_axis];
        let mut best = (Real::NEG_INFINITY, (0, 0));
        for i in 0..3 {
            // The products of this edge with the three edges of the second box, side by side.
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let distance = (rows[j] * self.center1[k] - rows[k] * self.center1[j]).abs();
            let radius1 = rows[k].abs() * self.half1[j] + rows[j].abs() * self.half1[k];
            let (row, half) = (rows[i].abs(), self.half2);
            let radius2 = Vector::new(
                half.y * row.z + half.z * row.y,
                half.z * row.x + half.x * row.z,
                half.x * row.y + half.y * row.x,
            );
            let sine_squared = Vector::ONE - row * row;
            let gaps = distance - radius1 - radius2;
            for edge2 in 0..3 {
                if sine_squared[edge2] > PARALLEL_SINE_SQUARED_MAX {
                    let gap = gaps[edge2] / sine_squared[edge2].sqrt();
                    if gap > best.0 {
                        best = (gap, (i, edge2));
                    }
                }
            }
        }
        best
    }

    /// The unit vector along an axis, in the first frame, from the first box to the second.
    fn normal(&self, axis: Axis) -> Vector {
        let direction = match axis {
            Axis::Face1(axis) => unit(axis),
            Axis::Face2(axis) => self.rotation.col(axis),
            Axis::Edges(axis1, axis2) => {
                unit(axis1).cross(self.rotation.col(axis2)).normalize_or(Vector::Y)
            }
        };
        if direction.dot(self.center1) < 0.0 { -direction } else { direction }
    }

    /// The points of two crossing edges that are nearest to each other.
    fn edge_point(&self, axis1: usize, axis2: usize, raw: &mut RawManifold) {
        let normal1 = raw.local_n1;
        let normal2 = self.rotation.transpose() * -normal1;
        let signs1 = edge_signs(normal1, axis1);
        let signs2 = edge_signs(normal2, axis2);
        let middle1 = signs1 * self.half1;
        let middle2 = self.center1 + self.rotation * (signs2 * self.half2);
        let (along1, along2) = (unit(axis1), self.rotation.col(axis2));
        // Closest points of two lines whose directions are unit vectors.
        let offset = middle2 - middle1;
        let cosine = along1.dot(along2);
        let (a, b) = (along1.dot(offset), along2.dot(offset));
        let scale = 1.0 / (1.0 - cosine * cosine);
        let (s, t) = ((a - cosine * b) * scale, (cosine * a - b) * scale);
        let s = s.clamp(-self.half1[axis1], self.half1[axis1]);
        let t = t.clamp(-self.half2[axis2], self.half2[axis2]);
        let p1 = middle1 + along1 * s;
        let p2 = middle2 + along2 * t;
        let dist = (p2 - p1).dot(normal1);
        let local_p2 = signs2 * self.half2 + unit(axis2) * t;
        let (id1, id2) = (box_feature(signs1), box_feature(signs2));
        raw.points.push(RawPoint::new(p1, local_p2, id1, id2, dist));
    }
}

/// The signs of the edge along `axis` that is farthest in direction `normal`; 0 at the axis itself.
fn edge_signs(normal: Vector, axis: usize) -> Vector {
    let mut signs = Vector::ONE.copysign(normal);
    signs[axis] = 0.0;
    signs
}

/// The unit vector of a coordinate axis.
pub(super) fn unit(axis: usize) -> Vector {
    Vector::AXES[axis]
}

fn abs(matrix: Matrix) -> Matrix {
    Matrix::from_cols(matrix.x_axis.abs(), matrix.y_axis.abs(), matrix.z_axis.abs())
}
