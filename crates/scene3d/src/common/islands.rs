//! Groups of bodies that touch or are joined, for colours.

use crate::rapier::prelude::*;
use drawing::Color;
use std::collections::HashMap;

/// A number for each body: equal for bodies that touch or are joined, directly or through other ones.
#[derive(Default)]
pub(super) struct Islands {
    parents: HashMap<RigidBodyHandle, RigidBodyHandle>,
}

impl Islands {
    /// The groups of the dynamic bodies of a world.
    pub(super) fn of(world: &PhysicsWorld) -> Self {
        let mut islands = Self::default();
        for (handle, _) in world.bodies.iter().filter(|(_, body)| body.is_dynamic()) {
            islands.parents.insert(handle, handle);
        }
        for (first, second, pair) in world.narrow_phase.contact_pairs() {
            let body = |handle| world.colliders.get(handle).and_then(Collider::parent);
            if let (true, Some(a), Some(b)) =
                (pair.has_any_active_contact, body(first), body(second))
            {
                islands.join(a, b);
            }
        }
        for (_, joint) in world.impulse_joints.iter() {
            islands.join(joint.body1(), joint.body2());
        }
        islands
    }

    /// The root of a body's group. Each visited body moves up to its grandparent, which keeps the paths short.
    fn root(&mut self, mut body: RigidBodyHandle) -> Option<RigidBodyHandle> {
        loop {
            let parent = *self.parents.get(&body)?;
            if parent == body {
                return Some(body);
            }
            let above = *self.parents.get(&parent)?;
            self.parents.insert(body, above);
            body = above;
        }
    }

    fn join(&mut self, a: RigidBodyHandle, b: RigidBodyHandle) {
        let (Some(a), Some(b)) = (self.root(a), self.root(b)) else { return };
        // The lower slot is the root, whatever the order of the pairs.
        let (low, high) = if slot(a) < slot(b) { (a, b) } else { (b, a) };
        self.parents.insert(high, low);
    }

    /// The colour of a body's group; none for a body that is not dynamic.
    pub(super) fn color(&mut self, body: RigidBodyHandle) -> Option<Color> {
        let hue = (slot(self.root(body)?) as f32 * 0.618_034).fract() * 360.0;
        Some(Color::from_hsl(hue, 0.6, 0.58, 1.0))
    }
}

fn slot(body: RigidBodyHandle) -> u32 {
    body.into_raw_parts().0
}
