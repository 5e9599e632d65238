//! The saved form of shapes that contain no other shape.

/// Defines `PlainShape`, with one variant per listed type of the geometry library. `SharedShape`'s own saved
/// form may nest compounds to any depth.
macro_rules! plain_shapes {
    ($($shape:ident),*) => {
        /// A shape that is defined by a few numbers, or a convex hull.
        #[derive(serde::Serialize, serde::Deserialize)]
        pub enum PlainShape {
            $($shape($shape)),*
        }

        impl PlainShape {
            /// A copy of a shape; `None` if it has parts, or is the user's own.
            pub fn of(shape: TypedShape<'_>) -> Option<Self> {
                match shape {
                    $(TypedShape::$shape(shape) => Some(Self::$shape(shape.clone())),)*
                    _ => None,
                }
            }

            pub fn into_shared(self) -> SharedShape {
                match self {
                    $(Self::$shape(shape) => SharedShape::new(shape)),*
                }
            }
        }
    };
}
pub(crate) use plain_shapes;
