//! Convex hulls of clouds of points, pleasant and not.

use crate::base::measure::SHAPE_MAX;
use crate::base::random::Random;
use crate::dim::math::{DIM, Real, Vector};
use crate::model::collider::ColliderBuilder;

fn point(random: &mut Random, size: f64) -> Vector {
    Vector::from_array(core::array::from_fn(|_| random.within(-size, size)))
}

/// The hull must reach as far as its points in every direction, within `slack`.
#[track_caller]
fn assert_hull_fits(points: &[Vector], size: Real, slack: Real) {
    let Some(builder) = ColliderBuilder::convex_hull(points) else {
        panic!("no hull around {} points of size {size}", points.len());
    };
    let collider = builder.try_build().expect("a hull is a shape");
    let hull = collider.shape().as_support_map().expect("a hull is convex");
    let mut random = Random(99);
    let outwards = (0..300).map(|i| points[i % points.len()] + point(&mut random, 1.0) * size);
    for direction in outwards.map(|d| d.normalize_or(Vector::X)) {
        let reach = points.iter().map(|p| p.dot(direction)).fold(Real::MIN, Real::max);
        let hull_reach = hull.local_support_point(direction).dot(direction);
        let missing = (reach - hull_reach) / size;
        assert!((-1.0e-5..=slack).contains(&missing), "{missing} missing along {direction}");
    }
}

#[test]
fn hulls_of_random_clouds_of_any_size_contain_their_points() {
    let mut random = Random(1);
    for count in [10, 30, 200, 1000] {
        for size in [1.0e-9, 1.0e-4, 0.1, 1.0, 1.0e2, 1.0e6, 0.5 * SHAPE_MAX] {
            let points: Vec<_> = (0..count).map(|_| point(&mut random, 1.0) * size).collect();
            assert_hull_fits(&points, size, 1.0e-4);
        }
    }
}

#[test]
fn hulls_of_finely_rounded_clouds_contain_their_points() {
    let mut random = Random(2);
    for count in [100, 1000, 5000] {
        let points: Vec<_> =
            (0..count).map(|_| point(&mut random, 1.0).normalize_or(Vector::X)).collect();
        assert_hull_fits(&points, 1.0, 0.03);
    }
}

#[test]
fn thin_clouds_have_a_hull_as_long_as_they_are_not_flat() {
    let mut random = Random(3);
    for thickness in [0.1, 1.0e-2, 1.0e-3] {
        for axis in [Vector::X, Vector::Y] {
            let squeeze = Vector::ONE - axis * (1.0 - thickness);
            let points: Vec<_> = (0..50).map(|_| point(&mut random, 1.0) * squeeze).collect();
            assert_hull_fits(&points, 1.0, 0.03 * thickness);
        }
    }
}

#[test]
fn a_hull_keeps_the_corners_of_a_box_exactly() {
    let mut corners = Vec::new();
    for bits in 0..1_u32 << DIM {
        let side = |axis: usize| if bits >> axis & 1 == 0 { 0.1 } else { 0.7 };
        corners.push(Vector::from_array(core::array::from_fn(side)));
    }
    let mut points = corners.clone();
    points.push(Vector::splat(0.4));
    points.extend_from_slice(&corners);
    let collider = ColliderBuilder::convex_hull(&points).expect("a box").build();
    let aabb = collider.compute_aabb();
    assert_eq!((aabb.mins, aabb.maxs), (Vector::splat(0.1), Vector::splat(0.7)));
    let side: Real = 0.6;
    assert!((collider.volume() - side.powi(DIM as i32)).abs() < 1.0e-5, "{}", collider.volume());
}

#[test]
fn no_cloud_makes_the_hull_panic() {
    let mut random = Random(4);
    let (mut some, mut none) = (0, 0);
    for round in 0..3000 {
        let count = 1 + random.below(24);
        // Coordinates on a coarse grid make coinciding, collinear and coplanar points common; a tiny
        // disturbance makes them nearly so.
        let grid = 1 + random.below(4) as i32;
        let noise = [0.0, 1.0e-7, 1.0e-5, 1.0e-3][round % 4];
        let coarse = |v: Real| (v * grid as Real).round() / grid as Real;
        let points: Vec<_> = (0..count)
            .map(|_| {
                let p = Vector::from_array(point(&mut random, 1.0).to_array().map(coarse));
                p + point(&mut random, noise)
            })
            .collect();
        match ColliderBuilder::convex_hull(&points) {
            None => none += 1,
            Some(builder) => {
                some += 1;
                let collider = builder.try_build().expect("a hull is a shape");
                assert!(collider.compute_aabb().half_extents().max_element() > 0.0);
            }
        }
    }
    assert!(some > 500 && none > 100, "{some} hulls, {none} without");
}
