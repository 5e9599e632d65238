//! Bodies that stop at everything: fast ones with `ccd_enabled`.
//!
//! The stop of a bullet depends on the positions of others at that time, and these may be bullets that were
//! stopped before. Impacts are therefore processed in order of time. The bodies of an impact stop, and
//! everything in their neighbourhood is searched again. Time is monotonic, so each body stops at most once.
//! Each pair is searched at most three times: when its paths are known, and when either body stops. Nearly
//! all searches end with the balls around the bodies, which miss each other.

use super::Search;
use super::path::{Path, ROUNDING};
use crate::base::bvh::{BoxProbe, BoxTree};
use crate::base::segments::Segments;
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodyHandle;
use crate::model::tree::TreeKind;
use core::cmp::Ordering;
use parry::bounding_volume::Aabb;
use std::collections::BinaryHeap;

/// Buffers of the search.
#[derive(Default)]
pub(super) struct Bullets {
    /// The paths of all fast bodies, by their positions in the list.
    boxes: BoxTree,
    /// The balls around all fast bodies, by the same.
    balls: Vec<Ball>,
    /// Possible targets of each bullet.
    pairs: Vec<Pair>,
    /// Fast bodies with their pairs.
    pairs_of: Vec<(u32, u32)>,
    queue: BinaryHeap<Impact>,
    /// By the first of each group of fast bodies: the number of stops of the group.
    stopped: Vec<u32>,
}

/// A bullet and a body near its path.
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
    fraction: Real,
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
        other.fraction.total_cmp(&self.fraction).then(other.pair.cmp(&self.pair))
    }
}

impl Bullets {
    /// Finds the stops of bullets, and reduces their motion fractions.
    pub fn find(&mut self, search: Search<'_>, toi_fractions: &mut [Real]) {
        let fast = search.context.fast;
        if !(0..fast.len()).any(|position| is_bullet(search, position)) {
            return;
        }
        self.find_pairs(search, toi_fractions);
        self.stopped.clear();
        self.stopped.resize(fast.len(), 0);
        self.queue.clear();
        for pair in 0..self.pairs.len() {
            self.foresee(pair, search, toi_fractions);
        }
        while let Some(Impact { fraction, pair, stopped }) = self.queue.pop() {
            // One of them was stopped since: the queue already contains the later impact.
            if stopped != self.stopped_of(pair, search) {
                continue;
            }
            let Pair { bullet, other } = self.pairs[pair as usize];
            self.stop(bullet, fraction, search, toi_fractions);
            if let Other::Fast(other) = other {
                self.stop(other, fraction, search, toi_fractions);
            }
        }
    }

    fn stop(
        &mut self,
        position: u32,
        fraction: Real,
        search: Search<'_>,
        toi_fractions: &mut [Real],
    ) {
        if !search.groups.stop(position as usize, fraction, toi_fractions) {
            return;
        }
        let first = search.groups.first(position as usize);
        self.stopped[first] += 1;
        for member in search.groups.members(first) {
            let start = self.pairs_of.partition_point(|of| of.0 < member);
            let mut at = start;
            while let Some(&(_, pair)) = self.pairs_of.get(at).filter(|of| of.0 == member) {
                self.foresee(pair as usize, search, toi_fractions);
                at += 1;
            }
        }
    }

    fn stopped_of(&self, pair: u32, search: Search<'_>) -> [u32; 2] {
        let Pair { bullet, other } = self.pairs[pair as usize];
        let of = |position: u32| self.stopped[search.groups.first(position as usize)];
        let of_other = match other {
            Other::Fast(other) => of(other),
            Other::Slow(_) => 0,
        };
        [of(bullet), of_other]
    }

    /// Puts the impact of a pair into the queue, if there is one.
    fn foresee(&mut self, pair: usize, search: Search<'_>, toi_fractions: &[Real]) {
        let Pair { bullet, other } = self.pairs[pair];
        if !self.may_meet(bullet, other, toi_fractions) {
            return;
        }
        let path_of = |at: u32| Path::of(search, at as usize, toi_fractions[at as usize]);
        let other = match other {
            Other::Fast(other) => path_of(other),
            Other::Slow(handle) => Path::of_slow(search, handle),
        };
        let Some((bullet, other)) = path_of(bullet).zip(other) else { return };
        // After both have stopped nothing more happens.
        if let Some(fraction) = bullet.impact(&other, search, 1.0) {
            let stopped = self.stopped_of(pair as u32, search);
            self.queue.push(Impact { fraction, pair: pair as u32, stopped });
        }
    }

    /// Lists the bullets with all that is near their paths.
    fn find_pairs(&mut self, search: Search<'_>, toi_fractions: &[Real]) {
        self.pairs.clear();
        self.boxes.clear();
        self.balls.clear();
        let mut bullets = Vec::new();
        for position in 0..search.context.fast.len() {
            let path = Path::of(search, position, toi_fractions[position]);
            self.balls.push(Ball::around(search, position));
            let Some(path) = path.filter(|path| !path.movers.is_empty()) else { continue };
            let region = path.region();
            self.boxes.insert(&region, position as u32);
            if path.body.ccd_enabled {
                bullets.push((position as u32, region));
            }
        }
        for (bullet, region) in bullets {
            self.find_others(bullet, &region, search, toi_fractions);
        }
        self.pairs.sort_unstable();
        self.pairs.dedup();
        self.pairs_of.clear();
        for (number, pair) in (0..).zip(&self.pairs) {
            self.pairs_of.push((pair.bullet, number));
            if let Other::Fast(other) = pair.other {
                self.pairs_of.push((other, number));
            }
        }
        self.pairs_of.sort_unstable();
    }

    fn find_others(
        &mut self,
        bullet: u32,
        region: &Aabb,
        search: Search<'_>,
        toi_fractions: &[Real],
    ) {
        let Self { boxes, balls, pairs, .. } = self;
        boxes.for_each_leaf(&BoxProbe(*region), |other| {
            // Each of two bullets finds the other.
            let is_first = bullet < other || !is_bullet(search, other as usize);
            let of = |position: u32| (&balls[position as usize], toi_fractions[position as usize]);
            if other != bullet && is_first && Ball::ways_meet([of(bullet), of(other)]) {
                pairs.push(Pair { bullet, other: Other::Fast(other) });
            }
        });
        search.context.trees.for_each_overlapping(TreeKind::Dynamic, region, |slot| {
            let parent = search.context.colliders.at_slot(slot).and_then(|(_, c)| c.parent());
            let Some(handle) = parent else { return };
            let is_fast = search.groups.position(handle.into_raw_parts().0).is_some();
            if !is_fast {
                pairs.push(Pair { bullet, other: Other::Slow(handle) });
            }
        });
    }

    /// Returns whether the bounding spheres of two fast bodies meet. For slow bodies the result is unknown.
    fn may_meet(&self, bullet: u32, other: Other, toi_fractions: &[Real]) -> bool {
        let Other::Fast(other) = other else { return true };
        Ball::may_meet(
            [bullet, other].map(|at| (&self.balls[at as usize], toi_fractions[at as usize])),
        )
    }
}

fn is_bullet(search: Search<'_>, position: usize) -> bool {
    let body =
        search.context.fast.get(position).and_then(|motion| search.context.bodies.get(motion.body));
    body.is_some_and(|body| body.ccd_enabled)
}

/// Bounding sphere of a body's path. Among many bullets with crossing paths, nearly all pairs miss each
/// other. This test excludes them in about ten operations.
#[derive(Copy, Clone, Debug)]
struct Ball {
    center: Vector,
    shift: Vector,
    radius: Real,
}

impl Ball {
    fn around(search: Search<'_>, position: usize) -> Self {
        let motion = &search.context.fast[position];
        let body = search.context.bodies.get(motion.body);
        // A link does not go straight.
        let body = body.filter(|_| motion.link.is_none());
        let prediction = search.context.params.prediction_distance();
        let radius =
            body.map_or(Real::INFINITY, |body| body.extent + prediction + search.skin_of(body));
        Self { center: motion.center, shift: motion.path_shift(), radius }
    }

    /// Returns whether the paths of these spheres cross at any time.
    fn ways_meet([(ball1, stop1), (ball2, stop2)]: [(&Self, Real); 2]) -> bool {
        let along = [ball1.shift * stop1, ball2.shift * stop2];
        let segments = Segments::new([ball1.center, ball2.center], along);
        let [fraction1, fraction2] = segments.nearest_from(segments.crossing());
        let apart = ball1.center + along[0] * fraction1 - ball2.center - along[1] * fraction2;
        // Positions on long paths have this rounding error.
        let rounding = ROUNDING * (along[0].abs() + along[1].abs()).max_element();
        let radius = ball1.radius + ball2.radius + rounding;
        let misses = apart.length_squared() > radius * radius;
        !misses
    }

    /// Returns whether the bodies in these spheres may meet.
    fn may_meet([(ball1, stop1), (ball2, stop2)]: [(&Self, Real); 2]) -> bool {
        let apart = |fraction: Real| {
            let at = |ball: &Self, stop: Real| ball.center + ball.shift * fraction.min(stop);
            at(ball1, stop1) - at(ball2, stop2)
        };
        // As seen from the second, the first goes straight until one of them stops.
        let places = [0.0, stop1.min(stop2), stop1.max(stop2)].map(apart);
        let rounding = ROUNDING * (ball1.shift.abs() + ball2.shift.abs()).max_element();
        let radius = ball1.radius + ball2.radius + rounding;
        let misses = |from: Vector, to: Vector| nearest_square(from, to) > radius * radius;
        !(misses(places[0], places[1]) && misses(places[1], places[2]))
    }
}

/// Squared distance of a segment from the origin, up to rounding.
fn nearest_square(from: Vector, to: Vector) -> Real {
    let displacement = to - from;
    let length_squared = displacement.length_squared();
    let fraction =
        if length_squared > 0.0 { -from.dot(displacement) / length_squared } else { 0.0 };
    (from + displacement * fraction.clamp(0.0, 1.0)).length_squared()
}
