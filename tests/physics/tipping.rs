//! A body that tips over an edge does not penetrate the ground.

use super::stage::{G, RATES, add_ground, steps, world};
use super::table::Table;
use crate::dim::{about_z, cuboid, vec};
use rapier::prelude::*;

/// A pillar that leans too far falls over its lower edge. The edge stands still all the while, so the
/// contact points there do not move; those of the side that comes down must be found all the same.
#[test]
fn a_falling_pillar_does_not_sink_in() {
    for rate in RATES {
        let mut world = world(rate);
        add_ground(&mut world, 0.5);
        let lean: Real = -0.3;
        let (half_width, half_height): (Real, Real) = (0.2, 1.0);
        let middle = half_width * lean.sin().abs() + half_height * lean.cos();
        let body =
            RigidBodyBuilder::dynamic().translation(vec(0.0, middle)).rotation(about_z(lean));
        let (_, collider) = world.insert(body, cuboid(half_width, half_height));
        let mut deepest: Real = 0.0;
        for _ in 0..steps(&world, 3.0) {
            world.step();
            deepest = deepest.max(-world.colliders[collider].compute_aabb().mins.y);
        }
        // Its top arrives at 5 m/s; contacts are looked for once a step.
        let tolerance = 5.0 / rate as Real + 0.01;
        assert!(deepest < tolerance, "at {rate} Hz it sank {deepest} into the ground");
    }
}

/// A slab that leans beyond its edge is a pendulum on that edge, whatever its size. It moves from
/// `θ₀`, measured from the balanced position, to `θ₁` in the time `∫ dθ / √(2 (m g r / I) (cos θ₀ -
/// cos θ))`.
#[test]
fn slabs_of_all_sizes_tip_over_in_time() {
    let columns = ["width (m)", "time (s)", "formula"];
    let mut table = Table::new("slabs 1 : 4 that tip over an edge, 240 Hz", &columns);
    for half in [0.5, 0.05, 0.02, 0.01] as [Real; 4] {
        let mut world = world(240);
        add_ground(&mut world, 1.0);
        let (half_width, half_height) = (half, 4.0 * half);
        let (lean, end): (Real, Real) = (0.35, 1.0);
        let (sin, cos) = lean.sin_cos();
        let middle =
            vec(half_height * sin - half_width * cos, half_height * cos + half_width * sin);
        let body = RigidBodyBuilder::dynamic()
            .translation(middle)
            .rotation(about_z(-lean))
            .can_sleep(false);
        let slab = cuboid(half_width, half_height).friction(1.0);
        let (body, _) = world.insert(body, slab);
        let mut time = 0.0;
        while crate::dim::turned_about_z(world.bodies[body].rotation()) > -end && time < 10.0 {
            world.step();
            time += world.integration_parameters.dt;
        }
        let formula = pendulum_time(half_width, half_height, lean, end);
        table.row([(2.0 * half).to_string(), format!("{time:.3}"), format!("{formula:.3}")]);
        // Two steps, and what the edge sinks in.
        table.check("the time", time, formula, 0.03 * formula + 2.0 / 240.0);
    }
}

/// See [`slabs_of_all_sizes_tip_over_in_time`], for angles of the slab's side against the vertical.
fn pendulum_time(half_width: Real, half_height: Real, lean: Real, end: Real) -> Real {
    let balance = (half_width / half_height).atan();
    let (start, end) = (lean - balance, end - balance);
    let radius = half_width.hypot(half_height);
    // I / m about the edge: a third of the square of the diagonal's half, and that again for Steiner's share.
    let inertia = radius * radius * (1.0 + 1.0 / 3.0);
    let drive = G * radius / inertia;
    // θ = θ₀ + s² takes the pole out of the beginning.
    let (pieces, mut time) = (1000, 0.0);
    let length = (end - start).sqrt() / pieces as Real;
    for piece in 0..pieces {
        let s = (piece as Real + 0.5) * length;
        // cos θ₀ - cos θ, without the difference.
        let fall = 2.0 * (start + 0.5 * s * s).sin() * (0.5 * s * s).sin();
        let speed = (2.0 * drive * fall).sqrt();
        time += 2.0 * s / speed * length;
    }
    time
}
