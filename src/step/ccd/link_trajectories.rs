//! Trajectories of links of multibodies.
//!
//! A link goes where the coordinates of its joints lead it: on an arc, if it is the end of a swinging arm.
//! The path of a link consists of many segments, each straight enough that the chord error is harmless. The
//! segments sample the trajectory of the whole multibody (`src/multibody/trajectory.rs`). When one link
//! stops, all coordinates return to that fraction of the trajectory, so the joints hold.
//!
//! A kinematic root carries its links through walls, as kinematic bodies pass walls.

use super::{CcdContext, StopContext};
use crate::collide::PathSegment;
use crate::dim::math::{AngVector, Real, Vector, rotation_to_angle};
use crate::model::multibody::{LinkTrajectory, Multibody};
use crate::multibody::LinkSample;
use crate::step::notes::FastMotion;
use core::ops::Range;

/// Largest distance of a link from its segment, as a fraction of the thickness of the thinnest fast link. It
/// is less than the gap that the search leaves between a core and the other shape. Otherwise a stopped link
/// could have its middle inside.
const CHORD_DEVIATION_MAX: Real = 0.01;

/// The segments of all links of fast multibodies.
#[derive(Default)]
pub(super) struct LinkTrajectories {
    segments: Vec<PathSegment>,
    of_tree: Vec<Tree>,
}

/// Positions of a multibody in the lists.
struct Tree {
    /// Start of its segments, link by link.
    segments: usize,
    /// Each link has one more than this many.
    pieces: usize,
    /// Its links among the fast bodies.
    links: Range<usize>,
}

impl LinkTrajectories {
    /// Samples the trajectories of all fast multibodies.
    pub fn find(&mut self, context: CcdContext<'_>) {
        self.segments.clear();
        self.of_tree.clear();
        let mut next = 0;
        for (tree, trajectory) in context.trajectories.iter().enumerate() {
            let is_own = |motion: &&FastMotion| motion.link.is_some_and(|link| link.0 == tree);
            let links = &context.fast[next..];
            let before = links.iter().take_while(|motion| !is_own(motion)).count();
            let count = links[before..].iter().take_while(is_own).count();
            debug_assert!(count > 0, "the links of a fast multibody are fast bodies");
            let links = next + before..next + before + count;
            next = links.end;
            let pieces = trajectory
                .pieces(CHORD_DEVIATION_MAX * thickness(context, &context.fast[links.clone()]));
            self.of_tree.push(Tree { segments: self.segments.len(), pieces, links });
            if let Some(multibody) = context.multibodies.get_multibody(trajectory.index) {
                self.walk(context, trajectory, multibody, pieces);
            }
        }
    }

    /// The segments of a link of a multibody; empty if the link is missing.
    pub fn of(&self, (tree, link): (usize, usize)) -> &[PathSegment] {
        let Tree { segments, pieces, .. } = self.of_tree[tree];
        let (start, count) = (segments + link * (pieces + 1), pieces + 1);
        self.segments.get(start..start + count).unwrap_or_default()
    }

    /// Puts multibodies back to where they were stopped.
    pub fn stop(&self, context: &mut StopContext<'_>, toi_fractions: &[Real]) {
        let StopContext { bodies, multibodies, fast, trajectories, dt, .. } = context;
        if toi_fractions.is_empty() {
            return;
        }
        for (tree, trajectory) in self.of_tree.iter().zip(*trajectories) {
            let links = &fast[tree.links.clone()];
            let fraction = toi_fractions[tree.links.clone()].first().copied().unwrap_or(1.0);
            let multibody = multibodies.get_unnoted_mut(trajectory.index);
            let Some(multibody) = multibody.filter(|_| fraction < 1.0) else { continue };
            let acceleration = |id| {
                let motion =
                    links.iter().find(|motion| motion.link.is_some_and(|link| link.1 == id));
                motion.map(|motion| motion.acceleration).unwrap_or_default()
            };
            let fraction = gone(fraction, tree.pieces);
            trajectory.go_back(multibody, bodies, fraction, tree.pieces, *dt, acceleration);
        }
    }

    fn walk(
        &mut self,
        context: CcdContext<'_>,
        trajectory: &LinkTrajectory,
        multibody: &Multibody,
        pieces: usize,
    ) {
        let start = self.segments.len();
        let count = pieces + 1;
        let mut last: Vec<LinkSample> = Vec::new();
        trajectory.walk(multibody, pieces, |at, samples| {
            if at == 0 {
                self.segments.resize(start + samples.len() * count, PathSegment::AT_REST);
            }
            for (link, (from, to)) in last.iter().zip(samples).enumerate() {
                let rotvec = (from.angular + to.angular) * (0.5 / pieces as Real);
                self.segments[start + link * count + at - 1] =
                    segment(at - 1, pieces, from, to.center, rotvec);
            }
            last.clear();
            last.extend_from_slice(samples);
        });
        for (id, (link, from)) in multibody.links.iter().zip(&last).enumerate() {
            let Some(body) = context.bodies.get(link.body) else { continue };
            let rotvec = rotation_to_angle(&(body.pose.rotation * from.rotation.inverse()));
            let to = body.mprops.world_com;
            self.segments[start + id * count + pieces] = segment(pieces, pieces, from, to, rotvec);
        }
    }
}

/// Segment `at` of a trajectory with this number of pieces. One more segment leads to the pose of the solver.
/// That pose differs slightly from the trajectory if the link rotated about several axes in sequence. The
/// last two take half as long as the others.
fn segment(
    at: usize,
    pieces: usize,
    from: &LinkSample,
    to: Vector,
    rotvec: AngVector,
) -> PathSegment {
    let time = |at: usize| match at {
        at if at < pieces => at as Real / pieces as Real,
        at if at == pieces => 1.0 - 0.5 / pieces as Real,
        _ => 1.0,
    };
    let (begin, end) = (time(at), time(at + 1));
    let pace = 1.0 / (end - begin);
    let (shift, rotvec) = ((to - from.center) * pace, rotvec * pace);
    PathSegment {
        from: begin,
        until: end,
        rotation: from.rotation,
        center: from.center,
        shift,
        rotvec,
    }
}

/// Fraction of the trajectory after a fraction of the step. A link that stopped on the last segment is at its
/// start.
fn gone(fraction: Real, pieces: usize) -> Real {
    let last = 1.0 - 1.0 / pieces as Real;
    if fraction <= last { fraction } else { (fraction + fraction - last).min(1.0) }
}

/// The thickness of the thinnest fast link. For a link without an inside, the distance at which contacts are
/// searched.
fn thickness(context: CcdContext<'_>, links: &[FastMotion]) -> Real {
    let bodies = links.iter().filter_map(|motion| context.bodies.get(motion.body));
    let fast = bodies.filter(|body| body.ccd_active).map(|body| {
        let is_solid = body.thickness > 0.0;
        if is_solid { body.thickness } else { context.params.prediction_distance() }
    });
    fast.fold(Real::MAX, Real::min)
}
