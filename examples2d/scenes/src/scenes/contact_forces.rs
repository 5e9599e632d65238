//! Crates that break above a contact force.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "contact_forces",
    description: "Contact-force events report the crates that a heavy ball breaks into pieces.",
    category: Category::Events,
    steps: 110,
    // Pieces still land: these overlap by up to half their size.
    law: Law { overlap_max: 0.3, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Half extent of a crate.
const CRATE: Real = 0.6;
/// Breaking force of a crate (N), about ten times the load of the lowest crates.
const STRENGTH: Real = 900.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(200.0);
    for i in 0..30 {
        let place = Vector::new(1.25 * (i % 5) as Real, CRATE * (1.0 + 2.0 * (i / 5) as Real));
        add(&mut world, place, crate_shape());
    }
    let ball = RigidBodyBuilder::dynamic()
        .translation(Vector::new(-14.0, 3.0))
        .linvel(Vector::new(25.0, 2.0));
    world.insert(ball, ColliderBuilder::ball(0.9).density(8.0));

    Scene::new(world, View::flat()).focusing(Vector::new(-10.0, 0.0), Vector::new(14.0, 8.0)).react(
        |world, events| {
            for event in &events.contact_forces {
                for collider in [event.collider1, event.collider2] {
                    break_crate(world, collider);
                }
            }
        },
    )
}

/// Returns a crate with an event for each force above its breaking force. Its user data distinguishes it from
/// other colliders.
fn crate_shape() -> ColliderBuilder {
    square(CRATE)
        .active_events(ActiveEvents::CONTACT_FORCE_EVENTS)
        .contact_force_event_threshold(STRENGTH)
        .user_data(1)
}

/// Replaces a crate by four small boxes.
fn break_crate(world: &mut PhysicsWorld, collider: ColliderHandle) {
    let whole = world.colliders.get(collider).filter(|collider| collider.user_data == 1);
    let Some(body) = whole.and_then(Collider::parent) else { return };
    let Some(body) = world.remove_body(body) else { return };
    let half = 0.5 * CRATE;
    for (x, y) in [(-half, -half), (half, -half), (-half, half), (half, half)] {
        let place = *body.position() * Vector::new(x, y);
        let piece = RigidBodyBuilder::dynamic()
            .pose(Pose::from_parts(place, *body.rotation()))
            .linvel(body.velocity_at_point(place))
            .angvel(body.angvel());
        world.insert(piece, square(half));
    }
}
