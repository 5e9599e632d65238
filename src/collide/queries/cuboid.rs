//! A moving point against the layer around a box.

use super::layer::{Meeting, Touch, enter_first};
use crate::dim::math::{DIM, Real, Vector};

/// Returns the time at which a point meets the layer of thickness `radius` around a box about the origin.
///
/// The box with its faces moved outward encloses the layer. If the path enters right above a face, it enters
/// the layer. Otherwise it is in a gap of a rounded edge or corner (Ericson, "Real-Time Collision Detection",
/// 2005, section 5.5.7). It can leave the gap of an edge lengthwise only into the gap of a corner, so only
/// the edges that meet there matter.
pub fn enter_layer(half: Vector, origin: Vector, dir: Vector, radius: Real) -> Meeting {
    let Some((time, axis)) = enter_slabs(half + Vector::splat(radius), origin, dir) else {
        return Meeting::Never;
    };
    if time < 0.0
        && let Some(meeting) = begin_within(half, origin, radius)
    {
        return meeting;
    }
    let place = origin + dir * time.max(0.0);
    let is_outside = |axis: usize| place[axis].abs() > half[axis];
    if time >= 0.0 && (0..DIM).all(|other| other == axis || !is_outside(other)) {
        let mut normal = Vector::ZERO;
        normal[axis] = -dir[axis].signum();
        return Meeting::At(Touch { time, normal, core: place - normal * radius });
    }
    let mut corner = half;
    for axis in 0..DIM {
        let side = if is_outside(axis) || dir[axis] == 0.0 { place[axis] } else { dir[axis] };
        corner[axis] = half[axis].copysign(side);
    }
    let edge = |axis| {
        let mut end = corner;
        end[axis] = -corner[axis];
        [corner, end]
    };
    enter_first(origin, dir, radius, (0..DIM).map(edge))
}

/// The time at which a path enters a box, and the axis. The time is negative if the path begins inside;
/// `None` if the box is not in the path, or behind the start.
fn enter_slabs(half: Vector, origin: Vector, dir: Vector) -> Option<(Real, usize)> {
    let (mut enter, mut leave) = ((Real::NEG_INFINITY, 0), Real::INFINITY);
    for axis in 0..DIM {
        let (place, speed) = (origin[axis], dir[axis]);
        if speed == 0.0 {
            if place.abs() > half[axis] {
                return None;
            }
            continue;
        }
        let near = (-half[axis].copysign(speed) - place) / speed;
        enter = if near > enter.0 { (near, axis) } else { enter };
        leave = leave.min((half[axis].copysign(speed) - place) / speed);
    }
    (enter.0 <= leave && leave >= 0.0).then_some(enter)
}

/// The touch of a point that is within the layer, or in the box, to begin with; `None` if it is neither.
fn begin_within(half: Vector, point: Vector, radius: Real) -> Option<Meeting> {
    let heights = point.abs() - half;
    let axis = heights.max_position();
    if heights[axis] < 0.0 {
        // Inside: out through the nearest face.
        let (mut normal, mut core) = (Vector::ZERO, point);
        normal[axis] = (1.0 as Real).copysign(point[axis]);
        core[axis] = half[axis].copysign(point[axis]);
        return Some(Touch::at_once(normal, core));
    }
    let core = point.clamp(-half, half);
    (core.distance_squared(point) <= radius * radius).then(|| Touch::around(point, core, 0.0))
}
