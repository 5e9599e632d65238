//! Queries with known results.

use crate::dim::{about_z, cuboid, vec};
use rapier::parry::query::NonlinearRigidMotion;
use rapier::prelude::*;

pub fn alone(collider: ColliderBuilder) -> (ColliderSet, ColliderHandle, QueryPipeline) {
    let mut colliders = ColliderSet::new();
    let handle = colliders.insert(collider);
    let mut queries = QueryPipeline::new();
    queries.update(&colliders);
    (colliders, handle, queries)
}

pub const ALL: QueryFilter<'static> = QueryFilter {
    flags: QueryFilterFlags::empty(),
    groups: None,
    exclude_collider: None,
    exclude_rigid_body: None,
    predicate: None,
};

#[test]
fn rays_enter_solids_at_once_and_leave_hollow_shapes() {
    let (colliders, ball, queries) = alone(ColliderBuilder::ball(2.0));
    let ray = Ray::new(Vector::ZERO, Vector::X * 4.0);
    assert_eq!(queries.cast_ray(&colliders, &ray, 10.0, true, ALL), Some((ball, 0.0)));
    // Times are in units of the direction's length.
    assert_eq!(queries.cast_ray(&colliders, &ray, 10.0, false, ALL), Some((ball, 0.5)));
    assert_eq!(queries.cast_ray(&colliders, &ray, 0.4, false, ALL), None);
    let from_left = Ray::new(vec(-5.0, 0.0), Vector::X);
    let (_, hit) = queries
        .cast_ray_and_get_normal(&colliders, &from_left, 10.0, true, ALL)
        .expect("the ball is in the way");
    assert!((hit.time_of_impact - 3.0).abs() < 1.0e-5);
    assert!((hit.normal + Vector::X).length() < 1.0e-5);
}

#[test]
fn walls_beyond_the_limit_are_not_hit_from_within() {
    let (colliders, hollow, queries) = alone(cuboid(2.0, 2.0));
    let ray = Ray::new(Vector::ZERO, Vector::X);
    let cast = |limit: Real| queries.cast_ray(&colliders, &ray, limit, false, ALL);
    assert_eq!(cast(1.0), None);
    assert_eq!(cast(3.0), Some((hollow, 2.0)));
}

/// A ray exactly along the common face of two boxes hits both at the same time. The result is the lower slot,
/// however the tree was built.
#[test]
fn equal_hits_return_the_lower_slot() {
    let places = [vec(0.0, 1.0), vec(0.0, -1.0), vec(0.0, 3.0), vec(0.0, -3.0)];
    for order in [[0, 1, 2, 3], [1, 0, 3, 2], [3, 2, 1, 0], [2, 0, 1, 3]] {
        let mut colliders = ColliderSet::new();
        let handles = order.map(|k| colliders.insert(cuboid(1.0, 1.0).translation(places[k])));
        let lower = order.iter().position(|&k| k < 2).expect("two boxes meet at the height 0");
        let mut queries = QueryPipeline::new();
        queries.update(&colliders);
        let ray = Ray::new(vec(-5.0, 0.0), Vector::X);
        let hit = queries.cast_ray(&colliders, &ray, 10.0, true, ALL);
        assert_eq!(hit, Some((handles[lower], 4.0)));
    }
}

#[test]
fn points_are_projected_onto_the_nearest_collider() {
    let mut colliders = ColliderSet::new();
    let left = colliders.insert(cuboid(1.0, 1.0).translation(vec(-4.0, 0.0)));
    let right = colliders.insert(cuboid(1.0, 1.0).translation(vec(5.0, 0.0)));
    let mut queries = QueryPipeline::new();
    queries.update(&colliders);
    let (handle, found) =
        queries.project_point(&colliders, &Vector::ZERO, true, ALL).expect("something is nearest");
    assert_eq!((handle, found.point), (left, vec(-3.0, 0.0)));
    let inside = vec(5.0, 0.25);
    let (handle, found) =
        queries.project_point(&colliders, &inside, true, ALL).expect("something is nearest");
    assert_eq!((handle, found.point, found.is_inside), (right, inside, true));
    let (_, found) =
        queries.project_point(&colliders, &inside, false, ALL).expect("something is nearest");
    assert!((found.point - inside).length() > 0.7);
    let mut around = Vec::new();
    queries.intersections_with_point(&colliders, inside, ALL, |handle| {
        around.push(handle);
        true
    });
    assert_eq!(around, [right]);
}

#[test]
fn cast_shapes_hit_obstacles() {
    let (colliders, wall, queries) = alone(cuboid(1.0, 10.0).translation(vec(6.0, 0.0)));
    let ball = rapier::parry::shape::Ball::new(0.5);
    let start = Pose::from_translation(Vector::ZERO);
    let cast = |velocity: Vector, limit: Real| {
        queries.cast_shape(&colliders, &start, &velocity, &ball, limit, true, ALL)
    };
    let (handle, hit) = cast(Vector::X * 3.0, 10.0).expect("the wall is in the way");
    assert_eq!(handle, wall);
    // The distance from the ball's surface at 0.5 to the wall's at 5, at 3 per unit of time.
    assert!((hit.time_of_impact - 1.5).abs() < 1.0e-3, "{hit:?}");
    assert!(cast(Vector::X * 3.0, 1.4).is_none());
    assert!(cast(-Vector::X, 100.0).is_none());
    let close = Pose::from_translation(vec(4.6, 0.0));
    assert_eq!(queries.intersection_with_shape(&colliders, &close, &ball, ALL), Some(wall));
    assert_eq!(queries.intersection_with_shape(&colliders, &start, &ball, ALL), None);
}

/// A rotating bar sweeps over a peg beside it, which a translation would not touch.
#[test]
fn rotating_shapes_hit_obstacles_in_their_sweep() {
    let (colliders, peg, queries) = alone(ColliderBuilder::ball(0.2).translation(vec(0.0, 2.0)));
    let bar = cuboid(3.0, 0.1).build();
    let still = RigidBodyBuilder::fixed().build();
    let motion = |turn: Real| {
        let pose = *still.position();
        NonlinearRigidMotion::new(pose, Vector::ZERO, Vector::ZERO, about_z(turn))
    };
    let sweep = |turn| {
        queries.cast_shape_nonlinear(&colliders, &motion(turn), bar.shape(), 0.0, 1.0, true, ALL)
    };
    assert!(sweep(0.0).is_none());
    // The upper side of the bar reaches the peg when sin φ · 2 = 0.3, nearly, before a quarter revolution.
    let (handle, hit) = sweep(1.6).expect("the peg is in the way");
    let turned = hit.time_of_impact * 1.6;
    assert_eq!(handle, peg);
    let until = (std::f64::consts::FRAC_PI_2 as Real) - (0.3 / 2.0 as Real).asin();
    assert!((turned - until).abs() < 0.01, "after {turned} rad instead of {until}");
}

#[test]
fn groups_and_exclusions_are_respected() {
    let mut world = PhysicsWorld::new();
    let group = |n: u32| InteractionGroups::new(Group::from_bits_retain(n), Group::ALL);
    let (body, first) = world.insert(
        RigidBodyBuilder::kinematic_position_based().translation(vec(1.0, 0.0)),
        cuboid(0.1, 1.0).collision_groups(group(1)),
    );
    let second = world.insert_collider(
        cuboid(0.1, 1.0).translation(vec(2.0, 0.0)).collision_groups(group(2)),
        None,
    );
    let (_, third) = world.insert(
        RigidBodyBuilder::dynamic().translation(vec(3.0, 0.0)),
        cuboid(0.1, 1.0).collision_groups(group(4)).sensor(true),
    );
    let mut queries = QueryPipeline::new();
    queries.update(&world.colliders);
    let first_hit = |filter: QueryFilter<'_>| {
        let ray = Ray::new(vec(-1.0, 0.0), Vector::X);
        let hit = queries.cast_ray(&world.colliders, &ray, 100.0, true, filter);
        hit.map(|(handle, _)| handle)
    };
    assert_eq!(first_hit(ALL), Some(first));
    assert_eq!(first_hit(ALL.exclude_rigid_body(body)), Some(second));
    assert_eq!(first_hit(ALL.exclude_collider(first)), Some(second));
    assert_eq!(first_hit(ALL.exclude_kinematic()), Some(second));
    assert_eq!(first_hit(ALL.only_kinematic()), Some(first));
    assert_eq!(first_hit(ALL.only_fixed()), Some(second));
    assert_eq!(first_hit(ALL.only_dynamic()), Some(third));
    assert_eq!(first_hit(ALL.only_dynamic().exclude_sensors()), None);
    assert_eq!(first_hit(ALL.exclude_solids()), Some(third));
    let only = |n: u32| InteractionGroups::new(Group::ALL, Group::from_bits_retain(n));
    assert_eq!(first_hit(ALL.groups(only(2))), Some(second));
    assert_eq!(first_hit(ALL.groups(only(4))), Some(third));
    assert_eq!(first_hit(ALL.groups(only(8))), None);
}

/// A ray that begins within a crowd hits all of it at time zero, compounds and single shapes alike.
#[test]
fn in_a_crowd_the_lowest_slot_is_hit_whatever_its_shape() {
    for compound_at in 0..4 {
        let mut colliders = ColliderSet::new();
        let handles: Vec<_> = (0..4)
            .map(|k| {
                let single = cuboid(1.0, 1.0);
                if k != compound_at {
                    return colliders.insert(single.translation(vec(0.1 * k as Real, 0.0)));
                }
                let part = single.build().shared_shape().clone();
                let parts =
                    [-0.5, 0.5].map(|x| (Pose::from_translation(vec(x, 0.0)), part.clone()));
                colliders.insert(ColliderBuilder::compound(parts.to_vec()))
            })
            .collect();
        let mut queries = QueryPipeline::new();
        queries.update(&colliders);
        let ray = Ray::new(vec(0.2, 0.1), Vector::X);
        let hit = queries.cast_ray(&colliders, &ray, 10.0, true, ALL);
        assert_eq!(hit, Some((handles[0], 0.0)));
        let (start, ball) =
            (Pose::from_translation(vec(0.2, 0.1)), rapier::parry::shape::Ball::new(0.1));
        let hit = queries.cast_shape(&colliders, &start, &Vector::X, &ball, 10.0, true, ALL);
        assert_eq!(hit.map(|(handle, hit)| (handle, hit.time_of_impact)), Some((handles[0], 0.0)));
    }
}
