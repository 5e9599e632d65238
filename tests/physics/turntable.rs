//! Bodies on rotating ground. 3D only: in the plane no body can stand beside the axis.

use crate::suite::physics::stage::{RATES, run, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// A box on a heavy dynamic disc turns with it. Friction keeps its distance from the axis.
#[test]
fn dynamic_turntable() {
    let columns = ["rate", "spin (rad/s)", "creep outwards (m)"];
    let mut table = Table::new("box 5 m from the middle of a disc, one turn", &columns);
    for rate in RATES {
        for speed in [0.1, 0.3] {
            let mut world = world(rate);
            let spin = Vector::Y * speed;
            let disc = RigidBodyBuilder::dynamic()
                .lock_translations()
                .gravity_scale(0.0)
                .angvel(spin)
                .can_sleep(false);
            world.insert(disc, ColliderBuilder::cuboid(20.0, 0.5, 20.0).density(100.0));
            let start = Vector::new(5.0, 1.0, 0.0);
            let cargo = RigidBodyBuilder::dynamic()
                .translation(start)
                .linvel(spin.cross(start))
                .angvel(spin)
                .can_sleep(false);
            let (cargo, _) =
                world.insert(cargo, ColliderBuilder::cuboid(0.5, 0.5, 0.5).friction(1.0));
            let turn = 2.0 * std::f64::consts::PI as Real / speed;
            run(&mut world, turn);
            let end = world.bodies[cargo].translation();
            let creep = Vector::new(end.x, 0.0, end.z).length() - 5.0;
            table.row([rate.to_string(), speed.to_string(), format!("{creep:+.4}")]);
            // Friction stops the sliding of each substep, but not the displacement within the substep: an
            // angle of ω h, in each of 2π / ω h substeps.
            let substep = world.integration_parameters.substep();
            let limit = 5.0 * 2.0 * std::f64::consts::PI as Real * speed * substep + 0.01;
            table.check("the creep", creep, 0.0, 2.0 * limit);
        }
    }
}

/// A box stays where it is on a kinematic disc.
#[test]
fn kinematic_turntable() {
    let columns =
        ["rate", "disc", "spin (rad/s)", "friction", "radius (m)", "way on the disc (mm)"];
    let mut table = Table::new("boxes on a disc, one minute", &columns);
    for rate in RATES {
        for by_position in [false, true] {
            for (speed, radius) in [(0.3, 5.0), (1.0, 2.0)] {
                for model in [FrictionModel::Standard, FrictionModel::Coulomb] {
                    let mut world = world(rate);
                    world.integration_parameters.friction_model = model;
                    let spin = Vector::Y * speed;
                    let disc = if by_position {
                        RigidBodyBuilder::kinematic_position_based()
                    } else {
                        RigidBodyBuilder::kinematic_velocity_based().angvel(spin)
                    };
                    let (disc, _) =
                        world.insert(disc, ColliderBuilder::cylinder(0.5, 8.0).friction(1.0));
                    let start = Vector::new(radius, 0.75, 0.0);
                    let cargo = RigidBodyBuilder::dynamic()
                        .translation(start)
                        .linvel(spin.cross(start))
                        .angvel(spin)
                        .can_sleep(false);
                    let side = ColliderBuilder::cuboid(0.25, 0.25, 0.25).friction(1.0);
                    let (cargo, _) = world.insert(cargo, side);
                    for step in 1..=steps(&world, 60.0) {
                        let angle = speed * step as Real * world.integration_parameters.dt;
                        let turn = Rotation::from_rotation_y(angle);
                        world.bodies[disc].set_next_kinematic_rotation(turn);
                        world.step();
                    }
                    let end = world.bodies[disc]
                        .position()
                        .inverse_transform_point(world.bodies[cargo].translation());
                    let way = Vector::new(end.x - start.x, 0.0, end.z - start.z).length();
                    table.row([
                        rate.to_string(),
                        if by_position { "by position" } else { "by velocity" }.to_string(),
                        speed.to_string(),
                        format!("{model:?}"),
                        radius.to_string(),
                        format!("{:.3}", way * 1.0e3),
                    ]);
                    // The box turns as well, and friction acts some millimetres beside its middle.
                    let limit = 1.5e-3 * (60.0 / rate as Real).max(1.0).powi(2);
                    table.check("the way", way, 0.0, limit);
                }
            }
        }
    }
}
