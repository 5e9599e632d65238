//! What is the same for Box2D and Box3D, which know the same things by other names: what they cannot do, how they are to mix coefficients,
//! and what is counted and measured in their worlds.

use super::ours::prelude::*;
use super::overlap::overlap;
use super::separation::largest_separation;
use super::template::{SUBSTEPS, Template};
use crate::engine::{Counts, Stats, Unsupported};

/// Half the size of the box that stands for a half-space.
pub const ENDLESS: f32 = 1000.0;

/// Refuses a body that asks for what they do not know, or what is not transcribed.
pub fn check_body(body: &RigidBody) -> Result<(), Unsupported> {
    if body.dominance_group() != 0 {
        return Err(Unsupported::because("no dominance"));
    }
    if body.mass_properties().additional_local_mprops().is_some() {
        return Err(Unsupported::because("additional mass is not transcribed"));
    }
    Ok(())
}

/// Refuses a collider that asks for what they do not know; its shape is another question.
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

/// Refuses a shape.
pub fn unknown_shape(collider: &Collider) -> Unsupported {
    let kind = collider.shape().shape_type();
    Unsupported::because(format!("shape {kind:?} is not transcribed"))
}

/// Mass by volume, which in 2D is an area; 0 for what has none.
pub fn density(collider: &Collider) -> f32 {
    let volume = collider.volume();
    if volume > 0.0 { collider.mass() / volume } else { 0.0 }
}

/// How the coefficients of two shapes mix: as in this engine and in Rapier. Left to themselves, they mix friction by the geometric mean.
pub extern "C" fn average(coefficient1: f32, _: u64, coefficient2: f32, _: u64) -> f32 {
    0.5 * (coefficient1 + coefficient2)
}

/// Counts in a world of `all` bodies. One of them is the ground, which carries the colliders without a body and is not in `bodies`.
/// `count_contacts` tells the touching pairs in which a body is the first, and their points.
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

/// What there is to measure beside what was counted.
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
