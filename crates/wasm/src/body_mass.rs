//! Bodies: mass.

use crate::body::mass_properties;
use crate::fault::non_negative;
#[cfg(not(feature = "dim2"))]
use crate::memory::put_rotation;
use crate::memory::{put_angular, put_number, put_vector};
use crate::rapier::math::{AngularInertia, Real};
use crate::registry::{body, body_mut, write};

/// Writes an angular inertia: a number in 2D, the upper triangle of the matrix by rows in 3D.
#[cfg(feature = "dim2")]
fn put_inertia(inertia: AngularInertia) {
    put_number(0, 0, inertia);
}

/// Writes an angular inertia: a number in 2D, the upper triangle of the matrix by rows in 3D.
#[cfg(not(feature = "dim2"))]
fn put_inertia(inertia: AngularInertia) {
    let values = [inertia.m11, inertia.m12, inertia.m13, inertia.m22, inertia.m23, inertia.m33];
    for (at, value) in values.into_iter().enumerate() {
        put_number(0, at, value);
    }
}

#[cfg(feature = "dim2")]
fn inverse(inertia: AngularInertia) -> AngularInertia {
    if inertia == 0.0 { 0.0 } else { 1.0 / inertia }
}

#[cfg(not(feature = "dim2"))]
fn inverse(inertia: AngularInertia) -> AngularInertia {
    inertia.inverse_unchecked()
}

exports! {
    /// The mass of a body.
    fn body_mass(world: u32, handle: f64) -> f64 {
        body(world, handle)?.mass().into()
    }

    /// The inverse mass of a body, whatever its type.
    fn body_inv_mass(world: u32, handle: f64) -> f64 {
        body(world, handle)?.mass_properties().local_mprops().inv_mass.into()
    }

    /// Writes the effective inverse mass for impulses along each world axis.
    fn body_effective_inv_mass(world: u32, handle: f64) {
        put_vector(0, body(world, handle)?.mass_properties().effective_inv_mass());
    }

    /// Writes the centre of mass in the frame of the body.
    fn body_local_com(world: u32, handle: f64) {
        put_vector(0, body(world, handle)?.local_center_of_mass());
    }

    /// Writes the centre of mass in world space.
    fn body_world_com(world: u32, handle: f64) {
        put_vector(0, body(world, handle)?.center_of_mass());
    }

    /// Writes the inverse principal inertia.
    fn body_inv_principal_inertia(world: u32, handle: f64) {
        put_angular(0, body(world, handle)?.mass_properties().local_mprops().inv_principal_inertia);
    }

    /// Writes the principal inertia.
    fn body_principal_inertia(world: u32, handle: f64) {
        put_angular(0, body(world, handle)?.mass_properties().local_mprops().principal_inertia());
    }

    /// Writes the effective inverse inertia for angular impulses, in world space.
    fn body_effective_world_inv_inertia(world: u32, handle: f64) {
        put_inertia(*body(world, handle)?.mass_properties().effective_world_inv_inertia());
    }

    /// Writes the effective inertia for angular impulses, in world space.
    fn body_effective_angular_inertia(world: u32, handle: f64) {
        put_inertia(inverse(*body(world, handle)?.mass_properties().effective_world_inv_inertia()));
    }

    /// Sets the mass that is added to the mass of the colliders.
    fn body_set_additional_mass(world: u32, handle: f64, mass: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.set_additional_mass(non_negative("mass", mass)? as Real, wake != 0);
    }

    /// Sets the mass properties that are added to those of the colliders.
    fn body_set_additional_mass_properties(world: u32, handle: f64, mass: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.set_additional_mass_properties(mass_properties(mass as Real, 0)?, wake != 0);
    }

    /// Computes the mass from the colliders again.
    fn body_recompute_mass(world: u32, handle: f64) {
        body(world, handle)?;
        let world = write(world)?;
        let body = crate::handle::Handle::of_number(handle);
        if let Some(body) = world.bodies.get_mut(body) {
            body.recompute_mass_properties_from_colliders(&world.colliders);
        }
    }
}

#[cfg(not(feature = "dim2"))]
exports! {
    /// Writes the frame of the principal inertia.
    fn body_principal_inertia_frame(world: u32, handle: f64) {
        put_rotation(0, body(world, handle)?.mass_properties().local_mprops().principal_inertia_local_frame);
    }
}
