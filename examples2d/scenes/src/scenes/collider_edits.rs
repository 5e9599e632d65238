//! Colliders that change while the world runs.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "collider_edits",
    description: "Colliders grow, change their shape, move to another body and vanish while the world runs.",
    category: Category::Events,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 14.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Edits of the colliders, by their place in the row.
#[derive(Copy, Clone)]
enum Fate {
    Grow,
    Reshape,
    ChangeBody,
    Vanish,
}

const FATES: [Fate; 4] = [Fate::Grow, Fate::Reshape, Fate::ChangeBody, Fate::Vanish];

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let mut subjects = Vec::new();
    for (group, fate) in FATES.into_iter().enumerate() {
        for i in 0..3 {
            let x = 2.2 * ((3 * group + i) as Real - 5.5);
            let lower = add(&mut world, Vector::new(x, 0.5), square(0.5));
            let upper = add(&mut world, Vector::new(x, 1.5), square(0.4));
            subjects.push((fate, 40 + 30 * i, lower, upper));
        }
    }
    Scene::new(world, View::flat()).script(move |world, step| {
        for &(fate, start, lower, upper) in &subjects {
            if step >= start {
                edit(world, fate, step - start, lower, upper);
            }
        }
    })
}

/// Applies an edit, `step` steps after the first one.
fn edit(
    world: &mut PhysicsWorld,
    fate: Fate,
    step: usize,
    lower: RigidBodyHandle,
    upper: RigidBodyHandle,
) {
    let Some(&collider) = world.bodies.get(lower).and_then(|body| body.colliders().first()) else {
        return;
    };
    let PhysicsWorld { bodies, colliders, .. } = world;
    match (fate, step) {
        (Fate::Grow, 0..=60) => {
            let half = 0.5 + 0.45 * step as Real / 60.0;
            colliders[collider].set_shape(SharedShape::cuboid(half, 0.5));
        }
        (Fate::Reshape, 0) => colliders[collider].set_shape(SharedShape::ball(0.5)),
        (Fate::ChangeBody, 0) => {
            // The lower square becomes a part of the upper body; its own body remains without colliders.
            colliders.set_parent(collider, Some(upper), bodies);
            let foot = Pose::from_translation(Vector::new(0.9, -0.3));
            colliders[collider].set_position_wrt_parent(foot);
        }
        (Fate::Vanish, 0) => {
            world.remove_collider(collider);
        }
        _ => {}
    }
}
