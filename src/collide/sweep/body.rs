//! Convex parts as the search sees them: whole, or without an outer layer.

use crate::base::closest::{Closest, closest, extents};
use crate::dim::collide::{Flat, as_flat};
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::bounding_volume::Aabb;
use parry::shape::{Shape, SupportMap, TypedShape};

/// A convex part: a sharp body and a layer of some thickness around it.
pub(super) struct Body<'a> {
    sharp: Sharp<'a>,
    radius: Real,
    /// The part, if nothing was taken off.
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

/// A convex shape, drawn together along its axes towards a point inside.
#[derive(Copy, Clone)]
struct Shrunk<'a> {
    shape: &'a dyn SupportMap,
    center: Vector,
    scale: Vector,
}

impl SupportMap for Shrunk<'_> {
    fn local_support_point(&self, direction: Vector) -> Vector {
        let scaled = direction * self.scale;
        // Drawn together to nothing along that direction: all points are as good, but none lies that way.
        let ahead = if scaled == Vector::ZERO { direction } else { scaled };
        let point = self.shape.local_support_point(ahead);
        self.center + (point - self.center) * self.scale
    }
}

impl<'a> Body<'a> {
    /// A part as it is; `None` if nothing is known of where it ends.
    pub fn whole(part: &'a dyn Shape) -> Option<Self> {
        let center = Vector::ZERO;
        let sharp = |shape, scale| Sharp::Convex(Shrunk { shape, center, scale });
        let (sharp, radius) = match part.as_typed_shape() {
            TypedShape::HalfSpace(plane) => (Sharp::Plane(plane.normal), 0.0),
            TypedShape::Ball(ball) => (sharp(ball, Vector::ZERO), ball.radius),
            TypedShape::Capsule(capsule) => (sharp(&capsule.segment, Vector::ONE), capsule.radius),
            _ => (sharp(part.as_support_map()?, Vector::ONE), 0.0),
        };
        let flat = as_flat(part).and_then(Flat::new).map(|flat| flat.normal());
        Some(Self { sharp, radius, whole: Some(part), flat })
    }

    /// What of a whole box is within a region of its frame. A search of closest points has few digits for a floor of a kilometre.
    pub fn within(self, region: &Aabb) -> Self {
        let cuboid = self.whole.and_then(|part| part.as_cuboid());
        let Some((half, shrunk)) = cuboid.map(|cuboid| cuboid.half_extents).zip(self.convex())
        else {
            return self;
        };
        let (low, high) = (region.mins.max(-half), region.maxs.min(half));
        let scale = (high - low) / (half + half);
        // Nothing to take off, or nothing left.
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

    /// The point that is left of a ball, or of the core of one.
    fn as_point(&self) -> Option<Vector> {
        match &self.sharp {
            Sharp::Convex(shape) if shape.scale == Vector::ZERO => Some(shape.center),
            _ => None,
        }
    }

    /// The same, drawn together to this share of its size.
    pub fn shrunk(self, share: Real) -> Self {
        let Sharp::Convex(Shrunk { shape, center, scale }) = self.sharp else { return self };
        if share == 1.0 {
            return self;
        }
        let is_whole = scale == Vector::ONE;
        let center = if is_whole { middle(shape) } else { center };
        let sharp = Sharp::Convex(Shrunk { shape, center, scale: scale * share });
        Self { sharp, whole: None, flat: None, ..self }
    }

    /// A part without its outer layer of this depth.
    pub fn core(shape: &'a dyn Shape, depth: Real) -> Option<Self> {
        let Self { sharp, radius, .. } = Self::whole(shape)?;
        let Sharp::Convex(shrunk) = sharp else { return None };
        if depth <= radius {
            return Some(Self { sharp, radius: radius - depth, whole: None, flat: None });
        }
        let half_extents = shape.compute_local_aabb().half_extents();
        let scale = (half_extents - Vector::splat(depth)).max(Vector::ZERO) / half_extents;
        // Along an axis in which the shape has no thickness there is nothing to take off.
        let scale = Vector::select(half_extents.cmpgt(Vector::ZERO), scale, Vector::ONE);
        let sharp = Sharp::Convex(Shrunk { center: middle(shrunk.shape), scale, ..shrunk });
        Some(Self { sharp, radius: 0.0, whole: None, flat: None })
    }

    /// A part without thickness, drawn together to this share of its size.
    pub fn middle(shape: &'a dyn Shape, share: Real) -> Option<Self> {
        let Self { sharp, radius, flat, .. } = Self::whole(shape)?;
        let Sharp::Convex(shrunk) = sharp else { return None };
        let center = inner_point(shape).unwrap_or_else(|| middle(shrunk.shape));
        let sharp = Sharp::Convex(Shrunk { center, scale: Vector::splat(share), ..shrunk });
        Some(Self { sharp, radius, whole: None, flat })
    }

    /// The direction to another body, in the frame of this one, and the distance; `None` if it is farther than `reach`.
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
                // Of a triangle that is much larger than the other one the search may say that they overlap where they do not.
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

    /// How fast a turn by an angle of one moves the points of the sharp body (length units), about a centre. The layer around it is as
    /// thick everywhere, so turning does not move that.
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

/// By what share of it a distance that the search of closest points finds may be too large: it ends where an upper and a lower bound
/// differ by no more. On a way of 30 m that is 3 cm in `f32`, and who jumped ahead by that was on the other side.
fn search_error() -> Real {
    (10.0 * Real::EPSILON).sqrt()
}

/// The one of some directions along which two shapes are farthest apart, and how far: no more than their distance.
///
/// Between a wide floor and something thin and near the search may lose itself and say that they are far apart. This is what is
/// certain.
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

/// The direction from a point to a part at `pos12`, and its distance: exact where a search of closest points has its
/// tolerances. 0 if it is inside.
fn nearest(pos12: &Pose, point: Vector, part: &dyn Shape, last_normal: Vector) -> (Vector, Real) {
    let local = pos12.inverse_transform_point(point);
    let way = part.project_local_point(local, true).point - local;
    let dist = way.length();
    let normal = if dist > 0.0 { pos12.rotation * (way / dist) } else { last_normal };
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

/// A point inside a convex shape, in the middle of what has one: the mean of its farthest points along all diagonals.
/// (Along the axes the farthest points of a box are whole faces, and it may say any of their corners.)
fn middle(shape: &dyn SupportMap) -> Vector {
    let corners = 1 << DIM;
    let diagonal = |corner: usize| {
        let mut direction = Vector::ONE;
        (0..DIM).filter(|k| corner >> k & 1 == 1).for_each(|k| direction[k] = -1.0);
        shape.local_support_point(direction)
    };
    (0..corners).map(diagonal).sum::<Vector>() / corners as Real
}

/// The mean of the corners of what has no inside.
fn inner_point(shape: &dyn Shape) -> Option<Vector> {
    match shape.as_typed_shape() {
        TypedShape::Triangle(triangle) => Some((triangle.a + triangle.b + triangle.c) / 3.0),
        TypedShape::Segment(segment) => Some((segment.a + segment.b) * 0.5),
        _ => None,
    }
}
