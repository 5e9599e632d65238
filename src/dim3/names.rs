//! The names that only three dimensions have, or that are made differently there.

#[cfg(not(feature = "parry026"))]
pub use parry::shape::CompoundFaceCone;
pub use parry::shape::{
    Cone, ConvexPolyhedron, Cylinder, HeightFieldFlags, HeightFieldRadialTriangles, RoundCone,
    RoundConvexPolyhedron, RoundCylinder, Tetrahedron, TetrahedronPointLocation,
};
// Height fields take their heights in an `Array2`.
pub use parry::utils::Array2;
