//! Balls on hulls: where the closest point is, against all pieces of the surface.

use super::manifolds;
use crate::base::random::Random;
use crate::dim::collide::samples;
use crate::dim::math::{Pose, Real, Vector};
use parry::query::PointQuery;
use parry::shape::{Ball, SharedShape};

/// Faces of parry's hulls that are nearly one are made one, with a normal that may be off by this (rad).
const TILT: Real = 2.0e-2;

/// Thin hulls have faces that are far from flat: a ball that is deep in one must not be missed.
#[test]
fn a_ball_touches_a_thin_hull() {
    let mut random = Random(32);
    let mut deep = 0;
    for round in 0..3_000 {
        let thickness = [0.1, 0.03, 0.01][round % 3];
        let flatten = |point: Vector| point * Vector::ONE.with_y(thickness);
        let points: Vec<_> =
            (0..8 + round % 40).map(|_| flatten(samples::vector(&mut random, 1.0))).collect();
        let Some(hull) = SharedShape::convex_hull(&points) else { continue };
        let center =
            flatten(samples::vector(&mut random, 1.0)) + Vector::Y * random.within(0.0, 0.3);
        let ball = Ball::new(random.within(0.05, 0.3));
        let surface = samples::surface(&*hull);
        let from = |point| {
            let distances = surface.iter().map(|piece| piece.distance_to_local_point(point, true));
            distances.fold(Real::INFINITY, Real::min)
        };
        let dist = from(center) - ball.radius;
        if dist < -TILT {
            let (found, _) = manifolds(&Pose::from_translation(center), &*hull, &ball, 0.02);
            // Inside the hull it may be deeper than its surface is near.
            let contact = found[0].contacts()[0];
            assert!(contact.dist < dist + TILT, "{round}: {} instead of {dist}", contact.dist);
            deep += 1;
        }
    }
    assert!(deep > 500, "{deep}");
}

#[test]
fn a_ball_touches_a_hull_where_it_is_closest() {
    let mut random = Random(31);
    let (mut inside, mut outside) = (0, 0);
    for round in 0..3_000 {
        let Some(hull) = samples::hull(&mut random, 1.0) else { continue };
        let center = samples::vector(&mut random, 1.5);
        let ball = Ball::new(random.within(0.5, 1.0));
        let surface = samples::surface(&*hull);
        let middle = surface.iter().map(|piece| piece.a).sum::<Vector>() / surface.len() as Real;
        let is_inside = surface.iter().filter_map(|piece| Some((piece.a, piece.normal()?))).all(
            |(corner, normal)| normal.dot(center - corner) * normal.dot(middle - corner) > 0.0,
        );
        let from = |point| {
            let distances = surface.iter().map(|piece| piece.distance_to_local_point(point, true));
            distances.fold(Real::INFINITY, Real::min)
        };
        let dist = if is_inside { -from(center) } else { from(center) } - ball.radius;
        let (found, bound) = manifolds(&Pose::from_translation(center), &*hull, &ball, 0.02);
        if dist > 0.02 + TILT {
            assert!(found.is_empty() && bound > 0.0 && bound < dist + TILT, "round {round}");
        } else if dist < 0.02 - TILT {
            let contact = found[0].contacts()[0];
            assert!((contact.dist - dist).abs() < TILT, "{round}: {} {dist}", contact.dist);
            assert!(from(contact.local_p1) < TILT, "{round}: {}", from(contact.local_p1));
            let apart = (contact.local_p1 - center).dot(-found[0].local_n1);
            assert!((apart - ball.radius - contact.dist).abs() < 1.0e-4, "round {round}");
        }
        inside += i32::from(is_inside);
        outside += i32::from(!is_inside && dist < 0.0);
    }
    assert!(inside > 150 && outside > 500, "{inside} inside, {outside} outside");
}
