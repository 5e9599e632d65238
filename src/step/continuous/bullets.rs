//! Bodies that stop at everything: fast ones with `ccd_enabled`.
//!
//! Where a bullet is stopped depends on where the others are then, and these may be bullets that were stopped before.
//! So impacts are taken in the order of time. Whoever takes part in one stands still from then on, which makes all
//! later impacts with it uncertain: they are searched again when their time comes.

use super::Surroundings;
use super::path::Path;
use crate::base::bvh::{BoxProbe, BoxTree};
use crate::dim::math::Real;
use crate::model::body::{RigidBody, RigidBodyHandle};
use crate::model::tree::TreeKind;
use crate::step::notes::FastMotion;
use core::cmp::Ordering;
use parry::bounding_volume::Aabb;
use std::collections::BinaryHeap;

/// Buffers of the search.
#[derive(Default)]
pub(super) struct Bullets {
    /// The paths of all fast bodies, by their positions in the list.
    boxes: BoxTree,
    /// What each bullet may hit.
    pairs: Vec<Pair>,
    queue: BinaryHeap<Impact>,
    /// By fast body: how often it was stopped.
    stopped: Vec<u32>,
    /// Fast bodies by slot, with their positions in the list.
    by_slot: Vec<(u32, u32)>,
}

/// A bullet and what may be in its way.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Pair {
    bullet: u32,
    other: Other,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Other {
    /// A position in the list of fast bodies.
    Fast(u32),
    Slow(RigidBodyHandle),
}

/// An impact as it was foreseen when its bodies had been stopped so often.
#[derive(Copy, Clone, Debug, PartialEq)]
struct Impact {
    share: Real,
    pair: u32,
    stopped: [u32; 2],
}

impl Eq for Impact {}

impl PartialOrd for Impact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Impact {
    /// The greatest is the first.
    fn cmp(&self, other: &Self) -> Ordering {
        other.share.total_cmp(&self.share).then(other.pair.cmp(&self.pair))
    }
}

impl Bullets {
    /// Finds what stops bullets, and takes it off the shares of their motions that happen.
    pub fn find(&mut self, around: Surroundings<'_>, fast: &[FastMotion], stops: &mut [Real]) {
        let is_bullet = |motion: &&FastMotion| {
            around.bodies.get(motion.body).is_some_and(|body| body.ccd_enabled)
        };
        if !fast.iter().any(|motion| is_bullet(&motion)) {
            return;
        }
        self.find_pairs(around, fast, stops);
        self.stopped.clear();
        self.stopped.resize(fast.len(), 0);
        self.queue.clear();
        for pair in 0..self.pairs.len() {
            self.foresee(pair, around, fast, stops);
        }
        while let Some(Impact { share, pair, stopped }) = self.queue.pop() {
            if stopped != self.stopped_of(pair) {
                self.foresee(pair as usize, around, fast, stops);
                continue;
            }
            let Pair { bullet, other } = self.pairs[pair as usize];
            self.stop(bullet, share, stops);
            if let Other::Fast(other) = other {
                self.stop(other, share, stops);
            }
        }
    }

    fn stop(&mut self, position: u32, share: Real, stops: &mut [Real]) {
        let stop = &mut stops[position as usize];
        if share < *stop {
            *stop = share;
            self.stopped[position as usize] += 1;
        }
    }

    fn stopped_of(&self, pair: u32) -> [u32; 2] {
        let Pair { bullet, other } = self.pairs[pair as usize];
        let of_other = match other {
            Other::Fast(other) => self.stopped[other as usize],
            Other::Slow(_) => 0,
        };
        [self.stopped[bullet as usize], of_other]
    }

    /// Puts the impact of a pair into the queue, if there is one.
    fn foresee(
        &mut self,
        pair: usize,
        around: Surroundings<'_>,
        fast: &[FastMotion],
        stops: &[Real],
    ) {
        let Pair { bullet, other } = self.pairs[pair];
        let path_of = |at: u32| Path::of(around, &fast[at as usize], stops[at as usize]);
        let other = match other {
            Other::Fast(other) => path_of(other),
            Other::Slow(handle) => Path::of_slow(around, handle),
        };
        let Some((bullet, other)) = path_of(bullet).zip(other) else { return };
        // After both have stopped nothing more happens.
        if let Some(share) = bullet.impact(&other, around, 1.0) {
            let stopped = self.stopped_of(pair as u32);
            self.queue.push(Impact { share, pair: pair as u32, stopped });
        }
    }

    /// Lists the bullets with all that is near their paths.
    fn find_pairs(&mut self, around: Surroundings<'_>, fast: &[FastMotion], stops: &[Real]) {
        self.pairs.clear();
        self.by_slot.clear();
        self.boxes.clear();
        let mut bullets = Vec::new();
        for (position, motion) in (0..).zip(fast) {
            self.by_slot.push((motion.body.into_raw_parts().0, position));
            let path = Path::of(around, motion, stops[position as usize]);
            let Some(path) = path.filter(|path| !path.movers.is_empty()) else { continue };
            let region = path.region();
            self.boxes.insert(&region, position);
            if path.body.ccd_enabled {
                bullets.push((position, region));
            }
        }
        self.by_slot.sort_unstable();
        for (bullet, region) in bullets {
            self.find_others(bullet, &region, around, fast);
        }
        self.pairs.sort_unstable();
        self.pairs.dedup();
    }

    fn find_others(
        &mut self,
        bullet: u32,
        region: &Aabb,
        around: Surroundings<'_>,
        fast: &[FastMotion],
    ) {
        let Self { boxes, pairs, by_slot, .. } = self;
        boxes.for_each_leaf(&BoxProbe(*region), |other| {
            let body = around.bodies.get(fast[other as usize].body);
            let is_bullet = body.is_some_and(|body| body.ccd_enabled);
            // Of two bullets each finds the other.
            if other != bullet && (!is_bullet || bullet < other) {
                pairs.push(Pair { bullet, other: Other::Fast(other) });
            }
        });
        around.trees.for_each_overlapping(TreeKind::Movable, region, |slot| {
            let parent = around.colliders.at_slot(slot).and_then(|(_, c)| c.parent());
            let Some(handle) = parent else { return };
            let is_fast =
                by_slot.binary_search_by_key(&handle.into_raw_parts().0, |at| at.0).is_ok();
            if !is_fast && around.bodies.get(handle).is_some_and(RigidBody::is_dynamic) {
                pairs.push(Pair { bullet, other: Other::Slow(handle) });
            }
        });
    }
}
