//! Stepping up.
//!
//! An obstacle is a step if the raised character can continue far enough, and would stand on a floor there. A
//! shape with a round bottom does not reach the top of the step at once. It rests on the edge for a while,
//! with a steep normal. An edge of a step therefore supports like a floor ([`Kind::Step`]), and every move
//! into it ends where the shape rests on it. A capsule rolls over the edge, a box is placed on top.

use super::mover::Mover;
use super::obstacles::Surface;
use super::planes::{Kind, Plane, WALL_LEAN_MAX};
use super::polyhedron::nearest;
use super::resolved::StepUp;
use crate::dim::math::{Pose, Real, Vector};

impl Mover<'_> {
    /// Finds the walls that are steps for a desired translation.
    ///
    /// Only walls that the desired translation leads into matter, or walls that are the only support.
    pub fn find_steps(&mut self, desired: Vector) {
        let (_, ahead) = self.settings.split(desired);
        let on_floor = self.planes.iter().any(|plane| plane.holds(&self.settings));
        let mut floor_below = None;
        for index in 0..self.planes.len() {
            let plane = &self.planes[index];
            let blocks = on_floor && ahead.dot(plane.normal) < -self.settings.nothing();
            let may_support = !on_floor && plane.rise > WALL_LEAN_MAX;
            let (_, across) = self.settings.split(plane.normal);
            let away = across.normalize_or_zero();
            if plane.kind != Kind::Wall || away == Vector::ZERO || !(blocks || may_support) {
                continue;
            }
            let is_step = self.is_step_up(index, -away)
                || (may_support && self.is_step_down(index, away, &mut floor_below));
            if is_step {
                self.planes[index].kind = Kind::Step;
            }
        }
    }

    /// Returns whether a wall is the edge of a step that the character climbs in this direction.
    fn is_step_up(&mut self, index: usize, direction: Vector) -> bool {
        let Some(step_up) = self.settings.step_up else { return false };
        let plane = &self.planes[index];
        let edge = plane.points[0];
        self.is_low(plane, step_up) && self.has_room(direction, edge, step_up)
    }

    /// Returns whether the obstacle could be a step, by its contact alone.
    fn is_low(&self, plane: &Plane, step_up: StepUp) -> bool {
        let foot = self.pose().translation.dot(self.settings.up) - self.settings.foot;
        (step_up.include_dynamic_bodies || !plane.is_dynamic)
            && plane.lowest(&self.settings) < foot + step_up.max_height
    }

    /// Returns whether there is a floor one step up behind this point of the wall, and enough room on the
    /// path.
    fn has_room(&mut self, direction: Vector, edge: Vector, step_up: StepUp) -> bool {
        let raised = self.raised(step_up);
        // Far enough for the middle of the shape to be above the step, where its normal is that of the top.
        let middle = self.settings.half_width + 2.0 * self.settings.offset;
        let far = middle.max(step_up.min_width);
        let swept = self.sweep_from(&raised, direction * far);
        let free = swept.fraction * far;
        if free + self.settings.tolerance < step_up.min_width || free <= self.settings.offset {
            return false;
        }
        let ahead = shifted(&raised, direction * free);
        self.lands_on_floor(&ahead, step_up) || self.has_tread(direction, edge, step_up)
    }

    /// Returns whether the shape stands on a floor when it is lowered from a pose.
    fn lands_on_floor(&mut self, raised: &Pose, step_up: StepUp) -> bool {
        let Some(landing) = self.lowered(raised) else { return false };
        let mut planes = core::mem::take(&mut self.scratch);
        let reach = self.settings.reach();
        self.obstacles.planes(&landing, reach, &self.settings, &mut planes);
        let holds = |plane: &Plane| {
            plane.is_firm(&self.settings) && (step_up.include_dynamic_bodies || !plane.is_dynamic)
        };
        let found = planes.iter().any(holds);
        self.scratch = planes;
        found
    }

    /// Returns whether there is a level or gently sloped surface right behind an edge. On narrow stairs a
    /// shape is too wide for one step: it rests on the edge of the next.
    fn has_tread(&self, direction: Vector, edge: Vector, step_up: StepUp) -> bool {
        let settings = &self.settings;
        let foot = self.pose().translation.dot(settings.up) - settings.foot;
        let height = step_up.max_height + settings.offset;
        let behind = edge + direction * (2.0 * settings.offset);
        let origin = behind + settings.up * (foot + height - behind.dot(settings.up));
        let found = self.walkable_below(origin, height + settings.offset);
        found.is_some_and(|surface| step_up.include_dynamic_bodies || !surface.is_dynamic)
    }

    /// The surface below a point, no deeper than `depth`, if it is level or gently sloped.
    pub fn walkable_below(&self, point: Vector, depth: Real) -> Option<Surface> {
        let settings = &self.settings;
        let surface = self.obstacles.surface_below(point, settings.up, depth)?;
        let rise = surface.normal.dot(settings.up);
        (rise >= settings.climb_cos.max(settings.slide_cos)).then_some(surface)
    }

    /// Takes the step in the path of the desired translation, if there is one. Returns the fraction of the
    /// desired translation that this took.
    pub fn step_up(&mut self, desired: Vector) -> Option<Real> {
        let step_up = self.settings.step_up?;
        let (_, ahead) = self.settings.split(desired);
        let is_in_the_way = |plane: &Plane| ahead.dot(plane.normal) < -self.settings.nothing();
        if !self.planes.iter().any(|plane| plane.kind == Kind::Step && is_in_the_way(plane)) {
            return None;
        }
        let walls = self.planes.iter().filter(|plane| plane.kind == Kind::Wall);
        let walls: Vec<_> =
            walls.filter_map(|plane| plane.upright_half_space(&self.settings)).collect();
        let ahead = nearest(ahead, &walls)?;
        if ahead.length() <= self.settings.nothing() {
            return None;
        }
        let raised = self.raised(step_up);
        // A flat bottom that is not over the step yet comes down before it. A slow character must reach the
        // step, too, so it is moved ahead by the gap to the step.
        let past_the_gap = ahead + ahead.normalize_or_zero() * (2.0 * self.settings.offset);
        let least = self.moved.dot(self.settings.up) + self.settings.tolerance;
        for ahead in [ahead, past_the_gap] {
            let fraction = self.sweep_from(&raised, ahead).fraction;
            if fraction * ahead.length() <= self.settings.nothing() {
                return None;
            }
            let landing = self.lowered(&shifted(&raised, ahead * fraction))?;
            let moved = landing.translation - self.start.translation;
            if moved.dot(self.settings.up) > least {
                self.moved = moved;
                return Some(fraction);
            }
        }
        None
    }

    /// The pose one step up, or as far up as possible.
    fn raised(&mut self, step_up: StepUp) -> Pose {
        let (pose, displacement) = (self.pose(), self.settings.up * step_up.max_height);
        let fraction = self.sweep_from(&pose, displacement).fraction;
        shifted(&pose, displacement * fraction)
    }

    /// The final pose of a shape that is lowered from a pose, not below the character's current height.
    fn lowered(&mut self, pose: &Pose) -> Option<Pose> {
        let height = (pose.translation - self.pose().translation).dot(self.settings.up);
        let displacement = -self.settings.up * (height + self.settings.offset);
        let swept = self.sweep_from(pose, displacement);
        swept.hit.is_some().then(|| shifted(pose, displacement * swept.fraction))
    }
}

fn shifted(pose: &Pose, by: Vector) -> Pose {
    Pose::from_parts(pose.translation + by, pose.rotation)
}
