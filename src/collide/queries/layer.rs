//! Entry of a moving point into a layer around a shape.

use super::rounded::enter_capsule;
use crate::dim::math::{Real, Vector};

/// Whether a moving point meets a layer around a shape.
#[derive(Copy, Clone, Debug)]
pub(super) enum Meeting {
    /// The point does not meet the layer.
    Never,
    /// The point meets the layer from outside or at once.
    At(Touch),
    /// The start has no unique nearest normal, or there is no formula.
    Unclear,
}

/// The entry of a moving point into a layer, in the frame of the shape.
#[derive(Copy, Clone, Debug)]
pub(super) struct Touch {
    /// The time of the entry (units of the velocity): zero if the point starts there.
    pub time: Real,
    /// The outward normal there.
    pub normal: Vector,
    /// The nearest point of the layer's core.
    pub core: Vector,
}

impl Touch {
    /// A touch at a place that is nearest to a point of the core.
    pub fn around(place: Vector, core: Vector, time: Real) -> Meeting {
        match (place - core).try_normalize() {
            Some(normal) => Meeting::At(Self { time, normal, core }),
            None => Meeting::Unclear,
        }
    }

    /// A touch of a point that begins where it is.
    pub fn at_once(normal: Vector, core: Vector) -> Meeting {
        Meeting::At(Self { time: 0.0, normal, core })
    }
}

/// The first of the capsules around some segments that a point meets from outside of all.
pub(super) fn enter_first(
    origin: Vector,
    dir: Vector,
    radius: Real,
    segments: impl Iterator<Item = [Vector; 2]>,
) -> Meeting {
    let mut first: Option<(Real, Vector)> = None;
    for ends in segments {
        if let Some((time, core)) = enter_capsule(origin, dir, ends, radius)
            && time >= 0.0
            && first.is_none_or(|(earliest, _)| time < earliest)
        {
            first = Some((time, core));
        }
    }
    first.map_or(Meeting::Never, |(time, core)| Touch::around(origin + dir * time, core, time))
}
