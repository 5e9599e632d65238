//! Convex decomposition: a concave mesh as a compound of convex parts, by parry's V-HACD.

use super::check::{check_margin, check_parts};
use super::grid::check_resolution;
use super::shapes::check_surface;
use super::{ColliderBuilder, InvalidCollider};
use crate::base::guard::guarded;
use crate::dim::hull::ConvexShape;
use crate::dim::math::{DIM, Pose, Real, Vector};
use crate::dim::shapes;
use parry::shape::{Compound, RoundShape, SharedShape};
use parry::transformation::vhacd::{VHACD, VHACDParameters};

/// Steps of the search that are multiplied with each other further down must not overflow.
const DOWNSAMPLING_MAX: u32 = 65_536;
const HULLS_MAX: u32 = 65_536;

/// Concave meshes as convex parts.
impl ColliderBuilder {
    /// A compound of convex parts that fill the interior of a surface (segments in 2D, triangles in 3D). The
    /// decomposition is slow: compute it in advance for shapes that are used often.
    pub fn convex_decomposition(vertices: &[Vector], indices: &[[u32; DIM]]) -> Self {
        Self::convex_decomposition_with_params(vertices, indices, &VHACDParameters::default())
    }

    /// A compound of convex parts that fill the interior of a surface, computed with the given parameters.
    pub fn convex_decomposition_with_params(
        vertices: &[Vector],
        indices: &[[u32; DIM]],
        params: &VHACDParameters,
    ) -> Self {
        Self::of(decompose(vertices, indices, params, SharedShape::new))
    }

    /// A compound of convex parts that fill the interior of a surface. Each part is enlarged and rounded by
    /// `border_radius` (length units) on all sides.
    pub fn round_convex_decomposition(
        vertices: &[Vector],
        indices: &[[u32; DIM]],
        border_radius: Real,
    ) -> Self {
        let params = VHACDParameters::default();
        Self::round_convex_decomposition_with_params(vertices, indices, &params, border_radius)
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

/// A compound of the results of `finish` for each convex part.
pub(super) fn decompose(
    vertices: &[Vector],
    indices: &[[u32; DIM]],
    params: &VHACDParameters,
    finish: impl Fn(ConvexShape) -> SharedShape,
) -> Result<SharedShape, InvalidCollider> {
    check_surface(vertices, indices)?;
    check_parameters(params)?;
    let hulls = guarded(|| {
        let decomposition = VHACD::decompose(params, vertices, indices, true);
        let parts = decomposition.voxel_parts().iter();
        // A part for which the library fails is omitted: a gap is better than no shape.
        parts.filter_map(|part| guarded(|| shapes::exact_hull(part, vertices, indices))?).collect()
    });
    let hulls: Vec<ConvexShape> = hulls.unwrap_or_default();
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
