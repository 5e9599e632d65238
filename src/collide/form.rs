//! Kind of a shape.

use super::parts::Parts;
use crate::dim::shapes::has_curved_surface;
use crate::model::collider::ShapeForm;
use parry::shape::{Shape, TypedShape};

/// Cached data of a shape for the narrow phase.
pub(crate) fn form_of(shape: &dyn Shape) -> ShapeForm {
    let mut form = ShapeForm::empty();
    form.set(ShapeForm::CONVEX, Parts::of(shape).is_convex());
    form.set(ShapeForm::ROUND, is_round(shape));
    form
}

/// Returns whether the shape can roll.
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
