//! The names that only three dimensions have, or that are made differently there.

pub use parry::shape::{
    CompoundFaceCone, Cone, ConvexPolyhedron, Cylinder, HeightFieldFlags,
    HeightFieldRadialTriangles, RoundCone, RoundConvexPolyhedron, RoundCylinder, Tetrahedron,
    TetrahedronPointLocation,
};
// Height fields take their heights in it.
pub use parry::utils::Array2;
