//! The axis that separates a box and a segment best.
//!
//! They are apart exactly if they are along one of three axes: the two of the box and the normal of the
//! segment. If they are not, the axis of least overlap is the contact normal. Chains and height fields
//! are made of nothing but segments, and most of those near a body are in its way for the first time: a
//! search that starts from nothing would take several times as long.

use super::polytope::Polytope;
use crate::base::axis::{BestAxis, Side};
use crate::dim::math::{Pose, Real, Vector};
use parry::shape::{Cuboid, Segment};

/// How much more overlap the segment's axis may have and still be preferred, as a share of the smallest
/// half extent.
const TOLERANCE: Real = 0.001;
/// How much the axis of last time is preferred, in the same measure.
const SAME_AXIS_BONUS: Real = 0.01;
/// An axis with at least this cosine to the normal of last time is the same axis.
const SAME_AXIS: Real = 0.98;

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
        (Polytope::Cuboid(cuboid), Polytope::Segment(segment)) => {
            box_segment(pos12, cuboid, segment, reach, hint)
        }
        (Polytope::Segment(segment), Polytope::Cuboid(cuboid)) => {
            let pos21 = pos12.inverse();
            let best = box_segment(&pos21, cuboid, segment, reach, pos21.rotation * -hint)?;
            Some(best.exchanged(pos12))
        }
        _ => None,
    }
}

/// The best axis of a box and a segment, in the frame of the box; `None` if the segment has no length.
fn box_segment(
    pos12: &Pose,
    cuboid: &Cuboid,
    segment: &Segment,
    reach: Real,
    hint: Vector,
) -> Option<BestAxis> {
    let half = cuboid.half_extents;
    let [a, b] = [segment.a, segment.b].map(|end| *pos12 * end);
    // How far the segment is beyond each face of the box.
    let (above, below) = (a.min(b) - half, -half - a.max(b));
    let gaps = above.max(below);
    let axis = gaps.max_position();
    let unit = Vector::AXES[axis];
    let normal = if above[axis] >= below[axis] { unit } else { -unit };
    let of_box = BestAxis { gap: gaps[axis], normal, face: Some(Side::First) };
    if of_box.gap > reach {
        return Some(of_box);
    }
    // The box is on the side of the segment on which its centre is.
    let normal = (b - a).perp().try_normalize()?;
    let height = normal.dot(a);
    let normal = if height < 0.0 { -normal } else { normal };
    let gap = height.abs() - half.dot(normal.abs());
    let of_segment = BestAxis { gap, normal, face: Some(Side::Second) };
    let score = |axis: &BestAxis, bonus: Real| {
        let is_same = axis.normal.dot(hint) > SAME_AXIS;
        let bonus = bonus + if is_same { SAME_AXIS_BONUS } else { 0.0 };
        axis.gap + bonus * half.min_element()
    };
    let prefers_segment = score(&of_segment, TOLERANCE) >= score(&of_box, 0.0);
    Some(if gap > reach || prefers_segment { of_segment } else { of_box })
}
