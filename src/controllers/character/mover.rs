//! The move: recover, then repeat contacts, solve and sweep until the desired translation is used up.

use super::movement::{CharacterCollision, CharacterGround, EffectiveCharacterMovement};
use super::obstacles::Obstacles;
use super::planes::Plane;
use super::resolved::ResolvedSettings;
use super::sweep::Swept;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::ColliderHandle;

/// Largest number of direction changes of a move.
const TURNS_MAX: usize = 8;
/// Least cosine of equal normals.
const NORMAL_COSINE_MIN: Real = 0.999;

/// A moving character.
pub(super) struct Mover<'a> {
    pub settings: ResolvedSettings,
    pub obstacles: Obstacles<'a>,
    pub start: Pose,
    /// The translation so far. Added to the start only where the pose is needed, so that it is exactly zero
    /// when nothing happens, wherever the start is.
    pub moved: Vector,
    /// The planes around the present pose.
    pub planes: Vec<Plane>,
    /// A buffer.
    pub scratch: Vec<Plane>,
    /// Reported collisions.
    met: Vec<(ColliderHandle, Vector)>,
    events: &'a mut dyn FnMut(CharacterCollision),
}

impl<'a> Mover<'a> {
    pub fn new(
        settings: ResolvedSettings,
        obstacles: Obstacles<'a>,
        start: Pose,
        events: &'a mut dyn FnMut(CharacterCollision),
    ) -> Self {
        Self {
            settings,
            obstacles,
            start,
            moved: Vector::ZERO,
            planes: Vec::new(),
            scratch: Vec::new(),
            met: Vec::new(),
            events,
        }
    }

    pub fn pose(&self) -> Pose {
        Pose::from_parts(self.start.translation + self.moved, self.start.rotation)
    }

    /// Updates the planes around the present pose.
    pub fn update_planes(&mut self, reach: Real) {
        let pose = self.pose();
        self.obstacles.planes(&pose, reach, &self.settings, &mut self.planes);
    }

    pub fn run(&mut self, desired: Vector) -> EffectiveCharacterMovement {
        self.recover();
        self.find_steps(desired);
        let rises = desired.dot(self.settings.up) > self.settings.tolerance;
        let stood = !rises && self.is_supported();
        let slides = self.go(desired, stood);
        let floor = if rises { None } else { self.floor() };
        EffectiveCharacterMovement {
            translation: self.moved,
            grounded: floor.is_some(),
            is_sliding_down_slope: slides,
            ground: floor.map(|floor| self.ground(floor)),
        }
    }

    pub fn is_supported(&self) -> bool {
        self.planes.iter().any(|plane| plane.holds(&self.settings))
    }

    /// Moves along the desired translation. Leaves the planes around the place where it ends. Returns whether
    /// it slid down a slope.
    fn go(&mut self, desired: Vector, stood: bool) -> bool {
        let sticks = stood && self.settings.snap > 0.0;
        let deepest = self.deepest_foothold();
        let (mut left, mut slides, mut turned) = (desired, false, false);
        for _ in 0..TURNS_MAX {
            if stood && let Some(fraction) = self.step_up(left) {
                left *= 1.0 - fraction;
                turned = true;
                self.update_planes_for(left);
                continue;
            }
            let solved = self.settings.solved_move(left, &self.planes, sticks);
            slides |= solved.slides;
            self.report_planes(left);
            let length = solved.translation.length();
            // Between planes beyond the range of squares, there is no finite move.
            if length <= self.settings.nothing() || !length.is_finite() {
                break;
            }
            let pose = self.pose();
            let swept = self.sweep_from(&pose, solved.translation);
            self.moved += solved.translation * swept.fraction;
            turned |= swept.hit.is_some();
            let Some(plane) = swept.hit else {
                self.update_planes_for(Vector::ZERO);
                break;
            };
            left *= 1.0 - swept.fraction;
            self.report(&plane, left);
            self.update_planes_for(left);
            if swept.fraction * solved.translation.length() <= self.settings.tolerance {
                self.add_hit_plane(plane);
            }
        }
        if turned {
            self.recover();
            self.find_steps(Vector::ZERO);
        }
        if sticks && !self.is_supported() {
            self.snap(deepest);
        }
        slides
    }

    pub fn update_planes_for(&mut self, desired: Vector) {
        self.update_planes(self.settings.reach());
        self.find_steps(desired);
    }

    /// Adds the plane of a hit to the planes. If a sweep is stopped by an obstacle that has no plane at the
    /// final pose, the character would repeat the same move.
    fn add_hit_plane(&mut self, plane: Plane) {
        let is_known = |other: &Plane| {
            other.collider == plane.collider && other.normal.dot(plane.normal) > NORMAL_COSINE_MIN
        };
        if !self.planes.iter().any(is_known) {
            self.planes.push(Plane { gap: self.settings.offset, ..plane });
        }
    }

    /// Sweeps the shape from a pose.
    pub fn sweep_from(&mut self, pose: &Pose, translation: Vector) -> Swept {
        // An obstacle that is already closer than the stopping distance must not stop the sweep at its start.
        let gaps = self.planes.iter().map(|plane| plane.gap - self.settings.tolerance);
        let within =
            gaps.fold(self.settings.offset - 2.0 * self.settings.tolerance, Real::min).max(0.0);
        self.obstacles.sweep(pose, translation, within, &self.settings)
    }

    /// The most level plane that supports the character.
    fn floor(&self) -> Option<&Plane> {
        let floors = self.planes.iter().filter(|plane| plane.holds(&self.settings));
        floors.max_by(|a, b| a.rise.total_cmp(&b.rise))
    }

    /// The ground in the user's form.
    fn ground(&self, floor: &Plane) -> CharacterGround {
        let origin = self.pose().translation;
        let height = (origin - floor.points[0]).dot(floor.normal) / floor.rise;
        CharacterGround {
            collider: floor.collider,
            normal: floor.normal,
            point: origin - self.settings.up * height,
        }
    }

    /// Reports the planes that reduce the desired translation.
    fn report_planes(&mut self, desired: Vector) {
        for index in 0..self.planes.len() {
            let plane = &self.planes[index];
            let into = desired.dot(plane.normal);
            if into < -self.settings.nothing() && into < plane.approach_limit(&self.settings) {
                let plane = plane.clone();
                self.report(&plane, desired);
            }
        }
    }

    /// Reports a collision, unless it was reported already.
    fn report(&mut self, plane: &Plane, left: Vector) {
        let is_same = |&(handle, normal): &(_, Vector)| {
            handle == plane.collider && normal.dot(plane.normal) > NORMAL_COSINE_MIN
        };
        let is_gone = self.obstacles.queries.colliders.get(plane.collider).is_none();
        if is_gone || self.met.iter().any(is_same) {
            return;
        }
        self.met.push((plane.collider, plane.normal));
        let character_pos = self.pose();
        (self.events)(CharacterCollision {
            handle: plane.collider,
            character_pos,
            translation_applied: self.moved,
            translation_remaining: left,
            hit: plane.hit(&character_pos),
        });
    }
}
