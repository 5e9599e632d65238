//! Differences between two snapshots, for programs that send or store many of them.
//!
//! A delta is a list of runs: some new bytes, then some bytes that are copied from the older snapshot (the
//! base). The *shift* of a copy is its position in the new snapshot minus that in the base. It stays the same
//! while no list grows or shrinks, and most copies keep it. If none of the next bytes match under the present
//! shift, a table of the blocks of the base gives another.
//!
//! Copies move forward through the base and never overlap. So a forged delta cannot make more bytes than the
//! base and itself have.
//!
//! Every run is three numbers in front of the new bytes: their number, the number of copied bytes, and the
//! change of the shift. General tools (bsdiff, xdelta) find shorter deltas of executables, which move in many
//! pieces. A world moves in few pieces, and these tools take a hundred times longer.

use super::codec::{CodecError, read, write};
use super::error::SnapshotError;
use super::header::{checksum, open};

const MAGIC: [u8; 8] = *b"physdlt\n";

/// A copy of fewer bytes would be longer than the bytes.
const COPY_BYTES_MIN: usize = 5;
/// Number of new bytes in a row after which another shift is searched.
const LITERAL_BYTES_MAX: usize = 32;
/// The bytes of a block of the table.
const BLOCK_BYTES: usize = 16;
/// Number of bytes that a new shift must match: fewer may match by chance.
const SHIFTED_BYTES_MIN: usize = 32;

/// The input of [`apply_snapshot_delta`] to make `next` from `base`. Both are
/// [snapshots](crate::pipeline::PhysicsWorld::to_snapshot), usually of the same world at two times.
///
/// # Errors
/// If one of them is not a snapshot of this engine.
///
/// ```
/// # use rapier3d::prelude::*;
/// let mut world = PhysicsWorld::new();
/// for i in 0..100 {
///     let body = RigidBodyBuilder::dynamic().translation(vector![3.0 * i as Real, 0.0, 0.0]).sleeping(i > 0);
///     world.insert(body, ColliderBuilder::ball(0.5));
/// }
/// world.step();
/// let base = world.to_snapshot()?;
/// world.step();
/// let next = world.to_snapshot()?;
/// let delta = snapshot_delta(&base, &next)?;
/// assert!(delta.len() < next.len() / 2);
/// assert_eq!(apply_snapshot_delta(&base, &delta)?, next);
/// # Ok::<(), SnapshotError>(())
/// ```
pub fn snapshot_delta(base: &[u8], next: &[u8]) -> Result<Vec<u8>, SnapshotError> {
    open(base)?;
    open(next)?;
    let mut bytes = MAGIC.to_vec();
    bytes.extend(checksum(base).to_le_bytes());
    Differ::new(base, next).write_runs(&mut bytes).map_err(SnapshotError::invalid("delta"))?;
    Ok(bytes)
}

/// The newer snapshot of a [delta](snapshot_delta).
///
/// # Errors
/// If the delta was made from another snapshot than `base`, or if the delta is damaged.
pub fn apply_snapshot_delta(base: &[u8], delta: &[u8]) -> Result<Vec<u8>, SnapshotError> {
    open(base)?;
    let rest = delta.strip_prefix(&MAGIC).ok_or(SnapshotError::NotADelta)?;
    let (expected, runs) = rest.split_first_chunk().ok_or(SnapshotError::NotADelta)?;
    let (expected, found) = (u64::from_le_bytes(*expected), checksum(base));
    if expected != found {
        return Err(SnapshotError::Base { expected, found });
    }
    let next = read_runs(base, runs).map_err(SnapshotError::invalid("delta"))?;
    open(&next)?;
    Ok(next)
}

/// Some new bytes, and the copy that follows them.
type Run = (usize, usize, i64);

fn read_runs(base: &[u8], mut runs: &[u8]) -> Result<Vec<u8>, CodecError> {
    let error = |what: &str| CodecError(format!("{what} of {} bytes", base.len()));
    let (mut next, mut copied, mut from) = (Vec::new(), 0, 0_usize);
    while !runs.is_empty() {
        let ((literal, copy, skip), rest) = read::<Run>(runs)?;
        let (literals, rest) =
            rest.split_at_checked(literal).ok_or_else(|| error("new bytes beyond the end"))?;
        next.extend_from_slice(literals);
        // Under an unchanged shift the copy begins as many bytes further in the base as there are new ones.
        from = (from as i64).wrapping_add(literal as i64).wrapping_add(skip) as usize;
        if copy > 0 {
            let end = from.checked_add(copy).filter(|_| from >= copied);
            let bytes = end.and_then(|end| base.get(from..end));
            next.extend_from_slice(bytes.ok_or_else(|| error("a copy outside of the base"))?);
            from += copy;
            copied = from;
        }
        runs = rest;
    }
    Ok(next)
}

/// Two snapshots, and the position of the comparison.
struct Differ<'a> {
    base: &'a [u8],
    next: &'a [u8],
    /// Position in the new snapshot.
    at: usize,
    /// Position in the base under the present shift.
    from: usize,
    /// The base in front of this position has been copied or passed.
    copied: usize,
    blocks: Option<Blocks>,
}

impl<'a> Differ<'a> {
    fn new(base: &'a [u8], next: &'a [u8]) -> Self {
        Self { base, next, at: 0, from: 0, copied: 0, blocks: None }
    }

    fn write_runs(&mut self, bytes: &mut Vec<u8>) -> Result<(), CodecError> {
        while self.at < self.next.len() {
            let (start, from) = (self.at, self.from);
            let copy = self.find_copy();
            let literals = &self.next[start..self.at];
            let skip = self.from as i64 - (from + literals.len()) as i64;
            write(&(literals.len(), copy, skip), bytes)?;
            bytes.extend_from_slice(literals);
            self.at += copy;
            self.from += copy;
            self.copied = self.from;
        }
        Ok(())
    }

    /// Moves to the next bytes that can be copied, and returns their number; 0 at the end.
    fn find_copy(&mut self) -> usize {
        let start = self.at;
        while self.at < self.next.len() {
            let matching = self.matching(self.from);
            if matching >= COPY_BYTES_MIN.min(self.next.len() - self.at) {
                return matching;
            }
            if self.at - start >= LITERAL_BYTES_MAX
                && let Some(from) = self.find_shift()
            {
                self.from = from;
                return self.matching(from);
            }
            self.at += 1;
            self.from += 1;
        }
        0
    }

    /// The number of bytes from here on that equal those of the base from a position on.
    fn matching(&self, from: usize) -> usize {
        let base = self.base.get(from..).unwrap_or_default();
        let pairs = self.next[self.at..].iter().zip(base);
        pairs.take_while(|(next, base)| next == base).count()
    }

    /// Another position in the base from which the next bytes can be copied.
    fn find_shift(&mut self) -> Option<usize> {
        let block = self.next[self.at..].first_chunk()?;
        let blocks = self.blocks.get_or_insert_with(|| Blocks::of(self.base));
        let from = blocks.find(block, self.copied)?;
        (self.matching(from) >= SHIFTED_BYTES_MIN).then_some(from)
    }
}

/// The blocks of a snapshot, ordered by content, then by position.
struct Blocks(Vec<(u128, u32)>);

impl Blocks {
    fn of(base: &[u8]) -> Self {
        let (blocks, _) = base[..base.len().min(u32::MAX as usize)].as_chunks::<BLOCK_BYTES>();
        let positions = (0_u32..).step_by(BLOCK_BYTES);
        let all = blocks.iter().map(|block| u128::from_le_bytes(*block)).zip(positions);
        // Runs of zeros are frequent, so they do not identify a shift.
        let mut blocks: Vec<_> = all.filter(|(block, _)| *block != 0).collect();
        blocks.sort_unstable();
        Self(blocks)
    }

    /// The first position of a block that is not in front of another position.
    fn find(&self, block: &[u8; BLOCK_BYTES], not_before: usize) -> Option<usize> {
        let block = u128::from_le_bytes(*block);
        let before = |entry: &(u128, u32)| *entry < (block, not_before as u32);
        let (found, position) = *self.0.get(self.0.partition_point(before))?;
        (found == block).then_some(position as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::{Differ, read_runs};
    use crate::base::random::Random;

    fn check(base: &[u8], next: &[u8]) -> usize {
        let mut runs = Vec::new();
        Differ::new(base, next).write_runs(&mut runs).expect("numbers can be written");
        assert_eq!(read_runs(base, &runs).expect("it was just made"), next);
        runs.len()
    }

    fn noise(random: &mut Random, count: usize) -> Vec<u8> {
        (0..count).map(|_| random.bits() as u8).collect()
    }

    #[test]
    fn any_two_lists_of_bytes_have_a_delta() {
        let mut random = Random(1);
        for _ in 0..300 {
            let (count, other) = (random.below(300), random.below(300));
            let base = noise(&mut random, count);
            let mut next = noise(&mut random, other);
            check(&base, &next);
            let (from, to) = (random.below(count + 1), random.below(other + 1));
            next.splice(to..to, base[from..].iter().copied());
            check(&base, &next);
        }
    }

    #[test]
    fn unchanged_bytes_cost_nothing() {
        let mut random = Random(2);
        let base = noise(&mut random, 100_000);
        assert!(check(&base, &base) <= 8);
        // Every tenth number changes.
        let mut next = base.clone();
        next.iter_mut().step_by(40).for_each(|byte| *byte ^= 0x55);
        assert!(check(&base, &next) <= 2_500 * 5);
    }

    #[test]
    fn bytes_that_are_inserted_or_removed_cost_themselves_alone() {
        let mut random = Random(3);
        let base = noise(&mut random, 100_000);
        let mut next = base.clone();
        let new = noise(&mut random, 700);
        next.splice(30_000..30_000, new);
        next.drain(60_000..61_000);
        let cost = check(&base, &next);
        assert!(cost < 900, "700 new bytes took {cost}");
    }

    #[test]
    fn forged_runs_copy_nothing_twice() {
        let base = [7; 100];
        let mut runs = Vec::new();
        for _ in 0..2 {
            super::write(&(0_usize, 100_usize, 0_i64), &mut runs).expect("numbers");
        }
        assert!(read_runs(&base, &runs).is_err(), "the second copy begins behind the end");
        runs.truncate(3);
        super::write(&(0_usize, 100_usize, -100_i64), &mut runs).expect("numbers");
        assert!(read_runs(&base, &runs).is_err(), "the second copy is the first again");
        super::write(&(usize::MAX, usize::MAX, i64::MIN), &mut runs).expect("numbers");
        assert!(read_runs(&base, &runs[3..]).is_err());
    }
}
