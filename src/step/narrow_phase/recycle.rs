//! Admissible motion of a touching pair until its contact points are recomputed.
//!
//! Until then the points ride along with the two bodies, which is nearly right as long as the same
//! corners and edges touch. It is wrong at once where a round surface rolls: its point of contact moves
//! on. A point that lags behind by `δ` lets the normal force `N` turn the body with the torque `N δ`.

use crate::dim::math::Real;
use crate::model::collider::ShapeForm;

/// Fraction of the recycle distance for which the points of round surfaces ride along.
///
/// With the default distance of 0.01 m, a ball of radius `r` rolls on with a point that lags by 0.2 mm at
/// most. The rule changes the acceleration of a ball of `r` = 0.5 on a slope of 20° by less than 0.1 %. The
/// full distance changed it by 2.5 %.
const ROUND_FRACTION: Real = 0.02;

/// Bound (length units) on the motion of any point of two shapes relative to each other until contacts must
/// be computed again. `distance` is the bound for shapes with flat sides.
pub(super) fn recycle_distance(forms: [ShapeForm; 2], distance: Real) -> Real {
    let [form1, form2] = forms;
    if (form1 | form2).contains(ShapeForm::ROUND) { distance * ROUND_FRACTION } else { distance }
}
