//! Clipping of parts outside the picture or behind the eye.
//!
//! Clipping precedes the division by distance, where the borders of the view are planes. A point is inside a
//! plane while a linear function of it is positive. Points here have the coordinates x, y and w of the
//! camera.

use crate::Seen;

/// Clipping border relative to the picture's edge, so that the ends of clipped lines are invisible.
const BORDER: f32 = 1.2;

/// Returns the signed distances of a point to all borders (negative: outside).
fn insides(p: Seen, nearest: f32) -> [f32; 5] {
    let reach = BORDER * p.w;
    [p.w - nearest, reach - p.x, reach + p.x, reach - p.y, reach + p.y]
}

fn between(a: Seen, b: Seen, t: f32) -> Seen {
    Seen { x: a.x + (b.x - a.x) * t, y: a.y + (b.y - a.y) * t, w: a.w + (b.w - a.w) * t }
}

/// Returns the visible part of a line.
pub(super) fn line(from: Seen, to: Seen, nearest: f32) -> Option<[Seen; 2]> {
    let (mut enter, mut leave) = (0.0_f32, 1.0_f32);
    for (a, b) in insides(from, nearest).into_iter().zip(insides(to, nearest)) {
        match (a < 0.0, b < 0.0) {
            (true, true) => return None,
            (true, false) => enter = enter.max(a / (a - b)),
            (false, true) => leave = leave.min(a / (a - b)),
            (false, false) => {}
        }
    }
    (enter < leave).then(|| [between(from, to, enter), between(from, to, leave)])
}

/// Returns the visible part of a triangle: a convex polygon, or nothing.
pub(super) fn triangle(corners: [Seen; 3], nearest: f32) -> Vec<Seen> {
    let mut polygon = corners.to_vec();
    for border in 0..5 {
        let Some(&last) = polygon.last() else { break };
        let mut kept = Vec::with_capacity(polygon.len() + 1);
        let mut previous = (last, insides(last, nearest)[border]);
        for &corner in &polygon {
            let inside = insides(corner, nearest)[border];
            if (inside < 0.0) != (previous.1 < 0.0) {
                kept.push(between(previous.0, corner, previous.1 / (previous.1 - inside)));
            }
            if inside >= 0.0 {
                kept.push(corner);
            }
            previous = (corner, inside);
        }
        polygon = kept;
    }
    polygon
}
