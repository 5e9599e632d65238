//! Convex hull of points in a plane: Andrew's monotone chain ("Another efficient algorithm for convex hulls
//! in two dimensions", 1979).

use parry::math::Real;

/// The indices of the corners of the convex hull of finite points, counter-clockwise.
pub fn hull_corners(points: &[[Real; 2]]) -> Vec<usize> {
    let mut sorted: Vec<usize> = (0..points.len()).collect();
    let order = |p: [Real; 2], q: [Real; 2]| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1]));
    sorted.sort_by(|&i, &j| order(points[i], points[j]));
    sorted.dedup_by(|i, j| points[*i] == points[*j]);
    let mut corners = half_hull(points, sorted.iter().copied());
    let mut upper = half_hull(points, sorted.iter().rev().copied());
    corners.pop(); // Each half ends where the other begins.
    upper.pop();
    corners.append(&mut upper);
    corners
}

/// Visits sorted points and keeps the left turns.
fn half_hull(points: &[[Real; 2]], sorted: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut chain: Vec<usize> = Vec::new();
    for index in sorted {
        while let [.., a, b] = chain[..] {
            if turn(points[a], points[b], points[index]) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(index);
    }
    chain
}

/// The perpendicular product of the sides `ab` and `bc`: positive for a left turn.
fn turn(a: [Real; 2], b: [Real; 2], c: [Real; 2]) -> Real {
    let (along, next) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
    along[0] * next[1] - along[1] * next[0]
}
