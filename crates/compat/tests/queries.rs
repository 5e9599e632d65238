//! Queries of the broad phase, and characters.

use super::world::{World, assert_near, cuboid, rounding};
use rapier::control::KinematicCharacterController;
use rapier::parry::query::ShapeCastOptions;
use rapier::prelude::*;

/// A fixed ball at x = 5 and a dynamic one at x = 10, each with radius 1.
fn two_balls() -> (World, [ColliderHandle; 2]) {
    let mut world = World::default();
    let place = |x| Vector::X * x;
    let fixed = RigidBodyBuilder::fixed().translation(place(5.0));
    let (_, fixed) = world.insert(fixed, ColliderBuilder::ball(1.0));
    let dynamic = RigidBodyBuilder::dynamic().translation(place(10.0)).gravity_scale(0.0);
    let (_, dynamic) = world.insert(dynamic, ColliderBuilder::ball(1.0));
    world.steps(1);
    (world, [fixed, dynamic])
}

/// The queries of a world.
fn queries<'a>(world: &'a World, filter: QueryFilter<'a>) -> QueryPipeline<'a> {
    let dispatcher = world.narrow_phase.query_dispatcher();
    world.broad_phase.as_query_pipeline(dispatcher, &world.bodies, &world.colliders, filter)
}

/// A ray along x meets a ball of radius 1 one unit before its center.
#[test]
fn rays_respect_filters() {
    let (world, [fixed, dynamic]) = two_balls();
    let ray = Ray::new(Vector::ZERO, Vector::X);
    let first = |filter| queries(&world, filter).cast_ray(&ray, 100.0, true);
    let is_dynamic = |handle: ColliderHandle, _: &Collider| handle == dynamic;
    assert_eq!(first(QueryFilter::default()), Some((fixed, 4.0)));
    assert_eq!(first(QueryFilter::only_dynamic()), Some((dynamic, 9.0)));
    assert_eq!(first(QueryFilter::exclude_fixed()), Some((dynamic, 9.0)));
    assert_eq!(first(QueryFilter::new().exclude_collider(fixed)), Some((dynamic, 9.0)));
    assert_eq!(first(QueryFilter::new().predicate(&is_dynamic)), Some((dynamic, 9.0)));
    assert_eq!(first(QueryFilter::only_kinematic()), None);
}

#[test]
fn flags_have_the_bits_of_version_032() {
    let flags = [
        QueryFilterFlags::EXCLUDE_FIXED,
        QueryFilterFlags::EXCLUDE_KINEMATIC,
        QueryFilterFlags::EXCLUDE_DYNAMIC,
        QueryFilterFlags::EXCLUDE_SENSORS,
        QueryFilterFlags::EXCLUDE_SOLIDS,
        QueryFilterFlags::ONLY_DYNAMIC,
        QueryFilterFlags::ONLY_KINEMATIC,
        QueryFilterFlags::ONLY_FIXED,
    ];
    assert_eq!(flags.map(|flag| flag.bits()), [1, 2, 4, 8, 16, 3, 5, 6]);
}

/// The engine's queries and the test of a filter find the same colliders.
#[test]
fn each_flag_excludes_its_kind() {
    let mut world = World::default();
    let bodies = [
        RigidBodyBuilder::fixed(),
        RigidBodyBuilder::kinematic_position_based(),
        RigidBodyBuilder::dynamic(),
    ];
    for body in bodies {
        for is_sensor in [false, true] {
            world.insert(body.clone(), ColliderBuilder::ball(1.0).sensor(is_sensor));
        }
    }
    world.colliders.insert(ColliderBuilder::ball(1.0));
    world.steps(1);
    let flags = [
        (QueryFilterFlags::EXCLUDE_FIXED, 4),
        (QueryFilterFlags::EXCLUDE_KINEMATIC, 5),
        (QueryFilterFlags::EXCLUDE_DYNAMIC, 5),
        (QueryFilterFlags::EXCLUDE_SENSORS, 4),
        (QueryFilterFlags::EXCLUDE_SOLIDS, 3),
        (QueryFilterFlags::ONLY_DYNAMIC, 2),
        (QueryFilterFlags::ONLY_KINEMATIC, 2),
        (QueryFilterFlags::ONLY_FIXED, 3),
    ];
    for (flag, count) in flags {
        let filter = QueryFilter::from(flag);
        let passes = |(handle, collider): &(ColliderHandle, &Collider)| {
            filter.test(&world.bodies, *handle, collider)
        };
        assert_eq!(world.colliders.iter().filter(passes).count(), count, "{flag:?}");
        let found = queries(&world, filter);
        assert_eq!(found.intersect_point(Vector::X * 0.1).count(), count, "{flag:?}");
    }
}

/// A filter reads the type of a body from its argument, so that it holds before the next step.
#[test]
fn filters_read_the_bodies() {
    let (mut world, [fixed, _]) = two_balls();
    let body = world.colliders[fixed].parent().unwrap();
    world.bodies[body].set_body_type(RigidBodyType::Dynamic, true);
    let collider = &world.colliders[fixed];
    assert!(QueryFilter::only_dynamic().test(&world.bodies, fixed, collider));
    assert!(!QueryFilter::only_fixed().test(&world.bodies, fixed, collider));
}

#[test]
fn iterators_borrow_the_pipeline() {
    let (world, [fixed, dynamic]) = two_balls();
    let pipeline = queries(&world, QueryFilter::default());
    let ray = Ray::new(Vector::ZERO, Vector::X);
    let mut hits: Vec<_> = pipeline.intersect_ray(ray, 100.0, true).map(|hit| hit.0).collect();
    hits.sort_by_key(|handle| handle.into_raw_parts());
    assert_eq!(hits, [fixed, dynamic]);
    let inside: Vec<_> = pipeline.intersect_point(Vector::X * 5.5).map(|hit| hit.0).collect();
    assert_eq!(inside, [fixed]);
    let ball = Ball::new(3.0);
    let pose = Pose::from_translation(Vector::X * 7.5);
    assert_eq!(pipeline.intersect_shape(pose, &ball).count(), 2);
    let only_dynamic = pipeline.with_filter(QueryFilterFlags::ONLY_DYNAMIC.into());
    assert_eq!(only_dynamic.intersect_shape(pose, &ball).count(), 1);
}

/// A ball of radius 0.5 stops when the centers are 1.5 apart.
#[test]
fn shapes_are_cast() {
    let (world, [fixed, _]) = two_balls();
    let pipeline = queries(&world, QueryFilter::default());
    let options = ShapeCastOptions { max_time_of_impact: 10.0, ..ShapeCastOptions::default() };
    let (handle, hit) =
        pipeline.cast_shape(&Pose::IDENTITY, Vector::X * 2.0, &Ball::new(0.5), options).unwrap();
    assert_eq!(handle, fixed);
    assert_near(hit.time_of_impact, 3.5 / 2.0, rounding(500));
    let (handle, projection) = pipeline.project_point(Vector::X, 100.0, true).unwrap();
    assert_eq!(handle, fixed);
    assert_near(projection.point.x, 4.0, rounding(500));
}

/// A character on flat ground moves by its desired translation, and stops in front of a wall.
#[test]
fn characters_move() {
    let mut world = World::default();
    world.colliders.insert(cuboid(50.0, 1.0).translation(Vector::Y * -1.0));
    world.colliders.insert(cuboid(1.0, 5.0).translation(Vector::X * 5.0));
    world.steps(1);
    let controller = KinematicCharacterController::default();
    let pipeline = queries(&world, QueryFilter::default());
    let shape = Ball::new(0.5);
    let start = Pose::from_translation(Vector::Y * 0.51);
    let walk = |distance: Real| {
        let wanted = Vector::X * distance;
        controller.move_shape(1.0 / 60.0, &pipeline, &shape, &start, wanted, |_| {}).translation.x
    };
    assert_near(walk(1.0), 1.0, 0.01);
    // The wall begins at x = 4; the radius is 0.5, and the gap at most 0.1.
    assert_near(walk(10.0), 3.45, 0.06);
}

/// A character pushes a body: the body moves away from it.
#[test]
fn characters_push() {
    let mut world = World::default();
    let body = RigidBodyBuilder::dynamic().translation(Vector::X * 1.2).gravity_scale(0.0);
    let (body, _) = world.insert(body, cuboid(0.5, 0.5));
    world.steps(1);
    let controller = KinematicCharacterController::default();
    let (shape, start) = (Ball::new(0.5), Pose::IDENTITY);
    let mut collisions = Vec::new();
    let pipeline = queries(&world, QueryFilter::default());
    controller.move_shape(0.1, &pipeline, &shape, &start, Vector::X, |hit| collisions.push(hit));
    let dispatcher = world.narrow_phase.query_dispatcher();
    let mut pipeline = world.broad_phase.as_query_pipeline_mut(
        dispatcher,
        &mut world.bodies,
        &mut world.colliders,
        QueryFilter::default(),
    );
    controller.solve_character_collision_impulses(0.1, &mut pipeline, &shape, 10.0, &collisions);
    assert!(world.bodies[body].linvel().x > 0.1);
}
