//! Scheduling: which constraints fill the lanes of a block, and which blocks run at the same time.
//!
//! All rows of the solver are in blocks of lanes. A colour is a range of blocks whose constraints have no
//! common dynamic body. Blocks of one colour run on any number of threads, and colours run in sequence.

mod kernel;
mod layout;
mod overflow;

use crate::base::tasks::Tasks;
use core::ops::Range;
pub(super) use kernel::block_kernel;
pub(super) use layout::Layout;
pub(super) use overflow::OverflowOrder;

/// Distributes the blocks colour by colour, in tasks of `grain` blocks. Those of one colour run at the same
/// time.
pub(super) fn for_each_color(
    colors: &[Range<usize>],
    tasks: Tasks<'_>,
    grain: usize,
    work: impl Fn(Range<usize>) + Sync,
) {
    for color in colors {
        tasks.par_for(color.len(), grain, |range| {
            work(color.start + range.start..color.start + range.end);
        });
    }
}
