//! Thickness and skeletons, against brute force over many directions.

use crate::base::random::Random;
use crate::dim::math::{DIM, Real, Rotation, Vector};
use crate::dim::shapes;
use crate::model::collider::{ColliderBuilder, Widths};
use parry::shape::{Shape, SharedShape, SupportMap, Triangle};

fn point(random: &mut Random) -> Vector {
    Vector::from_array(core::array::from_fn(|_| random.within(-1.0, 1.0)))
}

fn width(shape: &dyn SupportMap, along: Vector) -> Real {
    (shape.local_support_point(along) - shape.local_support_point(-along)).dot(along)
}

/// The least width over random directions, each of the best of which is improved by ever smaller steps.
fn least_width(shape: &dyn SupportMap, random: &mut Random) -> Real {
    let mut tried: Vec<(Real, Vector)> = (0..400)
        .filter_map(|_| point(random).try_normalize())
        .map(|along| (width(shape, along), along))
        .collect();
    tried.sort_by(|a, b| a.0.total_cmp(&b.0));
    tried.truncate(8);
    for (least, along) in &mut tried {
        let mut size = 0.3;
        while size > 1.0e-5 {
            let steps = (0..12).filter_map(|_| (*along + point(random) * size).try_normalize());
            let better = steps.map(|n| (width(shape, n), n)).min_by(|a, b| a.0.total_cmp(&b.0));
            match better.filter(|better| better.0 < *least) {
                Some(found) => (*least, *along) = found,
                None => size *= 0.6,
            }
        }
    }
    tried.iter().map(|tried| tried.0).fold(Real::MAX, Real::min)
}

/// Hulls of all kinds: clouds, plates, rods and slivers that lie aslant, wedges with few corners, and round
/// bodies.
fn hulls(random: &mut Random) -> Vec<SharedShape> {
    let mut hulls = Vec::new();
    for round in 0..60 {
        let count = [DIM + 1, DIM + 3, 30, 200][round % 4];
        let flat = [1.0, 0.3, 0.03, 0.01][round / 4 % 4];
        let mut squeeze = Vector::ONE;
        squeeze[round % DIM] = flat;
        if round % 3 == 0 {
            squeeze[(round + 1) % DIM] = flat;
        }
        let turned = shapes::spread_directions(&[point(random), point(random), point(random)]);
        let on_ball = round % 5 == 0;
        let cloud = (0..count).map(|_| {
            let point = point(random);
            turned * (if on_ball { point.normalize_or(Vector::X) } else { point } * squeeze)
        });
        let hull = ColliderBuilder::convex_hull(&cloud.collect::<Vec<_>>());
        hulls.extend(hull.map(|hull| hull.shape));
    }
    hulls
}

/// All other solid parts that both dimensions have, and those of one of them.
fn plain() -> Vec<SharedShape> {
    let half = |k: usize| {
        Vector::from_array(core::array::from_fn(|axis| [0.5, 0.02, 0.2][(axis + k) % 3]))
    };
    let (a, b, c) = (Vector::X, Vector::Y * 0.1 - Vector::X * 0.3, -Vector::Y * 0.2);
    let mut shapes = vec![
        SharedShape::ball(0.3),
        SharedShape::capsule(a, b, 0.02),
        SharedShape::new(parry::shape::RoundShape {
            inner_shape: Triangle::new(a, b, c),
            border_radius: 0.05,
        }),
    ];
    for k in 0..3 {
        let cuboid = parry::shape::Cuboid::new(half(k));
        shapes.push(SharedShape::new(cuboid));
        shapes.push(SharedShape::new(parry::shape::RoundShape {
            inner_shape: cuboid,
            border_radius: 0.03,
        }));
    }
    if DIM == 2 {
        shapes.push(SharedShape::new(Triangle::new(a, b, c)));
    }
    shapes.extend(shapes::tests::solids());
    shapes
}

fn all(random: &mut Random) -> Vec<SharedShape> {
    let mut all = plain();
    all.extend(hulls(random));
    all
}

#[test]
fn thickness_is_half_the_minimum_width() {
    let mut random = Random(7);
    let mut worst = (1.0, 1.0);
    for shape in all(&mut random) {
        let support = shape.as_support_map().expect("convex");
        let widths = Widths::of(&*shape);
        // Among the random directions hardly one is near the narrowest of a sliver, so the axis that was
        // found is tried as well.
        let least = least_width(support, &mut random).min(width(support, widths.axes * Vector::X));
        let found = 2.0 * widths.thickness;
        let ratio = found / least;
        worst = (Real::min(worst.0, ratio), Real::max(worst.1, ratio));
        // Above: rounding of a plate a hundred times as long as thick. Below: the tolerance of the search,
        // and the error of the descent.
        let name = shape.shape_type();
        assert!((0.96..1.002).contains(&ratio), "{name:?}: {found} found, {least} tried");
    }
    println!("minimum width found over the least one tried: {:.4} to {:.4}", worst.0, worst.1);
}

/// The skeleton is thin along the narrow axis, and inside, with a gap on all sides.
#[test]
fn skeletons_are_inside() {
    let mut random = Random(8);
    for shape in all(&mut random) {
        let (widths, support) = (Widths::of(&*shape), shape.as_support_map().expect("convex"));
        let Widths { center, axes, skeleton, thickness } = widths;
        for _ in 0..300 {
            let Some(along) = point(&mut random).try_normalize() else { continue };
            let flat = axes * ((axes.inverse() * along) * skeleton);
            let own = (support.local_support_point(along) - center).dot(along);
            let inner = match flat {
                Vector::ZERO => 0.0,
                _ => (support.local_support_point(flat) - center).dot(flat),
            };
            let room = own - inner;
            let name = shape.shape_type();
            assert!(room > 0.1 * thickness, "{name:?}: {room} along {along} of {thickness}");
        }
        let narrow = axes * Vector::X;
        let thin = width(support, narrow) * skeleton[0];
        let is_own = axes == Rotation::IDENTITY;
        assert!(is_own || thin < 0.1 * thickness, "{thin} of {thickness}");
    }
}

/// Shapes without parts of their own give no widths; all parts of a compound are there if one of them is a
/// hull.
#[test]
fn widths_are_kept_where_they_are_costly() {
    let cloud = hulls(&mut Random(9));
    let hull = cloud[0].clone();
    assert!(Widths::of_costly(&*SharedShape::ball(1.0)).is_none());
    assert_eq!(Widths::of_costly(&*hull).map(|known| known.len()), Some(1));
    let place = crate::dim::math::Pose::IDENTITY;
    let compound =
        SharedShape::compound(vec![(place, SharedShape::ball(1.0)), (place, hull.clone())]);
    let known = Widths::of_costly(&*compound).expect("a hull is among them");
    assert_eq!(known.len(), 2);
    let kept = super::super::thickness(&*compound, Some(&known));
    assert_eq!(kept, super::super::thickness(&*compound, None));
    assert_eq!(kept, Widths::of(&*hull).thickness.min(1.0));
    let shape: &dyn Shape = &*hull;
    assert_eq!(Widths::of(shape).thickness, super::super::thickness(shape, None));
}
