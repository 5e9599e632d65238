//! Rays rotate about a mast, and dots mark their ends.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, add_fixed, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "laser_scanner",
    description: "A fan of 48 rays turns about a mast; a dot marks the point that each ray hits.",
    category: Category::Queries,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of rays, and their length.
const RAYS: usize = 48;
const REACH: Real = 14.0;
/// Height of the rays, and their angular velocity (rad per step).
const HEIGHT: Real = 0.6;
const TURN: Real = 0.012;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(40.0);
    let mut dice = Dice::new(11);
    for _ in 0..40 {
        let angle = dice.between(0.0, 2.0 * HALF_TURN);
        let place = Vector::new(angle.cos(), 0.0, angle.sin()) * dice.between(3.0, 11.0);
        let size = dice.between(0.3, 0.8);
        let place = place + Vector::Y * size;
        add(&mut world, place, if size < 0.5 { ColliderBuilder::ball(size) } else { cube(size) });
    }
    add_fixed(&mut world, Vector::Y, ColliderBuilder::cylinder(1.0, 0.2));
    let dots: Vec<RigidBodyHandle> = (0..RAYS).map(|_| add_dot(&mut world)).collect();
    Scene::new(world, View::orbit(30.0, 42.0))
        .focusing(Vector::new(-11.0, 0.0, -9.0), Vector::new(11.0, 1.0, 9.0))
        .script(move |world, step| scan(world, &dots, step as Real * TURN))
}

/// Adds a small ball without collisions, which no ray hits.
fn add_dot(world: &mut PhysicsWorld) -> RigidBodyHandle {
    let dot = ColliderBuilder::ball(0.12).collision_groups(InteractionGroups::none());
    world.insert(RigidBodyBuilder::kinematic_position_based(), dot).0
}

/// Moves each dot to the end of its ray.
fn scan(world: &mut PhysicsWorld, dots: &[RigidBodyHandle], start: Real) {
    // Dots belong to no group, so a filter for all groups excludes them.
    let all = QueryFilter::default().groups(InteractionGroups::all());
    for (i, &dot) in dots.iter().enumerate() {
        let angle = start + 2.0 * HALF_TURN * i as Real / RAYS as Real;
        let direction = Vector::new(angle.cos(), 0.0, angle.sin());
        // The ray starts outside the mast.
        let ray = Ray::new(Vector::Y * HEIGHT + direction * 0.3, direction);
        let hit = world.cast_ray(&ray, REACH, true, all);
        let distance = hit.map_or(REACH, |(_, distance)| distance);
        if let Some(dot) = world.bodies.get_mut(dot) {
            dot.set_next_kinematic_translation(ray.point_at(distance));
        }
    }
}
