//! The overlap of shapes, measured from shapes and poses alone, so that no engine marks its own work.

use super::ours::parry::partitioning::{Bvh, BvhBuildStrategy};
use super::ours::parry::query::contact;
use super::ours::parry::shape::ShapeType;
use super::ours::prelude::*;
use super::template::Template;
use crate::engine::Overlap;

/// A collider where its body is now.
struct Part<'t> {
    /// Position of the body in the template, none for colliders without a body.
    body: Option<usize>,
    dynamic: bool,
    collider: &'t Collider,
    pose: Pose,
}

/// The overlap of all pairs of colliders that may touch, with the bodies in `poses`.
pub fn overlap(template: &Template, poses: &[Pose]) -> Overlap {
    let parts = parts(template, poses);
    let boxes: Vec<Aabb> =
        parts.iter().map(|part| part.collider.shape().compute_aabb(&part.pose)).collect();
    let tree = Bvh::from_iter(BvhBuildStrategy::Binned, boxes.iter().copied().enumerate());
    let mut depths = Vec::new();
    for (index, part) in parts.iter().enumerate().filter(|(_, part)| part.dynamic) {
        for other_index in tree.intersect_aabb(&boxes[index]) {
            let other = &parts[other_index as usize];
            // Two dynamic colliders find each other twice.
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

/// How deep two parts overlap (length units), 0 if they are apart.
fn depth(part: &Part, other: &Part) -> f64 {
    // parry 0.31 takes the pose of a half-space that comes second for that of the other shape.
    let swap = other.collider.shape().shape_type() == ShapeType::HalfSpace;
    let (first, second) = if swap { (other, part) } else { (part, other) };
    let (shape1, shape2) = (first.collider.shape(), second.collider.shape());
    match contact(&first.pose, shape1, &second.pose, shape2, 0.0) {
        Ok(Some(contact)) => f64::from(-contact.dist).max(0.0),
        // Apart, or a pair of shapes for which no contacts exist.
        Ok(None) | Err(_) => 0.0,
    }
}
