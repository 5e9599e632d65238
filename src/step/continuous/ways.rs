//! The ways of links of multibodies.
//!
//! A link goes where the coordinates of its joints lead it: on an arc, if it is the end of a swinging arm. So its path is one of
//! many legs, each straight enough that the link cannot hide in the bend: the way of the whole multibody, walked in pieces
//! (`src/multibody/course.rs`). Where one link is stopped, all coordinates go back to that share of the way, so the joints hold.
//!
//! What a kinematic root carries along it carries through walls, as a kinematic body passes them.

use super::Surroundings;
use crate::collide::Leg;
use crate::dim::math::{AngVector, Real, Vector, rotation_to_angle};
use crate::model::body::RigidBodySet;
use crate::model::multibody::{Course, Multibody, MultibodyJointSet};
use crate::multibody::Station;
use crate::step::notes::FastMotion;
use core::ops::Range;

/// How far a link may be off its leg, as a share of the thickness of the thinnest fast link: less than what the search leaves between a
/// core and what it hits, or the link could be put back with its middle inside.
const DEVIATION: Real = 0.01;

/// The legs of all links of multibodies that are fast.
#[derive(Default)]
pub(super) struct Ways {
    legs: Vec<Leg>,
    of_tree: Vec<Tree>,
}

/// Where a multibody stands in the lists.
struct Tree {
    /// Its legs begin here, link by link.
    legs: usize,
    /// Each link has one more than this many.
    pieces: usize,
    /// Its links among the fast bodies.
    links: Range<usize>,
}

impl Ways {
    /// Walks the ways of all fast multibodies.
    pub fn find(&mut self, world: Surroundings<'_>) {
        self.legs.clear();
        self.of_tree.clear();
        let mut next = 0;
        for (tree, course) in world.courses.iter().enumerate() {
            let is_own = |motion: &&FastMotion| motion.link.is_some_and(|link| link.0 == tree);
            let links = &world.fast[next..];
            let before = links.iter().take_while(|motion| !is_own(motion)).count();
            let count = links[before..].iter().take_while(is_own).count();
            let links = next + before..next + before + count;
            next = links.end;
            let pieces = course.pieces(DEVIATION * thickness(world, &world.fast[links.clone()]));
            self.of_tree.push(Tree { legs: self.legs.len(), pieces, links });
            if let Some(multibody) = world.multibodies.get_multibody(course.index) {
                self.walk(world, course, multibody, pieces);
            }
        }
    }

    /// The legs of a link of a multibody; none if it is not there.
    pub fn of(&self, (tree, link): (usize, usize)) -> &[Leg] {
        let Tree { legs, pieces, .. } = self.of_tree[tree];
        let (start, count) = (legs + link * (pieces + 1), pieces + 1);
        self.legs.get(start..start + count).unwrap_or_default()
    }

    /// Puts multibodies back to where they were stopped.
    pub fn stop(
        &self,
        bodies: &mut RigidBodySet,
        multibodies: &mut MultibodyJointSet,
        (fast, courses): (&[FastMotion], &[Course]),
        stops: &[Real],
        dt: Real,
    ) {
        if stops.is_empty() {
            return;
        }
        for (tree, course) in self.of_tree.iter().zip(courses) {
            let links = &fast[tree.links.clone()];
            let share = stops[tree.links.clone()].first().copied().unwrap_or(1.0);
            let multibody = multibodies.get_unnoted_mut(course.index);
            let Some(multibody) = multibody.filter(|_| share < 1.0) else { continue };
            let acceleration = |id| {
                let motion =
                    links.iter().find(|motion| motion.link.is_some_and(|link| link.1 == id));
                motion.map(|motion| motion.acceleration).unwrap_or_default()
            };
            let share = gone(share, tree.pieces);
            course.go_back(multibody, bodies, (share, tree.pieces, dt), acceleration);
        }
    }

    fn walk(
        &mut self,
        world: Surroundings<'_>,
        course: &Course,
        multibody: &Multibody,
        pieces: usize,
    ) {
        let start = self.legs.len();
        let count = pieces + 1;
        let mut last: Vec<Station> = Vec::new();
        course.walk(multibody, pieces, |at, stations| {
            if at == 0 {
                self.legs.resize(start + stations.len() * count, Leg::AT_REST);
            }
            for (link, (from, to)) in last.iter().zip(stations).enumerate() {
                let turn = (from.angular + to.angular) * (0.5 / pieces as Real);
                self.legs[start + link * count + at - 1] =
                    leg(at - 1, pieces, from, to.center, turn);
            }
            last.clear();
            last.extend_from_slice(stations);
        });
        for (id, (link, from)) in multibody.links.iter().zip(&last).enumerate() {
            let Some(body) = world.bodies.get(link.body) else { continue };
            let turn = rotation_to_angle(&(body.pose.rotation * from.rotation.inverse()));
            let to = body.mprops.world_com;
            self.legs[start + id * count + pieces] = leg(pieces, pieces, from, to, turn);
        }
    }
}

/// The leg number `at` of a way in so many pieces, and one more: to where the solver has put the link. Where it turned about one axis
/// after the other that is not quite where the way leads. The last two take half as long as the others.
fn leg(at: usize, pieces: usize, from: &Station, to: Vector, turn: AngVector) -> Leg {
    let time = |at: usize| match at {
        at if at < pieces => at as Real / pieces as Real,
        at if at == pieces => 1.0 - 0.5 / pieces as Real,
        _ => 1.0,
    };
    let (begin, end) = (time(at), time(at + 1));
    let pace = 1.0 / (end - begin);
    let (shift, turn) = ((to - from.center) * pace, turn * pace);
    Leg { from: begin, until: end, rotation: from.rotation, center: from.center, shift, turn }
}

/// What share of a way in so many pieces has been gone after a share of the step. Who was stopped on the last leg is where that begins.
fn gone(share: Real, pieces: usize) -> Real {
    let last = 1.0 - 1.0 / pieces as Real;
    if share <= last { share } else { (share + share - last).min(1.0) }
}

/// The thickness of the thinnest of these links that is fast; of one without an inside, how near contacts are looked for.
fn thickness(world: Surroundings<'_>, links: &[FastMotion]) -> Real {
    let bodies = links.iter().filter_map(|motion| world.bodies.get(motion.body));
    let fast = bodies.filter(|body| body.ccd_active).map(|body| {
        let is_solid = body.thickness > 0.0;
        if is_solid { body.thickness } else { world.params.prediction_distance() }
    });
    fast.fold(Real::MAX, Real::min)
}
