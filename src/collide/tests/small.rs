//! Worlds of millimetres have the same relative accuracy as worlds of metres.

use super::{just_touching, manifolds};
use crate::base::random::Random;
use crate::dim::collide::samples::{self, CONVEX_KINDS};
use crate::dim::math::{Pose, Real};

/// The same shapes and pose, a thousand times smaller: the same manifold, as much smaller.
#[test]
fn small_shapes_touch_like_large_ones() {
    let (mut compared, mut agreed) = (0, 0);
    for round in 0..2_000 {
        let kinds = [round % CONVEX_KINDS, (round / CONVEX_KINDS) % CONVEX_KINDS];
        let scale: Real = 1.0e-3;
        let pair = |size: f64| {
            let mut random = Random(round as u64);
            kinds.map(|kind| samples::shape(kind, &mut random, size))
        };
        let ([large1, large2], [small1, small2]) = (pair(1.0), pair(1.0e-3));
        let pos12 = just_touching(&*large1, &*large2, 0.005, &mut Random(round as u64));
        let small = Pose::from_parts(pos12.translation * scale, pos12.rotation);
        let (of_large, _) = manifolds(&pos12, &*large1, &*large2, 0.02);
        let (of_small, _) = manifolds(&small, &*small1, &*small2, 0.02 * scale);
        let ([large], [small]) = (&*of_large, &*of_small) else { continue };
        compared += 1;
        let turn = (large.local_n1 - small.local_n1).length();
        let dist = (large.deepest_dist() - small.deepest_dist() / scale).abs();
        agreed += u32::from(turn < 0.05 && dist < 2.0e-3);
    }
    // Of two equally good directions, rounding selects one.
    assert!(compared > 1_500 && agreed * 100 > compared * 92, "{agreed} of {compared}");
}
