//! Rays from a mast, and a drone under feedback control.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "radar",
    description: "96 rays from a mast mark what they hit; a PD controller guides a drone around it.",
    category: Category::Queries,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 12.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of rays in a full revolution, and their length.
const RAYS: usize = 96;
const REACH: Real = 12.0;
/// Origin of the rays.
const EYE: Vector = Vector::new(0.0, 0.8, 0.0);

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(40.0);
    for i in 0..60 {
        let angle = 2.4 * i as Real;
        let distance = 3.5 + 0.12 * i as Real;
        let place = Vector::new(distance * angle.cos(), 1.0, distance * angle.sin());
        let shape = match i % 3 {
            0 => ColliderBuilder::ball(0.6),
            1 => cube(0.6),
            _ => ColliderBuilder::cylinder(0.7, 0.4),
        };
        add(&mut world, place, shape);
    }
    // Markers of hits collide with nothing, and rays ignore them.
    let marker = ColliderBuilder::ball(0.09).collision_groups(InteractionGroups::none());
    let markers: Vec<_> = (0..RAYS)
        .map(|_| world.insert(RigidBodyBuilder::kinematic_position_based(), marker.clone()).0)
        .collect();
    let drone = add(&mut world, Vector::new(8.0, 3.0, 0.0), ColliderBuilder::cuboid(0.6, 0.1, 0.4));
    let pilot = PdController::default();
    Scene::new(world, View::orbit(35.0, 24.0)).script(move |world, step| {
        let time = step as Real * world.integration_parameters.dt;
        lead(world, drone, &pilot, time);
        for (index, marker) in markers.iter().enumerate() {
            let angle = 2.0 * HALF_TURN * index as Real / RAYS as Real + 0.2 * time;
            let ray = Ray::new(EYE, Vector::new(angle.cos(), 0.0, angle.sin()));
            let filter = QueryFilter::default().exclude_kinematic();
            let hit = world.cast_ray(&ray, REACH, true, filter);
            let place = ray.point_at(hit.map_or(REACH, |(_, distance)| distance));
            world.bodies[*marker].set_next_kinematic_translation(place);
        }
    })
}

/// Corrects the drone's velocity towards its target on a circle at this time.
fn lead(world: &mut PhysicsWorld, drone: RigidBodyHandle, pilot: &PdController, time: Real) {
    let angle = 0.8 * time;
    let place = Vector::new(8.0 * angle.cos(), 3.0, 8.0 * angle.sin());
    let target = Pose::from_parts(place, Rotation::from_rotation_y(-angle));
    let velocity = Vector::new(-angle.sin(), 0.0, angle.cos()) * 6.4;
    let velocities = RigidBodyVelocity::new(velocity, -Vector::Y * 0.8);
    let body = &mut world.bodies[drone];
    let correction = pilot.rigid_body_correction(body, target, velocities);
    body.set_linvel(body.linvel() + correction.linvel, true);
    body.set_angvel(body.angvel() + correction.angvel, true);
}
