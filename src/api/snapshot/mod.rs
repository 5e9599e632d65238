//! # Snapshots: whole worlds as bytes
//!
//! A snapshot is a [header](header) and the nine parts of a world, in sequence, in the [format](codec) of
//! this module. Each part checks itself when it is read; references between the sets are checked by the first
//! step (`src/model/structure/check/`).

pub(super) mod codec;
mod delta;
mod error;
mod header;

pub use delta::{apply_snapshot_delta, snapshot_delta};
pub use error::SnapshotError;

use super::world::PhysicsWorld;
use codec::{read, write};
use header::HEADER_BYTES;
use serde::Serialize;
use serde::de::DeserializeOwned;

impl PhysicsWorld {
    /// The whole world as bytes: gravity, parameters, bodies, colliders, joints, pairs, islands and trees.
    ///
    /// A world that is [restored](Self::from_snapshot) from it continues bit for bit like this one, on every
    /// machine. The same history gives the same bytes. Pipelines have no state of the world; their settings
    /// (threads, registers) are not saved.
    ///
    /// # Errors
    /// If a collider has a user-defined shape.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let mut world = PhysicsWorld::new();
    /// world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
    /// let snapshot = world.to_snapshot()?;
    /// world.step();
    /// let mut restored = PhysicsWorld::from_snapshot(&snapshot)?;
    /// restored.step();
    /// assert_eq!(world.hash(), restored.hash());
    /// # Ok::<(), SnapshotError>(())
    /// ```
    pub fn to_snapshot(&self) -> Result<Vec<u8>, SnapshotError> {
        let mut bytes = Vec::new();
        self.write_snapshot(&mut bytes)?;
        Ok(bytes)
    }

    /// The same as [`Self::to_snapshot`], into an existing list: its content is replaced and its memory
    /// reused.
    ///
    /// # Errors
    /// If a collider has a user-defined shape. The list is then empty.
    pub fn write_snapshot(&self, bytes: &mut Vec<u8>) -> Result<(), SnapshotError> {
        bytes.clear();
        bytes.resize(HEADER_BYTES, 0);
        let written = self.write_parts(bytes);
        match written {
            Ok(()) => header::fill_header(bytes),
            Err(_) => bytes.clear(),
        }
        written
    }

    fn write_parts(&self, bytes: &mut Vec<u8>) -> Result<(), SnapshotError> {
        let mut parts = Parts(bytes);
        parts.write("gravity", &self.gravity)?;
        parts.write("integration parameters", &self.integration_parameters)?;
        parts.write("bodies", &self.bodies)?;
        parts.write("colliders", &self.colliders)?;
        parts.write("islands", &self.islands)?;
        parts.write("broad phase", &self.broad_phase)?;
        parts.write("narrow phase", &self.narrow_phase)?;
        parts.write("impulse joints", &self.impulse_joints)?;
        parts.write("multibody joints", &self.multibody_joints)
    }

    /// The world of a [snapshot](Self::to_snapshot), with new pipelines.
    ///
    /// # Errors
    /// If the snapshot has another version of the format, another dimension or another precision. If it is
    /// damaged or truncated. If its data does not describe a valid world.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let mut snapshot = PhysicsWorld::new().to_snapshot()?;
    /// snapshot.pop();
    /// assert!(matches!(PhysicsWorld::from_snapshot(&snapshot), Err(SnapshotError::Length { .. })));
    /// # Ok::<(), SnapshotError>(())
    /// ```
    pub fn from_snapshot(snapshot: &[u8]) -> Result<Self, SnapshotError> {
        let mut parts = Parts(header::open(snapshot)?);
        let world = Self {
            gravity: parts.read("gravity")?,
            integration_parameters: parts.read("integration parameters")?,
            bodies: parts.read("bodies")?,
            colliders: parts.read("colliders")?,
            islands: parts.read("islands")?,
            broad_phase: parts.read("broad phase")?,
            narrow_phase: parts.read("narrow phase")?,
            impulse_joints: parts.read("impulse joints")?,
            multibody_joints: parts.read("multibody joints")?,
            ..Self::new()
        };
        match parts.0 {
            [] => Ok(world),
            rest => Err(SnapshotError::Invalid {
                part: "end",
                reason: format!("{} bytes follow the last part", rest.len()),
            }),
        }
    }
}

/// The bytes of the parts: those that are written, or those that are left to read.
struct Parts<B>(B);

impl Parts<&mut Vec<u8>> {
    fn write(&mut self, part: &'static str, value: &impl Serialize) -> Result<(), SnapshotError> {
        write(value, self.0).map_err(SnapshotError::invalid(part))
    }
}

impl Parts<&[u8]> {
    fn read<T: DeserializeOwned>(&mut self, part: &'static str) -> Result<T, SnapshotError> {
        let (value, rest) = read(self.0).map_err(SnapshotError::invalid(part))?;
        self.0 = rest;
        Ok(value)
    }
}
