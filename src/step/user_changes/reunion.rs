//! Sets that are not the ones of the last step: `mem::take(&mut world.bodies)`, an older copy of the colliders alone, joints from a file.
//!
//! What the others know of such a set is wrong. If it is one of those that know of each other (bodies, colliders, islands, pairs, trees), the
//! step forgets all that it knew, and takes in what there is as if it were new and awake: bodies that are gone count as
//! removed, and their colliders and joints go with them. So it does if it knew joints of another set; a set of joints of which it knew none is
//! only taken in. [`Seal`](crate::model::seal::Seal) says how
//! it is noticed.

use crate::dim::math::Vector;
use crate::model::contact::NarrowPhase;
use crate::model::event::{CollisionEvent, CollisionEventFlags};
use crate::model::island::IslandManager;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;
use crate::model::seal::Seal;
use crate::model::structure::Structure;
use crate::model::tree::BroadPhaseBvh;

/// All that must belong together.
pub(crate) struct Reunion<'a> {
    pub structure: Structure<'a>,
    pub tree: &'a mut BroadPhaseBvh,
}

impl Reunion<'_> {
    /// Before a step. Returns the events of pairs that were forgotten.
    pub fn before_step(
        mut self,
        joints: &mut ImpulseJointSet,
        multibodies: &mut MultibodyJointSet,
    ) -> Vec<CollisionEvent> {
        let mut parted = self.unite();
        let seal = self.structure.islands.seal;
        let other_joints = !joints.seal.is_of_same_step(seal);
        let other_multibodies = !multibodies.seal.is_of_same_step(seal);
        let islands = &self.structure.islands;
        // Who has no joints may come with a new empty set each time.
        let known_are_others = other_joints && islands.joints.iter().next().is_some()
            || other_multibodies && islands.groups.bodies().next().is_some();
        if known_are_others {
            parted.extend(self.begin_anew());
        }
        if other_joints || known_are_others {
            joints.begin_anew();
        }
        if other_multibodies || known_are_others {
            multibodies.begin_anew();
        }
        let next = seal.after_step(&self.trace());
        self.put(next);
        (joints.seal, multibodies.seal) = (next, next);
        parted
    }

    /// Before collisions are detected without a step. Returns the events of pairs that were forgotten.
    pub fn before_detection(mut self) -> Vec<CollisionEvent> {
        let parted = self.unite();
        let next = self.structure.islands.seal.after_detection(&self.trace());
        self.put(next);
        parted
    }

    fn unite(&mut self) -> Vec<CollisionEvent> {
        let Structure { bodies, colliders, narrow_phase, islands } = &self.structure;
        let seals = [bodies.seal, narrow_phase.seal, self.tree.seal];
        let are_of_one_world =
            seals.into_iter().all(|seal| seal.is_of_same_detection(islands.seal));
        if are_of_one_world && bodies.seal == colliders.seal {
            return Vec::new();
        }
        log::warn!("a set is not that of the last step: all that is there is taken in anew");
        self.begin_anew()
    }

    /// Forgets all that was known.
    fn begin_anew(&mut self) -> Vec<CollisionEvent> {
        let Structure { bodies, colliders, narrow_phase, islands } = &mut self.structure;
        bodies.begin_anew();
        colliders.begin_anew(bodies);
        let known = core::mem::take(*narrow_phase);
        **islands = IslandManager::new();
        *self.tree = BroadPhaseBvh::new();
        self.parted(&known)
    }

    /// Tells whoever heard that two colliders began to touch that they do not any more.
    fn parted(&self, known: &NarrowPhase) -> Vec<CollisionEvent> {
        let contacts = known.contacts.iter().filter(|pair| pair.start_event_emitted);
        let contacts = contacts.map(|pair| ([pair.collider1, pair.collider2], false));
        let intersections = known.intersections.iter().filter(|pair| pair.start_event_emitted);
        let intersections = intersections.map(|pair| ([pair.collider1, pair.collider2], true));
        let is_there = |&collider: &_| self.structure.colliders.contains(collider);
        let event = |(pair, is_sensor): ([_; 2], bool)| {
            let mut flags = CollisionEventFlags::empty();
            flags.set(CollisionEventFlags::SENSOR, is_sensor);
            flags.set(CollisionEventFlags::REMOVED, !pair.iter().all(is_there));
            CollisionEvent::Stopped(pair[0], pair[1], flags)
        };
        contacts.chain(intersections).map(event).collect()
    }

    fn put(&mut self, seal: Seal) {
        self.structure.bodies.seal = seal;
        self.structure.colliders.seal = seal;
        self.structure.narrow_phase.seal = seal;
        self.structure.islands.seal = seal;
        self.tree.seal = seal;
    }

    /// What tells a world from others of the same history so far: how much there is, how much was edited, and where one of the awake bodies is,
    /// in each step another one.
    fn trace(&self) -> [u64; 6] {
        let Structure { bodies, colliders, narrow_phase, islands } = &self.structure;
        let awake = islands.active_bodies();
        let turn = islands.step as usize % awake.len().max(1);
        let body = awake.get(turn).and_then(|&handle| bodies.get(handle));
        let place = body.map_or(Vector::ZERO, |body| body.pose.translation);
        [
            bodies.len() as u64,
            colliders.len() as u64,
            narrow_phase.contacts.len() as u64,
            awake.len() as u64,
            (bodies.modified().len() + colliders.modified().len()) as u64,
            f64::from(place.x + place.y).to_bits(),
        ]
    }
}
