//! Pace: the lengths of the last steps, to which soft contacts are adapted.
//!
//! Softness is defined per substep, so a longer step has softer contacts, with more overlap under the same
//! load (`../params/softness.rs`). If steps of different lengths alternated, each short step would push out
//! what the long one let in. A box on the ground would rock, and walk by 6 cm in ten seconds at 1/10 and
//! 1/240 s.
//!
//! Contacts of a step that is shorter than those before therefore keep the spring of the longer ones, the
//! *reference*. If no step was as long for [`HOLDING_TIME`], the reference approaches the present length
//! within [`ADAPTATION_TIME`]. A longer step has its own spring at once: in it, a stiffer one would tremble.
//!
//! With the same spring in both, the load needs the same overlap, and impulses in proportion to the steps.
//! Contacts store their impulses for the reference, and start with the present step's share. What a step adds
//! to its share is added as it is. Multiplied as well, the errors of an unfinished iteration, which do not
//! depend on the step, grow: with steps of 1/30 and 1/144 s they kick two stacked boxes apart.

use crate::dim::math::Real;

/// Time after a step for which contacts stay adapted to it (s). It contains two frames at the lowest rates.
///
/// Boxes sink in by 3 mm after a single step of 0.1 s. With a second instead it would be 5 mm.
const HOLDING_TIME: Real = 0.2;

/// Time in which contacts then adapt to shorter steps (s).
const ADAPTATION_TIME: Real = 0.1;

/// The longest reference of shorter steps (s). A program that stalls for a second may make a single step of
/// it. Contacts that were adapted to that would let all bodies sink by half a metre.
const REFERENCE_MAX: Real = 0.1;

/// References within this factor of the step's length become equal to it.
const REFERENCE_RATIO_MIN: Real = 1.01;

/// Lengths of the last steps (s); 0 before the first.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Pace {
    /// The last step.
    step: Real,
    /// The length to which contacts are adapted.
    reference: Real,
    /// Time since a step was that long.
    age: Real,
}

/// The pace of the present step.
#[derive(Copy, Clone, Debug)]
pub(crate) struct StepPace {
    /// Length of the step before (s).
    pub last: Real,
    /// The length of steps to which contacts are adapted, over that of the present step (1 or more).
    pub reference_ratio: Real,
}

impl Pace {
    /// Returns the pace of a step of `step` seconds (more than 0).
    pub fn of(self, step: Real) -> StepPace {
        let last = if self.step > 0.0 { self.step } else { step };
        StepPace { last, reference_ratio: self.after(step).reference / step }
    }

    /// Returns the lengths after a step of `step` seconds.
    pub fn after(self, step: Real) -> Self {
        let (age, longest) = (self.age + step, self.reference.min(REFERENCE_MAX));
        if step >= longest {
            return Self { step, reference: step, age: 0.0 };
        }
        if age <= HOLDING_TIME {
            return Self { step, reference: longest, age };
        }
        let reference = step + (longest - step) / (1.0 + step / ADAPTATION_TIME);
        if reference < REFERENCE_RATIO_MIN * step {
            Self { step, reference: step, age: 0.0 }
        } else {
            Self { step, reference, age: HOLDING_TIME }
        }
    }

    /// Returns whether the numbers are those of steps.
    pub fn is_valid(&self) -> bool {
        let Self { step, reference, age } = *self;
        (0.0..=Real::MAX).contains(&step)
            && (step..=Real::MAX).contains(&reference)
            && (0.0..=HOLDING_TIME).contains(&age)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes a step and returns its pace.
    fn step(pace: &mut Pace, length: Real) -> StepPace {
        let present = pace.of(length);
        *pace = pace.after(length);
        present
    }

    #[test]
    fn equal_steps_are_their_own_reference() {
        let mut pace = Pace::default();
        for _ in 0..5 {
            let StepPace { last, reference_ratio } = step(&mut pace, 0.02);
            assert_eq!([last, reference_ratio], [0.02, 1.0]);
        }
    }

    #[test]
    fn alternating_steps_have_the_reference_of_the_longer_ones() {
        let mut pace = Pace::default();
        for _ in 0..50 {
            assert_eq!(step(&mut pace, 0.03).reference_ratio, 1.0);
            assert_eq!(step(&mut pace, 0.005).reference_ratio, 0.03 / 0.005);
        }
    }

    #[test]
    fn a_stall_is_no_reference() {
        let mut pace = Pace::default();
        step(&mut pace, 0.02);
        assert_eq!(step(&mut pace, 1.0).reference_ratio, 1.0);
        assert_eq!(step(&mut pace, 0.02).reference_ratio, REFERENCE_MAX / 0.02);
        assert_eq!(step(&mut pace, 0.5).reference_ratio, 1.0);
    }

    #[test]
    fn the_reference_reaches_shorter_steps() {
        let mut pace = Pace::default();
        step(&mut pace, 0.1);
        let after: Vec<_> = (0..200).map(|_| step(&mut pace, 0.005).reference_ratio).collect();
        assert!(after.is_sorted_by(|a, b| a >= b), "{after:?}");
        assert!(after[100] < 2.0, "after 0.5 s: {}", after[100]);
        assert_eq!(after[199], 1.0);
    }
}
