//! Invalid queries have no result, and do no harm.

use crate::dim::queries::every_shape;
use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::Dice;
use rapier::parry::query::NonlinearRigidMotion;
use rapier::prelude::*;

const BAD: [Real; 3] = [Real::NAN, Real::INFINITY, Real::NEG_INFINITY];

fn block() -> (ColliderSet, QueryPipeline) {
    let mut colliders = ColliderSet::new();
    colliders.insert(cuboid(1.0, 1.0));
    colliders.insert(ColliderBuilder::ball(1.0).translation(vec(3.0, 0.0)));
    let mut queries = QueryPipeline::new();
    queries.update(&colliders);
    (colliders, queries)
}

#[test]
fn rays() {
    let (colliders, queries) = block();
    let cast =
        |ray: Ray, limit| queries.cast_ray(&colliders, &ray, limit, true, QueryFilter::default());
    assert!(cast(Ray::new(vec(-5.0, 0.0), Vector::X), Real::INFINITY).is_some());
    assert!(cast(Ray::new(vec(-5.0, 0.0), Vector::X), Real::MAX).is_some());
    assert!(cast(Ray::new(vec(-5.0, 0.0), Vector::ZERO), 10.0).is_none());
    assert_eq!(cast(Ray::new(vec(0.3, 0.0), Vector::ZERO), 0.0).map(|(_, time)| time), Some(0.0));
    assert!(cast(Ray::new(vec(-5.0, 0.0), Vector::X), -1.0).is_none());
    assert!(cast(Ray::new(vec(-5.0, 0.0), Vector::X), Real::NAN).is_none());
    for bad in BAD {
        assert!(cast(Ray::new(vec(bad, 0.0), Vector::X), 10.0).is_none());
        assert!(cast(Ray::new(vec(-5.0, 0.0), vec(1.0, bad)), 10.0).is_none());
    }
    // Directions have the largest and smallest representable lengths.
    for size in [Real::MAX, 1.0e30, 1.0e-30, Real::MIN_POSITIVE] {
        let hit = cast(Ray::new(vec(-5.0, 0.0), Vector::X * size), Real::MAX);
        let time = hit.map(|(_, time)| time * size);
        let is_representable = 4.0 / size < Real::MAX && 4.0 / size > Real::MIN_POSITIVE;
        let is_right = time.is_some_and(|way| (way - 4.0).abs() < 1.0e-3);
        assert!(is_right || !is_representable, "{time:?} of 4 along {size}");
        cast(Ray::new(vec(-size, 0.0), Vector::X), Real::MAX);
    }
}

/// A ray without a direction is a point: solid shapes that contain it are hit at once, in all queries.
#[test]
fn rays_without_direction_are_points() {
    for (name, shape) in every_shape() {
        let mut colliders = ColliderSet::new();
        let collider = colliders.insert(ColliderBuilder::new(shape));
        let mut queries = QueryPipeline::new();
        queries.update(&colliders);
        let mut dice = Dice(3);
        for _ in 0..200 {
            let mut point = Vector::ZERO;
            (0..DIM).for_each(|axis| point[axis] = dice.within(-1.0, 1.5));
            let ray = Ray::new(point, Vector::ZERO);
            let mut contains = false;
            queries.intersections_with_point(&colliders, point, QueryFilter::default(), |_| {
                contains = true;
                false
            });
            for limit in [0.0, 1.0, Real::INFINITY] {
                let all = QueryFilter::default;
                let hit = queries.cast_ray(&colliders, &ray, limit, true, all());
                assert_eq!(hit, contains.then_some((collider, 0.0)), "{name}: {point}");
                let hit = queries.cast_ray_and_get_normal(&colliders, &ray, limit, true, all());
                assert_eq!(hit.is_some(), contains, "{name}: {point}");
                let hollow = queries.cast_ray(&colliders, &ray, limit, false, all());
                assert_eq!(hollow, None, "{name}: {point}");
            }
        }
    }
}

#[test]
fn points() {
    let (colliders, queries) = block();
    for bad in BAD {
        let point = vec(0.0, bad);
        assert!(queries.project_point(&colliders, &point, true, QueryFilter::default()).is_none());
        let with_feature =
            queries.project_point_and_get_feature(&colliders, &point, QueryFilter::default());
        assert!(with_feature.is_none());
        queries.intersections_with_point(&colliders, point, QueryFilter::default(), |handle| {
            panic!("{handle:?} is at {point}")
        });
    }
    let far = vec(1.0e6, 0.0);
    assert!(queries.project_point(&colliders, &far, true, QueryFilter::default()).is_some());
}

#[test]
fn shapes() {
    let (colliders, queries) = block();
    let shape = cuboid(0.5, 0.5).build();
    let cast = |translation: Vector, velocity: Vector, limit: Real| {
        let pose = Pose::from_translation(translation);
        let filter = QueryFilter::default();
        queries.cast_shape(&colliders, &pose, &velocity, shape.shape(), limit, true, filter)
    };
    let start = vec(-5.0, 0.0);
    assert!(cast(start, Vector::X, Real::INFINITY).is_some());
    assert!(cast(start, Vector::ZERO, Real::INFINITY).is_none());
    assert!(cast(Vector::ZERO, Vector::ZERO, 1.0).is_none(), "it is not on its way");
    let ball = ColliderBuilder::ball(0.5).build();
    let onto_ball = Pose::from_translation(vec(3.0, 0.0));
    let (still, all) = (Vector::ZERO, QueryFilter::default());
    let hit = queries.cast_shape(&colliders, &onto_ball, &still, ball.shape(), 1.0, true, all);
    assert!(hit.is_none(), "nor is a ball");
    assert!(cast(start, Vector::X, -1.0).is_none());
    assert!(cast(start, Vector::X, Real::NAN).is_none());
    for bad in BAD {
        assert!(cast(vec(bad, 0.0), Vector::X, 10.0).is_none());
        assert!(cast(start, vec(1.0, bad), 10.0).is_none());
        let pose = Pose::from_translation(vec(0.0, bad));
        let filter = QueryFilter::default();
        let touching = queries.intersection_with_shape(&colliders, &pose, shape.shape(), filter);
        assert!(touching.is_none());
        let motion = NonlinearRigidMotion::new(pose, Vector::ZERO, Vector::X, Default::default());
        let shape = shape.shape();
        let hit = queries.cast_shape_nonlinear(&colliders, &motion, shape, 0.0, 1.0, true, filter);
        assert!(hit.is_none());
    }
}

#[test]
fn a_pipeline_without_update_finds_nothing() {
    let (colliders, _) = block();
    let queries = QueryPipeline::new();
    let ray = Ray::new(vec(-5.0, 0.0), Vector::X);
    assert!(queries.cast_ray(&colliders, &ray, 10.0, true, QueryFilter::default()).is_none());
}
