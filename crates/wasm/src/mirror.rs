//! Poses, velocities and sleep flags of all bodies side by side, where JavaScript reads them without a call.

use crate::handle::Handle;
use crate::memory::{number, put_rotation};
use crate::rapier::dynamics::{RigidBody, RigidBodyHandle};
use crate::rapier::math::{ANG_DIM, DIM, Real};
use crate::rapier::pipeline::PhysicsWorld;
use crate::registry::mirror;

/// Numbers of a rotation: an angle or a quaternion.
const ROTATION: usize = if DIM == 2 { 1 } else { 4 };
/// Numbers of a pose.
const POSE: usize = DIM + ROTATION;
/// Numbers of a velocity.
const VELOCITY: usize = DIM + ANG_DIM;

/// The states of all bodies, by slot.
#[derive(Default)]
pub struct Mirror {
    /// By slot: translation, rotation.
    poses: Vec<Real>,
    /// By slot: linear and angular velocity.
    velocities: Vec<Real>,
    /// By slot: 1 for sleeping and fixed bodies, and for empty slots.
    sleeping: Vec<u8>,
    /// By slot: the handle, or NaN.
    handles: Vec<f64>,
    /// Bodies that were awake at the last update.
    active: Vec<RigidBodyHandle>,
    /// Bodies may have been inserted, removed or edited since the last update.
    pub is_stale: bool,
}

impl Mirror {
    /// Updates the copies after a step: all bodies after edits, otherwise the awake and previously awake
    /// ones.
    pub fn update(&mut self, world: &PhysicsWorld) {
        let active = world.active_bodies();
        if self.is_stale {
            self.copy_all(world);
        } else {
            for handle in core::mem::take(&mut self.active).iter().chain(active) {
                if let Some(body) = world.bodies.get(*handle) {
                    self.copy(*handle, body);
                }
            }
        }
        self.active.clear();
        self.active.extend_from_slice(active);
        self.is_stale = false;
    }

    fn copy_all(&mut self, world: &PhysicsWorld) {
        self.handles.fill(f64::NAN);
        self.sleeping.fill(1);
        for (handle, body) in world.bodies.iter() {
            self.copy(handle, body);
        }
    }

    fn copy(&mut self, handle: RigidBodyHandle, body: &RigidBody) {
        let slot = handle.into_raw_parts().0 as usize;
        if self.handles.len() <= slot {
            let slots = (slot + 1).next_power_of_two().max(64);
            self.handles.resize(slots, f64::NAN);
            self.sleeping.resize(slots, 1);
            self.poses.resize(slots * POSE, 0.0);
            self.velocities.resize(slots * VELOCITY, 0.0);
        }
        self.handles[slot] = handle.to_number();
        self.sleeping[slot] = u8::from(body.is_sleeping() || body.is_fixed());
        let pose = &mut self.poses[slot * POSE..][..POSE];
        pose[..DIM].copy_from_slice(&body.translation().to_array());
        put_rotation(0, *body.rotation());
        for (at, value) in pose[DIM..].iter_mut().enumerate() {
            *value = number(0, at);
        }
        let velocity = &mut self.velocities[slot * VELOCITY..][..VELOCITY];
        velocity[..DIM].copy_from_slice(&body.linvel().to_array());
        crate::memory::put_angular(0, body.angvel());
        for (at, value) in velocity[DIM..].iter_mut().enumerate() {
            *value = number(0, at);
        }
    }
}

exports! {
    /// Updates the mirror, and creates it if necessary. Returns the number of slots.
    fn mirror_refresh(world: u32) -> usize {
        mirror(world, true)?.map_or(0, |mirror| mirror.handles.len())
    }

    /// The number of slots. 0 without a mirror.
    fn mirror_len(world: u32) -> usize {
        mirror(world, false)?.map_or(0, |mirror| mirror.handles.len())
    }

    /// The address of poses (0), velocities (1), sleep flags (2) or handles (3).
    fn mirror_address(world: u32, part: u32) -> usize {
        let Some(mirror) = mirror(world, false)? else { return Ok(0) };
        match part {
            0 => mirror.poses.as_ptr() as usize,
            1 => mirror.velocities.as_ptr() as usize,
            2 => mirror.sleeping.as_ptr() as usize,
            _ => mirror.handles.as_ptr() as usize,
        }
    }
}
