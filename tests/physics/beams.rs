//! Beams that slide at an angle to their axis. 3D only: in the plane there is one direction of sliding.

use crate::suite::physics::stage::{G, add_ground, run, substep, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

const FRICTION: Real = 0.5;
const SPEED: Real = 8.0;

/// Puts a beam of 4×0.5×0.5 m along x on the ground, which slides at an angle to x.
fn add_beam(world: &mut PhysicsWorld, angle: Real, is_link: bool) -> RigidBodyHandle {
    let place = Vector::Y * 0.25;
    let velocity = Vector::new(angle.cos(), 0.0, angle.sin()) * SPEED;
    let body = RigidBodyBuilder::dynamic().translation(place).linvel(velocity);
    let collider = ColliderBuilder::cuboid(2.0, 0.25, 0.25).friction(FRICTION);
    let (beam, _) = world.insert(body, collider);
    if is_link {
        let load = RigidBodyBuilder::dynamic().additional_mass(1.0).translation(place);
        let load = world.insert_body(load.linvel(velocity));
        let joint = world.multibody_joints.insert(beam, load, FixedJoint::new(), true);
        joint.expect("the joint fits");
    }
    beam
}

/// Friction is opposite to the slip: a beam slides straight on, for the distance `v² / 2µg`, at any angle. An
/// impulse along its width meets a smaller effective mass, because it rotates the beam about its axis. The
/// ground prevents that rotation.
#[test]
fn beams_slide_straight_on() {
    let columns = ["friction", "angle (°)", "direction (°)", "distance", "formula"];
    let mut table = Table::new("beam that slides at an angle to its axis", &columns);
    let cases = [
        ("standard", FrictionModel::Standard, false),
        ("coulomb", FrictionModel::Coulomb, false),
        ("of a link", FrictionModel::Standard, true),
    ];
    for (name, model, is_link) in cases {
        for degrees in [0.0, 20.0, 45.0, 70.0, 90.0] {
            let mut world = world(60);
            world.integration_parameters.friction_model = model;
            add_ground(&mut world, FRICTION);
            let angle = (degrees as Real).to_radians();
            let beam = add_beam(&mut world, angle, is_link);
            run(&mut world, 3.0);
            table.require(world.bodies[beam].linvel().length() < 1.0e-3, "still slides");
            let end = world.bodies[beam].translation();
            let distance = end.x.hypot(end.z);
            let direction = end.z.atan2(end.x);
            // The velocity of a substep is the one at its end, as in `slide_to_stop`.
            let formula = SPEED * SPEED / (2.0 * FRICTION * G) - 0.5 * SPEED * substep(&world);
            table.row([
                name.to_string(),
                degrees.to_string(),
                format!("{:.3}", direction.to_degrees()),
                format!("{distance:.4}"),
                format!("{formula:.4}"),
            ]);
            // The rotation about the normal that the beam gets by rounding, in radians.
            table.check("the direction", direction, angle, 1.0e-3);
            // As in `slide_to_stop`: the beam also loses speed while it settles.
            table.check("the distance", distance, formula, 5.0e-3);
        }
    }
}
