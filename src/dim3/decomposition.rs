//! Defaults of convex decompositions, in 3D.

use super::hull::signed_volume;
use super::math::{Real, Vector};
use parry::transformation::vhacd::VHACDParameters;

/// Parameters of the attempts at a decomposition. parry's defaults fill the notches of a comb; finer ones
/// take several times as long.
pub fn attempts() -> [VHACDParameters; 3] {
    let coarse = VHACDParameters::default();
    let fine = VHACDParameters {
        concavity: 0.0025,
        plane_downsampling: 2,
        convex_hull_downsampling: 2,
        ..coarse
    };
    let dense = VHACDParameters { concavity: 0.0025, resolution: 100, ..coarse };
    [coarse, fine, dense]
}

/// The volume inside oriented triangles.
pub fn enclosed(points: &[Vector], triangles: &[[u32; 3]]) -> Real {
    let Some(&tip) = points.first() else { return 0.0 };
    let points: Vec<Vector> = points.iter().map(|point| *point - tip).collect();
    signed_volume(&points, triangles).abs()
}

/// Calls `visit` with the sides of a triangle in rising order, and whether they rise (1) or fall (-1) along
/// the triangle.
pub fn for_each_end([a, b, c]: [u32; 3], mut visit: impl FnMut([u32; 2], i32)) {
    for [from, to] in [[a, b], [b, c], [c, a]] {
        visit([from.min(to), from.max(to)], if from < to { 1 } else { -1 });
    }
}
