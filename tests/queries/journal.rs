//! Updates: every reader gets all changes at once.

use crate::dim::{cuboid, vec};
use rapier::prelude::*;

fn box_at(x: Real) -> ColliderBuilder {
    cuboid(0.5, 0.5).translation(vec(x, 0.0))
}

/// Returns the hit of a ray from the left.
fn hit(queries: &QueryPipeline, colliders: &ColliderSet) -> Option<ColliderHandle> {
    let ray = Ray::new(vec(-10.0, 0.0), Vector::X);
    let hit = queries.cast_ray(colliders, &ray, 100.0, true, QueryFilter::default());
    hit.map(|(handle, _)| handle)
}

#[test]
fn every_kind_of_edit_takes_effect_after_an_update() {
    let (mut bodies, mut islands) = (RigidBodySet::new(), IslandManager::new());
    let mut colliders = ColliderSet::new();
    let mut queries = QueryPipeline::new();
    queries.update(&colliders);
    assert_eq!(hit(&queries, &colliders), None);

    let far = colliders.insert(box_at(5.0));
    queries.update(&colliders);
    assert_eq!(hit(&queries, &colliders), Some(far));

    let near = colliders.insert(box_at(2.0));
    queries.update(&colliders);
    assert_eq!(hit(&queries, &colliders), Some(near));

    // There are two edits with an update in between, and none is lost.
    colliders[near].set_translation(vec(8.0, 0.0));
    queries.update(&colliders);
    assert_eq!(hit(&queries, &colliders), Some(far));
    colliders[near].set_translation(vec(-2.0, 0.0));
    queries.update(&colliders);
    assert_eq!(hit(&queries, &colliders), Some(near));

    colliders[near].set_enabled(false);
    queries.update(&colliders);
    assert_eq!(hit(&queries, &colliders), Some(far));
    colliders[near].set_enabled(true);
    queries.update(&colliders);
    assert_eq!(hit(&queries, &colliders), Some(near));

    colliders.remove(near, &mut islands, &mut bodies, true);
    assert_eq!(hit(&queries, &colliders), Some(far), "a collider that is gone is not found");
    queries.update(&colliders);
    assert_eq!(hit(&queries, &colliders), Some(far));

    colliders[far].set_shape(SharedShape::ball(1.0));
    colliders[far].set_translation(vec(5.0, 0.9));
    queries.update(&colliders);
    assert_eq!(hit(&queries, &colliders), Some(far));
}

#[test]
fn two_readers_get_all_changes() {
    let mut colliders = ColliderSet::new();
    let (mut first, mut second) = (QueryPipeline::new(), QueryPipeline::new());
    let collider = colliders.insert(box_at(0.0));
    first.update(&colliders);
    second.update(&colliders);
    colliders[collider].set_translation(vec(0.0, 50.0));
    first.update(&colliders);
    assert_eq!(hit(&first, &colliders), None);
    colliders[collider].set_translation(vec(3.0, 0.0));
    second.update(&colliders);
    assert_eq!(hit(&second, &colliders), Some(collider));
}

#[test]
fn another_set_is_read_completely() {
    let mut one = ColliderSet::new();
    one.insert(box_at(0.0));
    let mut queries = QueryPipeline::new();
    queries.update(&one);
    let mut copy = one.clone();
    let added = copy.insert(box_at(-3.0));
    queries.update(&copy);
    assert_eq!(hit(&queries, &copy), Some(added));
    queries.update(&one);
    assert_ne!(hit(&queries, &one), Some(added));
}

/// The user moves a collider, and steps then move it within its box.
#[test]
fn a_moved_collider_is_found_after_further_motion() {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let body = RigidBodyBuilder::dynamic().linvel(vec(0.0, -1.0));
    let (body, collider) = world.insert(body, cuboid(0.5, 0.5));
    world.step();
    world.bodies[body].set_translation(vec(0.02, 30.0), true);
    let mut queries = QueryPipeline::new();
    for _ in 0..4 * 60 {
        world.step();
        queries.update(&world.colliders);
        let position = world.bodies[body].translation();
        for edge in [-0.499, 0.499] {
            let ray = Ray::new(vec(-10.0, position.y + edge), Vector::X);
            let found =
                queries.cast_ray(&world.colliders, &ray, 100.0, true, QueryFilter::default());
            assert_eq!(found.map(|(handle, _)| handle), Some(collider));
        }
    }
}

#[test]
fn boxes_are_found_without_the_collider_set() {
    let mut colliders = ColliderSet::new();
    let near = colliders.insert(box_at(0.0));
    let sensor = colliders.insert(box_at(1.0).sensor(true));
    colliders.insert(box_at(20.0));
    let mut queries = QueryPipeline::new();
    queries.update(&colliders);
    let region = Aabb::from_half_extents(Vector::ZERO, Vector::splat(3.0));
    let mut found = Vec::new();
    let note = |handle| {
        found.push(handle);
        true
    };
    queries.colliders_with_aabb_intersecting_aabb(&region, QueryFilter::default(), note);
    found.sort_unstable_by_key(|handle| handle.into_raw_parts());
    assert_eq!(found, [near, sensor]);
    let mut solid = Vec::new();
    let filter = QueryFilter::default().exclude_sensors();
    queries.colliders_with_aabb_intersecting_aabb(&region, filter, |handle| {
        solid.push(handle);
        false
    });
    assert_eq!(solid, [near]);
}

/// A body moves its collider far beyond the limits of the world and back again.
#[test]
fn a_collider_is_found_after_its_return_into_the_world() {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let (_, collider) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
    let mut queries = QueryPipeline::new();
    world.step();
    queries.update(&world.colliders);
    world.colliders[collider].set_position(Pose::from_translation(vec(2.0e10, 0.0)));
    queries.update(&world.colliders);
    world.step();
    queries.update(&world.colliders);
    assert_eq!(hit(&queries, &world.colliders), Some(collider));
}
