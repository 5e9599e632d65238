//! Contacts conserve the total momentum and angular momentum.

use super::stage::{Dice, RATES, steps, weightless};
use super::table::Table;
use crate::dim::{ang_length, assortment, moment, spin_momentum, vec};
use rapier::prelude::*;

/// Linear and angular momentum about the origin.
struct Momenta {
    linear: Vector,
    angular: AngVector,
    /// Sums of the magnitudes over single bodies, the scale of rounding.
    scales: [Real; 2],
}

fn momenta(world: &PhysicsWorld) -> Momenta {
    let mut sum = Momenta { linear: Vector::ZERO, angular: AngVector::default(), scales: [0.0; 2] };
    for (_, body) in world.bodies.iter() {
        let p = body.linvel() * body.mass();
        let l = moment(body.mass_properties().world_com(), p) + spin_momentum(body);
        sum.linear += p;
        sum.angular += l;
        sum.scales[0] += p.length();
        sum.scales[1] += ang_length(l);
    }
    sum
}

/// Returns bodies of all shapes in a ring, which move to its middle with equal spins.
fn implosion(rate: u32) -> PhysicsWorld {
    let mut world = weightless(rate);
    let shapes = assortment();
    let mut dice = Dice(7);
    let count = 42;
    for k in 0..count {
        let angle = 0.7 * k as Real;
        let radius = 1.0 + 0.2 * k as Real;
        let outward = vec(angle.cos(), angle.sin());
        let wobble = vec(dice.within(-0.5, 0.5), dice.within(-0.5, 0.5));
        let body = RigidBodyBuilder::dynamic()
            .translation(outward * radius)
            .linvel(outward * (-0.3 * radius) + wobble + vec(0.5, 0.2))
            .angvel(crate::dim::about_z(1.0))
            .can_sleep(false);
        world.insert(body, shapes[k % shapes.len()].clone().restitution(0.3));
    }
    world
}

/// A contact applies opposite impulses to its two bodies. `Σp` is therefore constant except for
/// rounding: `n` changes of a momentum `p` round by about `ε p √n`.
///
/// `ΣL` is constant as long as both impulses act at the same point. The moment arms are those at the
/// beginning of a step, and the bodies move during the step. The error is of first order in the step.
#[test]
fn momentum_without_gravity() {
    let columns = ["rate", "manifolds", "|Σp|", "error / Σ|p|", "limit", "|ΣL|", "error / Σ|L|"];
    let mut table = Table::new("42 bodies collide without gravity, 6 s", &columns);
    for rate in RATES {
        let mut world = implosion(rate);
        let before = momenta(&world);
        let mut manifolds = 0;
        for _ in 0..steps(&world, 6.0) {
            world.step();
            manifolds += world.physics_pipeline.counters.solver.nconstraints;
        }
        let after = momenta(&world);
        let p = (after.linear - before.linear).length() / before.scales[0];
        let l = ang_length(after.angular - before.angular) / before.scales[1];
        // A manifold has nine iterations per step, with two bodies each.
        let limit = Real::EPSILON * (18.0 * manifolds as Real).sqrt();
        table.row([
            rate.to_string(),
            manifolds.to_string(),
            format!("{:.3}", before.linear.length()),
            format!("{p:.1e}"),
            format!("{limit:.1e}"),
            format!("{:.3}", ang_length(before.angular)),
            format!("{l:.1e}"),
        ]);
        table.require(manifolds > 1000, "hardly anything touched");
        table.check("the error of Σp", p, 0.0, limit);
        table.check("the error of ΣL", l, 0.0, 0.3 / rate as Real);
    }
}

/// Two cubes are pressed together and spin as one body. The spin is constant: the forces act through
/// both centres, and the contact's torques cancel.
#[test]
fn pressed_together_they_spin_on() {
    let columns = ["rate", "spin (rad/s)", "after 10 s", "largest error of L (%)"];
    let mut table = Table::new("two cubes pressed together by their weight, spinning", &columns);
    for (rate, spin) in RATES.into_iter().flat_map(|rate| [(rate, 0.02), (rate, 0.5)]) {
        let mut world = weightless(rate);
        let spin: Real = spin;
        let cubes = [-0.5, 0.5].map(|x: Real| {
            let body = RigidBodyBuilder::dynamic()
                .translation(vec(x, 0.0))
                .linvel(vec(0.0, spin * x))
                .angvel(crate::dim::about_z(spin))
                .can_sleep(false);
            world.insert(body, crate::dim::cuboid(0.5, 0.5).friction(0.5)).0
        });
        let start = crate::dim::z_of(momenta(&world).angular);
        let mut worst: Real = 0.0;
        for _ in 0..steps(&world, 10.0) {
            let apart = world.bodies[cubes[1]].translation() - world.bodies[cubes[0]].translation();
            let press = apart.normalize() * (9.81 * world.bodies[cubes[0]].mass());
            for (cube, force) in [(cubes[0], press), (cubes[1], -press)] {
                world.bodies[cube].reset_forces(true);
                world.bodies[cube].add_force(force, true);
            }
            world.step();
            let now = crate::dim::z_of(momenta(&world).angular);
            worst = worst.max((now / start - 1.0).abs());
        }
        let end = crate::dim::z_of(world.bodies[cubes[0]].angvel());
        table.row([
            rate.to_string(),
            format!("{spin:.4}"),
            format!("{end:.4}"),
            format!("{:.3}", worst * 100.0),
        ]);
        table.check("the angular momentum", worst, 0.0, 0.03);
        table.check("the spin", end, spin, 0.03 * spin);
    }
}
