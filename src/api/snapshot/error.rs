//! Error of making or restoring a snapshot.

use super::codec::CodecError;
use super::header::FORMAT;
use crate::dim::math::DIM;

/// Error of making or restoring a snapshot.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SnapshotError {
    /// The first bytes are not the mark of a snapshot.
    #[error("the data does not begin as a snapshot does")]
    NotASnapshot,
    /// The first bytes are not the mark of a delta of snapshots.
    #[error("the data does not begin as a delta of snapshots does")]
    NotADelta,
    /// The length of the data differs from the length in the header.
    #[error("the snapshot has {expected} bytes, the data {found}")]
    Length {
        /// Number of bytes that the header states.
        expected: u64,
        /// Number of bytes of the data.
        found: u64,
    },
    /// Another version of the format wrote the snapshot.
    #[error("the snapshot has format {found}; this version of the engine reads format {FORMAT}")]
    Format {
        /// The snapshot's format.
        found: u16,
    },
    /// The snapshot is of a world with another number of dimensions.
    #[error("the snapshot is of a {found}D world; this is the {DIM}D engine")]
    Dimension {
        /// The snapshot's number of dimensions.
        found: u8,
    },
    /// The snapshot is of a world with another precision.
    #[error("the snapshot has numbers of {found} bits; those of this engine have {expected}")]
    Precision {
        /// Bits of the snapshot's numbers.
        found: u32,
        /// Bits of this engine's numbers.
        expected: u32,
    },
    /// The data was changed after it was saved.
    #[error("the snapshot is damaged: its checksum is {found:016x} instead of {expected:016x}")]
    Damaged {
        /// The checksum in the header.
        expected: u64,
        /// The checksum of the data.
        found: u64,
    },
    /// A part of the world cannot be saved, or its data is invalid.
    #[error("{part}: {reason}")]
    Invalid {
        /// The part of the world.
        part: &'static str,
        /// The error, with the value.
        reason: String,
    },
    /// A delta was applied to another snapshot than the one that it was made from.
    #[error(
        "the delta was made from a snapshot with the checksum {expected:016x}, not {found:016x}"
    )]
    Base {
        /// The checksum of the snapshot from which the delta was made.
        expected: u64,
        /// The checksum of the given snapshot.
        found: u64,
    },
}

impl SnapshotError {
    /// An error in a part of the world.
    pub(super) fn invalid(part: &'static str) -> impl FnOnce(CodecError) -> Self {
        move |CodecError(reason)| Self::Invalid { part, reason }
    }
}
