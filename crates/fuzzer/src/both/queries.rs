//! Queries of the world, whether or not a step followed the last edit.

use super::dim::{SHAPES, shape, spin};
use super::play::Play;
use super::rapier::parry::query::NonlinearRigidMotion;
use super::rapier::prelude::*;
use super::values::{some_pose, some_positive, some_real, some_vector};
use crate::choices::Choices;

/// Runs a random query.
pub fn query(play: &mut Play<'_>) {
    let (collider, body) = (play.collider(), play.body());
    let Play { choices, world, queries, .. } = play;
    let is_enabled = |_: ColliderHandle, collider: &Collider| collider.is_enabled();
    let mut filter =
        QueryFilter::from(QueryFilterFlags::from_bits_truncate(choices.below(64) as u32));
    match choices.below(6) {
        0 => filter = filter.exclude_collider(collider),
        1 => filter = filter.exclude_rigid_body(body),
        2 => filter = filter.predicate(&is_enabled),
        3 => filter = filter.groups(InteractionGroups::new(Group::GROUP_1, Group::GROUP_2)),
        _ => {}
    }
    let own = choices.once_in(4);
    if own {
        queries.update(&world.colliders);
    }
    let view = if own {
        queries.view(&world.colliders, filter)
    } else {
        world.query_pipeline_with_filter(filter)
    };
    match choices.below(4) {
        0 => cast_rays(view, choices),
        1 => query_regions(view, choices),
        2 => cast_shape(view, choices),
        _ => query_pairs(world, collider, choices),
    }
}

fn cast_rays(view: QueryView<'_>, choices: &mut Choices<'_>) {
    let ray = Ray::new(some_vector(choices, 5.0), some_vector(choices, 2.0));
    let (reach, solid) = (10.0 * some_real(choices), choices.coin());
    let first = view.cast_ray(&ray, reach, solid);
    assert!(first.is_none_or(|(_, time)| time.is_finite()), "{ray:?} takes {first:?}");
    view.cast_ray_and_get_normal(&ray, reach, solid);
    view.cast_rays(&[ray; 3], reach, solid);
    view.intersect_ray(ray, reach, solid).for_each(drop);
}

fn query_regions(view: QueryView<'_>, choices: &mut Choices<'_>) {
    let (point, reach) = (some_vector(choices, 5.0), 10.0 * some_real(choices));
    view.project_point(point, reach, choices.coin());
    view.project_point_and_get_feature(point, reach);
    view.intersect_point(point).for_each(drop);
    let (mins, maxs) = (some_vector(choices, 5.0), some_vector(choices, 5.0));
    view.intersect_aabb_conservative(Aabb { mins, maxs }).for_each(drop);
}

/// Returns a valid shape. Constructors reject invalid ones.
pub fn some_shape(choices: &mut Choices<'_>) -> Option<SharedShape> {
    let kind = choices.below(SHAPES);
    let size = if choices.once_in(50) { some_positive(choices) } else { 0.5 };
    let collider = shape(kind, size, choices)?.try_build().ok()?;
    Some(collider.shared_shape().clone())
}

fn cast_shape(view: QueryView<'_>, choices: &mut Choices<'_>) {
    let Some(shape) = some_shape(choices) else { return };
    let (pose, velocity) = (some_pose(choices, 4.0), some_vector(choices, 5.0));
    let (from, to) = (some_real(choices), some_real(choices));
    let options = ShapeCastOptions {
        max_time_of_impact: to,
        target_distance: if choices.once_in(4) { from } else { 0.0 },
        stop_at_penetration: choices.coin(),
        ..ShapeCastOptions::default()
    };
    view.cast_shape(&pose, velocity, &*shape, options);
    view.intersect_shape(pose, &*shape).for_each(drop);
    let motion = NonlinearRigidMotion::new(pose, Vector::ZERO, velocity, spin(choices));
    view.cast_shape_nonlinear(&motion, &*shape, from, to, choices.coin());
}

fn query_pairs(world: &PhysicsWorld, collider: ColliderHandle, choices: &mut Choices<'_>) {
    world.contact_pairs_with(collider).for_each(drop);
    world.intersection_pairs_with(collider).for_each(drop);
    let dt = some_real(choices);
    for (handle, body) in world.bodies.iter() {
        body.kinetic_energy();
        body.gravitational_potential_energy(dt, world.gravity);
        body.predict_position_using_velocity_and_forces(dt);
        world.impulse_joints_with(handle).for_each(drop);
        world.multibody_joints_with(handle).for_each(drop);
    }
    for (_, collider) in world.colliders.iter() {
        collider.compute_aabb();
        collider.compute_swept_aabb(collider.position());
        collider.mass_properties();
    }
}
