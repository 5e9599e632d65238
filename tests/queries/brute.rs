//! A hundred thousand queries, each answered twice: by the trees, and by a search of all colliders.
//!
//! Points and casts are compared to the last bit. For some shapes, parry's rays use other formulas than the
//! engine's, so times are compared within its tolerance. A test in `src/query/tests.rs` checks that
//! trees change no bit of rays.

use crate::dim::{about_z, assortment, vec};
use crate::suite::physics::stage::{Dice, world};
use rapier::prelude::*;

const COLLIDERS: usize = 2000;
const EDITS: usize = 500;
/// Half the size of the region that contains all colliders.
const REGION: Real = 20.0;

/// Numbers of queries of each kind, before and after the edits: a hundred thousand in all.
const RAYS: usize = 30_000;
const POINTS: usize = 15_000;
const CASTS: usize = 5_000;

fn place(dice: &mut Dice) -> Pose {
    let mut translation = Vector::ZERO;
    for axis in 0..DIM {
        translation[axis] = dice.within(-REGION, REGION);
    }
    let body = RigidBodyBuilder::fixed().translation(translation);
    *body.rotation(about_z(dice.within(-3.0, 3.0))).build().position()
}

fn direction(dice: &mut Dice) -> Vector {
    let mut direction = Vector::ZERO;
    for axis in 0..DIM {
        direction[axis] = dice.within(-1.0, 1.0);
    }
    // Some directions are along an axis.
    if dice.within(0.0, 1.0) < 0.1 { Vector::X } else { direction }
}

/// Returns colliders of all kinds, some with bodies of all kinds, some of them sensors.
fn crowd(dice: &mut Dice) -> PhysicsWorld {
    let mut world = world(60);
    let mut shapes = assortment();
    let parts = [0.0, 0.5].map(|x: Real| {
        let part = shapes[0].build();
        (Pose::from_translation(vec(x, 0.3 * x)), part.shared_shape().clone())
    });
    shapes.push(ColliderBuilder::compound(parts.to_vec()));
    for index in 0..COLLIDERS {
        let collider = shapes[index % shapes.len()].clone().sensor(index % 7 == 0);
        let pose = place(dice);
        let body = match index % 4 {
            0 => {
                world.insert_collider(collider.position(pose), None);
                continue;
            }
            1 => RigidBodyBuilder::fixed(),
            2 => RigidBodyBuilder::kinematic_velocity_based().linvel(direction(dice)),
            _ => RigidBodyBuilder::dynamic().linvel(direction(dice) * 5.0).gravity_scale(0.0),
        };
        world.insert(body.pose(pose), collider);
    }
    let ground = ColliderBuilder::halfspace(Vector::Y);
    world.insert_collider(ground.translation(vec(0.0, -REGION - 5.0)), None);
    world
}

/// Edits the sets like a user, without a step afterwards.
fn edit(world: &mut PhysicsWorld, dice: &mut Dice) {
    let shapes = assortment();
    for _ in 0..EDITS {
        let handles: Vec<_> = world.colliders.iter().map(|(handle, _)| handle).collect();
        let pick =
            |dice: &mut Dice| handles[dice.within(0.0, handles.len() as Real - 1.0) as usize];
        let (handle, pose) = (pick(dice), place(dice));
        match dice.within(0.0, 5.0) as usize {
            0 => drop(world.remove_collider(handle)),
            1 => world.colliders[handle].set_position(pose),
            2 => {
                let other = world.colliders[pick(dice)].shared_shape().clone();
                world.colliders[handle].set_shape(other);
            }
            3 => {
                let enabled = world.colliders[handle].is_enabled();
                world.colliders[handle].set_enabled(!enabled);
            }
            _ => drop(world.insert_collider(shapes[0].clone().position(pose), None)),
        }
    }
}

/// Returns the nearest hit of all colliders; of equal ones, that of the lowest slot.
fn first<T>(
    colliders: &ColliderSet,
    filter: QueryFilter<'_>,
    test: impl Fn(&Collider) -> Option<(Real, T)>,
) -> Option<(ColliderHandle, Real)> {
    let mut best: Option<(ColliderHandle, Real)> = None;
    for (handle, collider) in colliders.iter_enabled() {
        if !filter.test(handle, collider) {
            continue;
        }
        if let Some((distance, _)) = test(collider)
            && best.is_none_or(|(_, nearest)| distance < nearest)
        {
            best = Some((handle, distance));
        }
    }
    best
}

fn filters<'a>(index: usize) -> QueryFilter<'a> {
    match index % 6 {
        0 => QueryFilter::default().exclude_sensors(),
        1 => QueryFilter::default().only_dynamic(),
        2 => QueryFilter::default().exclude_fixed().exclude_solids(),
        3 => QueryFilter::default().predicate(&|handle, _| handle.into_raw_parts().0 % 3 != 0),
        _ => QueryFilter::default(),
    }
}

/// Returns parry's time of impact under conditions that make it exact. The ray starts nearby, because parry's
/// rays lose digits over distance. Its direction has unit length, which parry's exits from hollow shapes
/// require. Hollow shapes also request the normal, because without it parry takes the limit for the wall of a
/// box.
fn time_of_impact(collider: &Collider, ray: &Ray, limit: Real, solid: bool) -> Option<Real> {
    let (shape, pose, length) = (collider.shape(), collider.position(), ray.dir.length());
    let unit = ray.dir / length;
    let around = shape.compute_bounding_sphere(pose);
    let start = ((around.center - ray.origin).dot(unit) - 2.0 * around.radius).max(0.0);
    let near = Ray::new(ray.origin + unit * start, unit);
    let limit = limit * length - start;
    let time = if limit < 0.0 {
        None
    } else if solid {
        shape.cast_ray(pose, &near, limit, true)
    } else {
        shape.cast_ray_and_get_normal(pose, &near, limit, false).map(|hit| hit.time_of_impact)
    };
    time.map(|time| (time + start) / length)
}

/// Returns whether two first hits are equal within rounding. Each shape is then hit at about the other's
/// time.
fn agree(
    [found, expected]: [Option<(ColliderHandle, Real)>; 2],
    (ray, limit): (&Ray, Real),
    time_of: impl Fn(ColliderHandle) -> Option<Real>,
) -> bool {
    // parry's search for the first point of a hull ends at this distance, relative to the size of numbers
    // (here up to 40).
    let tolerance = 2.0e-3 / ray.dir.length();
    match (found, expected) {
        (None, None) => true,
        (Some((handle, time)), Some((_, nearest))) => {
            (time - nearest).abs() <= tolerance
                && time_of(handle).is_some_and(|time| time - nearest <= tolerance)
        }
        (Some((_, time)), None) | (None, Some((_, time))) => time >= limit - tolerance,
    }
}

fn compare_rays(view: QueryView<'_>, dice: &mut Dice) -> usize {
    let (colliders, mut hits) = (view.colliders, 0);
    for index in 0..RAYS {
        let ray = Ray::new(place(dice).translation, direction(dice));
        let (limit, solid) = (dice.within(0.0, 40.0), index % 2 == 0);
        let filter = filters(index);
        let expected = first(colliders, filter, |collider| {
            Some((time_of_impact(collider, &ray, limit, solid)?, ()))
        });
        let found = view.with_filter(filter).cast_ray(&ray, limit, solid);
        let time_of = |handle| time_of_impact(&colliders[handle], &ray, limit + 1.0, solid);
        assert!(
            agree([found, expected], (&ray, limit), time_of),
            "{found:?} but {expected:?}: {ray:?} up to {limit}, {filter:?}"
        );
        let with_normal = view.with_filter(filter).cast_ray_and_get_normal(&ray, limit, solid);
        assert_eq!(with_normal.is_some(), found.is_some());
        hits += usize::from(found.is_some());
        if index % 100 == 0 {
            let all = view.with_filter(filter).intersect_ray(ray, limit, solid);
            let mut all: Vec<_> = all.map(|(handle, ..)| handle).collect();
            all.sort_unstable_by_key(|handle| handle.into_raw_parts());
            let every = colliders.iter_enabled().filter(|&(handle, collider)| {
                let hit = time_of_impact(collider, &ray, limit, solid);
                filter.test(handle, collider) && hit.is_some()
            });
            assert_eq!(all, every.map(|(handle, _)| handle).collect::<Vec<_>>());
        }
    }
    hits
}

fn compare_points(view: QueryView<'_>, dice: &mut Dice) -> usize {
    let (colliders, mut hits) = (view.colliders, 0);
    for index in 0..POINTS {
        let point = place(dice).translation;
        let (limit, solid) = (dice.within(0.0, 4.0), index % 2 == 0);
        let filter = filters(index);
        let expected = first(colliders, filter, |collider| {
            let found = collider.shape().project_point(collider.position(), point, solid);
            let distance = found.point.distance(point);
            (distance <= limit).then_some((distance, ()))
        });
        let found = view.with_filter(filter).project_point(point, limit, solid);
        let found = found.map(|(handle, projection)| (handle, projection.point.distance(point)));
        assert_eq!(found, expected, "{point} up to {limit}, {filter:?}");
        let around = view.with_filter(filter).intersect_point(point);
        let mut around: Vec<_> = around.map(|(handle, _)| handle).collect();
        around.sort_unstable_by_key(|handle| handle.into_raw_parts());
        let every = colliders.iter_enabled().filter(|&(handle, collider)| {
            filter.test(handle, collider)
                && collider.shape().contains_point(collider.position(), point)
        });
        assert_eq!(around, every.map(|(handle, _)| handle).collect::<Vec<_>>());
        hits += usize::from(found.is_some());
    }
    hits
}

fn compare_casts(view: QueryView<'_>, dice: &mut Dice) -> usize {
    let shapes: Vec<_> = assortment().iter().map(ColliderBuilder::build).collect();
    let (colliders, mut hits) = (view.colliders, 0);
    for index in 0..CASTS {
        let shape = shapes[index % shapes.len()].shape();
        let (pose, velocity) = (place(dice), direction(dice));
        let options = ShapeCastOptions {
            max_time_of_impact: dice.within(0.0, 20.0),
            target_distance: if index % 3 == 0 { 0.1 } else { 0.0 },
            stop_at_penetration: index % 2 == 0,
            ..ShapeCastOptions::default()
        };
        let filter = filters(index);
        let expected = first(colliders, filter, |collider| {
            let pose12 = pose.inv_mul(collider.position());
            let velocity12 = pose.rotation.inverse() * -velocity;
            let other = collider.shape();
            let hit = view.dispatcher.cast_shapes(&pose12, velocity12, shape, other, options);
            hit.ok().flatten().map(|hit| (hit.time_of_impact, ()))
        });
        let found = view.with_filter(filter).cast_shape(&pose, velocity, shape, options);
        let found = found.map(|(handle, hit)| (handle, hit.time_of_impact));
        assert_eq!(found, expected, "{pose:?} at {velocity}, {options:?}, {filter:?}");
        hits += usize::from(found.is_some());
    }
    hits
}

/// Compares all queries. The test fails if all or no queries have hits, because it would then prove little.
fn compare(view: QueryView<'_>, dice: &mut Dice) {
    for (what, count, hits) in [
        ("rays", RAYS, compare_rays(view, dice)),
        ("points", POINTS, compare_points(view, dice)),
        ("casts", CASTS, compare_casts(view, dice)),
    ] {
        println!("{count} {what}: {hits} hits");
        assert!(hits > count / 20 && hits < count - count / 20, "{hits} of {count} {what} hit");
    }
}

#[test]
fn results_agree_with_a_search_of_all_colliders() {
    let mut dice = Dice(31);
    let mut world = crowd(&mut dice);
    let mut queries = QueryPipeline::new();
    queries.update(&world.colliders);
    compare(queries.view(&world.colliders, QueryFilter::default()), &mut dice);
    for _ in 0..10 {
        world.step();
    }
    edit(&mut world, &mut dice);
    queries.update(&world.colliders);
    compare(queries.view(&world.colliders, QueryFilter::default()), &mut dice);
}

/// Bodies move within and out of their boxes, step by step; the trees get some of the updates.
#[test]
fn results_follow_moving_bodies() {
    let mut dice = Dice(32);
    let mut world = crowd(&mut dice);
    let mut queries = QueryPipeline::new();
    for step in 0..60 {
        world.step();
        if step % 3 == 0 {
            queries.update(&world.colliders);
            let own = queries.view(&world.colliders, QueryFilter::default());
            let shared = world.broad_phase.as_query_pipeline(
                world.narrow_phase.query_dispatcher(),
                &world.bodies,
                &world.colliders,
                QueryFilter::default(),
            );
            for _ in 0..20 {
                let ray = Ray::new(place(&mut dice).translation, direction(&mut dice));
                let expected = first(&world.colliders, QueryFilter::default(), |collider| {
                    let time = collider.shape().cast_ray(collider.position(), &ray, 40.0, true)?;
                    Some((time, ()))
                });
                let found = own.cast_ray(&ray, 40.0, true);
                let time_of = |handle| time_of_impact(&world.colliders[handle], &ray, 40.0, true);
                assert!(
                    agree([found, expected], (&ray, 40.0), time_of),
                    "{found:?} but {expected:?}"
                );
                assert_eq!(shared.cast_ray(&ray, 40.0, true), found);
            }
        }
    }
}

/// Batches of rays, on any number of threads, have the results of single rays.
#[test]
fn batches_equal_single_rays() {
    let mut dice = Dice(33);
    let world = crowd(&mut dice);
    let mut queries = QueryPipeline::new();
    queries.update(&world.colliders);
    let rays: Vec<_> =
        (0..2000).map(|_| Ray::new(place(&mut dice).translation, direction(&mut dice))).collect();
    for index in 0..6 {
        let filter = filters(index);
        let together = queries.cast_rays(&world.colliders, &rays, 20.0, true, filter);
        let alone =
            rays.iter().map(|ray| queries.cast_ray(&world.colliders, ray, 20.0, true, filter));
        assert_eq!(together, alone.collect::<Vec<_>>());
    }
}
