//! Groups of bodies that touch or are joined, for colours.

use super::palette::spread;
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
        for (_, joint) in world.impulse_joints.iter().filter(|(_, joint)| joint.data.is_enabled()) {
            islands.join(joint.body1(), joint.body2());
        }
        for multibody in world.multibody_joints.multibodies() {
            let mut links = multibody.links().map(MultibodyLink::rigid_body_handle);
            // The solver moves a multibody as a whole, so its links are one group even around a fixed root.
            let Some(first) = links.find(|link| islands.parents.contains_key(link)) else {
                continue;
            };
            links.for_each(|link| islands.join(first, link));
        }
        islands
    }

    /// The root of a body's group. Each visited body moves up to its grandparent, which keeps the paths
    /// short.
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
        let hue = spread(slot(self.root(body)?)) * 360.0;
        Some(Color::from_hsl(hue, 0.6, 0.58, 1.0))
    }
}

fn slot(body: RigidBodyHandle) -> u32 {
    body.into_raw_parts().0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bodies without contact, in a row.
    fn row(count: usize) -> (PhysicsWorld, Vec<RigidBodyHandle>) {
        let mut world = PhysicsWorld::new();
        let place = |i: usize| RigidBodyBuilder::dynamic().translation(Vector::X * (3 * i) as Real);
        let handles =
            (0..count).map(|i| world.insert(place(i), ColliderBuilder::ball(0.5)).0).collect();
        (world, handles)
    }

    #[test]
    fn enabled_joints_unite_bodies_and_disabled_ones_do_not() {
        let (mut world, bodies) = row(3);
        for (pair, enabled) in bodies.windows(2).zip([true, false]) {
            let mut joint: GenericJoint = FixedJointBuilder::new().build().into();
            joint.set_enabled(enabled);
            world.insert_impulse_joint(pair[0], pair[1], joint);
        }
        let mut islands = Islands::of(&world);
        let roots: Vec<_> = bodies.iter().map(|body| islands.root(*body)).collect();
        assert_eq!(roots, [Some(bodies[0]), Some(bodies[0]), Some(bodies[2])]);
    }

    #[test]
    fn links_of_a_multibody_are_one_group_around_a_fixed_root() {
        let (mut world, bodies) = row(4);
        let root = world.insert_body(RigidBodyBuilder::fixed());
        for (parent, child) in [(root, bodies[1]), (root, bodies[2]), (bodies[2], bodies[3])] {
            world.insert_multibody_joint(parent, child, FixedJointBuilder::new());
        }
        let mut islands = Islands::of(&world);
        let roots: Vec<_> = bodies.iter().map(|body| islands.root(*body)).collect();
        assert_eq!(roots, [bodies[0], bodies[1], bodies[1], bodies[1]].map(Some));
        assert_eq!(islands.root(root), None);
    }
}
