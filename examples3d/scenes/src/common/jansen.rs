//! Geometry of Theo Jansen's walking linkage.
//!
//! A leg has one crank and eleven bars. Its foot moves straight and slowly on the ground, high and fast above
//! it. The lengths are Jansen's "holy numbers" (strandbeest.com), in hundredths of the unit here.

use crate::rapier::prelude::Real;

/// A point of the plane in which a leg moves.
pub type Point = [Real; 2];

/// Position of the leg's pivot on the body, relative to the crank: behind and below it.
const PIVOT: Point = [-0.380, -0.078];
/// Length of the crank.
const CRANK: Real = 0.150;
/// Bars from the crank's pin to the upper and the lower knee.
const TO_UPPER: Real = 0.500;
const TO_LOWER: Real = 0.619;
/// Bars from the pivot to these knees and to the hip, and from the upper knee to the hip.
const UPPER: Real = 0.415;
const LOWER: Real = 0.393;
const HIP: Real = 0.401;
const UPPER_TO_HIP: Real = 0.558;
/// Bars from the hip and the lower knee to the heel, and from heel and lower knee to the foot.
const HIP_TO_HEEL: Real = 0.394;
const LOWER_TO_HEEL: Real = 0.367;
const HEEL_TO_FOOT: Real = 0.657;
const LOWER_TO_FOOT: Real = 0.490;

/// Joints of one leg, relative to the crank.
pub struct Leg {
    /// The crank's pin.
    pub pin: Point,
    /// Pivot of the leg on the body.
    pub pivot: Point,
    /// Joint of the pin's upper bar and the upper triangle.
    pub upper: Point,
    /// Joint of the pin's lower bar, the pivot's bar and the foot's triangle.
    pub lower: Point,
    /// Third corner of the upper triangle.
    pub hip: Point,
    /// Joint of the hip's bar and the foot's triangle.
    pub heel: Point,
    /// The foot.
    pub foot: Point,
}

impl Leg {
    /// Returns the leg behind the crank (`side` -1) or in front of it (1), for an angle of the crank (rad).
    pub fn new(angle: Real, side: Real) -> Self {
        // A leg in front of the crank is the mirror image of one behind it.
        let mirror = |[x, y]: Point| [-side * x, y];
        let pin = mirror([CRANK * angle.cos(), CRANK * angle.sin()]);
        let upper = meet(pin, TO_UPPER, PIVOT, UPPER);
        let lower = meet(PIVOT, LOWER, pin, TO_LOWER);
        let hip = meet(upper, UPPER_TO_HIP, PIVOT, HIP);
        let heel = meet(hip, HIP_TO_HEEL, lower, LOWER_TO_HEEL);
        let foot = meet(heel, HEEL_TO_FOOT, lower, LOWER_TO_FOOT);
        let [pin, pivot, upper, lower, hip, heel, foot] =
            [pin, PIVOT, upper, lower, hip, heel, foot].map(mirror);
        Self { pin, pivot, upper, lower, hip, heel, foot }
    }
}

/// Returns the point at these distances from two others, to the right of the direction from the first to the
/// second.
fn meet(a: Point, from_a: Real, b: Point, from_b: Real) -> Point {
    let way = [b[0] - a[0], b[1] - a[1]];
    let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
    let along = (length * length + from_a * from_a - from_b * from_b) / (2.0 * length);
    let aside = (from_a * from_a - along * along).max(0.0).sqrt();
    let unit = way.map(|c| c / length);
    [a[0] + unit[0] * along + unit[1] * aside, a[1] + unit[1] * along - unit[0] * aside]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distance(a: Point, b: Point) -> Real {
        ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt()
    }

    /// All bars keep their lengths at every angle of the crank, and the foot moves straight near the ground.
    #[test]
    fn bars_keep_their_lengths_and_feet_move_straight() {
        let legs: Vec<Leg> = (0..360).map(|k| Leg::new((k as Real).to_radians(), -1.0)).collect();
        for leg in &legs {
            for (a, b, length) in [
                (leg.pin, leg.upper, TO_UPPER),
                (leg.pin, leg.lower, TO_LOWER),
                (leg.pivot, leg.upper, UPPER),
                (leg.pivot, leg.lower, LOWER),
                (leg.pivot, leg.hip, HIP),
                (leg.upper, leg.hip, UPPER_TO_HIP),
                (leg.hip, leg.heel, HIP_TO_HEEL),
                (leg.lower, leg.heel, LOWER_TO_HEEL),
                (leg.heel, leg.foot, HEEL_TO_FOOT),
                (leg.lower, leg.foot, LOWER_TO_FOOT),
            ] {
                assert!((distance(a, b) - length).abs() < 1.0e-5);
            }
        }
        let lowest = legs.iter().map(|leg| leg.foot[1]).fold(Real::MAX, Real::min);
        // For about half a revolution the foot is within 5 % of its stride from the ground.
        let grounded: Vec<_> = legs.iter().filter(|leg| leg.foot[1] < lowest + 0.03).collect();
        assert!((120..220).contains(&grounded.len()), "{} degrees", grounded.len());
        let reach = |pick: fn(Real, Real) -> Real, start| {
            grounded.iter().map(|leg| leg.foot[0]).fold(start, pick)
        };
        let stride = reach(Real::max, Real::MIN) - reach(Real::min, Real::MAX);
        assert!(stride > 0.5, "a stride of {stride}");
    }
}
