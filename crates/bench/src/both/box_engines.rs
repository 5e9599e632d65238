//! Code common to Box2D and Box3D, which have the same features under different names: unsupported features,
//! the average of coefficients, and measurements of their worlds.

use super::ours::prelude::*;
use super::overlap::overlap;
use super::separation::largest_separation;
use super::template::{SUBSTEPS, Template};
use crate::engine::{Counts, Stats, Unsupported};

/// Half extent (length units) of the box that replaces a half-space.
pub const HALF_SPACE_EXTENT: f32 = 1000.0;

/// Rejects a body with features that these engines lack or that the benchmark does not transcribe.
pub fn check_body(body: &RigidBody) -> Result<(), Unsupported> {
    if body.dominance_group() != 0 {
        return Err(Unsupported::because("no dominance"));
    }
    if body.mass_properties().additional_local_mprops().is_some() {
        return Err(Unsupported::because("additional mass is not transcribed"));
    }
    Ok(())
}

/// Rejects a collider with features that these engines lack. The shape is checked separately.
pub fn check_collider(collider: &Collider) -> Result<(), Unsupported> {
    if collider.contact_skin() != 0.0 {
        return Err(Unsupported::because("no contact skin"));
    }
    let rules = [collider.friction_combine_rule(), collider.restitution_combine_rule()];
    if rules != [CoefficientCombineRule::Average; 2] {
        return Err(Unsupported::because("coefficients are mixed by average alone"));
    }
    if collider.solver_groups() != InteractionGroups::all() {
        return Err(Unsupported::because("no solver groups"));
    }
    Ok(())
}

/// Returns the error of a shape that is not transcribed.
pub fn unknown_shape(collider: &Collider) -> Unsupported {
    let kind = collider.shape().shape_type();
    Unsupported::because(format!("shape {kind:?} is not transcribed"))
}

/// Returns the mass per volume (2D: per area), or 0 for a shape without volume.
pub fn density(collider: &Collider) -> f32 {
    let volume = collider.volume();
    if volume > 0.0 { collider.mass() / volume } else { 0.0 }
}

/// Combines the coefficients of two shapes by their mean, as this engine and Rapier do. By default both
/// engines combine friction by the geometric mean.
pub extern "C" fn average(coefficient1: f32, _: u64, coefficient2: f32, _: u64) -> f32 {
    0.5 * (coefficient1 + coefficient2)
}

/// Returns the counts of a world with `all` bodies. One of them is the ground, which holds the colliders
/// without a body and is not in `bodies`. `count_contacts` returns the touching pairs with a body in first
/// place, and their points.
pub fn counts<Id: Copy>(
    all: i32,
    bodies: &[Id],
    is_awake: fn(Id) -> bool,
    count_contacts: fn(Id) -> (usize, usize),
) -> Counts {
    let mut counts = Counts {
        bodies: usize::try_from(all - 1).unwrap_or(0),
        awake: bodies.iter().filter(|&&body| is_awake(body)).count(),
        substeps: SUBSTEPS,
        ..Counts::default()
    };
    for &body in bodies {
        let (pairs, points) = count_contacts(body);
        counts.pairs += pairs;
        counts.points += points;
    }
    counts
}

/// Returns the measurements of a world, with its counts.
pub fn stats<Id: Copy>(
    template: &Template,
    counts: Counts,
    bodies: &[Id],
    pose: fn(Id) -> Pose,
    kinetic_energy: fn(Id) -> f64,
) -> Stats {
    let poses: Vec<Pose> = bodies.iter().map(|&body| pose(body)).collect();
    Stats {
        counts,
        kinetic_energy: bodies.iter().map(|&body| kinetic_energy(body)).sum(),
        overlap: overlap(template, &poses),
        separation: largest_separation(template, &poses),
    }
}
