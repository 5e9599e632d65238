//! Sensors: zones that report each body that enters or leaves, and exert no force.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "sensors",
    description: "Each body in a sensor zone floats up, until an event reports its exit.",
    category: Category::Queries,
    steps: 420,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 7.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let zones: Vec<ColliderHandle> = [-3.5, 3.5]
        .into_iter()
        .map(|x| {
            let zone = ColliderBuilder::cylinder(2.0, 2.2)
                .translation(Vector::new(x, 2.0, 0.0))
                .sensor(true)
                .active_events(ActiveEvents::COLLISION_EVENTS);
            world.insert_collider(zone, None)
        })
        .collect();
    for i in 0..60 {
        let [x, y, z] = [i % 10, i / 30, i / 10 % 3].map(|n| n as Real);
        let place = Vector::new(1.25 * (x - 4.5), 6.0 + 1.5 * y, 1.3 * (z - 1.0));
        add(&mut world, place, ColliderBuilder::ball(0.4).restitution(0.4));
    }

    Scene::new(world, View::orbit(20.0, 16.0)).react(move |world, events| {
        for event in &events.collisions {
            let (h1, h2) = (event.collider1(), event.collider2());
            let visitor = if zones.contains(&h1) { h2 } else { h1 };
            let body = world.colliders.get(visitor).and_then(Collider::parent);
            if let Some(body) = body.and_then(|body| world.bodies.get_mut(body)) {
                body.set_gravity_scale(if event.started() { -0.3 } else { 1.0 }, true);
            }
        }
    })
}
