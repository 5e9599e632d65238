//! Convex parts of the search: whole, or without an outer layer.

use crate::base::closest::{Closest, closest, extents};
use crate::dim::collide::{Flat, as_flat};
use crate::dim::math::{DIM, Pose, Real, Rotation, Vector};
use crate::model::collider::Widths;
use parry::bounding_volume::Aabb;
use parry::shape::{Shape, SupportMap, TypedShape};

/// A convex part: a sharp body and a layer of some thickness around it.
pub(super) struct Body<'a> {
    sharp: Sharp<'a>,
    radius: Real,
    /// The part, if it has no removed layer.
    whole: Option<&'a dyn Shape>,
    /// The normal of a part that is flat.
    flat: Option<Vector>,
}

#[derive(Copy, Clone)]
enum Sharp<'a> {
    Convex(Shrunk<'a>),
    /// Everything behind the plane through the origin with this normal.
    Plane(Vector),
}

/// A convex shape, scaled along orthogonal axes about a point inside. With `M = R diag(scale) Rᵀ`, `R` the
/// axes, the support point of `c + M (K - c)` along `d` is `c + M (p - c)`, `p` that of `K` along `M d` (`M`
/// is symmetric).
#[derive(Copy, Clone)]
struct Shrunk<'a> {
    shape: &'a dyn SupportMap,
    center: Vector,
    /// From the frame of the axes to the shape's.
    axes: Rotation,
    scale: Vector,
}

impl Shrunk<'_> {
    fn scaled(&self, v: Vector) -> Vector {
        if self.axes == Rotation::IDENTITY {
            return v * self.scale;
        }
        self.axes * ((self.axes.inverse() * v) * self.scale)
    }
}

impl SupportMap for Shrunk<'_> {
    fn local_support_point(&self, direction: Vector) -> Vector {
        let scaled = self.scaled(direction);
        // A scale of zero along that direction: all points are support points.
        let ahead = if scaled == Vector::ZERO { direction } else { scaled };
        let point = self.shape.local_support_point(ahead);
        self.center + self.scaled(point - self.center)
    }
}

impl<'a> Body<'a> {
    /// A part without shrinking; `None` if its extent is unknown.
    pub fn whole(part: &'a dyn Shape) -> Option<Self> {
        let center = Vector::ZERO;
        let axes = Rotation::IDENTITY;
        let sharp = |shape, scale| Sharp::Convex(Shrunk { shape, center, axes, scale });
        let (sharp, radius) = match part.as_typed_shape() {
            TypedShape::HalfSpace(plane) => (Sharp::Plane(plane.normal), 0.0),
            TypedShape::Ball(ball) => (sharp(ball, Vector::ZERO), ball.radius),
            TypedShape::Capsule(capsule) => (sharp(&capsule.segment, Vector::ONE), capsule.radius),
            _ => (sharp(part.as_support_map()?, Vector::ONE), 0.0),
        };
        let flat = as_flat(part).and_then(Flat::new).map(|flat| flat.normal());
        Some(Self { sharp, radius, whole: Some(part), flat })
    }

    /// The part of a whole box within a region of its frame. The closest-point search has few digits for a
    /// floor of a kilometre.
    pub fn within(self, region: &Aabb) -> Self {
        let cuboid = self.whole.and_then(|part| part.as_cuboid());
        let Some((half, shrunk)) = cuboid.map(|cuboid| cuboid.half_extents).zip(self.convex())
        else {
            return self;
        };
        let (low, high) = (region.mins.max(-half), region.maxs.min(half));
        let scale = (high - low) / (half + half);
        // There is no layer, or no core.
        let cuts = scale.cmplt(Vector::ONE) & scale.cmpgt(Vector::ZERO);
        let scale = Vector::select(cuts, scale, Vector::ONE);
        let center = (low + high) * 0.5 / (Vector::ONE - scale);
        let center = Vector::select(cuts, center, Vector::ZERO);
        Self { sharp: Sharp::Convex(Shrunk { center, scale, ..shrunk }), ..self }
    }

    fn convex(&self) -> Option<Shrunk<'a>> {
        match self.sharp {
            Sharp::Convex(shrunk) => Some(shrunk),
            Sharp::Plane(_) => None,
        }
    }

    /// The point of the sharp body that is farthest along a direction; `None` if there is none.
    pub fn support_point(&self, direction: Vector) -> Option<Vector> {
        self.convex().map(|shape| shape.local_support_point(direction))
    }

    /// The point that is left of a ball, or of the core of one.
    fn as_point(&self) -> Option<Vector> {
        match &self.sharp {
            Sharp::Convex(shape) if shape.scale == Vector::ZERO => Some(shape.center),
            _ => None,
        }
    }

    /// The same, scaled by this about its centre.
    pub fn shrunk(self, fraction: Real) -> Self {
        let Sharp::Convex(shrunk) = self.sharp else { return self };
        if fraction == 1.0 {
            return self;
        }
        let sharp = Sharp::Convex(Shrunk { scale: shrunk.scale * fraction, ..shrunk });
        Self { sharp, whole: None, flat: None, ..self }
    }

    /// A part without its outer layer: interpolated from the part (`depth` 0) to its skeleton (1).
    pub fn core(shape: &'a dyn Shape, widths: &Widths, depth: Real) -> Option<Self> {
        let Self { sharp, radius, .. } = Self::whole(shape)?;
        let Sharp::Convex(shrunk) = sharp else { return None };
        let Widths { center, axes, skeleton, .. } = *widths;
        if radius > 0.0 {
            let sharp = Sharp::Convex(Shrunk { center, ..shrunk });
            return Some(Self { sharp, radius: radius * (1.0 - depth), whole: None, flat: None });
        }
        let scale = Vector::splat(1.0 - depth) + skeleton * depth;
        let sharp = Sharp::Convex(Shrunk { center, axes, scale, ..shrunk });
        Some(Self { sharp, radius: 0.0, whole: None, flat: None })
    }

    /// A box around it at a pose.
    pub fn aabb(&self, pose: &Pose) -> Aabb {
        let Sharp::Convex(shape) = &self.sharp else { return Aabb::new_invalid() };
        let reach = |direction: Vector| {
            let point = *pose * shape.local_support_point(pose.rotation.inverse() * direction);
            point + direction * self.radius
        };
        let ends = directions().map(|direction| (direction, reach(direction)));
        let (mut mins, mut maxs) = (Vector::ZERO, Vector::ZERO);
        for (k, pair) in ends.chunks(2).enumerate() {
            (maxs[k], mins[k]) = (pair[0].1[k], pair[1].1[k]);
        }
        Aabb::new(mins, maxs)
    }

    /// A part without thickness, scaled by this about its centre.
    pub fn middle(shape: &'a dyn Shape, widths: &Widths, fraction: Real) -> Option<Self> {
        let Self { sharp, radius, flat, .. } = Self::whole(shape)?;
        let Sharp::Convex(shrunk) = sharp else { return None };
        let (center, scale) = (widths.center, Vector::splat(fraction));
        let sharp = Sharp::Convex(Shrunk { center, scale, ..shrunk });
        Some(Self { sharp, radius, whole: None, flat })
    }

    /// The direction to another body, in the frame of this one, and the distance; `None` if it is farther
    /// than `reach`.
    pub fn distance(
        &self,
        other: &Self,
        [pose, other_pose]: &[Pose; 2],
        reach: Real,
        last_normal: Vector,
    ) -> Option<(Vector, Real)> {
        let radius = self.radius + other.radius;
        let pos12 = pose.inv_mul(other_pose);
        if let Some((point, shape)) = self.as_point().zip(other.whole) {
            let found = nearest(&pos12, point, shape, last_normal);
            return Some(found)
                .filter(|&(_, dist)| dist - self.radius <= reach)
                .map(|(normal, dist)| (normal, dist - self.radius));
        }
        let (normal, dist) = match (&self.sharp, &other.sharp) {
            (Sharp::Convex(shape1), Sharp::Convex(shape2)) => {
                let found = match closest(&pos12, shape1, shape2, reach + radius, last_normal) {
                    Closest::Near { normal, dist, .. } if dist <= reach + radius => {
                        (normal, dist - search_error() * dist.abs())
                    }
                    Closest::Near { normal: direction, .. } | Closest::Apart(direction) => {
                        let directions = [direction, last_normal, pos12.translation];
                        widest(&pos12, shape1, shape2, directions)?
                    }
                };
                // For a triangle that is much larger than the other shape, the search may report an overlap
                // of separated shapes.
                let flats = [self.flat, other.flat.map(|normal| pos12.rotation * normal)];
                let across = flats.into_iter().flatten().flat_map(|normal| [normal, -normal]);
                let apart = widest(&pos12, shape1, shape2, across);
                apart.filter(|apart| apart.1 > found.1).unwrap_or(found)
            }
            (Sharp::Convex(shape), Sharp::Plane(normal)) => {
                let down = -(pos12.rotation * *normal);
                let lowest = shape.local_support_point(down);
                (down, (pos12.translation - lowest).dot(down))
            }
            (Sharp::Plane(normal), Sharp::Convex(shape)) => {
                let down = -(pos12.rotation.inverse() * *normal);
                (*normal, (pos12 * shape.local_support_point(down)).dot(*normal))
            }
            (Sharp::Plane(_), Sharp::Plane(_)) => return None,
        };
        Some((normal, dist - radius)).filter(|&(_, dist)| dist <= reach)
    }

    /// Speed of the points of the sharp body (length units) for a rotation by an angle of one about a centre.
    /// The layer around it is as thick everywhere, so turning does not move that.
    pub fn reach_about(&self, center: Vector) -> Real {
        let Sharp::Convex(shape) = &self.sharp else { return Real::MAX };
        let farthest = directions().map(|direction| {
            (shape.local_support_point(direction) - center).dot(direction).max(0.0)
        });
        // The body lies within the box that these make.
        let square: Real = farthest.chunks(2).map(|pair| pair[0].max(pair[1])).map(|r| r * r).sum();
        square.sqrt()
    }
}

/// Relative error of the closest-point search, which ends when an upper and a lower bound differ by at most
/// this. On a path of 30 m that is 3 cm in `f32`, and a jump by that would pass a thin collider.
fn search_error() -> Real {
    (10.0 * Real::EPSILON).sqrt()
}

/// The direction, among some, along which two shapes are farthest apart, and that distance: a lower bound of
/// their distance.
///
/// The search may diverge for a wide floor and a thin object near it, and return a large distance. This is a
/// certain lower bound.
fn widest(
    pos12: &Pose,
    shape1: &Shrunk<'_>,
    shape2: &Shrunk<'_>,
    directions: impl IntoIterator<Item = Vector>,
) -> Option<(Vector, Real)> {
    let known = directions.into_iter().filter_map(Vector::try_normalize);
    let gaps = known.map(|along| (along, extents(pos12, shape1, shape2, along).gap));
    gaps.max_by(|(_, gap1), (_, gap2)| gap1.total_cmp(gap2))
}

/// The direction from a point to a part at `pos12`, and its distance, 0 if it is inside. The result is exact
/// where a search of closest points has tolerances.
fn nearest(pos12: &Pose, point: Vector, part: &dyn Shape, last_normal: Vector) -> (Vector, Real) {
    let local = pos12.inverse_transform_point(point);
    let displacement = part.project_local_point(local, true).point - local;
    let dist = displacement.length();
    let normal = if dist > 0.0 { pos12.rotation * (displacement / dist) } else { last_normal };
    (normal, dist)
}

/// The axes, there and back.
fn directions() -> [Vector; 2 * DIM] {
    core::array::from_fn(|k| {
        let mut direction = Vector::ZERO;
        direction[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
        direction
    })
}
