//! The parts of parry's interface that differ between its versions, for version 0.31. `parry026.rs` defines
//! the same names for version 0.26.

use parry::math::{Pose, Real, Vector};
use parry::query::{Contact, ContactManifold, ShapeCastHit, ShapeCastStatus};
use parry::shape::{Compound, SharedShape};
use parry::shape::{PolygonalFeature, PolygonalFeatureMap, Polyline};

/// Public names that only this version of parry has.
pub mod names {
    pub use parry::shape::{
        CompoundFlags, CompoundPseudoNormals, PolylineFlags, SegmentPseudoNormals, SubShapeId,
    };
}
pub use names::CompoundFlags;
pub use names::PolylineFlags;
pub use parry::query::{ShapeDistance, ShapeIntersection};

/// Returns whether a test found an intersection.
pub fn is_intersecting(found: ShapeIntersection) -> bool {
    found.intersecting
}

/// The distance of two shapes.
pub fn distance_of(found: ShapeDistance) -> Real {
    found.distance
}

/// Hit of a cast. The arrays contain one value for each shape.
pub fn shape_cast_hit(
    time_of_impact: Real,
    [witness1, witness2]: [Vector; 2],
    [normal1, normal2]: [Vector; 2],
    status: ShapeCastStatus,
    [subshape1, subshape2]: [u32; 2],
) -> ShapeCastHit {
    ShapeCastHit {
        time_of_impact,
        witness1,
        witness2,
        normal1,
        normal2,
        status,
        subshape1,
        subshape2,
    }
}

/// The result of an intersection test of two shapes, with their parts.
pub fn shape_intersection(intersecting: bool, [part1, part2]: [u32; 2]) -> ShapeIntersection {
    ShapeIntersection::new(intersecting).with_subshapes(part1, part2)
}

/// The distance of two shapes, with their closest parts.
pub fn shape_distance(distance: Real, [part1, part2]: [u32; 2]) -> ShapeDistance {
    ShapeDistance::new(distance).with_subshapes(part1, part2)
}

/// A contact of these parts.
pub fn contact_of_parts(contact: Contact, [subshape1, subshape2]: [u32; 2]) -> Contact {
    Contact { subshape1, subshape2, ..contact }
}

/// Sets the part of the shape that a ray hit.
pub fn set_subshape(hit: &mut parry::query::RayIntersection, subshape: u32) {
    hit.subshape = subshape;
}

/// Writes the feature of a shape in a direction. A round cap has a vertex next to the point `hint`.
pub fn support_feature(
    shape: &dyn PolygonalFeatureMap,
    direction: Vector,
    hint: Vector,
    feature: &mut PolygonalFeature,
) {
    shape.local_support_feature_toward(direction, hint, feature);
}

/// Poses of the parts of a manifold, `None` for the identity.
pub fn take_subshape_poses<M, P>(raw: &mut ContactManifold<M, P>) -> [Option<Pose>; 2] {
    let poses = raw.subshape_poses.take();
    poses.map(|poses| [poses.pos1, poses.pos2]).unwrap_or_default()
}

/// A polyline with options.
pub fn polyline(
    vertices: Vec<Vector>,
    indices: Option<Vec<[u32; 2]>>,
    flags: PolylineFlags,
) -> Polyline {
    Polyline::with_flags(vertices, indices, flags)
}

/// Options of a polyline.
#[cfg(feature = "serde-serialize")]
pub fn polyline_flags(line: &Polyline) -> PolylineFlags {
    line.flags()
}

/// A compound with options.
pub fn compound(parts: Vec<(Pose, SharedShape)>, flags: CompoundFlags) -> Compound {
    Compound::with_flags(parts, flags, None)
}

/// Options of a compound.
pub fn compound_flags(compound: &Compound) -> CompoundFlags {
    compound.flags()
}
