//! Rays from a mast, and a drone under feedback control.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};
use std::f64::consts::PI;

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "radar",
    description: "64 rays from above mark what they hit; a PD controller guides a drone over it.",
    category: Category::Queries,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of rays in half a revolution, and their length.
const RAYS: usize = 64;
const REACH: Real = 12.0;
/// Origin of the rays.
const EYE: Vector = Vector::new(0.0, 5.0);

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(40.0);
    for i in 0..28 {
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let place = Vector::new(side * (3.0 + 0.28 * i as Real), 1.0 + (i % 5) as Real);
        let shape = match i % 3 {
            0 => ColliderBuilder::ball(0.5),
            1 => square(0.5),
            _ => ColliderBuilder::capsule_y(0.4, 0.3),
        };
        add(&mut world, place, shape);
    }
    // Markers of hits collide with nothing, and rays ignore them.
    let marker = ColliderBuilder::ball(0.1).collision_groups(InteractionGroups::none());
    let markers: Vec<_> = (0..RAYS)
        .map(|_| world.insert(RigidBodyBuilder::kinematic_position_based(), marker.clone()).0)
        .collect();
    let drone = add(&mut world, Vector::new(0.0, 8.0), ColliderBuilder::cuboid(0.7, 0.15));
    let pilot = PdController::default();
    Scene::new(world, View::flat())
        .script(move |world, step| {
            let time = step as Real * world.integration_parameters.dt;
            lead(world, drone, &pilot, time);
            for (index, marker) in markers.iter().enumerate() {
                let angle = -PI as Real * (index as Real + 0.5) / RAYS as Real;
                let ray = Ray::new(EYE, Vector::new(angle.cos(), angle.sin()));
                let filter = QueryFilter::default().exclude_kinematic();
                let hit = world.cast_ray(&ray, REACH, true, filter);
                let place = ray.point_at(hit.map_or(REACH, |(_, distance)| distance));
                world.bodies[*marker].set_next_kinematic_translation(place);
            }
        })
        .focusing(Vector::new(-13.0, -0.5), Vector::new(13.0, 13.0))
}

/// Corrects the drone's velocity towards its target on a line at this time.
fn lead(world: &mut PhysicsWorld, drone: RigidBodyHandle, pilot: &PdController, time: Real) {
    let place = Vector::new(7.0 * (0.9 * time).sin(), 8.0);
    let velocity = Vector::X * (6.3 * (0.9 * time).cos());
    let target = Pose::from_translation(place);
    let body = &mut world.bodies[drone];
    let velocities = RigidBodyVelocity::new(velocity, 0.0);
    let correction = pilot.rigid_body_correction(body, target, velocities);
    body.set_linvel(body.linvel() + correction.linvel, true);
    body.set_angvel(body.angvel() + correction.angvel, true);
}
