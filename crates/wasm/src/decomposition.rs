//! Convex decompositions: places 4 and 5 of the scratch block hold their parameters. NaN keeps the default.

use crate::fault::Fault;
use crate::memory::{self, number};
use crate::rapier::geometry::ColliderBuilder;
use crate::rapier::math::{DIM, Real};
use crate::rapier::parry::transformation::vhacd::VHACDParameters;

/// A compound of the convex parts of the surface in the lists.
pub fn builder() -> Result<ColliderBuilder, Fault> {
    let (vertices, indices) = (memory::vectors("vertices")?, memory::groups::<DIM>("indices")?);
    let are_default = (0..7).all(|at| number(4 + at / 4, at % 4).is_nan()) && number(5, 3) != 0.0;
    Ok(if are_default {
        ColliderBuilder::convex_decomposition(&vertices, &indices)
    } else {
        ColliderBuilder::convex_decomposition_with_params(&vertices, &indices, &parameters())
    })
}

fn parameters() -> VHACDParameters {
    let default = VHACDParameters::default();
    let real = |place, component, default| {
        let value = number(place, component);
        if value.is_nan() { default } else { value }
    };
    let integer = |place, component, default: u32| real(place, component, default as Real) as u32;
    VHACDParameters {
        concavity: real(4, 0, default.concavity),
        alpha: real(4, 1, default.alpha),
        beta: real(4, 2, default.beta),
        resolution: integer(4, 3, default.resolution),
        plane_downsampling: integer(5, 0, default.plane_downsampling),
        convex_hull_downsampling: integer(5, 1, default.convex_hull_downsampling),
        max_convex_hulls: integer(5, 2, default.max_convex_hulls),
        convex_hull_approximation: real(5, 3, 1.0) != 0.0,
        ..default
    }
}
