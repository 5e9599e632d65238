//! How deep do shapes overlap? Measured from scratch, so that no engine marks its own work.

use super::ours::parry::partitioning::{Bvh, BvhBuildStrategy};
use super::ours::parry::query::contact;
use super::ours::parry::shape::ShapeType;
use super::ours::prelude::*;
use super::template::Template;

/// A collider where its body is now.
struct Part<'t> {
    /// Position of the body in the template, none for colliders without a body.
    body: Option<usize>,
    dynamic: bool,
    collider: &'t Collider,
    pose: Pose,
}

/// The deepest overlap of any two colliders that may touch (length units), with the bodies in `poses`.
pub fn deepest_overlap(template: &Template, poses: &[Pose]) -> f64 {
    let parts = parts(template, poses);
    let boxes: Vec<Aabb> =
        parts.iter().map(|part| part.collider.shape().compute_aabb(&part.pose)).collect();
    let tree = Bvh::from_iter(BvhBuildStrategy::Binned, boxes.iter().copied().enumerate());
    let mut deepest = 0.0_f64;
    for (index, part) in parts.iter().enumerate().filter(|(_, part)| part.dynamic) {
        for other_index in tree.intersect_aabb(&boxes[index]) {
            let other = &parts[other_index as usize];
            // Two dynamic ones find each other twice.
            let twice = other.dynamic && other_index as usize <= index;
            if !twice && may_touch(part, other) {
                deepest = deepest.max(overlap(part, other));
            }
        }
    }
    deepest
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

fn overlap(part: &Part, other: &Part) -> f64 {
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
