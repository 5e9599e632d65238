//! A moving point against a convex shape with flat faces, and against the layer around one.

use super::layer::{Meeting, Touch, enter_first};
use super::rounded::nearest_on_segment;
use crate::dim::facets::Facets;
use crate::dim::math::{Real, Vector};

/// Largest number of borders for which a test of all is faster than a search for closest points.
const BORDERS_MAX: usize = 64;

/// The time interval in which a path is below all faces, with its entry and exit faces.
pub struct Span {
    /// Minus infinity if the path comes from the inside of all faces.
    pub enter: (Real, usize),
    /// Infinity if the path never leaves.
    pub leave: (Real, usize),
}

/// Clips a path by the planes of all faces, each moved outward by `margin` (Cyrus, Beck, "Generalized Two-
/// and Three-Dimensional Clipping", 1978). `None` if nothing is left of it; it is not cut where it begins.
pub fn clip(facets: &Facets<'_>, origin: Vector, dir: Vector, margin: Real) -> Option<Span> {
    let (mut enter, mut leave) = ((Real::NEG_INFINITY, 0), (Real::INFINITY, 0));
    for index in 0..facets.len() {
        let facet = facets.facet(index);
        let height = facet.normal.dot(origin) - facet.offset - margin;
        let speed = facet.normal.dot(dir);
        if speed < 0.0 {
            let time = -height / speed;
            enter = if time > enter.0 { (time, index) } else { enter };
        } else if height > 0.0 {
            return None; // The ray starts above and does not descend.
        } else if speed > 0.0 {
            let time = -height / speed;
            leave = if time < leave.0 { (time, index) } else { leave };
        }
        if enter.0 > leave.0 {
            return None;
        }
    }
    Some(Span { enter, leave })
}

/// Returns the time at which a point meets the layer of thickness `radius` around the shape.
///
/// The faces, moved outward, enclose the layer. If the path enters right above a face, it enters the layer.
/// If it enters between faces, it is in a gap of rounded edges, and leaves the gap to the inside only
/// through these edges.
pub fn enter_layer(facets: &Facets<'_>, origin: Vector, dir: Vector, radius: Real) -> Meeting {
    let Some(span) = clip(facets, origin, dir, radius) else { return Meeting::Never };
    let (time, face) = span.enter;
    if time >= 0.0 {
        let place = origin + dir * time;
        if facets.is_over(face, place) {
            let normal = facets.facet(face).normal;
            return Meeting::At(Touch { time, normal, core: place - normal * radius });
        }
    }
    if facets.border_count() > BORDERS_MAX {
        return Meeting::Unclear;
    }
    if time < 0.0
        && let Some(meeting) = begin_within(facets, origin, radius)
    {
        return meeting;
    }
    let borders = (0..facets.border_count()).map(|index| facets.border(index));
    enter_first(origin, dir, radius, borders)
}

/// The touch of a point that is within the layer, or below it, to begin with; `None` if it is neither.
fn begin_within(facets: &Facets<'_>, point: Vector, radius: Real) -> Option<Meeting> {
    let mut highest = (Real::NEG_INFINITY, 0);
    for index in 0..facets.len() {
        let facet = facets.facet(index);
        let height = facet.normal.dot(point) - facet.offset;
        highest = if height > highest.0 { (height, index) } else { highest };
        if height >= 0.0 && height <= radius && facets.is_over(index, point) {
            return Some(Touch::at_once(facet.normal, point - facet.normal * height));
        }
    }
    let (height, index) = highest;
    if height < 0.0 {
        // Inside: of the nearest plane, the nearest point is on the face.
        let normal = facets.facet(index).normal;
        return Some(Touch::at_once(normal, point - normal * height));
    }
    let mut nearest = (Real::INFINITY, point);
    for index in 0..facets.border_count() {
        let core = nearest_on_segment(point, facets.border(index));
        let distance = core.distance_squared(point);
        nearest = if distance < nearest.0 { (distance, core) } else { nearest };
    }
    (nearest.0 <= radius * radius).then(|| Touch::around(point, nearest.1, 0.0))
}
