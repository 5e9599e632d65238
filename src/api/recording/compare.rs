//! The first difference of two recordings.

use super::error::RecordingError;
use super::frame::{Frame, read_frame, read_opening};
use crate::step::StepStage;

/// The first difference between two recordings.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Difference {
    /// The worlds differ before the first step.
    Start,
    /// The edits before a step differ: the programs made different calls.
    Edits {
        /// The step, counted from 0.
        step: usize,
    },
    /// The edits are equal, but the worlds differ after a step: the engines computed different bits.
    Step {
        /// The step, counted from 0.
        step: usize,
        /// The first stage after which the hashes differ, if both recordings have them.
        stage: Option<StepStage>,
        /// The first body, counted in the order of handles, whose hash differs. `None` if only a joint, a
        /// pair or a collider differs.
        body: Option<usize>,
    },
    /// One recording has fewer steps. All common steps are equal.
    Length {
        /// Number of steps of the shorter one.
        steps: usize,
    },
}

impl core::fmt::Display for Difference {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Start => write!(f, "the worlds differ before the first step"),
            Self::Edits { step } => write!(f, "the edits in front of step {step} differ"),
            Self::Length { steps } => write!(f, "one recording ends after {steps} steps"),
            Self::Step { step, stage, body } => {
                write!(f, "step {step} has different results after equal edits")?;
                if let Some(stage) = stage {
                    write!(f, "; the first stage that differs is {stage:?}")?;
                }
                match body {
                    Some(body) => write!(f, "; the first body that differs is number {body}"),
                    None => write!(f, "; no body differs, but a joint, a pair or a collider does"),
                }
            }
        }
    }
}

/// The first difference between two [recordings](super::Recorder) of the same run, for example on two
/// machines. `None` if there is none.
///
/// The comparison uses the recorded hashes, without a replay.
///
/// # Errors
/// If one of them is not a recording, or is damaged before the first difference.
///
/// ```
/// # use rapier3d::prelude::*;
/// let record = |impulse: Real| {
///     let mut world = PhysicsWorld::new();
///     let (ball, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
///     let mut recorder = Recorder::new(&world, "")?;
///     for k in 0..5 {
///         if k == 3 {
///             world.bodies[ball].apply_impulse(Vector::X * impulse, true);
///         }
///         recorder.step(&mut world)?;
///     }
///     Ok::<_, RecordingError>(recorder.into_bytes())
/// };
/// assert_eq!(compare_recordings(&record(1.0)?, &record(1.0)?)?, None);
/// assert_eq!(compare_recordings(&record(1.0)?, &record(2.0)?)?, Some(Difference::Edits { step: 3 }));
/// # Ok::<(), RecordingError>(())
/// ```
pub fn compare_recordings(
    first: &[u8],
    second: &[u8],
) -> Result<Option<Difference>, RecordingError> {
    let (opening1, mut frames1) = read_opening(first)?;
    let (opening2, mut frames2) = read_opening(second)?;
    if opening1.snapshot != opening2.snapshot {
        return Ok(Some(Difference::Start));
    }
    let mut step = 0;
    loop {
        if frames1.is_empty() || frames2.is_empty() {
            let are_equal = frames1.is_empty() && frames2.is_empty();
            return Ok((!are_equal).then_some(Difference::Length { steps: step }));
        }
        let (frame1, rest1) = read_frame(frames1, step)?;
        let (frame2, rest2) = read_frame(frames2, step)?;
        if let Some(difference) = compare_frames(step, &frame1, &frame2) {
            return Ok(Some(difference));
        }
        (frames1, frames2) = (rest1, rest2);
        step += 1;
    }
}

fn compare_frames(step: usize, one: &Frame, two: &Frame) -> Option<Difference> {
    if one.edits != two.edits {
        return Some(Difference::Edits { step });
    }
    if one.hash == two.hash {
        return None;
    }
    let mut stages = one.stages.iter().zip(&two.stages);
    let stage = stages.find(|(one, two)| one != two).map(|(one, _)| one.0);
    let body = match one.bodies.len() == two.bodies.len() {
        true => one.bodies.iter().zip(&two.bodies).position(|(one, two)| one != two),
        false => Some(one.bodies.len().min(two.bodies.len())),
    };
    Some(Difference::Step { step, stage, body })
}
