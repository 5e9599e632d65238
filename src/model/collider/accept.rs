//! Acceptance of shapes: the one place where shapes enter the world.
//!
//! Users may hand over any shape of parry. A mirrored or unevenly scaled one has normals and windings that
//! contradict its points ([`crate::dim::repair`]): bodies would fall through it. Such a shape is replaced by
//! a consistent copy, and a shape that cannot be repaired is refused.

use super::InvalidCollider;
use super::check::{check_kinds, check_numbers, check_pose, check_shape};
use crate::base::parry_version::{compound, compound_flags};
use crate::dim::math::Pose;
use crate::dim::repair::{repaired, repaired_mesh};
use parry::shape::{SharedShape, TypedShape};

/// Returns the shape, or a consistent copy.
///
/// # Errors
/// If the shape has sizes that are negative or not finite, coordinates that are not finite, indices out of
/// range, no elements, or convex faces that cannot collide.
pub(crate) fn accept_shape(shape: &SharedShape) -> Result<SharedShape, InvalidCollider> {
    check_numbers(&**shape)?;
    let accepted = match shape.as_typed_shape() {
        TypedShape::Compound(parts) => match accept_parts(parts.shapes())? {
            Some(accepted) => SharedShape::new(compound(accepted, compound_flags(parts))),
            None => shape.clone(),
        },
        TypedShape::TriMesh(mesh) => {
            repaired_mesh(mesh)?.map_or_else(|| shape.clone(), SharedShape::new)
        }
        typed => repaired(typed).unwrap_or_else(|| shape.clone()),
    };
    check_shape(&*accepted)?;
    Ok(accepted)
}

/// The parts of a compound, some of which are copies; `None` if all are consistent.
///
/// # Errors
/// If there are no parts, or one is composite itself or invalid.
pub(super) fn accept_parts(
    parts: &[(Pose, SharedShape)],
) -> Result<Option<Vec<(Pose, SharedShape)>>, InvalidCollider> {
    check_kinds(parts)?;
    let mut copies = None;
    for (part, (pose, shape)) in parts.iter().enumerate() {
        let accepted = check_pose(pose)
            .and_then(|()| accept_shape(shape))
            .map_err(|reason| InvalidCollider::Part { part, reason: Box::new(reason) })?;
        if !std::sync::Arc::ptr_eq(&accepted.0, &shape.0) {
            copies.get_or_insert_with(|| parts.to_vec())[part].1 = accepted;
        }
    }
    Ok(copies)
}
