//! The format of a recording: a header, a title, a snapshot, and one frame per step.

use super::error::RecordingError;
use crate::api::snapshot::codec::{CodecError, read, write};
use crate::api::world::PhysicsWorld;
use crate::model::body::RigidBodyHandle;
use crate::step::StepStage;
use serde::{Deserialize, Serialize};

const MAGIC: [u8; 8] = *b"physrec\n";

/// Version of the format. Snapshots in it have a version of their own.
const FORMAT: u16 = 1;

/// Header of the frames.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Opening {
    /// The user's description of the recording.
    pub title: String,
    /// The version of the engine.
    pub engine: String,
    #[serde(with = "bytes")]
    pub snapshot: Vec<u8>,
}

/// One step.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Frame {
    /// The difference that the user's edits made since the last step, as a delta of snapshots. `None`: no
    /// edits.
    pub edits: Option<Edits>,
    /// The hash of the world after the step.
    pub hash: u64,
    /// The lower halves of the hashes of all bodies, in the order of their slots.
    pub bodies: Vec<u32>,
    /// The hashes after the stages; empty if they are not recorded.
    pub stages: Vec<(StepStage, u64)>,
}

/// A delta of snapshots.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Edits(#[serde(with = "bytes")] pub Vec<u8>);

impl Frame {
    /// The frame of a world that has just been stepped.
    pub fn of(world: &PhysicsWorld, edits: Option<Edits>) -> Self {
        let bodies = body_hashes(world).map(|(_, hash)| hash).collect();
        let stages = world.physics_pipeline.stage_hashes().to_vec();
        Self { edits, hash: world.hash(), bodies, stages }
    }

    /// The first body whose hash differs from the recorded one.
    pub fn first_difference(&self, world: &PhysicsWorld) -> Option<RigidBodyHandle> {
        let mut recorded = self.bodies.iter();
        body_hashes(world).find(|(_, hash)| recorded.next() != Some(hash)).map(|(body, _)| body)
    }
}

fn body_hashes(world: &PhysicsWorld) -> impl Iterator<Item = (RigidBodyHandle, u32)> {
    world.bodies.iter().map(|(handle, body)| (handle, body.hash() as u32))
}

/// The first bytes of a recording.
pub fn write_opening(opening: &Opening) -> Vec<u8> {
    let mut bytes = MAGIC.to_vec();
    bytes.extend(FORMAT.to_le_bytes());
    append(opening, &mut bytes);
    bytes
}

/// Appends a frame to a recording.
pub fn write_frame(frame: &Frame, bytes: &mut Vec<u8>) {
    append(frame, bytes);
}

fn append(value: &impl Serialize, bytes: &mut Vec<u8>) {
    // The types of this file have no part that refuses to be saved.
    if let Err(CodecError(reason)) = write(value, bytes) {
        log::error!("a part of a recording was not written: {reason}");
    }
}

/// Reads the header before the frames, and returns it with the frames.
pub fn read_opening(recording: &[u8]) -> Result<(Opening, &[u8]), RecordingError> {
    let rest = recording.strip_prefix(&MAGIC).ok_or(RecordingError::NotARecording)?;
    let (format, rest) = rest.split_first_chunk().ok_or(RecordingError::NotARecording)?;
    let found = u16::from_le_bytes(*format);
    if found != FORMAT {
        return Err(RecordingError::Format { found, expected: FORMAT });
    }
    read(rest).map_err(|CodecError(reason)| RecordingError::Opening { reason })
}

/// Reads a frame, and returns it with the frames that follow it.
pub fn read_frame(frames: &[u8], step: usize) -> Result<(Frame, &[u8]), RecordingError> {
    read(frames).map_err(|CodecError(reason)| RecordingError::Damaged { step, reason })
}

/// Bytes as one piece: serde's derived code would read and write them one at a time.
mod bytes {
    use core::fmt;
    use serde::de::{Error, Visitor};
    use serde::{Deserializer, Serializer};

    pub fn serialize<S: Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_bytes(bytes)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<u8>, D::Error> {
        struct Bytes;

        impl Visitor<'_> for Bytes {
            type Value = Vec<u8>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("bytes")
            }

            fn visit_byte_buf<E: Error>(self, bytes: Vec<u8>) -> Result<Vec<u8>, E> {
                Ok(bytes)
            }
        }

        deserializer.deserialize_byte_buf(Bytes)
    }
}
