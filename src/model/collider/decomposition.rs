//! Convex decomposition: a concave mesh as a compound of convex parts, by parry's V-HACD.
//!
//! The method is approximate: it cuts voxels along planes of the axes. Its error depends on the shape more
//! than on its parameters, and no parameters are good for all shapes. The defaults are therefore several
//! attempts. The first whose volume is near that of the surface is the result, else the one with the least
//! error.

use super::check::{check_margin, check_parts};
use super::grid::check_resolution;
use super::mass::volume_properties;
use super::shapes::check_surface;
use super::{ColliderBuilder, InvalidCollider};
use crate::base::guard::guarded;
use crate::base::hash::FastHashMap;
use crate::dim::decomposition::{attempts, enclosed, for_each_end};
use crate::dim::hull::ConvexShape;
use crate::dim::math::{DIM, Pose, Real, Vector};
use crate::dim::shapes;
use parry::shape::{Compound, RoundShape, SharedShape};
use parry::transformation::vhacd::{VHACD, VHACDParameters};

/// Steps of the search that are multiplied with each other further down must not overflow.
const DOWNSAMPLING_MAX: u32 = 65_536;
const HULLS_MAX: u32 = 65_536;
/// Largest relative error of the volume with which the next attempt is not made.
const ERROR_MAX: Real = 0.03;

/// Concave meshes as convex parts.
impl ColliderBuilder {
    /// A compound of convex parts that approximately fill the interior of a surface (segments in 2D,
    /// triangles in 3D).
    ///
    /// If the volume (in 2D: area) differs from that inside the surface by more than 3 %, finer parameters
    /// are tried, and the result is the best of three. [`Self::decomposition_error`] returns the remaining
    /// error. The decomposition is slow, up to a second or more in 3D: compute it in advance for shapes that
    /// are used often.
    pub fn convex_decomposition(vertices: &[Vector], indices: &[[u32; DIM]]) -> Self {
        Self::of(decompose_closely(vertices, indices, SharedShape::new))
    }

    /// The error of the volume (in 2D: area) of this decomposition of a surface, as a fraction of the volume
    /// inside the surface: the sum of the parts, without borders, is `1 + error` times as large. Positive if
    /// notches are filled.
    ///
    /// `None` if the surface is not closed or its elements are not all wound the same way, if an index is out
    /// of range, or if this is no compound.
    pub fn decomposition_error(&self, vertices: &[Vector], indices: &[[u32; DIM]]) -> Option<Real> {
        check_surface(vertices, indices).ok()?;
        let parts = self.shape.as_compound()?.shapes().iter();
        let volume: Real = parts.map(|(_, part)| volume_properties(&**part, 1.0).mass()).sum();
        Some(volume / enclosed_volume(vertices, indices)? - 1.0)
    }

    /// A compound of convex parts that approximately fill the interior of a surface, computed with the given
    /// parameters. parry's default parameters fill notches.
    pub fn convex_decomposition_with_params(
        vertices: &[Vector],
        indices: &[[u32; DIM]],
        params: &VHACDParameters,
    ) -> Self {
        Self::of(decompose(vertices, indices, params, SharedShape::new))
    }

    /// A compound as [`Self::convex_decomposition`]. Each part is enlarged and rounded by `border_radius`
    /// (length units) on all sides.
    pub fn round_convex_decomposition(
        vertices: &[Vector],
        indices: &[[u32; DIM]],
        border_radius: Real,
    ) -> Self {
        let round = |inner_shape| SharedShape::new(RoundShape { inner_shape, border_radius });
        let checked = check_margin("border_radius", border_radius);
        Self::of(checked.and_then(|()| decompose_closely(vertices, indices, round)))
    }

    /// As [`Self::round_convex_decomposition`], computed with the given parameters.
    pub fn round_convex_decomposition_with_params(
        vertices: &[Vector],
        indices: &[[u32; DIM]],
        params: &VHACDParameters,
        border_radius: Real,
    ) -> Self {
        let round = |inner_shape| SharedShape::new(RoundShape { inner_shape, border_radius });
        let checked = check_margin("border_radius", border_radius);
        Self::of(checked.and_then(|()| decompose(vertices, indices, params, round)))
    }
}

/// A compound of the results of `finish` for each convex part, by the best of several attempts.
pub(super) fn decompose_closely(
    vertices: &[Vector],
    indices: &[[u32; DIM]],
    finish: impl Fn(ConvexShape) -> SharedShape,
) -> Result<SharedShape, InvalidCollider> {
    check_surface(vertices, indices)?;
    let enclosed = enclosed_volume(vertices, indices);
    let error = |hulls: &[ConvexShape]| {
        let volumes = hulls.iter().map(|hull| volume_properties(hull, 1.0).mass());
        let volume: Real = volumes.sum();
        enclosed.map_or(0.0, |enclosed| (volume / enclosed - 1.0).abs())
    };
    let mut best = (Real::INFINITY, Vec::new());
    for params in attempts() {
        let hulls = hulls_of(vertices, indices, &params);
        let error = error(&hulls);
        if error < best.0 && !hulls.is_empty() {
            best = (error, hulls);
        }
        if best.0 <= ERROR_MAX {
            break;
        }
    }
    compound_of(best.1, finish)
}

/// The volume inside a surface; `None` if it is not closed, or not wound the same way everywhere. Equal
/// points are one.
fn enclosed_volume(vertices: &[Vector], indices: &[[u32; DIM]]) -> Option<Real> {
    let mut first_at: FastHashMap<_, u32> = FastHashMap::default();
    let mut merged = |index: u32| {
        let place = vertices[index as usize].to_array().map(|x| (x + 0.0).to_bits());
        *first_at.entry(place).or_insert(index)
    };
    let mut balance: FastHashMap<[u32; 2], i32> = FastHashMap::default();
    for element in indices {
        for_each_end(element.map(&mut merged), |end, sign| {
            *balance.entry(end).or_default() += sign
        });
    }
    let is_closed = balance.values().all(|sum| *sum == 0);
    Some(enclosed(vertices, indices)).filter(|volume| is_closed && *volume > 0.0)
}

/// A compound of the results of `finish` for each convex part.
pub(super) fn decompose(
    vertices: &[Vector],
    indices: &[[u32; DIM]],
    params: &VHACDParameters,
    finish: impl Fn(ConvexShape) -> SharedShape,
) -> Result<SharedShape, InvalidCollider> {
    check_surface(vertices, indices)?;
    check_parameters(params)?;
    compound_of(hulls_of(vertices, indices, params), finish)
}

/// The convex parts. None if the library fails.
fn hulls_of(
    vertices: &[Vector],
    indices: &[[u32; DIM]],
    params: &VHACDParameters,
) -> Vec<ConvexShape> {
    let hulls = guarded(|| {
        let decomposition = VHACD::decompose(params, vertices, indices, true);
        let parts = decomposition.voxel_parts().iter();
        // A part for which the library fails is omitted: a gap is better than no shape.
        parts.filter_map(|part| guarded(|| shapes::exact_hull(part, vertices, indices))?).collect()
    });
    hulls.unwrap_or_default()
}

fn compound_of(
    hulls: Vec<ConvexShape>,
    finish: impl Fn(ConvexShape) -> SharedShape,
) -> Result<SharedShape, InvalidCollider> {
    let parts: Vec<_> = hulls.into_iter().map(|hull| (Pose::IDENTITY, finish(hull))).collect();
    if parts.is_empty() {
        let reason = "no convex part of it has a volume";
        return Err(InvalidCollider::Degenerate { shape: "mesh", reason });
    }
    check_parts(&parts)?;
    Ok(SharedShape::new(Compound::new(parts)))
}

fn check_parameters(params: &VHACDParameters) -> Result<(), InvalidCollider> {
    check_margin("concavity", params.concavity)?;
    check_margin("alpha", params.alpha)?;
    check_margin("beta", params.beta)?;
    check_resolution(params.resolution)?;
    check_count("resolution", params.resolution, 2..=u32::MAX)?;
    check_count("plane_downsampling", params.plane_downsampling, 1..=DOWNSAMPLING_MAX)?;
    check_count("convex_hull_downsampling", params.convex_hull_downsampling, 1..=DOWNSAMPLING_MAX)?;
    check_count("max_convex_hulls", params.max_convex_hulls, 1..=HULLS_MAX)
}

fn check_count(
    parameter: &'static str,
    value: u32,
    range: core::ops::RangeInclusive<u32>,
) -> Result<(), InvalidCollider> {
    if range.contains(&value) {
        return Ok(());
    }
    let expected = if *range.start() == 2 { "at least 2" } else { "between 1 and 65536" };
    Err(InvalidCollider::Number { parameter, value: value as Real, expected })
}
