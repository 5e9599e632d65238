//! Casts at grounds of many pieces: height fields, voxels, and surfaces with a solid inside.

use super::plain::alone;
use crate::dim::queries::{columns, field, pieces, rough_field, solid_box};
use crate::dim::{about_z, assortment, cuboid, vec};
use crate::suite::physics::stage::Dice;
use rapier::parry::query::NonlinearRigidMotion;
use rapier::parry::shape::Ball;
use rapier::prelude::*;

fn posed(dice: &mut Dice, place: Vector) -> Pose {
    let body = RigidBodyBuilder::fixed().translation(place);
    *body.rotation(about_z(dice.within(-3.0, 3.0))).build().position()
}

fn cast_at(ground: &SharedShape, start: Pose, path: Vector, shape: &dyn Shape) -> Option<Real> {
    let (colliders, handle, queries) = alone(ColliderBuilder::new(ground.clone()));
    let options = ShapeCastOptions::default();
    let view = queries.view(&colliders, QueryFilter::default());
    let hit = view.cast_shape(&start, path, shape, options);
    assert!(hit.is_none_or(|(found, _)| found == handle));
    hit.map(|(_, hit)| hit.time_of_impact)
}

/// A ball of radius `r` that falls from the height `y` at the speed `v` onto a level field touches it at
/// `(y - r) / v`, wherever it comes from.
#[test]
fn balls_from_beside_a_field_land_on_it() {
    let level = field(&[0.0; 3], 2.0);
    let case =
        cast_at(&level, Pose::from_translation(vec(-3.0, 1.0)), vec(2.5, -0.9), &Ball::new(0.1));
    assert!((case.expect("it lands") - 1.0).abs() < 1.0e-5, "{case:?}");
    let mut dice = Dice(5);
    let (mut worst, count): (Real, usize) = (0.0, 2000);
    for k in 0..count {
        let radius = dice.within(0.02, 0.3);
        let (land, side) = (dice.within(-0.99, 0.99), if k % 2 == 0 { -1.0 } else { 1.0 });
        let start = vec(side * dice.within(1.5, 30.0), radius + dice.within(0.5, 5.0));
        let time = dice.within(0.1, 4.0);
        let path = (vec(land, radius) - start) / time;
        let found = cast_at(&level, Pose::from_translation(start), path, &Ball::new(radius));
        // The edge of the field may be hit first, by the lower half of a flat path.
        let first = edge_time(start, path, radius, side).min(time);
        let error = (found.expect("it lands") - first).abs() * path.length();
        worst = worst.max(error);
    }
    println!("{count} balls from beside a level field: error at most {worst}");
    // The rounding of a path of 30 is some 10⁻⁵, and its root counts where the ball grazes the edge.
    assert!(worst < 5.0e-3, "{worst}");
}

/// The time at which the ball touches the edge of the field at `x = side`: infinity if it does not.
fn edge_time(start: Vector, path: Vector, radius: Real, side: Real) -> Real {
    let from_edge = start - vec(side, 0.0);
    let (a, b) = (path.length_squared(), from_edge.dot(path));
    let c = from_edge.length_squared() - radius * radius;
    let root = b * b - a * c;
    if root < 0.0 { Real::INFINITY } else { (-b - root.sqrt()) / a }
}

/// A half-space that comes down on a field touches its highest point.
#[test]
fn half_spaces_touch_the_top_of_a_field() {
    let mut dice = Dice(6);
    for _ in 0..50 {
        let ground = rough_field(6, 5.0, || dice.within(-1.0, 1.0));
        let top = ground.compute_local_aabb().maxs.y;
        let down = SharedShape::halfspace(-Vector::Y);
        let time = cast_at(&ground, Pose::from_translation(vec(0.3, 4.0)), vec(0.7, -2.0), &*down);
        let right = (4.0 - top) / 2.0;
        assert!((time.expect("it comes down") - right).abs() < 1.0e-4, "{time:?}, not {right}");
    }
}

/// The time of a cast at a ground is that of the first of its pieces, for paths of any length.
#[test]
fn small_shapes_hit_the_first_piece_of_a_wide_field() {
    let mut dice = Dice(7);
    let ground = rough_field(30, 333.0, || dice.within(-2.0, 2.0));
    let pieces = pieces(&ground);
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let (mut worst, mut hits): (Real, usize) = (0.0, 0);
    for k in 0..400 {
        let size = dice.within(0.01, 0.1);
        let shape = match k % 3 {
            0 => SharedShape::capsule_y(size, 0.7 * size),
            1 => SharedShape::ball(size),
            _ => cuboid(size, 0.6 * size).build().shared_shape().clone(),
        };
        let start = posed(&mut dice, Vector::ZERO);
        let place = vec(dice.within(-140.0, 140.0), dice.within(3.0, 20.0));
        let start = Pose::from_parts(place, start.rotation);
        let mut path = vec(dice.within(-1.0, 1.0), dice.within(-1.0, -0.1));
        path[DIM - 1] += dice.within(-0.1, 0.1);
        let options = ShapeCastOptions::default();
        let time = |ground: &SharedShape| {
            let hit = query.cast_shapes(&start, path, &**ground, &*shape, options);
            hit.expect("supports every pair").map(|hit| hit.time_of_impact)
        };
        let first = pieces.iter().filter_map(time).min_by(Real::total_cmp);
        let found = time(&ground);
        assert_eq!(found.is_some(), first.is_some(), "cast {k}: {found:?}, not {first:?}");
        if let (Some(found), Some(first)) = (found, first) {
            hits += 1;
            worst = worst.max((found - first).abs() * path.length());
        }
    }
    println!("{hits} hits on a field of 333 m: at most {worst} m from the first piece");
    assert!(hits > 300 && worst < 1.0e-3);
}

/// Voxels, hit obliquely from far away and from near, by balls, capsules and boxes: a voxel is a box.
#[test]
fn casts_at_voxels_hit_the_first_box() {
    let mut dice = Dice(8);
    let one = columns(1, || 0);
    let corner = Vector::splat(0.5);
    let from = vec(-0.41, 3.1) + (Vector::ONE - vec(1.0, 1.0)) * -1.2;
    let straight = (corner - from) * 0.5;
    let hit = cast_at(&one, Pose::from_translation(from), straight, &Ball::new(0.1));
    assert!(hit.is_some(), "the middle of a voxel is missed");
    let ground = columns(6, || dice.within(0.0, 3.99) as i32);
    let voxels = ground.as_voxels().expect("are voxels");
    let boxes: Vec<_> = voxels
        .voxels()
        .filter(|voxel| !voxel.state.is_empty())
        .map(|voxel| Pose::from_translation(voxel.center))
        .collect();
    let half = SharedShape::new(rapier::parry::shape::Cuboid::new(Vector::splat(0.5)));
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let (mut worst, mut hits): (Real, usize) = (0.0, 0);
    for k in 0..600 {
        let shapes = assortment();
        let shape = shapes[k % shapes.len()].build();
        let mut target = Vector::ZERO;
        (0..DIM).for_each(|axis| target[axis] = dice.within(0.0, 6.0));
        let mut path = Vector::ZERO;
        (0..DIM).for_each(|axis| path[axis] = dice.within(-1.0, 1.0));
        path.y = -path.y.abs() - 0.1;
        let start = Pose::from_parts(
            target - path * dice.within(4.0, 40.0),
            posed(&mut dice, Vector::ZERO).rotation,
        );
        let options = ShapeCastOptions::default();
        let time = |pose: &Pose, ground: &SharedShape| {
            let pose = pose.inv_mul(&start);
            let hit = query.cast_shapes(&pose, path, &**ground, shape.shape(), options);
            hit.expect("supports every pair").map(|hit| hit.time_of_impact)
        };
        let first = boxes.iter().filter_map(|pose| time(pose, &half)).min_by(Real::total_cmp);
        let found = time(&Pose::IDENTITY, &ground);
        assert_eq!(found.is_some(), first.is_some(), "cast {k}: {found:?}, not {first:?}");
        if let (Some(found), Some(first)) = (found, first) {
            hits += 1;
            worst = worst.max((found - first).abs() * path.length());
        }
    }
    println!("{hits} hits on voxels: at most {worst} from the first box");
    assert!(hits > 200 && worst < 1.0e-3);
}

/// Shapes deep inside voxels hit them at once, with and without rotation.
#[test]
fn the_inside_of_voxels_is_solid() {
    let ground = columns(5, || 5);
    let middle = Pose::from_translation(Vector::splat(2.6));
    for shape in [Ball::new(0.1), Ball::new(0.3)] {
        let (colliders, handle, queries) = alone(ColliderBuilder::new(ground.clone()));
        let motion = NonlinearRigidMotion::new(middle, Vector::ZERO, Vector::X, about_z(1.0));
        let view = queries.view(&colliders, QueryFilter::default());
        let hit = view.cast_shape_nonlinear(&motion, &shape, 0.0, 2.0, true);
        assert_eq!(hit.map(|(found, hit)| (found, hit.time_of_impact)), Some((handle, 0.0)));
        let hit = view.cast_shape(&middle, Vector::X, &shape, ShapeCastOptions::default());
        assert_eq!(hit.map(|(found, hit)| (found, hit.time_of_impact)), Some((handle, 0.0)));
        assert_eq!(view.intersect_shape(middle, &shape).count(), 1);
    }
}

/// A surface with a solid inside is as solid as a box of the same size, for all queries.
#[test]
fn oriented_surfaces_are_solid() {
    let (solid, cube) = (solid_box(1.0), cuboid(1.0, 1.0).build().shared_shape().clone());
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let mut dice = Dice(9);
    let mut inside = 0;
    for _ in 0..300 {
        let mut place = Vector::ZERO;
        (0..DIM).for_each(|axis| place[axis] = dice.within(-1.5, 1.5));
        let mut dir = Vector::ZERO;
        (0..DIM).for_each(|axis| dir[axis] = dice.within(-1.0, 1.0));
        let ray = |shape: &SharedShape, solid| {
            let (colliders, _, queries) = alone(ColliderBuilder::new(shape.clone()));
            let ray = Ray::new(place, dir);
            let all = QueryFilter::default();
            queries.cast_ray_and_get_normal(&colliders, &ray, 9.0, solid, all).map(|(_, hit)| hit)
        };
        let is_inside = place.abs().max_element() < 1.0;
        inside += usize::from(is_inside);
        for is_solid in [true, false] {
            let [ours, box_hit] = [&solid, &cube].map(|shape| ray(shape, is_solid));
            let times = [ours, box_hit].map(|hit| hit.map(|hit| hit.time_of_impact));
            match times {
                [Some(time), Some(right)] => assert!((time - right).abs() < 1.0e-3, "{times:?}"),
                [None, None] => {}
                _ => panic!("{times:?} from {place} along {dir}, solid: {is_solid}"),
            }
        }
        let pose = posed(&mut dice, place);
        for shape in assortment() {
            let shape = shape.build();
            let meets = |ground: &SharedShape| {
                let found = query.intersection_test(&pose, &**ground, shape.shape());
                found.expect("supports every pair").intersecting
            };
            let gap = |ground: &SharedShape| {
                let found = query.distance(&pose, &**ground, shape.shape());
                found.expect("supports every pair").distance
            };
            let distance = gap(&cube);
            assert!((gap(&solid) - distance).abs() < 4.0e-3, "{distance}");
            let contact = query.contact(&pose, &*cube, shape.shape(), 0.0);
            let contact = contact.expect("supports every pair");
            let is_clear = distance > 4.0e-3 || contact.is_some_and(|found| found.dist < -4.0e-3);
            assert!(!is_clear || meets(&cube) == meets(&solid), "{place}: {distance}");
            let options = ShapeCastOptions::default();
            let time = |ground: &SharedShape| {
                let hit = query.cast_shapes(&pose, dir, &**ground, shape.shape(), options);
                hit.expect("supports every pair").map(|hit| hit.time_of_impact)
            };
            let times = [time(&solid), time(&cube)];
            assert!(!is_inside || times == [Some(0.0); 2], "{times:?} from {place}");
        }
    }
    assert!(inside > 50, "{inside}");
}
