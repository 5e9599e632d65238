//! The first bytes of a snapshot: its format, and a checksum.

use super::error::SnapshotError;
use crate::base::hash::MixHasher;
use crate::dim::math::{DIM, Real};
use core::hash::Hasher as _;

/// Version of the format. It grows with every change of a saved type, and a snapshot of another version is
/// refused.
pub const FORMAT: u16 = 9;

const MAGIC: [u8; 8] = *b"physnap\n";

/// Number of bytes in front of the saved parts.
pub const HEADER_BYTES: usize = 28;

/// Description of the bytes that follow the header.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Header {
    format: u16,
    dimension: u8,
    /// Bytes of a number.
    precision: u8,
    length: u64,
    checksum: u64,
}

impl Header {
    /// The header of a snapshot of this engine.
    fn of(payload: &[u8]) -> Self {
        Self {
            format: FORMAT,
            dimension: DIM as u8,
            precision: size_of::<Real>() as u8,
            length: payload.len() as u64,
            checksum: checksum(payload),
        }
    }

    fn to_bytes(self) -> [u8; HEADER_BYTES] {
        let mut bytes = [0; HEADER_BYTES];
        bytes[..8].copy_from_slice(&MAGIC);
        bytes[8..10].copy_from_slice(&self.format.to_le_bytes());
        bytes[10] = self.dimension;
        bytes[11] = self.precision;
        bytes[12..20].copy_from_slice(&self.length.to_le_bytes());
        bytes[20..].copy_from_slice(&self.checksum.to_le_bytes());
        bytes
    }

    /// `None` if the bytes do not begin with the mark of a snapshot.
    fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (magic, rest) = bytes.split_first_chunk::<8>()?;
        let (format, rest) = rest.split_first_chunk::<2>()?;
        let ([dimension, precision], rest) = rest.split_first_chunk::<2>()?;
        let (length, rest) = rest.split_first_chunk::<8>()?;
        let (checksum, _) = rest.split_first_chunk::<8>()?;
        (*magic == MAGIC).then_some(Self {
            format: u16::from_le_bytes(*format),
            dimension: *dimension,
            precision: *precision,
            length: u64::from_le_bytes(*length),
            checksum: u64::from_le_bytes(*checksum),
        })
    }

    fn check(self, payload: &[u8]) -> Result<(), SnapshotError> {
        let expected = Self::of(payload);
        if self.format != expected.format {
            return Err(SnapshotError::Format { found: self.format });
        }
        if self.dimension != expected.dimension {
            return Err(SnapshotError::Dimension { found: self.dimension });
        }
        if self.precision != expected.precision {
            let [found, expected] = [self, expected].map(|it| u32::from(it.precision) * 8);
            return Err(SnapshotError::Precision { found, expected });
        }
        if self.length != expected.length {
            let header = HEADER_BYTES as u64;
            let [expected, found] = [self, expected].map(|it| it.length.saturating_add(header));
            return Err(SnapshotError::Length { expected, found });
        }
        if self.checksum != expected.checksum {
            let (expected, found) = (self.checksum, expected.checksum);
            return Err(SnapshotError::Damaged { expected, found });
        }
        Ok(())
    }
}

/// A hash that recognises damage. It is no defence against forgery: all data is validated besides.
pub fn checksum(bytes: &[u8]) -> u64 {
    let mut hasher = MixHasher::default();
    hasher.write_u64(bytes.len() as u64);
    hasher.write(bytes);
    hasher.finish()
}

/// Fills in the header in front of the saved parts.
pub fn fill_header(snapshot: &mut [u8]) {
    let (header, payload) = snapshot.split_at_mut(HEADER_BYTES);
    header.copy_from_slice(&Header::of(payload).to_bytes());
}

/// Returns the saved parts behind the header.
///
/// # Errors
/// If this engine cannot read the snapshot, or if it is damaged.
pub fn open(snapshot: &[u8]) -> Result<&[u8], SnapshotError> {
    let header = Header::from_bytes(snapshot).ok_or(SnapshotError::NotASnapshot)?;
    let payload = &snapshot[HEADER_BYTES..];
    header.check(payload)?;
    Ok(payload)
}
