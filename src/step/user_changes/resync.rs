//! Sets that are not the ones of the last step: `mem::take(&mut world.bodies)`, an older copy of the
//! colliders alone, joints from a file.
//!
//! The references of the other sets to such a set are wrong ([`WorldStamp`] detects this). If it refers to
//! the other sets (bodies, colliders, islands, pairs, trees), the step discards islands, pairs and trees. It
//! inserts all bodies, colliders and joints as new and awake. Bodies that are gone count as removed: their
//! colliders and joints are removed, too. The same happens if joints were replaced that the islands refer to.
//! A set of joints that replaces an empty one is only inserted.
//!
//! Loaded sets are unverified. The first step checks all references between the sets. If these hold, the
//! world continues bit for bit as if it had not been saved. Otherwise everything is inserted as new.

use crate::base::fault::{Fault, ensure};
use crate::collide::form_of;
use crate::dim::math::Vector;
use crate::model::collider::{ColliderChanges, ColliderSet};
use crate::model::contact::NarrowPhase;
use crate::model::event::{CollisionEvent, CollisionEventFlags};
use crate::model::island::IslandManager;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;
use crate::model::stamp::WorldStamp;
use crate::model::structure::Structure;
use crate::model::tree::BroadPhaseBvh;
use crate::step::world::World;

/// The result of a resync.
pub(crate) struct Resynced {
    /// Events of pairs that were discarded.
    pub end_events: Vec<CollisionEvent>,
    /// The stamp that the islands get when the step has ended. Until then they fit no other set. After a step
    /// that ended by a panic, everything is inserted as new.
    pub stamp: WorldStamp,
    /// Whether the joints, and the multibodies, are those of the islands, so that their edits can be applied.
    pub joints_fit: [bool; 2],
}

/// Before a step.
pub(crate) fn resync_before_step(world: &mut World<'_>) -> Resynced {
    let unverified = any_unverified(world)
        || world.joints.stamp.is_unverified()
        || world.multibodies.stamp.is_unverified();
    let mut end_events = Vec::new();
    if unverified {
        if let Err(fault) = check(world, world.joints, Some(world.multibodies)) {
            log::warn!("a loaded world is registered from scratch: {fault}");
            end_events = begin_anew(world);
            world.joints.begin_anew();
            world.multibodies.begin_anew();
        }
    } else {
        end_events = unite(world);
        end_events.extend(unite_joints(world));
    }
    let stamp = world.structure.islands.stamp.after_step(&trace(&world.structure));
    put(stamp, world);
    (world.joints.stamp, world.multibodies.stamp) = (stamp, stamp);
    world.structure.islands.stamp = WorldStamp::of_unfinished_step();
    Resynced { end_events, stamp, joints_fit: [true; 2] }
}

/// Before collisions are detected without a step.
pub(crate) fn resync_before_detection(
    world: &mut World<'_>,
    joints: &ImpulseJointSet,
    multibodies: &MultibodyJointSet,
) -> Resynced {
    let end_events = if !any_unverified(world) {
        unite(world)
    } else if let Err(fault) = check(world, joints, None) {
        log::warn!("a loaded world is registered from scratch: {fault}");
        begin_anew(world)
    } else {
        Vec::new()
    };
    let Structure { bodies, islands, .. } = &world.structure;
    let joints_fit =
        [islands.joints.are_of(joints, bodies), multibodies.check_grouped(&islands.groups).is_ok()];
    let stamp = islands.stamp.after_detection(&trace(&world.structure));
    put(stamp, world);
    world.structure.islands.stamp = WorldStamp::of_unfinished_step();
    Resynced { end_events, stamp, joints_fit }
}

fn stamps(world: &World<'_>) -> [WorldStamp; 5] {
    let Structure { bodies, colliders, narrow_phase, islands } = &world.structure;
    [bodies.stamp, colliders.stamp, narrow_phase.stamp, islands.stamp, world.broad_phase.stamp]
}

fn any_unverified(world: &World<'_>) -> bool {
    stamps(world).iter().any(|stamp| stamp.is_unverified())
}

fn check(
    world: &World<'_>,
    joints: &ImpulseJointSet,
    multibodies: Option<&MultibodyJointSet>,
) -> Result<(), Fault> {
    let Structure { colliders, islands, .. } = &world.structure;
    let stamp = islands.stamp;
    let fit = stamps(world).iter().all(|other| other.has_same_history(stamp));
    ensure!(fit, "the sets are of different times");
    // A set without joints may be replaced by another set.
    let has_none = joints.is_empty() && islands.joints.iter().next().is_none();
    let fit = has_none || joints.stamp.has_same_steps(stamp);
    ensure!(fit, "the joints are of another time than the bodies");
    let has_none =
        |set: &MultibodyJointSet| set.is_empty() && islands.groups.bodies().next().is_none();
    let fit = multibodies.is_none_or(|set| has_none(set) || set.stamp.has_same_steps(stamp));
    ensure!(fit, "the multibodies are of another time than the bodies");
    world.structure.check_world(world.broad_phase, joints, multibodies)?;
    for (handle, collider) in colliders.iter() {
        let (known, form) = (collider.form, form_of(&*collider.shape));
        let is_edited = collider.changes.contains(ColliderChanges::SHAPE);
        ensure!(known == form || is_edited, "{handle:?} is {known:?} and not {form:?}");
    }
    Ok(())
}

/// Inserts everything as new unless the sets are of one step.
fn unite(world: &mut World<'_>) -> Vec<CollisionEvent> {
    let Structure { bodies, colliders, islands, .. } = &world.structure;
    let are_of_one_world =
        stamps(world).iter().all(|stamp| stamp.is_of_same_detection(islands.stamp));
    if are_of_one_world && bodies.stamp == colliders.stamp {
        return Vec::new();
    }
    log::warn!("a set is not that of the last step: everything is registered from scratch");
    begin_anew(world)
}

/// The same for joints. A set without joints may be replaced by another one in each step at no cost.
fn unite_joints(world: &mut World<'_>) -> Vec<CollisionEvent> {
    let World { joints, multibodies, .. } = world;
    let Structure { bodies, islands, .. } = &world.structure;
    let other_joints = !joints.stamp.is_of_same_step(islands.stamp)
        || islands.stamp.has_detected() && !islands.joints.are_of(joints, bodies);
    let other_multibodies = !multibodies.stamp.is_of_same_step(islands.stamp)
        || islands.stamp.has_detected() && multibodies.check_grouped(&islands.groups).is_err();
    let known_are_others = other_joints && islands.joints.iter().next().is_some()
        || other_multibodies && islands.groups.bodies().next().is_some();
    let end_events = if known_are_others { begin_anew(world) } else { Vec::new() };
    if other_joints || known_are_others {
        world.joints.begin_anew();
    }
    if other_multibodies || known_are_others {
        world.multibodies.begin_anew();
    }
    end_events
}

/// Discards islands, pairs and trees: everything is new.
fn begin_anew(world: &mut World<'_>) -> Vec<CollisionEvent> {
    let Structure { bodies, colliders, narrow_phase, islands } = &mut world.structure;
    bodies.begin_anew();
    colliders.begin_anew(bodies);
    let known = core::mem::take(*narrow_phase);
    **islands = IslandManager::new();
    *world.broad_phase = BroadPhaseBvh::new();
    end_events(&known, colliders)
}

/// The end of each contact and intersection whose begin was reported.
fn end_events(known: &NarrowPhase, colliders: &ColliderSet) -> Vec<CollisionEvent> {
    let contacts = known.contacts.iter().filter(|pair| pair.start_event_emitted);
    let contacts = contacts.map(|pair| ([pair.collider1, pair.collider2], false));
    let intersections = known.intersections.iter().filter(|pair| pair.start_event_emitted);
    let intersections = intersections.map(|pair| ([pair.collider1, pair.collider2], true));
    let is_there = |&collider: &_| colliders.contains(collider);
    let event = |(pair, is_sensor): ([_; 2], bool)| {
        let mut flags = CollisionEventFlags::empty();
        flags.set(CollisionEventFlags::SENSOR, is_sensor);
        flags.set(CollisionEventFlags::REMOVED, !pair.iter().all(is_there));
        CollisionEvent::Stopped(pair[0], pair[1], flags)
    };
    contacts.chain(intersections).map(event).collect()
}

fn put(stamp: WorldStamp, world: &mut World<'_>) {
    world.structure.bodies.stamp = stamp;
    world.structure.colliders.stamp = stamp;
    world.structure.narrow_phase.stamp = stamp;
    world.structure.islands.stamp = stamp;
    world.broad_phase.stamp = stamp;
}

/// Identifies a world among others with the same history: counts, and the pose of one awake body, a
/// different one in each step.
fn trace(structure: &Structure<'_>) -> [u64; 6] {
    let Structure { bodies, colliders, narrow_phase, islands } = structure;
    let awake = islands.active_bodies();
    let index = islands.step as usize % awake.len().max(1);
    let body = awake.get(index).and_then(|&handle| bodies.get(handle));
    let place = body.map_or(Vector::ZERO, |body| body.pose.translation);
    [
        bodies.len() as u64,
        colliders.len() as u64,
        narrow_phase.contacts.len() as u64,
        awake.len() as u64,
        (bodies.modified().len() + colliders.modified().len()) as u64,
        f64::from(place.element_sum()).to_bits(),
    ]
}
