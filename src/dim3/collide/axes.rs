//! The axis that separates a box and a triangle best.
//!
//! They are apart exactly if they are along one of 13 axes: the three of the box, the normal of the
//! triangle, and nine products of edges (Akenine-Möller 2001, "Fast 3D triangle-box overlap testing").
//! If they are not, the axis of least overlap is the contact normal. Meshes are made of nothing but
//! triangles, and most of those near a body are in its way for the first time: a search that starts
//! from nothing would take ten times as long.

use super::polytope::Polytope;
use crate::base::axis::{BestAxis, Side};
use crate::dim::math::{Pose, Real, Vector};
use parry::shape::{Cuboid, Triangle};

/// How much more overlap a face may have than another axis and still be preferred, as a share of the
/// smallest half extent.
const TOLERANCE: Real = 0.01;
/// Of equal faces the triangle's is taken: the share of the tolerance that decides.
const FIRST_FACE: Real = 0.1;
/// An axis with at least this cosine to the normal of last time is the same axis.
const SAME_AXIS: Real = 0.98;
/// Edges whose directions have a smaller sine (squared) than this are parallel: their product says
/// nothing that the face normals do not.
const PARALLEL: Real = 1.0e-4;

/// The best axis, or any along which the two are farther apart than `reach`; `None` if this is not
/// known of such polytopes without a search. `hint` is the normal of last time, or zero.
pub fn best_axis(
    pos12: &Pose,
    polytope1: &Polytope<'_>,
    polytope2: &Polytope<'_>,
    reach: Real,
    hint: Vector,
) -> Option<BestAxis> {
    match (polytope1, polytope2) {
        (Polytope::Cuboid(cuboid), Polytope::Triangle(triangle, normal)) => {
            Some(box_triangle(pos12, cuboid, (triangle, *normal), reach, hint))
        }
        (Polytope::Triangle(triangle, normal), Polytope::Cuboid(cuboid)) => {
            let pos21 = pos12.inverse();
            let hint = pos21.rotation * -hint;
            let best = box_triangle(&pos21, cuboid, (triangle, *normal), reach, hint);
            Some(best.exchanged(pos12))
        }
        _ => None,
    }
}

/// The best axis of a box and a triangle, in the frame of the box.
fn box_triangle(
    pos12: &Pose,
    cuboid: &Cuboid,
    (triangle, normal): (&Triangle, Vector),
    reach: Real,
    hint: Vector,
) -> BestAxis {
    let half = cuboid.half_extents;
    let corners = [triangle.a, triangle.b, triangle.c].map(|corner| *pos12 * corner);
    let of_box = axis_of_box(half, corners);
    if of_box.gap > reach {
        return of_box;
    }
    let of_triangle = axis_of_triangle(half, corners[0], pos12.rotation * normal);
    if of_triangle.gap > reach {
        return of_triangle;
    }
    let of_edges = axis_of_edges(half, corners);
    if of_edges.gap > reach {
        return of_edges;
    }
    let tolerance = TOLERANCE * half.min_element();
    let penalties = [0.0, FIRST_FACE * tolerance, tolerance];
    let mut best = (of_triangle, Real::NEG_INFINITY);
    for (axis, penalty) in [of_triangle, of_box, of_edges].into_iter().zip(penalties) {
        let bonus = if axis.normal.dot(hint) > SAME_AXIS { tolerance } else { 0.0 };
        let score = axis.gap - penalty + bonus;
        if score > best.1 {
            best = (axis, score);
        }
    }
    best.0
}

/// The best of the box's own axes.
fn axis_of_box(half: Vector, [a, b, c]: [Vector; 3]) -> BestAxis {
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    // How far the triangle is beyond each face.
    let (above, below) = (low - half, -half - high);
    let gaps = above.max(below);
    let axis = gaps.max_position();
    let unit = Vector::AXES[axis];
    let normal = if above[axis] >= below[axis] { unit } else { -unit };
    BestAxis { gap: gaps[axis], normal, face: Some(Side::First) }
}

/// The triangle's normal; the box is on the side on which its centre is.
fn axis_of_triangle(half: Vector, corner: Vector, normal: Vector) -> BestAxis {
    let height = normal.dot(corner);
    let normal = if height < 0.0 { -normal } else { normal };
    BestAxis { gap: height.abs() - half.dot(normal.abs()), normal, face: Some(Side::Second) }
}

/// The best product of an edge of the box and one of the triangle.
fn axis_of_edges(half: Vector, corners: [Vector; 3]) -> BestAxis {
    let mut best = BestAxis { gap: Real::NEG_INFINITY, normal: Vector::Y, face: None };
    for index in 0..3 {
        let (start, opposite) = (corners[index], corners[(index + 2) % 3]);
        let along = corners[(index + 1) % 3] - start;
        let least = PARALLEL * along.length_squared();
        for axis in Vector::AXES {
            let product = axis.cross(along);
            let length_squared = product.length_squared();
            if length_squared <= least {
                continue;
            }
            let (height1, height2) = (product.dot(start), product.dot(opposite));
            let radius = half.dot(product.abs());
            let (above, below) = (height1.min(height2) - radius, -radius - height1.max(height2));
            let scale = 1.0 / length_squared.sqrt();
            let gap = above.max(below) * scale;
            if gap > best.gap {
                let normal = product * if above >= below { scale } else { -scale };
                best = BestAxis { gap, normal, face: None };
            }
        }
    }
    best
}
