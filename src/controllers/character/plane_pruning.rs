//! Removes redundant planes, so that internal edges have no effect.
//!
//! A capsule that walks over a flat mesh is close to the triangle below it. It is slightly less close to the
//! edges of that triangle's neighbours. The edges' normals oppose the motion, and a character that respects
//! them is lifted over each. But their contact points lie in the plane of the triangle below, which the
//! character stays in front of anyway. That plane keeps the offset from everything behind it. The same holds
//! for level tiles, of one body or of many, and for the far side of a ridge. Steps, walls and valleys have
//! points in front of the plane, and stay.

use super::planes::Plane;
use super::resolved::ResolvedSettings;

/// Largest number of planes; the nearest ones are kept.
const PLANES_MAX: usize = 12;

/// Sorts planes by distance and drops those whose contact points all lie behind a nearer one.
pub(super) fn prune_planes(planes: &mut Vec<Plane>, settings: &ResolvedSettings) {
    // The sort is stable: of equally near ones, that of the lower slot comes first.
    planes.sort_by(|a, b| a.gap.total_cmp(&b.gap));
    let mut kept = 0;
    for candidate in 0..planes.len() {
        let is_needless = planes[..kept]
            .iter()
            .any(|plane| planes[candidate].is_behind(plane, settings.tolerance));
        if !is_needless {
            planes.swap(kept, candidate);
            kept += 1;
        }
    }
    planes.truncate(kept.min(PLANES_MAX));
}
