//! Defaults of convex decompositions, in 2D.

use super::math::{Real, Vector};
use parry::transformation::vhacd::VHACDParameters;
use parry::transformation::voxelization::FillMode;

/// Parameters of the attempts at a decomposition. parry's concavity of 0.1 fills the notches of a comb. Holes
/// must be detected, or a ring becomes a disc; but parry then takes parts of some shapes without holes for
/// one.
pub fn attempts() -> [VHACDParameters; 3] {
    let with_holes =
        FillMode::FloodFill { detect_cavities: true, detect_self_intersections: false };
    let coarse = VHACDParameters { concavity: 0.01, ..VHACDParameters::default() };
    let with_holes = VHACDParameters { fill_mode: with_holes, ..coarse };
    let fine = VHACDParameters {
        concavity: 0.003,
        plane_downsampling: 2,
        convex_hull_downsampling: 2,
        alpha: 0.01,
        beta: 0.01,
        ..with_holes
    };
    [coarse, with_holes, fine]
}

/// The area inside oriented segments: the sum of triangles with their tips at a point.
pub fn enclosed(points: &[Vector], segments: &[[u32; 2]]) -> Real {
    let Some(&tip) = points.first() else { return 0.0 };
    let triangles = segments.iter().map(|segment| {
        let [a, b] = segment.map(|i| points[i as usize] - tip);
        a.perp_dot(b)
    });
    (0.5 * triangles.sum::<Real>()).abs()
}

/// Calls `visit` with the elements of the boundary of a segment, and whether it begins (1) or ends (-1)
/// there.
pub fn for_each_end([from, to]: [u32; 2], mut visit: impl FnMut([u32; 2], i32)) {
    visit([from; 2], 1);
    visit([to; 2], -1);
}
