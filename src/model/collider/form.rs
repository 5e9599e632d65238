//! What the narrow phase asks of a shape in each step, kept where it need not go to the shape for it.

use crate::dim::shapes::has_curved_surface;
use parry::shape::{Shape, TypedShape};

bitflags::bitflags! {
    /// What kind of shape a collider has.
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug)]
    pub(crate) struct ShapeForm: u8 {
        /// It is convex, and its own only part.
        const CONVEX = 1;
        /// It can roll.
        const ROUND = 1 << 1;
    }
}

impl ShapeForm {
    /// Of a shape that somebody may be changing: nothing is taken for granted until the next step has looked.
    pub const UNKNOWN: Self = Self::ROUND;

    /// The form of a shape.
    pub fn of(shape: &dyn Shape) -> Self {
        let has_parts = shape.as_composite_shape().is_some()
            || shape.as_heightfield().is_some()
            || shape.as_voxels().is_some();
        let mut form = Self::empty();
        form.set(Self::CONVEX, !has_parts);
        form.set(Self::ROUND, is_round(shape));
        form
    }
}

fn is_round(shape: &dyn Shape) -> bool {
    match shape.as_typed_shape() {
        TypedShape::Ball(_)
        | TypedShape::Capsule(_)
        | TypedShape::RoundCuboid(_)
        | TypedShape::RoundTriangle(_)
        | TypedShape::Custom(_) => true,
        TypedShape::Compound(compound) => {
            compound.shapes().iter().any(|(_, part)| is_round(&**part))
        }
        other => has_curved_surface(other),
    }
}
