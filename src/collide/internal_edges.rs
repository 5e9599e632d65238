//! Ghost contacts: contacts with internal edges of a surface of many pieces.
//!
//! A body that slides over tiles penetrates them a little, because contacts are soft. The next tile then
//! seems to be hit from the side: its shortest separation is against the motion. Each contact by itself is
//! correct; together the tiles are a floor without any sides. Bodies that catch on internal edges are the
//! oldest complaint about physics engines.
//!
//! Two rules find contacts that are not there. Let `X` be a convex body that touches the non-dynamic pieces
//! `A` and `B`, with the normals `a` and `b`, which point to `X`.
//!
//! 1. **Behind.** Assume that no point of `B` is above the plane through the contact with `A`. Then `B`
//!    cannot obstruct `X`, which is above that plane up to its contact with `A`: the normal `a` separates `X`
//!    from both. This holds for level tiles, for tiles behind a gap and for lower ones. It needs no
//!    connectivity of the pieces, so it is the same for the triangles of a mesh, for colliders, and for
//!    bodies.
//! 2. **Hidden.** The rule has four conditions. `X` meets `B` at an edge or a corner (`b` is no normal of a
//!    face of `B`). This point lies on `A`. `A` rises from there above the plane of the contact. A face of
//!    `B` with a normal near `a` begins there. The point is then the lowest line of a valley, and `X` touches
//!    one of its sides already. It reaches the other side before it reaches the line. Otherwise a ball would
//!    bounce at the lowest line of each valley of a terrain. (The foot of a wall is no such point: the wall
//!    has no face there with the floor's normal.)
//!
//! In either case `B` may still support `X` with its face whose normal is near `a`. The contact is recomputed
//! with that face, and removed only if there is none.
//!
//! A step is ignored if it is lower than the tolerance (`IntegrationParameters::allowed_linear_error`, 1 mm
//! by default). `X` must touch `A` in the same step. A body that lands flat beside an edge, or that is deep
//! in `B` at its first contact, meets the nearest side of `B`. Parts of a compound slide if they are above
//! the plane as a whole; moving meshes catch. And a plane is that of `A`'s face if the contact is within 0.17
//! degrees of it.
//!
//! Other engines mark the edges of a mesh as convex or not (Bullet, Jolt, parry), or store the corners of
//! neighbours in segments (Box2D). That requires known neighbours, and works within one shape only.

use super::normals::{FACE_COSINE_MIN, FACE_NORMAL_COSINE_MIN, NORMAL_DISTANCE_SQUARED_MAX};
use super::parts::Parts;
use crate::dim::collide::{Flat, FlatShape, Polytope, flat_corners};
use crate::dim::math::{Pose, Real, Vector};
use parry::query::PointQuery;
use parry::shape::Shape;
use smallvec::SmallVec;

/// The plane of a contact is that of the piece's face if their normals differ by at most this squared length
/// (0.17 degrees). Bodies on a face are level to about that.
const FACE_NORMAL_DISTANCE_SQUARED_MAX: Real = 9.0e-6;
/// Least height of the other side of a hidden internal edge above the contact plane, as a fraction of the
/// tolerance.
const HEIGHT_FRACTION_MIN: Real = 0.05;
/// Planes whose normals differ by less than this squared length stay together over 1000 times the tolerance
/// and more.
const PLANE_NORMAL_DISTANCE_SQUARED_MAX: Real = 1.0e-10;
/// Most planes that are compared with, the deepest: a ball in a bowl of its own radius touches thousands.
const PLANES_MAX: usize = 16;

/// A convex part of a shape, somewhere in the common frame.
#[derive(Copy, Clone)]
pub(super) enum Piece<'a> {
    /// A piece of a surface, in the common frame.
    Flat(Flat),
    /// A piece of a [coplanar patch](super::search) in the common frame, and all of them in a frame at a
    /// pose.
    CoplanarPatch(Flat, &'a [FlatShape], Pose),
    /// A convex shape, the polytope that it is, if it is one, and its pose.
    Convex(&'a dyn Shape, Option<(Polytope<'a>, Real)>, Pose),
    /// A part of a shape at a pose.
    Part(Parts<'a>, u32, Pose),
}

impl<'a> Piece<'a> {
    /// The part with this number of a shape at a pose.
    pub fn new(parts: Parts<'a>, id: u32, pose: Pose) -> Self {
        match parts {
            Parts::Convex(shape) => Self::Convex(shape, Polytope::of(shape), pose),
            _ => parts
                .flat(id)
                .map_or(Self::Part(parts, id, pose), |flat| Self::Flat(flat.at(&pose))),
        }
    }

    /// The patch of these pieces, in a frame at a pose; `None` if there are none.
    pub fn coplanar_patch(pieces: &'a [FlatShape], pose: Pose) -> Option<Self> {
        let flat = pieces.first().and_then(Flat::new)?;
        Some(Self::CoplanarPatch(flat.at(&pose), pieces, pose))
    }

    /// Calls `f` with the part, the polytope that it is, if it is one, and its pose.
    fn with<T>(
        &self,
        mut f: impl FnMut(&dyn Shape, Option<(Polytope<'_>, Real)>, &Pose) -> T,
    ) -> Option<T> {
        match self {
            // Any piece of a patch has the plane of all.
            Self::Flat(flat) | Self::CoplanarPatch(flat, ..) => {
                Some(f(flat.as_shape(), Some((flat.as_polytope(), 0.0)), &Pose::IDENTITY))
            }
            Self::Convex(shape, polytope, pose) => Some(f(*shape, *polytope, pose)),
            Self::Part(parts, id, pose) => {
                let mut result = None;
                parts.with_part(*id, &mut |part| {
                    let pose = part.pose.map_or(*pose, |in_shape| *pose * *in_shape);
                    result = Some(f(part.shape, Polytope::of(part.shape), &pose));
                });
                result
            }
        }
    }

    /// The extent along a direction; `None` if infinite.
    fn height(&self, direction: Vector) -> Option<Real> {
        if let Self::Flat(flat) = self {
            return Some(flat.height(direction));
        }
        if let Self::CoplanarPatch(_, pieces, pose) = self {
            let local = pose.rotation.inverse() * direction;
            let corners = pieces.iter().flat_map(flat_corners);
            let highest = corners.map(|corner| corner.dot(local)).reduce(Real::max)?;
            return Some(highest + direction.dot(pose.translation));
        }
        let height = self.with(|shape, polytope, pose| {
            let local = pose.rotation.inverse() * direction;
            let highest = match polytope {
                Some((polytope, radius)) => polytope.support(local) + local * radius,
                None => shape.as_support_map()?.local_support_point(local),
            };
            Some(direction.dot(*pose * highest))
        });
        height.flatten()
    }

    /// Returns whether a point is inside, or as near as `tolerance`.
    fn contains(&self, point: Vector, tolerance: Real) -> bool {
        if let Self::CoplanarPatch(_, pieces, pose) = self {
            let local = pose.inverse_transform_point(point);
            let dist = |flat: &FlatShape| flat.distance_to_local_point(local, true);
            return pieces.iter().any(|flat| dist(flat) <= tolerance);
        }
        let near = self.with(|shape, _, pose| {
            let local = pose.inverse_transform_point(point);
            shape.distance_to_local_point(local, true) <= tolerance
        });
        near == Some(true)
    }

    /// Returns whether a face along `direction` begins at a point.
    fn goes_on_along(&self, direction: Vector, point: Vector, tolerance: Real) -> bool {
        let found = self.with(|_, polytope, pose| {
            let local = pose.rotation.inverse() * direction;
            let (polytope, radius) = polytope?;
            let face = polytope.face_toward(local)?;
            let height = face.normal.dot(pose.inverse_transform_point(point)) - face.offset;
            let faces_direction = face.normal.dot(local) > FACE_COSINE_MIN;
            Some(faces_direction && (height - radius).abs() <= tolerance)
        });
        found.flatten() == Some(true)
    }

    /// The normal of the face along a direction, if they agree.
    fn face(&self, normal: Vector) -> Face {
        let face = self.with(|_, polytope, pose| {
            let local = pose.rotation.inverse() * normal;
            let face = polytope?
                .0
                .face_toward(local)
                .filter(|face| face.normal.dot(local) > FACE_NORMAL_COSINE_MIN);
            Some(face.map_or(Face::Edge, |face| Face::Flat(pose.rotation * face.normal)))
        });
        face.flatten().unwrap_or(Face::Round)
    }
}

/// The face, edge or corner of a piece that is extreme along a direction.
#[derive(Copy, Clone, PartialEq)]
enum Face {
    /// A face of this normal.
    Flat(Vector),
    /// An edge or a corner between faces.
    Edge,
    /// A surface without faces.
    Round,
}

/// A contact of a convex part with a non-dynamic piece, in a frame that is common to all contacts of the
/// part.
#[derive(Copy, Clone)]
pub(super) struct Facet<'a> {
    piece: Piece<'a>,
    /// The touching feature of the piece.
    face: Face,
    /// The body, and its touching part.
    body: Parts<'a>,
    body_part: u32,
    /// Unit normal, from the piece to the body.
    normal: Vector,
    /// The same, or the normal of the piece's face if the contact is with a face. A plane that extends over
    /// other pieces must not tilt with the body.
    plane: Vector,
    /// The deepest point, on the piece.
    place: Vector,
    /// Distance there.
    dist: Real,
}

impl<'a> Facet<'a> {
    pub fn new(
        piece: Piece<'a>,
        body: Parts<'a>,
        body_part: u32,
        normal: Vector,
        place: Vector,
        dist: Real,
    ) -> Self {
        let face = piece.face(normal);
        let plane = match face {
            Face::Flat(face)
                if face.distance_squared(normal) < FACE_NORMAL_DISTANCE_SQUARED_MAX =>
            {
                face
            }
            _ => normal,
        };
        Self { piece, face, body, body_part, normal, plane, place, dist }
    }
}

impl Facet<'_> {
    /// Returns whether the plane of `other` may constrain `self`. Its normal must differ, and the touching
    /// feature of the body must be above it.
    fn may_be_explained_by(&self, other: &Self, tolerance: Real) -> bool {
        if self.plane.distance_squared(other.plane) <= NORMAL_DISTANCE_SQUARED_MAX {
            return false;
        }
        let is_above = || {
            let level = other.plane.dot(other.place) + other.dist.min(0.0) - tolerance;
            let depth = Piece::new(self.body, self.body_part, Pose::IDENTITY).height(-other.plane);
            depth.is_some_and(|depth| -depth >= level)
        };
        self.body_part == other.body_part || is_above()
    }

    /// Returns whether the contact lies in the plane of another.
    fn is_level(&self, other: &Self, tolerance: Real) -> bool {
        let offset = other.plane.dot(self.place - other.place);
        let is_parallel =
            other.plane.distance_squared(self.plane) < PLANE_NORMAL_DISTANCE_SQUARED_MAX;
        is_parallel && offset.abs() < tolerance
    }

    /// Returns whether the collider meets the body with a face along a direction.
    fn is_with_face_along(&self, direction: Vector) -> bool {
        match self.face {
            Face::Flat(face) => face == self.plane && face.dot(direction) > FACE_COSINE_MIN,
            _ => false,
        }
    }

    /// Returns whether the collider of `self` is behind the plane of `other` (first rule).
    fn is_behind(&self, other: &Self, tolerance: Real) -> bool {
        let limit = other.plane.dot(other.place) + tolerance;
        self.piece.height(other.plane).is_some_and(|height| height <= limit)
    }

    /// Returns whether a collider within the plane of `other` hides a point of `self` (second rule). The
    /// point must be on that plane, and a face of its own collider must continue there.
    fn is_hidden_at<'b>(
        &self,
        point: Vector,
        other: &Facet<'_>,
        mut in_plane: impl Iterator<Item = &'b Facet<'b>>,
        tolerance: Real,
    ) -> bool {
        let level = self.normal.dot(point) + HEIGHT_FRACTION_MIN * tolerance;
        other.dist <= self.dist + tolerance
            && other.plane.dot(point - other.place).abs() <= tolerance
            && self.piece.goes_on_along(other.plane, point, tolerance)
            && in_plane.any(|facet| {
                facet.piece.height(self.normal).is_none_or(|height| height > level)
                    && facet.piece.contains(point, tolerance)
            })
    }
}

/// A ghost contact.
#[derive(Copy, Clone, Debug)]
pub(super) struct GhostContact {
    /// Its number.
    pub index: usize,
    /// The number of the contact that explains it.
    explained_by: usize,
    /// The normal along which the piece may still support the body: that of the contact.
    pub along: Vector,
    /// The largest depth of the body for that; a deeper body penetrates it in another direction.
    pub least_dist: Real,
    /// Whether the collider is behind the contact (first rule) or its edge is hidden (second rule).
    pub is_behind: bool,
    /// Whether the collider already supports the body with this face.
    pub is_turned: bool,
}

/// Calls its second argument with each point of a facet, on the facet's piece.
pub(super) type Points<'a> = dyn Fn(usize, &mut dyn FnMut(Vector)) + 'a;

/// Finds the ghost contacts among the first `own` facets; the others are known to be contacts.
///
/// The deepest contacts are tested first, and a ghost contact explains no other, so at least one contact
/// stays.
pub(super) fn find_ghost_contacts(
    facets: &[Facet<'_>],
    own: usize,
    points: &Points<'_>,
    tolerance: Real,
    ghost_contacts: &mut Vec<GhostContact>,
) {
    ghost_contacts.clear();
    let mut order: SmallVec<[usize; 32]> = (0..facets.len()).collect();
    order.sort_by(|&a, &b| facets[a].dist.total_cmp(&facets[b].dist));
    let planes = distinct_planes(facets, &order, tolerance);
    if planes.len() < 2 {
        return;
    }
    let mut search = Search { facets, planes, points, tolerance, ghost_contacts };
    for index in order.into_iter().filter(|index| *index < own) {
        let front = search.in_front_of(index);
        if let Some(explained_by) = front.or_else(|| search.hiding(index)) {
            let other = &facets[explained_by];
            let least_dist = other.dist.min(facets[index].dist) - 2.0 * tolerance;
            let (along, is_behind) = (other.plane, front.is_some());
            let is_turned = facets[index].is_with_face_along(along);
            search.ghost_contacts.push(GhostContact {
                index,
                explained_by,
                along,
                least_dist,
                is_behind,
                is_turned,
            });
            search.planes.retain(|plane| *plane != index);
        }
    }
}

/// The search for ghost contacts.
struct Search<'a> {
    facets: &'a [Facet<'a>],
    /// Numbers of contacts with different planes, the deepest first. Ghost contacts are removed.
    planes: SmallVec<[usize; PLANES_MAX]>,
    points: &'a Points<'a>,
    tolerance: Real,
    /// The ghost contacts found so far.
    ghost_contacts: &'a mut Vec<GhostContact>,
}

impl Search<'_> {
    /// The contacts that may explain a facet.
    fn others(&self, index: usize) -> impl Iterator<Item = usize> {
        let (facet, tolerance) = (&self.facets[index], self.tolerance);
        let explains = move |&other: &usize| {
            other != index && facet.may_be_explained_by(&self.facets[other], tolerance)
        };
        self.planes.iter().copied().filter(explains)
    }

    /// A contact that a facet is behind of.
    fn in_front_of(&self, index: usize) -> Option<usize> {
        let (facet, tolerance) = (&self.facets[index], self.tolerance);
        self.others(index).find(|&other| {
            let other = &self.facets[other];
            facet.is_behind(other, tolerance)
                && !(facet.dist < other.dist && self.is_all_behind(other, facet))
        })
    }

    /// Returns whether all colliders in the plane of a contact are behind another contact. Among tiles, the
    /// tile that the body leaves ends behind its own side wall, and the floor does not.
    fn is_all_behind(&self, contact: &Facet<'_>, other: &Facet<'_>) -> bool {
        let is_ghost = |index: usize| self.ghost_contacts.iter().any(|ghost| ghost.index == index);
        let contacts = self.facets.iter().enumerate().filter(|(index, _)| !is_ghost(*index));
        let mut in_plane = contacts.filter(|(_, facet)| facet.is_level(contact, self.tolerance));
        in_plane.all(|(_, facet)| facet.is_behind(other, self.tolerance))
    }

    /// Returns a contact whose pieces hide a point of a facet, if contacts hide all its points. Several
    /// contacts may hide them; the function returns any of these.
    fn hiding(&self, index: usize) -> Option<usize> {
        let facet = &self.facets[index];
        if facet.face != Face::Edge {
            return None;
        }
        let mut found = None;
        let mut are_all_hidden = true;
        (self.points)(index, &mut |point| {
            let hides = |&other: &usize| {
                let in_plane = self.explained_by(other);
                facet.is_hidden_at(point, &self.facets[other], in_plane, self.tolerance)
            };
            let hiding = self.others(index).find(hides);
            are_all_hidden &= hiding.is_some();
            found = found.or(hiding);
        });
        found.filter(|_| are_all_hidden)
    }

    /// A contact, those in its plane, and the ghost contacts that it explains.
    fn explained_by(&self, index: usize) -> impl Iterator<Item = &Facet<'_>> {
        let contact = &self.facets[index];
        let same = move |facet: &&Facet<'_>| {
            facet.plane.distance_squared(contact.plane) <= NORMAL_DISTANCE_SQUARED_MAX
        };
        let ghost_contacts =
            self.ghost_contacts.iter().filter(move |ghost| ghost.explained_by == index);
        let ghost_contacts = ghost_contacts.map(|ghost| &self.facets[ghost.index]);
        self.facets.iter().filter(same).chain(ghost_contacts)
    }
}

/// The deepest facet of each plane, the deepest first: a deep contact is least likely to be a ghost contact
/// itself, so it explains first. `order` is that of the facets' depths.
fn distinct_planes(
    facets: &[Facet<'_>],
    order: &[usize],
    tolerance: Real,
) -> SmallVec<[usize; PLANES_MAX]> {
    let mut planes = SmallVec::<[usize; PLANES_MAX]>::new();
    for &index in order {
        let facet = &facets[index];
        let is_known = planes.iter().any(|&plane| facet.is_level(&facets[plane], tolerance));
        if !is_known {
            planes.push(index);
        }
        if planes.len() == PLANES_MAX {
            break;
        }
    }
    planes
}
