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
    /// By multibody: where its legs begin, link by link, and how many each link has.
    of_tree: Vec<(usize, usize)>,
}

impl Ways {
    /// Walks the ways of all fast multibodies.
    pub fn find(&mut self, world: Surroundings<'_>) {
        self.legs.clear();
        self.of_tree.clear();
        for (tree, course) in world.courses.iter().enumerate() {
            let pieces = course.pieces(DEVIATION * thickness(world, tree));
            self.of_tree.push((self.legs.len(), pieces));
            if let Some(multibody) = world.multibodies.get_multibody(course.index) {
                self.walk(course, multibody, pieces);
            }
        }
    }

    /// The legs of a link of a multibody; none if it is not there.
    pub fn of(&self, (tree, link): (usize, usize)) -> &[Leg] {
        let (start, pieces) = self.of_tree[tree];
        let range: Range<usize> = start + link * pieces..start + (link + 1) * pieces;
        self.legs.get(range).unwrap_or_default()
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
        for (tree, course) in courses.iter().enumerate() {
            let of_tree = |motion: &FastMotion| motion.link.is_some_and(|(other, _)| other == tree);
            let Some(first) = fast.iter().position(of_tree) else { continue };
            let share = stops.get(first).copied().unwrap_or(1.0);
            let multibody = multibodies.get_unnoted_mut(course.index);
            let Some(multibody) = multibody.filter(|_| share < 1.0) else { continue };
            let links: Vec<_> = fast[first..].iter().take_while(|motion| of_tree(motion)).collect();
            let acceleration = |id| {
                let motion = links.iter().find(|motion| motion.link == Some((tree, id)));
                motion.map(|motion| motion.acceleration).unwrap_or_default()
            };
            let (_, pieces) = self.of_tree[tree];
            course.go_back(multibody, bodies, (share, pieces, dt), acceleration);
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

/// The thickness of the thinnest solid link that is fast.
fn thickness(world: Surroundings<'_>, tree: usize) -> Real {
    let links = world.fast.iter().filter(|motion| motion.link.is_some_and(|link| link.0 == tree));
    let bodies = links.filter_map(|motion| world.bodies.get(motion.body));
    let fast = bodies.filter(|body| body.ccd_active).map(|body| {
        let is_solid = body.thickness > 0.0;
        if is_solid { body.thickness } else { world.params.prediction_distance() }
    });
    fast.fold(Real::MAX, Real::min)
}
