//! Theo Jansen's walking linkage: where its joints are.
//!
//! A leg has one crank and eleven bars, and its foot goes straight and slowly while it is on the ground, high and fast while
//! it is not. The lengths are Jansen's "holy numbers" (strandbeest.com), in hundredths of ours.

use crate::rapier::prelude::Real;

/// A point of the plane in which a leg moves.
pub type Point = [Real; 2];

/// From the crank to where the body holds the leg: behind it, and below it.
const PIVOT: Point = [-0.380, -0.078];
/// The crank.
const CRANK: Real = 0.150;
/// From the crank's pin to the upper and the lower knee.
const TO_UPPER: Real = 0.500;
const TO_LOWER: Real = 0.619;
/// From the pivot to these knees, and to the hip, which is held by the upper one.
const UPPER: Real = 0.415;
const LOWER: Real = 0.393;
const HIP: Real = 0.401;
const UPPER_TO_HIP: Real = 0.558;
/// From the hip and from the lower knee to the heel; from heel and lower knee to the foot.
const HIP_TO_HEEL: Real = 0.394;
const LOWER_TO_HEEL: Real = 0.367;
const HEEL_TO_FOOT: Real = 0.657;
const LOWER_TO_FOOT: Real = 0.490;

/// The joints of one leg, seen from the crank.
pub struct Leg {
    /// The crank's pin.
    pub pin: Point,
    /// Where the body holds the leg.
    pub pivot: Point,
    /// Where the pin's upper bar holds the upper triangle.
    pub upper: Point,
    /// Where the pin's lower bar, the pivot's and the foot's triangle meet.
    pub lower: Point,
    /// The upper triangle's third corner.
    pub hip: Point,
    /// Where the hip's bar holds the foot's triangle.
    pub heel: Point,
    /// The foot.
    pub foot: Point,
}

impl Leg {
    /// The leg behind the crank (`side` -1) or before it (1), when the crank is at an angle (rad).
    pub fn new(angle: Real, side: Real) -> Self {
        // A leg before the crank is one behind it, in a mirror.
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

/// The point at these distances from two others, to the right of the way from the first to the second.
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

    /// All bars have their lengths in every position of the crank, and the foot does what it is famous for.
    #[test]
    fn bars_keep_their_lengths_and_feet_go_straight() {
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
        // For about half of a round the foot is within 5 % of its stride from the ground.
        let grounded: Vec<_> = legs.iter().filter(|leg| leg.foot[1] < lowest + 0.03).collect();
        assert!((120..220).contains(&grounded.len()), "{} degrees", grounded.len());
        let reach = |pick: fn(Real, Real) -> Real, start| {
            grounded.iter().map(|leg| leg.foot[0]).fold(start, pick)
        };
        let stride = reach(Real::max, Real::MIN) - reach(Real::min, Real::MAX);
        assert!(stride > 0.5, "a stride of {stride}");
    }
}
