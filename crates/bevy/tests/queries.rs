//! Spatial queries that return entities.

use crate::dim::{cube, vector};
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::ecs::system::RunSystemOnce;
use bevy::prelude::*;

/// A row of a cube, a ball and a sensor along x.
fn row() -> (App, [Entity; 3]) {
    let mut app = weightless();
    let cube = app.world_mut().spawn((cube(0.5), at(2.0, 0.0))).id();
    let ball = app.world_mut().spawn((RigidBody::Dynamic, Collider::ball(0.5), at(4.0, 0.0))).id();
    let sensor = app.world_mut().spawn((Collider::ball(0.5), Sensor, at(6.0, 0.0))).id();
    run(&mut app, 2);
    (app, [cube, ball, sensor])
}

/// The result of a query.
fn result_of<T: 'static>(
    app: &mut App,
    query: impl Fn(SpatialQuery) -> T + Send + Sync + 'static,
) -> T {
    app.world_mut()
        .run_system_once(move |world: SpatialQuery| query(world))
        .expect("the system runs")
}

#[test]
fn a_ray_hits_the_first_collider() {
    let (mut app, [cube, ball, sensor]) = row();
    let all = SpatialFilter::default();
    let hit = result_of(&mut app, move |query| {
        query.cast_ray(Vector::ZERO, vector(1.0, 0.0), 100.0, &all)
    });
    let hit = hit.expect("a hit");
    assert_eq!(hit.entity, cube);
    assert_near(hit.distance, 1.5, 1.0e-5);
    assert_near(hit.point.x, 1.5, 1.0e-5);
    assert_near(hit.normal.x, -1.0, 1.0e-5);
    let filter = SpatialFilter::default().excluding(cube);
    let hit = result_of(&mut app, move |query| {
        query.cast_ray(Vector::ZERO, vector(1.0, 0.0), 100.0, &filter)
    });
    assert_eq!(hit.expect("a hit").entity, ball);
    let filter = SpatialFilter::default().excluding(cube).excluding(ball).without_sensors();
    let hit = result_of(&mut app, move |query| {
        query.cast_ray(Vector::ZERO, vector(1.0, 0.0), 100.0, &filter)
    });
    assert_eq!(hit, None);
    let all = SpatialFilter::default();
    let found = result_of(&mut app, move |query| {
        query.intersections_with_ray(Vector::ZERO, vector(1.0, 0.0), 100.0, &all)
    });
    assert_eq!(found.len(), 3);
    assert!([cube, ball, sensor].iter().all(|entity| found.contains(entity)));
}

#[test]
fn a_moving_shape_stops_at_the_first_collider() {
    let (mut app, [cube, ..]) = row();
    let hit = result_of(&mut app, |query| {
        let (shape, all) = (Collider::ball(0.25), SpatialFilter::default());
        query.cast_shape(&shape, &Transform::IDENTITY, vector(10.0, 0.0), &all)
    });
    let hit = hit.expect("a hit");
    assert_eq!(hit.entity, cube);
    assert_near(hit.distance, 0.125, 1.0e-4);
    assert_near(hit.point.x, 1.5, 1.0e-3);
    assert_near(hit.normal.x, -1.0, 1.0e-3);
}

#[test]
fn points_and_shapes_find_colliders_around_them() {
    let (mut app, [cube, ball, _]) = row();
    let near = result_of(&mut app, |query| {
        query.project_point(vector(2.0, 2.0), 100.0, &SpatialFilter::default())
    });
    let near = near.expect("a collider");
    assert_eq!((near.entity, near.is_inside), (cube, false));
    assert_near(near.point.y, 0.5, 1.0e-5);
    let inside = result_of(&mut app, |query| {
        query.intersections_with_point(vector(4.1, 0.0), &SpatialFilter::default())
    });
    assert_eq!(inside, [ball]);
    let touched = result_of(&mut app, |query| {
        let (shape, all) = (Collider::ball(1.0), SpatialFilter::default());
        query.intersections_with_shape(&shape, &at(3.0, 0.0), &all)
    });
    assert_eq!(touched.len(), 2);
    assert!(touched.contains(&cube) && touched.contains(&ball));
}

#[test]
fn groups_and_bodies_filter_queries() {
    let mut app = weightless();
    let body = app.world_mut().spawn((RigidBody::Dynamic, at(2.0, 0.0))).id();
    let groups = CollisionGroups::new(Group::GROUP_3, Group::ALL);
    let part = app.world_mut().spawn((cube(0.5), groups, ChildOf(body))).id();
    run(&mut app, 2);
    let filters = [
        (SpatialFilter::default(), true),
        (SpatialFilter::default().excluding(body), false),
        (SpatialFilter::default().excluding(part), false),
        (
            SpatialFilter::default()
                .with_groups(InteractionGroups::all().with_filter(Group::GROUP_3)),
            true,
        ),
        (
            SpatialFilter::default()
                .with_groups(InteractionGroups::all().with_filter(Group::GROUP_4)),
            false,
        ),
    ];
    for (filter, expected) in filters {
        let found = result_of(&mut app, move |query| {
            query.intersections_with_point(vector(2.0, 0.0), &filter)
        });
        assert_eq!(found.contains(&part), expected);
    }
}

#[test]
fn an_invalid_shape_finds_nothing() {
    let (mut app, _) = row();
    let (hit, touched) = result_of(&mut app, |query| {
        let (shape, all) = (Collider::ball(-1.0), SpatialFilter::default());
        let hit = query.cast_shape(&shape, &at(0.0, 0.0), vector(10.0, 0.0), &all);
        (hit, query.intersections_with_shape(&shape, &at(2.0, 0.0), &all))
    });
    assert_eq!(hit, None);
    assert!(touched.is_empty());
}

#[test]
fn a_collider_without_entity_hides_nothing() {
    let (mut app, [cube, ..]) = row();
    let raw = crate::dim::engine_cube(0.25).translation(crate::dim::engine_vector(1.0, 0.0));
    app.world_mut().resource_mut::<PhysicsWorld>().engine.insert_collider(raw, None);
    run(&mut app, 2);
    let found = result_of(&mut app, |query| {
        let all = SpatialFilter::default();
        let ray = query.cast_ray(Vector::ZERO, vector(1.0, 0.0), 9.0, &all).map(|hit| hit.entity);
        let ball = Collider::ball(0.1);
        let path = vector(9.0, 0.0);
        let shape = query.cast_shape(&ball, &Transform::IDENTITY, path, &all);
        let point = query.project_point(vector(1.0, 0.0), 9.0, &all).map(|hit| hit.entity);
        [ray, shape.map(|hit| hit.entity), point]
    });
    assert_eq!(found, [Some(cube); 3]);
}
