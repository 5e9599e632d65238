//! Reported impulses of contacts.

use super::stage::{G, add_ground, run, world};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// Returns the impulse that carries a box of mass 1 for one step, and the height of its centre at rest.
fn box_at_rest(params: IntegrationParameters) -> (Real, Real) {
    let mut world = world(60);
    world.integration_parameters = params;
    add_ground(&mut world, 0.5);
    let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5)).can_sleep(false);
    let (body, collider) = world.insert(body, cuboid(0.5, 0.5).mass(1.0));
    run(&mut world, 2.0);
    let impulse = world
        .contact_pairs_with(collider)
        .flat_map(|pair| &pair.manifolds)
        .flat_map(|manifold| &manifold.data)
        .map(|contact| contact.impulse)
        .sum();
    (impulse, world.bodies[body].translation().y)
}

/// For any number of substeps and iterations, the impulses of a step add up to the weight times its length,
/// each counted once.
#[test]
fn impulses_carry_the_weight_whatever_the_iterations() {
    let default = IntegrationParameters::default();
    let variants = [
        default,
        IntegrationParameters { num_additional_friction_iterations: 3, ..default },
        IntegrationParameters { num_internal_pgs_iterations: 3, ..default },
        IntegrationParameters { num_solver_iterations: 1, ..default },
        IntegrationParameters { warmstart_coefficient: 0.5, ..default },
        IntegrationParameters { warmstart_coefficient: 0.0, ..default },
    ];
    for params in variants {
        let (impulse, height) = box_at_rest(params);
        let weight = G * params.dt;
        assert!((impulse - weight).abs() < 0.01 * weight, "{impulse}, not {weight}: {params:?}");
        assert!((height - 0.5).abs() < 0.01, "at {height}: {params:?}");
    }
}
