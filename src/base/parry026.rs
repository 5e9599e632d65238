//! The parts of parry's interface that differ between its versions, for version 0.26. `parry031.rs` defines
//! the same names for version 0.31, which the engine's own crates use.

use parry::math::{Pose, Real, Vector};
use parry::query::{Contact, ContactManifold, ShapeCastHit, ShapeCastStatus};
use parry::shape::{Compound, SharedShape};
use parry::shape::{PackedFeatureId, PolygonalFeature, PolygonalFeatureMap, Polyline};

/// Public names of other versions, without options.
pub mod names {
    bitflags::bitflags! {
        /// Options of polylines. They have no effect in this version of parry.
        #[derive(Copy, Clone, Debug, PartialEq, Eq)]
        pub struct PolylineFlags: u8 {
            /// The polyline has an inside.
            const ORIENTED = 1;
        }

        /// Options of compounds. This version of parry has none.
        #[derive(Copy, Clone, Debug, PartialEq, Eq)]
        pub struct CompoundFlags: u8 {}
    }
}
pub use names::CompoundFlags;
pub use names::PolylineFlags;

pub type ShapeDistance = Real;
pub type ShapeIntersection = bool;

/// Returns whether a test found an intersection.
pub fn is_intersecting(found: ShapeIntersection) -> bool {
    found
}

/// The distance of two shapes.
pub fn distance_of(found: ShapeDistance) -> Real {
    found
}

/// Hit of a cast. The arrays contain one value for each shape. This version of parry has no place for the
/// parts that were hit.
pub fn shape_cast_hit(
    time_of_impact: Real,
    [witness1, witness2]: [Vector; 2],
    [normal1, normal2]: [Vector; 2],
    status: ShapeCastStatus,
    _: [u32; 2],
) -> ShapeCastHit {
    ShapeCastHit { time_of_impact, witness1, witness2, normal1, normal2, status }
}

/// The result of an intersection test of two shapes. This version of parry has no place for their parts.
pub fn shape_intersection(intersecting: bool, _: [u32; 2]) -> ShapeIntersection {
    intersecting
}

/// The distance of two shapes. This version of parry has no place for their parts.
pub fn shape_distance(distance: Real, _: [u32; 2]) -> ShapeDistance {
    distance
}

/// A contact. This version of parry has no place for its parts.
pub fn contact_of_parts(contact: Contact, _: [u32; 2]) -> Contact {
    contact
}

/// The part of the shape that a ray hit has no place in this version of parry.
pub fn set_subshape(_: &mut parry::query::RayIntersection, _: u32) {}

/// Writes the feature of a shape in a direction. A round cap has a vertex next to the point `hint`.
///
/// This version of parry turns a cap's square by the direction alone. The square then misses up to a third of
/// the cap near its rim. A slightly tilted direction turns the square towards the point.
pub fn support_feature(
    shape: &dyn PolygonalFeatureMap,
    direction: Vector,
    hint: Vector,
    feature: &mut PolygonalFeature,
) {
    shape.local_support_feature(direction, feature);
    // The faces and vertices of a polyhedron may have the numbers of a cap.
    if !shape.is_convex_polyhedron()
        && is_round_cap(feature)
        && let Some(azimuth) = (Vector { y: 0.0, ..hint }).try_normalize()
    {
        let tilted = Vector::Y * direction.y + azimuth * CAP_TILT;
        shape.local_support_feature(tilted, feature);
    }
}

/// Tangent of the tilt that selects the orientation of a cap: far below the 60° at which another feature of a
/// cylinder is selected.
const CAP_TILT: Real = 0.01;

/// Returns whether a feature has the numbers that parry gives to the cap of a cylinder or a cone. In two
/// dimensions no feature has four vertices.
fn is_round_cap(feature: &PolygonalFeature) -> bool {
    let is_cap = |face, vertices: [u32; 4]| {
        feature.fid == PackedFeatureId::face(face)
            && feature.vids.into_iter().eq(vertices.map(PackedFeatureId::vertex))
    };
    feature.num_vertices == 4 && (is_cap(9, [1, 3, 5, 7]) || is_cap(19, [11, 13, 15, 17]))
}

/// Poses of the parts of a manifold, `None` for the identity.
pub fn take_subshape_poses<M, P>(raw: &mut ContactManifold<M, P>) -> [Option<Pose>; 2] {
    [raw.subshape_pos1.take(), raw.subshape_pos2.take()]
}

/// A polyline with options.
pub fn polyline(
    vertices: Vec<Vector>,
    indices: Option<Vec<[u32; 2]>>,
    _: PolylineFlags,
) -> Polyline {
    Polyline::new(vertices, indices)
}

/// Options of a polyline.
#[cfg(feature = "serde-serialize")]
pub fn polyline_flags(_: &Polyline) -> PolylineFlags {
    PolylineFlags::empty()
}

/// A compound with options.
pub fn compound(parts: Vec<(Pose, SharedShape)>, _: CompoundFlags) -> Compound {
    Compound::new(parts)
}

/// Options of a compound.
pub fn compound_flags(_: &Compound) -> CompoundFlags {
    CompoundFlags::empty()
}
