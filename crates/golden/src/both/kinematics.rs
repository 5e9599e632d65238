//! Fast bodies, and bodies that the user moves.

use super::super::dim::{about, cuboid, vec};
use super::super::rapier::prelude::*;
use super::Act;

/// Bullets against thin walls and doors that turn, and sensors that they pass.
pub fn bullets(world: &mut PhysicsWorld) -> Act {
    world.insert_collider(cuboid(20.0, 0.05, 5.0), None);
    for k in 0..4_u8 {
        let at = vec(4.0 * Real::from(k) - 4.0, 2.0, 0.0);
        world.insert_collider(cuboid(0.02, 2.0, 3.0).translation(at), None);
        let door =
            RigidBodyBuilder::kinematic_velocity_based().translation(at + vec(2.0, 0.0, 0.0));
        world.insert(door.angvel(about(0.0, 0.5, 4.0 + Real::from(k))), cuboid(0.8, 0.03, 0.5));
    }
    let gate = cuboid(0.05, 2.0, 2.0).translation(vec(-6.0, 2.0, 0.0)).sensor(true);
    world.insert_collider(gate.active_events(ActiveEvents::COLLISION_EVENTS), None);
    Box::new(|world, step, _| {
        if step % 5 == 0 && step < 100 {
            let speed = 40.0 + 15.0 * (step % 11) as Real;
            let body = RigidBodyBuilder::dynamic()
                .translation(vec(-8.0, 1.0 + 0.1 * (step % 13) as Real, 0.02 * (step % 7) as Real))
                .linvel(vec(speed, 3.0, 0.0))
                .ccd_enabled(step % 2 == 0);
            world.insert(body, ColliderBuilder::ball(0.08).restitution(0.8));
        }
    })
}

/// Platforms that rise, turn and swing with loads on them, a conveyor, and bodies of all dominance groups.
pub fn carriers(world: &mut PhysicsWorld) -> Act {
    world.insert_collider(cuboid(20.0, 0.5, 8.0), None);
    let platform = RigidBodyBuilder::kinematic_position_based();
    let platforms = [0, 1, 2].map(|k| {
        let at = vec(5.0 * k as Real - 5.0, 2.0, 0.0);
        let (body, _) = world.insert(platform.clone().translation(at), cuboid(1.5, 0.1, 1.5));
        for load in 0..5_i8 {
            let place =
                at + vec(0.4 * Real::from(load) - 0.8, 0.5 + 0.6 * Real::from(load % 2), 0.2);
            let cargo = RigidBodyBuilder::dynamic().translation(place).dominance_group(load);
            world.insert(cargo, cuboid(0.2, 0.2, 0.2).friction(0.8));
        }
        (body, at)
    });
    Box::new(move |world, step, _| {
        let time = step as Real / 60.0;
        for (k, &(body, at)) in platforms.iter().enumerate() {
            let rise = vec(0.0, 0.3 * time * (1.0 - 0.2 * time), 0.0);
            let turn = about(0.0, 0.4 * time, if k == 1 { 0.2 * time } else { 0.0 });
            world.bodies[body].set_next_kinematic_position(Pose::new(at + rise, turn));
        }
    })
}
