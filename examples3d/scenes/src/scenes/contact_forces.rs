//! Crates that break above a contact force.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "contact_forces",
    description: "Contact-force events report the crates that a heavy ball breaks into pieces.",
    category: Category::Events,
    steps: 120,
    law: Law { overlap_max: 0.05, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Half extent of a crate.
const CRATE: Real = 0.6;
/// Breaking force of a crate (N), about forty times its weight.
const STRENGTH: Real = 700.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    for i in 0..36 {
        let [x, y, z] = [i % 3, i / 12, i / 3 % 4].map(|n| n as Real);
        let place = Vector::new(1.25 * x, CRATE * (1.0 + 2.0 * y), 1.25 * (z - 1.5));
        add(&mut world, place, crate_shape());
    }
    let ball = RigidBodyBuilder::dynamic()
        .translation(Vector::new(-12.0, 2.5, 0.3))
        .linvel(Vector::new(18.0, 1.5, 0.0));
    world.insert(ball, ColliderBuilder::ball(0.9).density(8.0));

    Scene::new(world, View::orbit(30.0, 18.0))
        .focusing(Vector::new(-4.0, 0.0, -4.0), Vector::new(8.0, 3.5, 4.0))
        .react(|world, events| {
            for event in &events.contact_forces {
                for collider in [event.collider1, event.collider2] {
                    break_crate(world, collider);
                }
            }
        })
}

/// Returns a crate with an event for each force above its breaking force. Its user data distinguishes it from
/// other colliders.
fn crate_shape() -> ColliderBuilder {
    cube(CRATE)
        .active_events(ActiveEvents::CONTACT_FORCE_EVENTS)
        .contact_force_event_threshold(STRENGTH)
        .user_data(1)
}

/// Replaces a crate by eight small boxes.
fn break_crate(world: &mut PhysicsWorld, collider: ColliderHandle) {
    let whole = world.colliders.get(collider).filter(|collider| collider.user_data == 1);
    let Some(body) = whole.and_then(Collider::parent) else { return };
    let Some(body) = world.remove_body(body) else { return };
    let half = 0.5 * CRATE;
    for corner in 0..8 {
        let side = |bit: usize| if corner >> bit & 1 == 0 { -half } else { half };
        let place = *body.position() * Vector::new(side(0), side(1), side(2));
        let piece = RigidBodyBuilder::dynamic()
            .pose(Pose::from_parts(place, *body.rotation()))
            .linvel(body.velocity_at_point(place))
            .angvel(body.angvel());
        world.insert(piece, cube(half));
    }
}
