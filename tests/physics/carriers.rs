//! Platforms, conveyor belts, and contact forces under loads.

use super::stage::{G, RATES, add_ground, run, steps, world};
use super::table::Table;
use crate::dim::{cuboid, vec};
use rapier::prelude::*;
use std::sync::mpsc::channel;

/// Static friction carries a box on a kinematic platform: both have the same displacement.
#[test]
fn platform() {
    let columns = ["rate", "platform", "moved", "box moved", "slip (mm)"];
    let mut table = Table::new("box on a platform at 1 m/s for 3 s", &columns);
    for rate in RATES {
        for by_position in [false, true] {
            let mut world = world(rate);
            let body = if by_position {
                RigidBodyBuilder::kinematic_position_based()
            } else {
                RigidBodyBuilder::kinematic_velocity_based().linvel(vec(1.0, 0.5))
            };
            let (platform, _) = world.insert(body, cuboid(2.0, 0.1).friction(0.8));
            let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.6)).linvel(vec(1.0, 0.5));
            let (cargo, _) = world.insert(body, cuboid(0.5, 0.5).friction(0.8));
            for step in 1..=steps(&world, 3.0) {
                let time = step as Real * world.integration_parameters.dt;
                world.bodies[platform].set_next_kinematic_translation(vec(time, 0.5 * time));
                world.step();
            }
            let (platform, cargo) = (&world.bodies[platform], &world.bodies[cargo]);
            let slip = cargo.translation() - platform.translation() - vec(0.0, 0.6);
            table.row([
                rate.to_string(),
                if by_position { "by position" } else { "by velocity" }.to_string(),
                format!("{:.4}", platform.translation().x),
                format!("{:.4}", cargo.translation().x),
                format!("{:.3}", slip.x * 1.0e3),
            ]);
            table.check("the way of the platform", platform.translation().x, 3.0, 1.0e-4);
            table.check("the slip", slip.x, 0.0, 1.0e-3);
            // Rests on it as deep as the solver allows and gravity presses.
            table.check("the height", slip.y, 0.0, 3.0e-3);
        }
    }
}

/// Makes what lies on the ground run to the right at 2 m/s.
struct Belt(ColliderHandle);

impl PhysicsHooks for Belt {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        // The second surface relative to the first.
        let along = if context.collider1 == self.0 { 2.0 } else { -2.0 };
        context.set_tangent_velocity(vec(along, 0.0));
    }
}

/// Friction accelerates a box on a belt of the speed `u` by `a = µ g` until both speeds are equal.
/// This takes `u / µg`, and the box stays `u² / 2µg` behind the belt.
#[test]
fn belt() {
    let columns = ["rate", "speed", "of", "stayed behind (m)", "formula"];
    let mut table = Table::new("box on a belt, after 3 s", &columns);
    let (speed, friction): (Real, Real) = (2.0, 0.5);
    for rate in RATES {
        let mut world = world(rate);
        let ground = add_ground(&mut world, friction);
        world.colliders[ground].set_active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5));
        let (body, _) = world.insert(body, cuboid(0.5, 0.5).friction(friction));
        for _ in 0..steps(&world, 3.0) {
            world.step_with_events(&Belt(ground), &());
        }
        let body = &world.bodies[body];
        let behind = 3.0 * speed - body.translation().x;
        let formula = speed * speed / (2.0 * friction * G);
        table.row([
            rate.to_string(),
            format!("{:.5}", body.linvel().x),
            speed.to_string(),
            format!("{behind:.4}"),
            format!("{formula:.4}"),
        ]);
        table.check("the speed", body.linvel().x, speed, 1.0e-3);
        table.check("what it stayed behind", behind, formula, 0.5 * speed / rate as Real);
    }
}

/// The contact forces on a body at rest add up to its weight `m g`.
#[test]
fn contact_force_is_weight() {
    let columns = ["rate", "boxes", "force (N)", "weight (N)", "error (%)"];
    let mut table = Table::new("contact force events", &columns);
    for rate in RATES {
        for boxes in [1, 5] {
            let mut world = world(rate);
            let ground = add_ground(&mut world, 0.5);
            world.colliders[ground].set_active_events(ActiveEvents::CONTACT_FORCE_EVENTS);
            let mut weight = 0.0;
            for k in 0..boxes {
                let body = RigidBodyBuilder::dynamic()
                    .translation(vec(0.0, 0.5 + k as Real))
                    .can_sleep(false);
                let (body, _) = world.insert(body, cuboid(0.5, 0.5).density(3.0));
                weight += world.bodies[body].mass() * G;
            }
            run(&mut world, 3.0);
            let (force, magnitude) = force_of_one_step(&mut world);
            table.row([
                rate.to_string(),
                boxes.to_string(),
                format!("{magnitude:.4}"),
                format!("{weight:.4}"),
                format!("{:+.4}", (magnitude / weight - 1.0) * 100.0),
            ]);
            table.check("the force", magnitude, weight, 0.01 * weight);
            let upward = if force.y > 0.0 { force } else { -force };
            table.check("its direction", (upward - vec(0.0, weight)).length(), 0.0, 0.01 * weight);
        }
    }
}

/// The contact force of the next step, as its event has it: the sum, and the sum of magnitudes.
fn force_of_one_step(world: &mut PhysicsWorld) -> (Vector, Real) {
    let (collision_sender, _collisions) = channel();
    let (force_sender, forces) = channel();
    world.step_with_events(&(), &ChannelEventCollector::new(collision_sender, force_sender));
    let events: Vec<_> = forces.try_iter().collect();
    assert_eq!(events.len(), 1, "one pair touches the ground");
    (events[0].total_force, events[0].total_force_magnitude)
}
