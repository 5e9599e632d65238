//! Two points of a set that are far apart.

use parry::math::Vector;

/// The ends of a line that is nearly as long as the extent of the points: the point that is farthest from the
/// first one, and the point that is farthest from there. `None` if there are no points.
pub fn farthest_pair(points: &[Vector]) -> Option<[Vector; 2]> {
    let farthest = |from: Vector| {
        let distance = |point: &Vector| point.distance_squared(from);
        points.iter().copied().max_by(|p, q| distance(p).total_cmp(&distance(q)))
    };
    let start = farthest(*points.first()?)?;
    Some([start, farthest(start)?])
}
