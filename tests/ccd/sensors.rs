//! Sensors detect bodies that pass through them within one step.

use super::{PHASES, RADIUS, SPEEDS};
use crate::dim::grounds::box_mesh;
use crate::dim::{cuboid, vec};
use crate::suite::api::stage::Protocol;
use crate::suite::physics::stage::weightless;
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A gate of 2 cm across the x axis that reports crossings.
fn gate() -> ColliderBuilder {
    cuboid(0.01, 2.0).sensor(true).active_events(ActiveEvents::COLLISION_EVENTS)
}

fn add_ball(
    world: &mut PhysicsWorld,
    at: Vector,
    speed: Real,
) -> (RigidBodyHandle, ColliderHandle) {
    let body = RigidBodyBuilder::dynamic().translation(at).linvel(vec(speed, 0.0));
    world.insert(body, ColliderBuilder::ball(RADIUS))
}

/// Events between a gate at the origin and a ball along the x axis, `aside` of it.
fn events(speed: Real, phase: usize, gate: ColliderBuilder, aside: Real) -> Vec<bool> {
    let mut world = weightless(60);
    let protocol = Protocol::default();
    let way = speed / 60.0 * (2.0 + phase as Real / PHASES as Real);
    let gate = world.insert_collider(gate, None);
    let (_, ball) = add_ball(&mut world, vec(-way, aside), speed);
    let events = protocol.of_steps(&mut world, 8);
    for event in &events {
        assert!(event.sensor());
        let mut pair = [event.collider1(), event.collider2()];
        pair.sort();
        let mut expected = [gate, ball];
        expected.sort();
        assert_eq!(pair, expected);
    }
    events.iter().map(|event| event.started()).collect()
}

/// A sensor of 2 cm detects every ball that passes through it exactly once, and no ball beside it.
#[test]
fn gates_notice_what_flies_through() {
    let columns = ["speed", "box", "mesh", "aside"];
    let mut table = Table::new("balls that a gate of 2 cm notices, of 20", &columns);
    for speed in SPEEDS {
        let mesh = || {
            let mesh = box_mesh(vec(0.01, 2.0));
            mesh.sensor(true).active_events(ActiveEvents::COLLISION_EVENTS)
        };
        let count = |gate: &dyn Fn() -> ColliderBuilder, aside: Real, wanted: &[bool]| {
            (0..PHASES).filter(|&phase| events(speed, phase, gate(), aside) == wanted).count()
        };
        let (once, never) = ([true, false], []);
        let noticed = [count(&gate, 0.3, &once), count(&mesh, 0.3, &once)];
        let missed = count(&gate, 2.0 + 1.5 * RADIUS, &never);
        let [a, b] = noticed.map(|count| count.to_string());
        table.row([format!("{speed}"), a, b, (PHASES - missed).to_string()]);
        table.require(noticed == [PHASES; 2], "balls were not noticed once");
        table.require(missed == PHASES, "balls were noticed that flew past");
    }
}

#[test]
fn gates_that_nobody_asked_say_nothing() {
    let quiet = || cuboid(0.01, 2.0).sensor(true);
    let deaf = || gate().collision_groups(InteractionGroups::none());
    for phase in 0..PHASES {
        assert_eq!(events(400.0, phase, quiet(), 0.0), []);
        assert_eq!(events(400.0, phase, deaf(), 0.0), []);
    }
}

/// A body that a wall stops was not behind it.
#[test]
fn gates_behind_walls_notice_nobody() {
    let mut world = weightless(60);
    let protocol = Protocol::default();
    world.insert_collider(cuboid(0.01, 2.0), None);
    world.insert_collider(gate().translation(vec(0.5, 0.0)), None);
    add_ball(&mut world, vec(-3.0, 0.0), 400.0);
    assert!(protocol.of_steps(&mut world, 8).is_empty());
    assert_eq!(world.physics_pipeline.counters.ccd.num_sensors_passed, 0);
}

/// A gate on a body that moves: bullets are noticed, and what carries a gate past something notices it.
#[test]
fn gates_that_move_notice_bullets() {
    for ccd in [false, true] {
        let mut world = weightless(60);
        let protocol = Protocol::default();
        let carrier = RigidBodyBuilder::dynamic().linvel(vec(0.0, 0.1)).additional_mass(1.0);
        world.insert(carrier, gate());
        let bullet = RigidBodyBuilder::dynamic().translation(vec(-3.3, 0.0)).ccd_enabled(ccd);
        world.insert(bullet.linvel(vec(400.0, 0.0)), ColliderBuilder::ball(RADIUS));
        let events = protocol.of_steps(&mut world, 8);
        assert_eq!(events.len(), if ccd { 2 } else { 0 }, "ccd_enabled: {ccd}");
    }
    let mut world = weightless(60);
    let protocol = Protocol::default();
    world.insert_collider(cuboid(0.1, 0.1).translation(vec(0.0, 1.0)), None);
    let carrier = RigidBodyBuilder::dynamic().translation(vec(-3.3, 0.0)).linvel(vec(400.0, 0.0));
    world.insert(carrier.additional_mass(1.0), gate());
    let events = protocol.of_steps(&mut world, 8);
    assert_eq!(events.iter().map(|event| event.started()).collect::<Vec<_>>(), [true, false]);
}
