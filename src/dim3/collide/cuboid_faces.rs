//! The overlap of two faces of boxes. The normal of the reference face is the contact normal. The incident
//! face is the one of the other box that opposes it most.
//!
//! Seen along the normal, one is a rectangle and the other a parallelogram. Their overlap has three kinds of
//! corners: corners of the parallelogram, crossings of edges, and corners of the rectangle. All three contain
//! the features of the boxes, independent of the reference face. A contact is therefore matched in the next
//! step even if the roles have changed.

use super::cuboid::{Boxes, unit};
use super::features::box_feature;
use super::{RawManifold, RawPoint};
use crate::dim::math::{Matrix, Real, Vector};

/// Enlargement of the rectangle, as a fraction of its half edge, or of the other box's longest if that is
/// shorter. Boxes of equal size are stacked often: then all corners of the parallelogram are inside, and
/// rounding does not decide which of them are. Points outside by up to that are moved to the true rim.
const RIM_FRACTION_MAX: Real = 5.0e-3;

/// A reference face and the box that it meets.
pub(super) struct FacePair {
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
    /// The reference face is on the first box.
    pub fn of_first(boxes: &Boxes, axis: usize) -> Self {
        Self {
            half: boxes.half1,
            axis,
            sign: if boxes.center1[axis] < 0.0 { -1.0 } else { 1.0 },
            other_half: boxes.half2,
            rotation: boxes.rotation,
            center: boxes.center1,
            flipped: false,
        }
    }

    /// The reference face is on the second box.
    pub fn of_second(boxes: &Boxes, axis: usize) -> Self {
        Self {
            half: boxes.half2,
            axis,
            // Towards the first box, and so that the contact normal is the one of `Boxes::normal`.
            sign: if boxes.center2[axis] < 0.0 { 1.0 } else { -1.0 },
            other_half: boxes.half1,
            rotation: boxes.rotation.transpose(),
            center: -boxes.center2,
            flipped: true,
        }
    }

    /// A vector seen along the normal: two components in the face, and the height above it.
    fn seen(&self, vector: Vector) -> Vector {
        let (u, v) = self.axes();
        Vector::new(vector[u], vector[v], self.sign * vector[self.axis])
    }

    /// The axes that span the reference face.
    fn axes(&self) -> (usize, usize) {
        ((self.axis + 1) % 3, (self.axis + 2) % 3)
    }
}

/// The other box's face, seen along the normal of the reference face.
struct Incident {
    /// Its middle.
    middle: Vector,
    /// Half of its two edges.
    edges: [Vector; 2],
    /// Its signs in the other box's frame, 0 at the axes of the edges.
    face: Vector,
    /// The axes of the two edges.
    axes: [usize; 2],
}

impl Incident {
    fn of(pair: &FacePair) -> Self {
        let normal = pair.rotation.transpose() * (unit(pair.axis) * pair.sign);
        let axis = normal.abs().max_position();
        let face = unit(axis) * if normal[axis] < 0.0 { 1.0 } else { -1.0 };
        let axes = [(axis + 1) % 3, (axis + 2) % 3];
        let middle = pair.center + pair.rotation * (face * pair.other_half);
        let mut middle = pair.seen(middle);
        middle.z -= pair.half[pair.axis];
        let edges = axes.map(|k| pair.seen(pair.rotation.col(k) * pair.other_half[k]));
        Self { middle, edges, face, axes }
    }

    /// The signs in the other box's frame of a corner or an edge of the face.
    fn signs(&self, first: Real, second: Real) -> Vector {
        self.face + unit(self.axes[0]) * first + unit(self.axes[1]) * second
    }
}

/// The corners in order around the face, as signs of the two edges.
const CORNERS: [[Real; 2]; 4] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];

/// Adds the corners of the overlap that are within `prediction` above the reference face.
pub(super) fn face_points(pair: &FacePair, prediction: Real, raw: &mut RawManifold) {
    let incident = Incident::of(pair);
    let (u, v) = pair.axes();
    let rim_max = RIM_FRACTION_MAX * pair.other_half.max_element();
    let mut overlap = Overlap {
        pair,
        incident: &incident,
        prediction,
        size: [u, v].map(|axis| {
            let half = pair.half[axis];
            (half * (1.0 + RIM_FRACTION_MAX)).min(half + rim_max)
        }),
        raw,
    };
    let corners =
        CORNERS.map(|[a, b]| incident.middle + incident.edges[0] * a + incident.edges[1] * b);
    let inside = corners.map(|corner| overlap.contains(corner));
    for (index, [a, b]) in CORNERS.into_iter().enumerate() {
        if inside[index] {
            overlap.add(corners[index], [0.0, 0.0], incident.signs(a, b));
        }
    }
    if inside == [true; 4] {
        return; // the parallelogram lies in the rectangle: nothing crosses
    }
    for index in 0..4 {
        let next = (index + 1) % 4;
        if !(inside[index] && inside[next]) {
            overlap.add_crossings(
                index,
                [corners[index], corners[next]],
                [inside[index], inside[next]],
            );
        }
    }
    overlap.add_rectangle_corners();
}

/// The overlap as it is put together.
struct Overlap<'a> {
    pair: &'a FacePair,
    incident: &'a Incident,
    prediction: Real,
    /// Half of the rectangle's edges.
    size: [Real; 2],
    raw: &'a mut RawManifold,
}

impl Overlap<'_> {
    /// Returns whether the point lies in the rectangle.
    fn contains(&self, point: Vector) -> bool {
        point.x.abs() <= self.size[0] && point.y.abs() <= self.size[1]
    }

    /// Adds the points where an edge of the parallelogram enters and leaves the rectangle.
    ///
    /// Liang and Barsky 1984: an edge is a parameter range, which each side of the rectangle cuts.
    fn add_crossings(&mut self, index: usize, ends: [Vector; 2], inside: [bool; 2]) {
        let along = ends[1] - ends[0];
        let (mut enter, mut leave) = ((0.0, [0.0; 2]), (1.0, [0.0; 2]));
        for (axis, size) in self.size.into_iter().enumerate() {
            let (start, speed) = (ends[0][axis], along[axis]);
            for sign in [-1.0, 1.0] {
                let (ahead, speed) = (size - sign * start, sign * speed);
                let mut side = [0.0; 2];
                side[axis] = sign;
                if speed == 0.0 && ahead < 0.0 {
                    return; // parallel to the side and beyond it
                } else if speed < 0.0 && ahead / speed > enter.0 {
                    enter = (ahead / speed, side);
                } else if speed > 0.0 && ahead / speed < leave.0 {
                    leave = (ahead / speed, side);
                }
            }
        }
        if enter.0 >= leave.0 {
            return;
        }
        let [a, b] = CORNERS[index];
        let signs = if index.is_multiple_of(2) {
            self.incident.signs(0.0, b)
        } else {
            self.incident.signs(a, 0.0)
        };
        if !inside[0] && enter.0 > 0.0 {
            self.add(ends[0] + along * enter.0, enter.1, signs);
        }
        if !inside[1] && leave.0 < 1.0 {
            self.add(ends[0] + along * leave.0, leave.1, signs);
        }
    }

    /// Adds the corners of the rectangle that lie in the parallelogram.
    fn add_rectangle_corners(&mut self) {
        let (middle, [first, second]) = (self.incident.middle, self.incident.edges);
        let area = first.x * second.y - first.y * second.x;
        if area == 0.0 {
            return; // seen from the side
        }
        for [a, b] in CORNERS {
            let offset = Vector::new(a * self.size[0] - middle.x, b * self.size[1] - middle.y, 0.0);
            let along_first = (offset.x * second.y - offset.y * second.x) / area;
            let along_second = (first.x * offset.y - first.y * offset.x) / area;
            if along_first.abs() < 1.0 && along_second.abs() < 1.0 {
                let point = middle + first * along_first + second * along_second;
                self.add(point, [a, b], self.incident.signs(0.0, 0.0));
            }
        }
    }

    /// Adds a point of the incident face, given relative to the normal. `sides` are its sides of the
    /// rectangle, and `other_signs` is the feature of the other box.
    fn add(&mut self, seen: Vector, sides: [Real; 2], other_signs: Vector) {
        let dist = seen.z;
        if dist > self.prediction {
            return;
        }
        let pair = self.pair;
        let (u, v) = pair.axes();
        let (x, y) =
            (seen.x.clamp(-pair.half[u], pair.half[u]), seen.y.clamp(-pair.half[v], pair.half[v]));
        let on_face =
            unit(u) * x + unit(v) * y + unit(pair.axis) * (pair.sign * pair.half[pair.axis]);
        let on_other = on_face + unit(pair.axis) * (pair.sign * dist);
        let on_other = pair.rotation.transpose() * (on_other - pair.center);
        let signs = unit(u) * sides[0] + unit(v) * sides[1] + unit(pair.axis) * pair.sign;
        let (id, other_id) = (box_feature(signs), box_feature(other_signs));
        let point = RawPoint::flipped(on_face, on_other, id, other_id, dist, pair.flipped);
        self.raw.points.push(point);
    }
}
