//! Elements of the scenes of joints.

use crate::dim::{hinge, vec};
use rapier::prelude::*;

/// Returns a body without colliders, with this mass and the inertia of a ball of this radius.
pub fn bob(mass: Real, radius: Real) -> RigidBodyBuilder {
    RigidBodyBuilder::dynamic()
        .additional_mass_properties(MassProperties::from_ball(density(mass, radius), radius))
        .can_sleep(false)
}

/// Returns the density of a ball with this radius and mass.
fn density(mass: Real, radius: Real) -> Real {
    mass / MassProperties::from_ball(1.0, radius).mass()
}

/// Returns the moment of inertia of [`bob`] about its centre.
pub fn inertia(mass: Real, radius: Real) -> Real {
    crate::dim::about_z_of(&MassProperties::from_ball(density(mass, radius), radius))
}

/// Adds a fixed body at a place.
pub fn post(world: &mut PhysicsWorld, at: Vector) -> RigidBodyHandle {
    world.insert_body(RigidBodyBuilder::fixed().translation(at))
}

/// Hangs a bob of mass 1 from a post at the origin, at the angle `angle` from the vertical.
pub fn hang(world: &mut PhysicsWorld, length: Real, radius: Real, angle: Real) -> RigidBodyHandle {
    let post = post(world, Vector::ZERO);
    let at = vec(length * angle.sin(), -length * angle.cos());
    let bob =
        world.insert_body(bob(1.0, radius).translation(at).rotation(crate::dim::about_z(angle)));
    world.insert_impulse_joint(post, bob, hinge().local_anchor2(vec(0.0, length)));
    bob
}

/// Returns the angle of a point from the vertical about the origin.
pub fn swing(at: Vector) -> Real {
    at.x.atan2(-at.y)
}

/// Runs a world until a reading falls through zero `count` times. Returns the interpolated times of the
/// crossings.
pub fn falls_through_zero(
    world: &mut PhysicsWorld,
    count: usize,
    reading: impl Fn(&PhysicsWorld) -> Real,
) -> Vec<Real> {
    let dt = world.integration_parameters.dt;
    let (mut before, mut crossings) = (reading(world), Vec::new());
    for step in 0..100_000 {
        world.step();
        let after = reading(world);
        if before > 0.0 && after <= 0.0 {
            crossings.push((step as Real + before / (before - after)) * dt);
            if crossings.len() == count {
                return crossings;
            }
        }
        before = after;
    }
    panic!("only {} crossings", crossings.len());
}

/// Returns the mean of the times between crossings.
pub fn period(crossings: &[Real]) -> Real {
    (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as Real
}

/// Returns the largest value of a reading within this time (s).
pub fn largest(
    world: &mut PhysicsWorld,
    seconds: Real,
    reading: impl Fn(&PhysicsWorld) -> Real,
) -> Real {
    let mut largest = reading(world);
    for _ in 0..crate::suite::physics::stage::steps(world, seconds) {
        world.step();
        largest = largest.max(reading(world));
    }
    largest
}
