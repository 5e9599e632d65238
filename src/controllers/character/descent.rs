//! Stepping down.
//!
//! The character follows a floor that ends, to one that begins at most the snapping distance below: a step
//! down. A box leaves the upper floor and is moved down at once. A shape with a round bottom rolls over the
//! edge, and down the riser if that leans back. It touches them with normals that are too steep for a floor,
//! and cannot reach the lower floor before it is clear of them. Therefore edge and riser support like a floor
//! ([`Kind::Step`](super::planes::Kind::Step)). They are recognised by their height: there is a walkable
//! surface above and a floor below, at most the snapping distance apart. Higher slopes and cliffs lack one of
//! the two.

use super::mover::Mover;
use super::planes::{Kind, Plane, WALL_LEAN_MAX};
use super::polyhedron::{HalfSpace, nearest};
use crate::dim::math::{Real, Vector};

/// Largest number of straight parts of a descent.
const PARTS_MAX: usize = 8;
/// Heights at which the upper end of a riser is searched, as fractions of the snapping distance.
const RISER_HEIGHTS: [Real; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

impl Mover<'_> {
    /// Returns whether a steep plane is the edge or the riser of a step down. The floor below is that of
    /// [`Self::floor_below`], computed when it is first needed.
    pub fn is_step_down(
        &mut self,
        index: usize,
        away: Vector,
        floor_below: &mut Option<Option<Real>>,
    ) -> bool {
        if self.settings.snap == 0.0 {
            return false;
        }
        let Some(tread) = self.tread_above(&self.planes[index], away) else { return false };
        let floor = *floor_below.get_or_insert_with(|| self.floor_below());
        let depth_max = self.settings.snap + self.settings.tolerance;
        floor.is_some_and(|floor| tread - floor <= depth_max)
    }

    /// The height of the walkable surface right behind and above a steep plane, at most the snapping distance
    /// above the contact point; `None` if there is none.
    ///
    /// `away` is the horizontal direction of the plane's normal. If the plane is a riser, its upper end is
    /// where a point on the extended riser is above the surface.
    fn tread_above(&self, plane: &Plane, away: Vector) -> Option<Real> {
        let settings = &self.settings;
        let (point, margin) = (plane.points[0], 2.0 * settings.offset);
        let run = plane.rise / plane.normal.dot(away);
        RISER_HEIGHTS.into_iter().find_map(|fraction| {
            let height = settings.snap * fraction + margin;
            let behind = point - away * (run * height + 2.0 * settings.tolerance);
            let origin = behind + settings.up * (height + margin);
            let surface = self.walkable_below(origin, height + 2.0 * margin)?;
            Some(origin.dot(settings.up) - surface.depth)
        })
    }

    /// The height of the floor onto which the shape slides from the present pose; `None` if it is more than
    /// the snapping distance below.
    fn floor_below(&mut self) -> Option<Real> {
        let (before, planes) = (self.moved, self.planes.clone());
        let is_found = self.slide_down();
        let height = self.height_of_feet();
        (self.moved, self.planes) = (before, planes);
        is_found.then_some(height)
    }

    /// Slides down along steep planes, at most by the snapping distance. Returns whether it ends on a floor.
    fn slide_down(&mut self) -> bool {
        let lowest = self.height_of_feet() - self.settings.snap - self.settings.tolerance;
        for _ in 0..PARTS_MAX {
            let straight = -self.settings.up * (self.height_of_feet() - lowest).max(0.0);
            let down = self.past_planes(straight, 1.0);
            let pose = self.pose();
            let swept = self.sweep_from(&pose, down);
            self.moved += down * swept.fraction;
            self.update_planes(self.settings.reach());
            if self.planes.iter().any(|plane| plane.is_firm(&self.settings)) {
                return true;
            }
            if swept.hit.is_none() && down == straight {
                return false;
            }
        }
        false
    }

    /// The height of the surface on which the shape would stand at the present pose.
    fn height_of_feet(&self) -> Real {
        let settings = &self.settings;
        self.pose().translation.dot(settings.up) - settings.foot - settings.offset
    }

    /// The height to which a snap may lower the feet, if edges of steps are the only support: the snapping
    /// distance below the highest one. A shape with a round bottom may have rolled down a part of that.
    pub fn deepest_foothold(&self) -> Option<Real> {
        let supports = || self.planes.iter().filter(|plane| plane.holds(&self.settings));
        let on_edges = supports().all(|plane| plane.kind == Kind::Step);
        let highest = supports().map(|plane| plane.lowest(&self.settings)).reduce(Real::max)?;
        on_edges.then_some(highest - self.settings.snap)
    }

    /// Moves down to a floor that is not far below: at most the snapping distance, and not below `deepest`.
    pub fn snap(&mut self, deepest: Option<Real>) {
        let (before, snap) = (self.moved, self.settings.snap);
        let room = |deepest: Real| self.height_of_feet() - deepest + self.settings.tolerance;
        let mut depth = deepest.map_or(snap, |deepest| room(deepest).clamp(0.0, snap));
        for _ in 0..PARTS_MAX {
            // A shape with a round bottom touches an edge almost upright just before it is clear of the edge.
            let down = self.past_planes(-self.settings.up * depth, WALL_LEAN_MAX);
            let pose = self.pose();
            let swept = self.sweep_from(&pose, down);
            if swept.hit.is_none() {
                break;
            }
            self.moved += down * swept.fraction;
            self.update_planes_for(Vector::ZERO);
            if self.is_supported() {
                return;
            }
            depth *= 1.0 - swept.fraction;
        }
        self.moved = before;
        self.update_planes_for(Vector::ZERO);
    }

    /// The part of a translation down that planes which lean back, but rise at most by this, admit.
    fn past_planes(&self, down: Vector, rise_max: Real) -> Vector {
        let leans = |plane: &&Plane| plane.rise > 0.0 && plane.rise <= rise_max;
        let planes = self.planes.iter().filter(leans);
        let spaces: Vec<HalfSpace> = planes.map(|plane| plane.half_space(&self.settings)).collect();
        nearest(down, &spaces).unwrap_or(Vector::ZERO)
    }
}
