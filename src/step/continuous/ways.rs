//! The ways of links of multibodies.
//!
//! A link goes where the coordinates of its joints lead it: on an arc, if it is the end of a swinging arm. So its path is one of
//! many legs, each straight enough that the link cannot hide in the bend: the way of the whole multibody, walked in pieces
//! (`src/multibody/course.rs`). Where one link is stopped, all coordinates go back to that share of the way, so the joints hold.
//!
//! What a kinematic root carries along it carries through walls, as a kinematic body passes them.

use super::Surroundings;
use crate::collide::Leg;
use crate::dim::math::Real;
use crate::model::body::RigidBodySet;
use crate::model::multibody::{Course, Multibody, MultibodyJointSet};
use crate::multibody::Station;
use crate::step::notes::FastMotion;
use core::ops::Range;

/// How far a link may be off its leg, as a share of the thickness of the thinnest fast link.
const DEVIATION: Real = 0.1;

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
    /// So many of them each link has.
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
                self.walk(course, multibody, pieces);
            }
        }
    }

    /// The legs of a link of a multibody; none if it is not there.
    pub fn of(&self, (tree, link): (usize, usize)) -> &[Leg] {
        let Tree { legs, pieces, .. } = self.of_tree[tree];
        let start = legs + link * pieces;
        self.legs.get(start..start + pieces).unwrap_or_default()
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
            course.go_back(multibody, bodies, (share, tree.pieces, dt), acceleration);
        }
    }

    fn walk(&mut self, course: &Course, multibody: &Multibody, pieces: usize) {
        let start = self.legs.len();
        let piece = 1.0 / pieces as Real;
        let mut last: Vec<Station> = Vec::new();
        course.walk(multibody, pieces, |at, stations| {
            for (link, (from, to)) in last.iter().zip(stations).enumerate() {
                let until = if at == pieces { 1.0 } else { at as Real * piece };
                let leg = Leg {
                    from: (at - 1) as Real * piece,
                    until,
                    rotation: from.rotation,
                    center: from.center,
                    shift: (to.center - from.center) * pieces as Real,
                    turn: (from.angular + to.angular) * 0.5,
                };
                self.legs[start + link * pieces + at - 1] = leg;
            }
            if at == 0 {
                self.legs.resize(start + stations.len() * pieces, Leg::AT_REST);
            }
            last.clear();
            last.extend_from_slice(stations);
        });
    }
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
