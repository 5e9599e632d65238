//! Bodies on rotating ground. 3D only: in the plane no body can stand beside the axis.

use crate::suite::physics::stage::{RATES, run, world};
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
