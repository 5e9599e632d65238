//! The sides of a cast's hit: side 1 is the collider in world space, side 2 the cast shape in its own frame.

use super::plain::{ALL, alone};
use crate::dim::{about_z, assortment, vec};
use crate::suite::physics::stage::Dice;
use rapier::parry::query::{NonlinearRigidMotion, ShapeCastHit};
use rapier::prelude::*;

/// Number of casts of each pair of shapes.
const CASTS: usize = 12;

/// Returns a pose at this place, rotated by a random angle about the axis out of the plane.
fn posed(dice: &mut Dice, at: Vector) -> Pose {
    let body = RigidBodyBuilder::fixed().translation(at);
    *body.rotation(about_z(dice.within(-3.0, 3.0))).build().position()
}

/// Panics unless the hit lies on both surfaces, with opposite normals, and the collider's normal points
/// against the motion.
#[track_caller]
fn check(hit: &ShapeCastHit, collider: &Collider, shape: &dyn Shape, landed: &Pose, way: Vector) {
    // parry's search of curved shapes ends within some thousandths of their size. An exchange of sides or
    // frames would give errors of metres.
    let tolerance = 2.0e-2;
    // Points outside are checked as well: parry's projections of points on the surface of a polygon are
    // unreliable.
    let off = |shape: &dyn Shape, pose: &Pose, point: Vector, normal: Vector| {
        let from = |height: Real| shape.project_point(pose, point + normal * height, false).point;
        from(0.0).distance(point).min(from(0.1).distance(point))
    };
    let off1 = off(collider.shape(), collider.position(), hit.witness1, hit.normal1);
    let off2 = off(shape, &Pose::IDENTITY, hit.witness2, hit.normal2);
    assert!(
        off1 < tolerance,
        "witness1 is {off1} off {:?}: {hit:?}",
        collider.shape().shape_type()
    );
    assert!(off2 < tolerance, "witness2 is {off2} off {:?}: {hit:?}", shape.shape_type());
    let met = landed * hit.witness2;
    assert!(met.distance(hit.witness1) < tolerance, "{met} is not {}: {hit:?}", hit.witness1);
    let normal = landed.rotation * hit.normal2;
    assert!((normal + hit.normal1).length() < 5.0e-2, "{normal} is not -{}", hit.normal1);
    assert!(hit.normal1.dot(way) < 5.0e-2 * way.length(), "{} along {way}", hit.normal1);
}

#[test]
fn the_collider_is_side_1_in_world_space() {
    let mut dice = Dice(7);
    let mut hits = 0;
    for collider in assortment() {
        for shape in assortment() {
            let shape = shape.build();
            for _ in 0..CASTS {
                let pose = posed(&mut dice, vec(2.0, 1.0));
                let (colliders, handle, queries) = alone(collider.clone().position(pose));
                let start = vec(dice.within(-9.0, 12.0), 8.0);
                let from = posed(&mut dice, start);
                let aside = dice.within(-0.3, 0.3);
                let way = vec(2.0 - start.x + aside, -7.0) * 0.5;
                let hit =
                    queries.cast_shape(&colliders, &from, &way, shape.shape(), 5.0, true, ALL);
                let Some((_, hit)) = hit else { continue };
                hits += 1;
                let mut landed = from;
                landed.translation += way * hit.time_of_impact;
                check(&hit, &colliders[handle], shape.shape(), &landed, way);
                let motion = NonlinearRigidMotion::new(from, Vector::ZERO, way, about_z(0.0));
                let nonlinear = queries.cast_shape_nonlinear(
                    &colliders,
                    &motion,
                    shape.shape(),
                    0.0,
                    5.0,
                    true,
                    ALL,
                );
                let Some((_, hit)) = nonlinear else { continue };
                let landed = motion.position_at_time(hit.time_of_impact);
                check(&hit, &colliders[handle], shape.shape(), &landed, way);
            }
        }
    }
    println!("{hits} casts hit");
    assert!(hits > 200, "{hits}");
}
