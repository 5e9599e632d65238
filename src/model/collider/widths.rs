//! Width of convex parts: the measure of motion in continuous collision detection.
//!
//! The *width* of a convex set along a direction is the distance of the two planes across that direction
//! between which the set lies. Its *minimum width* is the least of these over all directions. Examples are
//! the diameter of a ball, the height of a disc and the thickness of a plate in any orientation. The
//! *thickness* of a part is half its minimum width. No point of it is deeper below the surface than that. A
//! body that moves less than its thickness keeps its middle on one side of everything.
//!
//! Boxes, cylinders, cones and round shapes have formulas. Hulls, triangles and custom shapes are searched
//! ([`crate::dim::width`]), with a lower bound as the result. A thickness that is too small makes a body fast
//! too early; one that is too large lets it through.

use super::ColliderMassProps;
use crate::base::planar_width::NarrowFrame;
use crate::dim::math::{DIM, Real, Rotation, Vector};
use crate::dim::width::{self, TRIANGLES_ARE_SOLID, narrow_frame};
use parry::shape::{Shape, SupportMap, Triangle, TypedShape};
use std::sync::Arc;

/// Thinning of a convex part.
///
/// The *skeleton* of a part `K` is `c + S (K - c)` with a linear map `S = R diag(skeleton) Rᵀ`. It is flat
/// along the direction of minimum width, and as large as fits into `K` across it. All of `c + ((1 - t) 1 + t
/// S)(K - c)`, for `t` from 0 to 1, lie in `(1 - t) K + t S K`, and so in the convex `K`. For a box with half
/// extents `h` they are the boxes with half extents `h - t min h`.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Widths {
    /// A point well inside, in the part's frame.
    pub center: Vector,
    /// From the frame of the axes to the part's. The first axis is the direction of minimum width, unless
    /// they are the part's own.
    pub axes: Rotation,
    /// The size of the skeleton along the axes, relative to that of the part.
    pub skeleton: Vector,
    /// Half the minimum width, or a little less: 0 for surfaces, which have no inside, infinite for
    /// half-spaces.
    pub thickness: Real,
}

/// Gap between the skeleton and the surface, as a fraction of the smallest distance from the centre to a
/// face.
const SKELETON_MARGIN: Real = 0.5;

impl Widths {
    /// The widths of a convex part.
    pub fn of(part: &dyn Shape) -> Self {
        let typed = part.as_typed_shape();
        let aligned = |center, half: Vector, thickness| Self {
            center,
            axes: Rotation::IDENTITY,
            skeleton: flattened(half, thickness),
            thickness,
        };
        let centered = |half: Vector| aligned(Vector::ZERO, half, half.min_element());
        match typed {
            TypedShape::HalfSpace(_) => centered(Vector::splat(Real::INFINITY)),
            TypedShape::Ball(b) => centered(Vector::splat(b.radius)),
            TypedShape::Cuboid(c) => centered(c.half_extents),
            TypedShape::RoundCuboid(c) => {
                centered(c.inner_shape.half_extents + Vector::splat(c.border_radius))
            }
            TypedShape::Capsule(c) => {
                let center = c.segment.a.midpoint(c.segment.b);
                aligned(center, Vector::splat(c.radius), c.radius)
            }
            TypedShape::Segment(s) => aligned(s.a.midpoint(s.b), Vector::ZERO, 0.0),
            // A surface has no core, and so no skeleton that must fit.
            TypedShape::Triangle(t) if !TRIANGLES_ARE_SOLID => of_triangle(t, 0.0),
            TypedShape::Triangle(t) => of_triangle(t, 0.0).fitted(part),
            TypedShape::RoundTriangle(t) => {
                of_triangle(&t.inner_shape, t.border_radius).fitted(part)
            }
            _ => match width::aligned(typed) {
                Some((center, half, thickness)) => aligned(center, half, thickness).fitted(part),
                None => {
                    of_corners(part).or_else(|| of_support(part)).unwrap_or_else(|| of_box(part))
                }
            },
        }
    }

    /// Makes the skeleton as small as it must be to keep its distance from all faces: with unit normals `n`,
    /// `λ` for which
    ///
    /// ```text
    /// λ h(S n) ≤ h(n) - margin · min h(n),  h(n) = max n·(x - c) over x in K
    /// ```
    fn fitted(self, part: &dyn Shape) -> Self {
        let Some(support) = part.as_support_map() else { return self };
        let height = |along: Vector| (support.local_support_point(along) - self.center).dot(along);
        let normals = width::face_normals(part.as_typed_shape());
        let least = normals.iter().map(|n| height(*n)).fold(Real::INFINITY, Real::min);
        let scales = normals.iter().map(|&normal| {
            let flat = self.axes * ((self.axes.inverse() * normal) * self.skeleton);
            let (room, needed) = (height(normal) - SKELETON_MARGIN * least, height(flat));
            // `needed` is NaN if the skeleton is flat across the normal. A comparison with NaN is false.
            if needed > room { room.max(0.0) / needed } else { 1.0 }
        });
        Self { skeleton: self.skeleton * scales.fold(1.0, Real::min), ..self }
    }

    /// The widths of all parts of a shape, by their numbers, where computing them again would cost more than
    /// looking them up.
    pub fn of_costly(shape: &dyn Shape) -> Option<Arc<[Self]>> {
        match shape.as_typed_shape() {
            TypedShape::Compound(compound) => {
                let parts = compound.shapes();
                let any = parts.iter().any(|(_, part)| is_costly(&**part));
                any.then(|| parts.iter().map(|(_, part)| Self::of(&**part)).collect())
            }
            _ => is_costly(shape).then(|| Arc::from([Self::of(shape)])),
        }
    }
}

/// The thickness of the thinnest part of a shape. `known` are the widths of its parts, if they are kept.
pub(crate) fn thickness(shape: &dyn Shape, known: Option<&[Widths]>) -> Real {
    let least = |parts: &mut dyn Iterator<Item = Real>| parts.fold(Real::INFINITY, Real::min);
    match (shape.as_typed_shape(), known) {
        (_, Some(known)) => least(&mut known.iter().map(|part| part.thickness)),
        (TypedShape::Compound(compound), None) => {
            least(&mut compound.shapes().iter().map(|(_, part)| thickness(&**part, None)))
        }
        (TypedShape::Voxels(voxels), None) => 0.5 * voxels.voxel_size().min_element(),
        (TypedShape::TriMesh(_) | TypedShape::Polyline(_) | TypedShape::HeightField(_), None) => {
            0.0
        }
        _ => Widths::of(shape).thickness,
    }
}

/// Returns whether the widths of a shape are searched for, or its skeleton is fitted to faces. All others
/// have a formula.
fn is_costly(shape: &dyn Shape) -> bool {
    let typed = shape.as_typed_shape();
    match typed {
        TypedShape::Triangle(_) => TRIANGLES_ARE_SOLID,
        TypedShape::Custom(_) => true,
        _ => width::corners(typed).is_some() || !width::face_normals(typed).is_empty(),
    }
}

fn of_triangle(triangle: &Triangle, layer: Real) -> Widths {
    let Triangle { a, b, c } = *triangle;
    let center = (a + b + c) / 3.0;
    if !TRIANGLES_ARE_SOLID && layer == 0.0 {
        let (axes, skeleton) = (Rotation::IDENTITY, Vector::ONE);
        return Widths { center, axes, skeleton, thickness: 0.0 };
    }
    let frame = narrow_frame(|along| farthest([a, b, c], along));
    let least = if TRIANGLES_ARE_SOLID { frame.least } else { 0.0 };
    with_layer(center, NarrowFrame { least, ..frame }, layer)
}

fn of_corners(part: &dyn Shape) -> Option<Widths> {
    let (points, layer) = width::corners(part.as_typed_shape())?;
    let frame = narrow_frame(|along| farthest(points.iter().copied(), along));
    let mass = ColliderMassProps::Density(1.0).mass_properties(part);
    // The centre of mass of a convex body is inside, by 1/4 of the width along each direction (1/3 in 2D).
    let is_inside = mass.mass() > 0.0;
    let center = if is_inside { mass.local_com } else { mean(points) };
    Some(with_layer(center, frame, layer).fitted(part))
}

fn of_support(part: &dyn Shape) -> Option<Widths> {
    let support = part.as_support_map()?;
    let frame = narrow_frame(|along| support.local_support_point(along));
    let is_usable = frame.widths.is_finite() && frame.least.is_finite();
    // Without known faces, the skeleton is a point.
    let widths = with_layer(inner_point(support), frame, 0.0);
    is_usable.then_some(Widths { skeleton: Vector::ZERO, ..widths })
}

/// For shapes without support points: their own value, limited by their box.
fn of_box(part: &dyn Shape) -> Widths {
    let aabb = part.compute_local_aabb();
    let half = aabb.half_extents();
    let said = part.ccd_thickness().max(0.0);
    let thickness = said.min(half.min_element());
    Widths { center: aabb.center(), axes: Rotation::IDENTITY, skeleton: Vector::ZERO, thickness }
}

fn with_layer(center: Vector, frame: NarrowFrame, layer: Real) -> Widths {
    let (half, thickness) = (frame.widths * 0.5 + Vector::splat(layer), 0.5 * frame.least + layer);
    Widths { center, axes: frame.axes, skeleton: flattened(half, thickness), thickness }
}

/// Relative size of a part along axes with the half widths `half`, after its thickness is removed on all
/// sides.
fn flattened(half: Vector, thickness: Real) -> Vector {
    let scale = (half - Vector::splat(thickness)).max(Vector::ZERO) / half;
    Vector::select(half.cmpgt(Vector::ZERO), scale, Vector::ONE)
}

fn farthest(points: impl IntoIterator<Item = Vector>, along: Vector) -> Vector {
    let reach = |point: &Vector| point.dot(along);
    let farther = |a: &Vector, b: &Vector| reach(a).total_cmp(&reach(b));
    points.into_iter().max_by(farther).unwrap_or_default()
}

fn mean(points: &[Vector]) -> Vector {
    points.iter().copied().sum::<Vector>() / points.len().max(1) as Real
}

/// A point inside a convex shape, at the centre of symmetric shapes: the mean of its farthest points along
/// all diagonals. (Along the axes the farthest points of a box are whole faces, and the result may be any of
/// their corners.)
fn inner_point(shape: &dyn SupportMap) -> Vector {
    let corners = 1 << DIM;
    let diagonal = |corner: usize| {
        let mut direction = Vector::ONE;
        (0..DIM).filter(|k| corner >> k & 1 == 1).for_each(|k| direction[k] = -1.0);
        shape.local_support_point(direction)
    };
    (0..corners).map(diagonal).sum::<Vector>() / corners as Real
}
