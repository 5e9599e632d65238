//! The set: handles, parents, and the notes it leaves for the step.

use crate::dim::math::{Pose, Vector};
use crate::model::body::{RigidBodyBuilder, RigidBodyHandle, RigidBodySet, RigidBodyType};
use crate::model::collider::{
    ColliderBuilder, ColliderChanges, ColliderEnabled, ColliderHandle, ColliderSet,
};
use crate::model::island::IslandManager;

struct World {
    bodies: RigidBodySet,
    colliders: ColliderSet,
    islands: IslandManager,
}

impl World {
    fn new() -> Self {
        Self {
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            islands: IslandManager::new(),
        }
    }

    /// A body 3 up, with a collider 1 to the right of it.
    fn with_attached() -> (Self, RigidBodyHandle, ColliderHandle) {
        let mut world = Self::new();
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 3.0);
        let body = world.bodies.insert(body);
        let collider = world.attach(body);
        (world, body, collider)
    }

    fn attach(&mut self, body: RigidBodyHandle) -> ColliderHandle {
        let collider = ColliderBuilder::ball(0.5).translation(Vector::X);
        self.colliders.insert_with_parent(collider, body, &mut self.bodies)
    }

    /// As if a step had applied all changes.
    fn settle(&mut self) {
        for handle in self.colliders.take_modified() {
            if let Some(collider) = self.colliders.get_unnoted_mut(handle) {
                collider.changes = ColliderChanges::empty();
            }
        }
        self.colliders.take_removed();
    }
}

#[test]
fn an_attached_collider_stands_on_its_body() {
    let (world, body, handle) = World::with_attached();
    let collider = &world.colliders[handle];
    assert_eq!(collider.parent(), Some(body));
    assert_eq!(collider.parent_type, Some(RigidBodyType::Dynamic));
    assert_eq!(collider.translation(), Vector::X + Vector::Y * 3.0);
    assert_eq!(collider.position_wrt_parent(), Some(&Pose::from_translation(Vector::X)));
    assert_eq!(world.bodies[body].colliders(), &[handle]);
    assert!(world.bodies[body].mass() > 0.0);
}

#[test]
fn a_stale_parent_leaves_the_collider_detached_and_disabled() {
    let (mut world, body, _) = World::with_attached();
    world.bodies.remove(body);
    for stale in [body, RigidBodyHandle::default(), RigidBodyHandle::from_raw_parts(77, 3)] {
        let handle = world.attach(stale);
        let collider = &world.colliders[handle];
        assert_eq!((collider.parent(), collider.is_enabled()), (None, false));
    }
}

#[test]
fn a_collider_changes_bodies() {
    let (mut world, first, handle) = World::with_attached();
    let second = world.bodies.insert(RigidBodyBuilder::fixed().translation(Vector::Y * -5.0));
    world.settle();

    world.colliders.set_parent(handle, Some(second), &mut world.bodies);
    assert!(world.bodies[first].colliders().is_empty());
    assert_eq!(world.bodies[second].colliders(), &[handle]);
    let collider = &world.colliders[handle];
    assert_eq!(collider.parent_type, Some(RigidBodyType::Fixed));
    assert_eq!(collider.translation(), Vector::X - Vector::Y * 5.0);
    assert!(collider.changes.contains(ColliderChanges::PARENT | ColliderChanges::POSITION));
    assert_eq!(world.colliders.take_modified(), [handle]);

    world.colliders.set_parent(handle, None, &mut world.bodies);
    assert!(world.bodies[second].colliders().is_empty());
    let collider = &world.colliders[handle];
    assert_eq!((collider.parent(), collider.parent_type), (None, None));
    assert_eq!(collider.translation(), Vector::X - Vector::Y * 5.0, "it stays where it was");

    world.colliders.set_parent(handle, Some(first), &mut world.bodies);
    assert_eq!(world.colliders[handle].position_wrt_parent(), Some(&Pose::IDENTITY));
    assert_eq!(world.bodies[first].colliders(), &[handle]);
}

#[test]
fn stale_handles_change_no_parent() {
    let (mut world, body, handle) = World::with_attached();
    world.settle();
    let stale = RigidBodyHandle::from_raw_parts(9, 9);
    world.colliders.set_parent(handle, Some(stale), &mut world.bodies);
    world.colliders.set_parent(ColliderHandle::invalid(), Some(body), &mut world.bodies);
    assert_eq!(world.colliders[handle].parent(), Some(body));
    assert_eq!(world.bodies[body].colliders(), &[handle]);
    assert!(world.colliders.take_modified().is_empty());
}

#[test]
fn a_disabled_body_disables_its_colliders_until_they_leave() {
    let mut world = World::new();
    let disabled = world.bodies.insert(RigidBodyBuilder::dynamic().enabled(false));
    let handle = world.attach(disabled);
    assert_eq!(world.colliders[handle].flags.enabled, ColliderEnabled::DisabledByParent);
    world.colliders.set_parent(handle, None, &mut world.bodies);
    assert!(world.colliders[handle].is_enabled());
}

#[test]
fn a_removed_collider_leaves_its_body_and_its_handle_finds_nothing() {
    let (mut world, body, handle) = World::with_attached();
    let World { bodies, colliders, islands } = &mut world;
    let removed = colliders.remove(handle, islands, bodies, true).expect("it was there");
    assert_eq!(removed.user_data, 0);
    assert!(colliders.get(handle).is_none() && !colliders.contains(handle));
    assert!(colliders.get_mut(handle).is_none());
    assert!(colliders.remove(handle, islands, bodies, true).is_none());
    assert!(bodies[body].colliders().is_empty());
    let notes = colliders.take_removed();
    assert_eq!(notes.len(), 1);
    assert_eq!((notes[0].handle, notes[0].wake_up), (handle, true));

    // The slot is used again, the old handle is not.
    let newer = colliders.insert(removed);
    assert_eq!(newer.into_raw_parts().0, handle.into_raw_parts().0);
    assert!(colliders.get(handle).is_none());
    assert_eq!(colliders[newer].parent(), None);
}

#[test]
fn a_collider_taken_out_goes_back_to_its_place_on_a_body() {
    let (mut world, body, handle) = World::with_attached();
    let World { bodies, colliders, islands } = &mut world;
    let removed = colliders.remove(handle, islands, bodies, false).expect("it was there");
    let again = colliders.insert_with_parent(removed, body, bodies);
    assert_eq!(colliders[again].translation(), Vector::X + Vector::Y * 3.0);
    assert_eq!(bodies[body].colliders(), &[again]);
}

#[test]
fn a_change_is_noted_once() {
    let mut world = World::new();
    let [a, b] = [0, 1].map(|_| world.colliders.insert(ColliderBuilder::ball(0.5)));
    assert_eq!(world.colliders.take_modified(), [a, b], "new ones are changes");
    world.settle();
    for handle in [a, b] {
        let collider = world.colliders.get_unnoted_mut(handle).expect("it is there");
        collider.changes = ColliderChanges::empty();
    }
    world.colliders[b].set_friction(0.1);
    if let Some(collider) = world.colliders.get_mut(b) {
        collider.set_friction(0.2);
    }
    world.colliders.get_pair_mut(b, a);
    assert_eq!(world.colliders.take_modified(), [b, a]);
}

#[test]
fn pairs_are_distinct() {
    let mut colliders = ColliderSet::new();
    let [a, b] = [0.5, 1.0].map(|radius| colliders.insert(ColliderBuilder::ball(radius)));
    assert!(matches!(colliders.get_pair_mut(a, b), (Some(_), Some(_))));
    assert!(matches!(colliders.get_pair_mut(a, a), (Some(_), None)));
    let invalid = ColliderSet::invalid_handle();
    assert!(matches!(colliders.get_pair_mut(invalid, b), (None, Some(_))));
}

#[test]
fn iteration_is_in_the_order_of_slots_and_can_skip_the_disabled() {
    let mut colliders = ColliderSet::with_capacity(3);
    assert!(colliders.is_empty());
    let builders = [true, false, true].map(|on| ColliderBuilder::ball(0.5).enabled(on));
    let handles = builders.map(|builder| colliders.insert(builder));
    assert_eq!(colliders.len(), 3);
    let all: Vec<_> = colliders.iter().map(|(handle, _)| handle).collect();
    assert_eq!(all, handles);
    let enabled: Vec<_> = colliders.iter_enabled().map(|(handle, _)| handle).collect();
    assert_eq!(enabled, [handles[0], handles[2]]);
    assert_eq!(colliders.iter_mut().count(), 3);
    assert_eq!(colliders.iter_enabled_mut().count(), 2);
    let (_, found) = colliders.get_unknown_gen(1).expect("slot 1 is taken");
    assert_eq!(found, handles[1]);
    assert!(colliders.get_unknown_gen(3).is_none() && colliders.get_unknown_gen_mut(3).is_none());
}

#[test]
#[should_panic(expected = "finds no collider")]
fn indexing_with_a_stale_handle_panics() {
    let colliders = ColliderSet::new();
    let _ = &colliders[ColliderHandle::default()];
}

#[test]
fn a_shape_broken_before_it_is_inserted_weighs_nothing_and_is_disabled() {
    let (mut world, body, _) = World::with_attached();
    let (mass, extent) = (world.bodies[body].mass(), world.bodies[body].extent);
    let mut collider = ColliderBuilder::ball(0.1).density(0.0).build();
    collider.shape_mut().as_ball_mut().expect("a ball").radius = -1.0;
    let handle = world.colliders.insert_with_parent(collider, body, &mut world.bodies);
    assert!(!world.colliders[handle].is_enabled());
    assert_eq!(world.bodies[body].mass(), mass);
    assert!(world.bodies[body].extent.is_finite() && world.bodies[body].extent >= extent);
}
