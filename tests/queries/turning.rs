//! Rotating shape casts, compared with formulas, and casts with very long rotations.

use super::plain::{ALL, alone};
use crate::dim::{about_z, cuboid, vec};
use rapier::parry::query::{NonlinearRigidMotion, ShapeCastHit, ShapeCastStatus};
use rapier::parry::shape::HalfSpace;
use rapier::prelude::*;

/// Returns a motion from a place, with a rotation about the shape's own middle.
fn motion(at: Vector, velocity: Vector, turn: Real) -> NonlinearRigidMotion {
    NonlinearRigidMotion::new(Pose::from_translation(at), Vector::ZERO, velocity, about_z(turn))
}

/// Returns the first contact of a moving shape with one collider.
fn cast(
    collider: ColliderBuilder,
    shape: &ColliderBuilder,
    motion: &NonlinearRigidMotion,
    [start, end]: [Real; 2],
    at_once: bool,
) -> Option<ShapeCastHit> {
    let (colliders, _, queries) = alone(collider);
    let shape = shape.build();
    let shape = shape.shape();
    let hit = queries.cast_shape_nonlinear(&colliders, motion, shape, start, end, at_once, ALL);
    hit.map(|(_, hit)| hit)
}

/// Half the length of the bar, and half its height.
const BAR: [Real; 2] = [1.0, 0.1];

/// The lowest point of a bar at the angle `φ` is `a |sin φ| + b |cos φ|` below its middle.
#[test]
fn a_tumbling_bar_lands_with_its_lowest_point() {
    let [a, b] = BAR;
    let floors =
        [ColliderBuilder::halfspace(Vector::Y), cuboid(10.0, 1.0).translation(vec(0.0, -1.0))];
    for floor in floors {
        for turn in [0.0, 0.5, -2.0, 7.0, 40.0] {
            let height = |t: Real| {
                let (sin, cos) = (turn * t).sin_cos();
                3.0 - t - a * sin.abs() - b * cos.abs()
            };
            let mut expected = 0.0;
            while height(expected) > 0.0 {
                expected += 1.0e-4;
            }
            let fall = motion(vec(0.5, 3.0), -Vector::Y, turn);
            let hit = cast(floor.clone(), &cuboid(a, b), &fall, [0.0, 5.0], true);
            let hit = hit.expect("the floor is below");
            assert!((hit.time_of_impact - expected).abs() < 1.0e-3, "{hit:?}, not {expected}");
            assert_eq!(hit.status, ShapeCastStatus::Converged);
            let landed = fall.position_at_time(hit.time_of_impact);
            let (point, normal) = (landed * hit.witness2, landed.rotation * hit.normal2);
            assert!(point.y.abs() < 1.0e-2, "it touches the floor at {point}");
            assert!((normal + Vector::Y).length() < 1.0e-2, "it touches the floor along {normal}");
        }
    }
}

/// A half-space that rotates about a point touches a bar, a ball or a mesh with the lowest point above its
/// plane. The same motion, seen from the half-space, has the same time.
#[test]
fn a_rotating_half_space_touches_the_lowest_point() {
    let [a, b] = BAR;
    let corners = [[a, b], [-a, b], [a, -b], [-a, -b]].map(|[x, y]| vec(x, y));
    let corner_mesh = crate::dim::queries::solid_box(0.5);
    let flat = |shape: &ColliderBuilder| shape.build().shared_shape().clone();
    let reach = |corners: &[Vector], down: Vector| {
        corners.iter().map(|corner| corner.dot(down)).fold(Real::MIN, Real::max)
    };
    let bar = |down: Vector| reach(&corners, down);
    let square = [[0.5, 0.5], [-0.5, 0.5], [0.5, -0.5], [-0.5, -0.5]].map(|[x, y]| vec(x, y));
    let cube = |down: Vector| reach(&square, down);
    let ball = |_: Vector| 0.4;
    let shapes: [(SharedShape, &dyn Fn(Vector) -> Real); 3] =
        [(flat(&cuboid(a, b)), &bar), (corner_mesh, &cube), (SharedShape::ball(0.4), &ball)];
    let world = PhysicsWorld::new();
    let query = world.narrow_phase.query_dispatcher();
    let plane = HalfSpace::new(Vector::Y);
    for (shape, lowest) in shapes {
        for turn in [0.3, -1.0, 5.0, 60.0] {
            for (x, rise, fall) in
                [(0.0, 0.0, -1.0), (3.0, 0.2, 0.0), (-20.0, 0.0, 0.5), (2.0, 1.0, -3.0)]
            {
                let still = motion(vec(x, 4.0), Vector::Y * fall, 0.0);
                let turning = motion(Vector::ZERO, Vector::Y * rise, turn);
                let gap = |time: Real| {
                    let (sin, cos) = (turn * time).sin_cos();
                    let normal = vec(-sin, cos);
                    normal.dot(vec(x, 4.0 + (fall - rise) * time)) - lowest(-normal)
                };
                let mut expected = 0.0;
                while gap(expected) > 0.0 && expected < 10.0 {
                    expected += 2.0e-5;
                }
                let hits = [
                    query.cast_shapes_nonlinear(&turning, &plane, &still, &*shape, 0.0, 10.0, true),
                    query.cast_shapes_nonlinear(&still, &*shape, &turning, &plane, 0.0, 10.0, true),
                ];
                for hit in hits {
                    let hit = hit.expect("supports every pair");
                    let time = hit.map_or(10.0, |hit| hit.time_of_impact);
                    assert!(
                        (time - expected).abs() < 1.0e-3,
                        "{turn}, {x}: {hit:?}, not {expected}"
                    );
                    let is_touch = hit.is_none_or(|hit| hit.status == ShapeCastStatus::Converged);
                    assert!(is_touch, "{hit:?}");
                }
            }
        }
    }
}

/// A ball arrives at the same time, whatever its spin; times may be negative.
#[test]
fn the_spin_of_a_ball_has_no_effect() {
    for turn in [0.0, 1.0, 1.0e3, 1.0e6, 1.0e12] {
        let wall = cuboid(1.0, 10.0).translation(vec(6.0, 0.0));
        let fly = motion(Vector::ZERO, Vector::X * 3.0, turn);
        let hit = cast(wall, &ColliderBuilder::ball(0.5), &fly, [-2.0, 10.0], true);
        let time = hit.expect("the wall is in the way").time_of_impact;
        assert!((time - 1.5).abs() < 1.0e-3, "after {time} at {turn} rad/s");
    }
}

/// parry's search does not terminate for some of these motions.
#[test]
fn the_search_terminates_for_long_rotations() {
    let bar = cuboid(BAR[0], BAR[1]);
    let peg = |distance| ColliderBuilder::ball(0.2).translation(vec(0.0, distance));
    for turn in [1.0, 1.0e3, 1.0e6, 1.0e9] {
        for end in [1.0, 1.0e3, 1.0e6] {
            for at_once in [false, true] {
                let spin = |from: Vector, drift| motion(from, Vector::Y * drift, turn);
                let meets = |distance, drift| {
                    let way = spin(Vector::ZERO, drift);
                    cast(peg(distance), &bar, &way, [0.0, end], at_once)
                };
                assert!(meets(1.7, 0.0).is_none(), "out of reach, for ever");
                assert!(meets(1.7, -1.0e-3).is_none(), "out of reach, and ever farther away");
                assert!(turn * end < 2.0 || meets(0.9, 0.0).is_some(), "within reach");
                // For a grazing motion, or one that passes a peg narrowly for a while, either result is
                // acceptable.
                let _ = [meets(1.2049, 0.0), meets(1.21, 1.0e-6), meets(0.31, 1.0e-3)];
            }
        }
    }
}

/// A ball that begins 0.1 deep in a wall hits it at once, or may leave. It leaves outwards at any speed, and
/// inwards until its middle would be inside.
#[test]
fn a_penetrating_start_is_ignored_unless_the_middle_enters() {
    let wall = || cuboid(1.0, 10.0).translation(vec(1.4, 0.0));
    let ball = ColliderBuilder::ball(0.5);
    let go = |velocity: Real, at_once| {
        let way = motion(Vector::ZERO, Vector::X * velocity, 1.0);
        cast(wall(), &ball, &way, [0.0, 10.0], at_once).map(|hit| hit.time_of_impact)
    };
    assert_eq!(go(-1.0, true), Some(0.0));
    assert_eq!(go(1.0, true), Some(0.0));
    assert_eq!(go(-1.0, false), None);
    let time = go(1.0, false).expect("it goes deeper");
    assert!(
        (0.3..0.41).contains(&time),
        "its middle is 0.4 away from the wall, and stopped after {time}"
    );
}

#[test]
fn the_touched_part_is_returned() {
    let part = |x: Real| {
        (Pose::from_translation(vec(x, 0.0)), cuboid(0.5, 0.5).build().shared_shape().clone())
    };
    let parts = ColliderBuilder::compound(vec![part(-3.0), part(3.0)]);
    let fall = |x| motion(vec(x, 5.0), -Vector::Y, 3.0);
    for (x, expected) in [(-3.0, 0), (3.0, 1)] {
        let hit = cast(parts.clone(), &cuboid(0.3, 0.3), &fall(x), [0.0, 9.0], true);
        let hit = hit.expect("a part is below");
        assert_eq!(hit.subshape1, expected);
        assert!((hit.witness1.y - 0.5).abs() < 1.0e-2, "on its upper side: {hit:?}");
    }
    assert!(cast(parts, &cuboid(0.3, 0.3), &fall(0.0), [0.0, 9.0], true).is_none());
}
