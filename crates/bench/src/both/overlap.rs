//! Overlap of shapes, measured from shapes and poses alone. The measurement is the same for all engines.

use super::ours::parry::partitioning::{Bvh, BvhBuildStrategy};
use super::ours::parry::query::contact;
use super::ours::parry::shape::ShapeType;
use super::ours::prelude::*;
use super::template::Template;
use crate::engine::Overlap;

/// Collider at the present pose of its body.
struct Part<'t> {
    /// Position of the body in the template, `None` for colliders without a body.
    body: Option<usize>,
    dynamic: bool,
    collider: &'t Collider,
    pose: Pose,
}

/// Returns the overlap of all pairs of colliders that may touch, with the bodies in `poses`.
pub fn overlap(template: &Template, poses: &[Pose]) -> Overlap {
    let parts = parts(template, poses);
    let boxes: Vec<Aabb> =
        parts.iter().map(|part| part.collider.shape().compute_aabb(&part.pose)).collect();
    let tree = Bvh::from_iter(BvhBuildStrategy::Binned, boxes.iter().copied().enumerate());
    let mut depths = Vec::new();
    for (index, part) in parts.iter().enumerate().filter(|(_, part)| part.dynamic) {
        for other_index in tree.intersect_aabb(&boxes[index]) {
            let other = &parts[other_index as usize];
            // The search finds a pair of dynamic colliders twice.
            let twice = other.dynamic && other_index as usize <= index;
            if !twice && may_touch(part, other) {
                depths.push(depth(part, other));
            }
        }
    }
    Overlap::of_depths(depths)
}

fn parts<'t>(template: &'t Template, poses: &[Pose]) -> Vec<Part<'t>> {
    let mut parts = Vec::new();
    for (index, (body, colliders)) in template.parts().enumerate() {
        for collider in colliders {
            let local = collider.position_wrt_parent().copied().unwrap_or(Pose::IDENTITY);
            let pose = poses[index] * local;
            parts.push(Part { body: Some(index), dynamic: body.is_dynamic(), collider, pose });
        }
    }
    for collider in template.loose_colliders() {
        parts.push(Part { body: None, dynamic: false, collider, pose: *collider.position() });
    }
    parts
}

fn may_touch(part: &Part, other: &Part) -> bool {
    part.body != other.body
        && !part.collider.is_sensor()
        && !other.collider.is_sensor()
        && part.collider.collision_groups().test(other.collider.collision_groups())
}

/// Returns the penetration depth of two parts (length units), 0 if they are apart.
fn depth(part: &Part, other: &Part) -> f64 {
    // For a half-space in second place, parry 0.31 uses its pose for the other shape.
    let swap = other.collider.shape().shape_type() == ShapeType::HalfSpace;
    let (first, second) = if swap { (other, part) } else { (part, other) };
    let (shape1, shape2) = (first.collider.shape(), second.collider.shape());
    match contact(&first.pose, shape1, &second.pose, shape2, 0.0) {
        Ok(Some(contact)) => f64::from(-contact.dist).max(0.0),
        // The shapes are apart, or parry has no contacts for this pair of shapes.
        Ok(None) | Err(_) => 0.0,
    }
}
