//! Solution of a desired translation for the planes around the character.

use super::planes::{Kind, Plane, WALL_LEAN_MAX};
use super::polyhedron::{HalfSpace, nearest};
use super::resolved::ResolvedSettings;
use super::settings::CharacterSlopeSpeed;
use crate::dim::math::{Real, Vector};
use smallvec::SmallVec;

type HalfSpaces = SmallVec<[HalfSpace; 12]>;

/// A translation, and its kind.
#[derive(Copy, Clone, Debug)]
pub(super) struct SolvedMove {
    pub translation: Vector,
    /// Whether the move leads down a slope that is too steep to stand on.
    pub slides: bool,
}

/// Effect of a floor on the horizontal part of a desired translation.
struct Lift<'a> {
    plane: &'a Plane,
    /// Height by which the floor lifts the character.
    height: Real,
}

impl ResolvedSettings {
    /// Converts a desired translation into one that no plane forbids.
    ///
    /// `sticks`: the character is grounded without an upward motion, so it follows floors downwards, too.
    pub fn solved_move(&self, desired: Vector, planes: &[Plane], sticks: bool) -> SolvedMove {
        let (fall, ahead) = self.split(desired);
        let uprights: HalfSpaces = planes
            .iter()
            .filter(|plane| plane.is_upright())
            .filter_map(|plane| plane.upright_half_space(self))
            .collect();
        let free = self.slid(ahead, &uprights);
        // Without sliding along walls, there is no sliding up on them.
        let is_stopped = !self.slide && free != ahead;
        let (ahead, fall) = (free, if is_stopped { fall.min(0.0) } else { fall });
        let (translation, slides) = match self.lift(ahead, planes) {
            Some(lift) => self.on_floor(ahead, fall, &lift, sticks),
            None => (ahead + self.up * fall, false),
        };
        let spaces: HalfSpaces = planes.iter().map(|plane| plane.half_space(self)).collect();
        let solved = self.slid(translation, &spaces);
        // Down a slope that is too steep to stand on, because nothing else is below.
        let is_steep = |p: &Plane| p.kind == Kind::Wall && p.rise > WALL_LEAN_MAX && !p.holds(self);
        let is_down = fall < 0.0 && solved.dot(self.up) < -self.nothing();
        let is_held = planes.iter().any(|plane| plane.holds(self));
        let slides = slides || (is_down && !is_held && planes.iter().any(is_steep));
        SolvedMove { translation: solved, slides }
    }

    /// The nearest admissible translation or, without sliding, its admissible part.
    fn slid(&self, translation: Vector, spaces: &[HalfSpace]) -> Vector {
        if self.slide {
            return nearest(translation, spaces).unwrap_or(Vector::ZERO);
        }
        let mut fraction: Real = 1.0;
        for space in spaces {
            let along = space.normal.dot(translation);
            if along < space.at_least {
                fraction = fraction.min(space.at_least / along);
            }
        }
        translation * fraction.max(0.0)
    }

    /// The floor that lifts the character highest, which satisfies all others, too.
    fn lift<'a>(&self, ahead: Vector, planes: &'a [Plane]) -> Option<Lift<'a>> {
        let floors = planes.iter().filter(|plane| plane.holds(self));
        let lifts = floors.map(|plane| Lift {
            plane,
            height: (plane.approach_limit(self) - ahead.dot(plane.normal)) / plane.rise,
        });
        lifts.max_by(|a, b| a.height.total_cmp(&b.height))
    }

    /// The translation of a character on a floor. Vertically, the floor alone decides. A downward desired
    /// translation has no component along it, or a standing character would creep down slopes.
    fn on_floor(&self, ahead: Vector, fall: Real, lift: &Lift<'_>, sticks: bool) -> (Vector, bool) {
        let plane = lift.plane;
        let is_supported = fall <= lift.height || (sticks && lift.height >= -self.snap);
        if !is_supported {
            return (ahead + self.up * fall, false);
        }
        let walk = self.walk(ahead, lift);
        let slips = plane.is_slippery(self) && fall < 0.0;
        if !slips {
            return (walk, false);
        }
        let down = (self.up - plane.normal * plane.rise) * fall;
        (walk + down, true)
    }

    /// Walking on a floor, at the speed of the settings.
    fn walk(&self, ahead: Vector, lift: &Lift<'_>) -> Vector {
        let plane = lift.plane;
        let speed = match plane.kind {
            Kind::Floor => self.slope_speed,
            // Edges are passed, not walked on.
            _ => CharacterSlopeSpeed::Horizontal,
        };
        let across = ahead.dot(plane.normal);
        let settle = self.up * (plane.approach_limit(self) / plane.rise);
        let climb = ahead - self.up * (across / plane.rise);
        match speed {
            CharacterSlopeSpeed::Horizontal => climb + settle,
            CharacterSlopeSpeed::Projected => ahead - plane.normal * across + settle,
            CharacterSlopeSpeed::Constant => {
                let length = climb.length();
                let fraction = if length > 0.0 { ahead.length() / length } else { 1.0 };
                climb * fraction + settle
            }
        }
    }
}
