//! Sensors that are passed within one step.
//!
//! The narrow phase finds intersections at the poses when a step begins. A body before a sensor at the start
//! and behind it at the end was inside meanwhile. The stage emits both events that a slower body would cause,
//! in sequence.
//!
//! The search covers fast bodies that cross a sensor, and fast bodies that carry a sensor past something. The
//! other one is fixed, kinematic, or a dynamic body that is not fast; dynamic ones count if one of the two
//! has `ccd_enabled`.

use super::Search;
use super::path::{Mover, Path};
use crate::collide::passes;
use crate::dim::math::Real;
use crate::model::body::RigidBody;
use crate::model::collider::{ActiveEvents, ActiveHooks, Collider, ColliderHandle, may_interact};
use crate::model::event::{CollisionEvent, CollisionEventFlags};
use crate::model::tree::TreeKind;

/// A sensor was passed.
#[derive(Copy, Clone, Debug)]
pub(super) struct SensorCrossing {
    colliders: [ColliderHandle; 2],
}

impl SensorCrossing {
    /// The events of the crossing.
    pub fn events(self) -> [CollisionEvent; 2] {
        let ([collider1, collider2], flags) = (self.colliders, CollisionEventFlags::SENSOR);
        [
            CollisionEvent::Started(collider1, collider2, flags),
            CollisionEvent::Stopped(collider1, collider2, flags),
        ]
    }
}

/// The sensors on the path of a fast body, up to a fraction of the step.
pub(super) fn crossings(search: Search<'_>, path: &Path<'_>, stop: Real) -> Vec<SensorCrossing> {
    let mut found = Vec::new();
    for mover in &path.movers {
        let region = mover.sweep.region(mover.collider.shape());
        for kind in TreeKind::ALL {
            search.context.trees.for_each_overlapping(kind, &region, |slot| {
                let Some((handle, collider)) = search.context.colliders.at_slot(slot) else {
                    return;
                };
                if !is_reported(mover.collider, collider) {
                    return;
                }
                // Bodies that are inside already were reported. At the edge of a shape this search and that
                // of the narrow phase may differ.
                let known = search.context.narrow_phase;
                if known.intersection_pair(mover.handle, handle) == Some(true) {
                    return;
                }
                let Some(other) = Mover::not_fast(search, handle, collider) else { return };
                if may_pass(search, path.body, mover, &other) && mover.passes(&other, search, stop)
                {
                    found.push(SensorCrossing {
                        colliders: mover.in_order(&other).map(|m| m.handle),
                    });
                }
            });
        }
    }
    // The order of the trees depends on the history of the world.
    found.sort_unstable_by_key(|crossing| crossing.colliders.map(ColliderHandle::into_raw_parts));
    found
}

/// Returns whether one of the two is a sensor and events are enabled.
fn is_reported(collider1: &Collider, collider2: &Collider) -> bool {
    let events = collider1.active_events() | collider2.active_events();
    (collider1.is_sensor() || collider2.is_sensor())
        && events.contains(ActiveEvents::COLLISION_EVENTS)
}

/// Returns whether the filters let the two intersect.
fn may_pass(search: Search<'_>, body: &RigidBody, mover: &Mover<'_>, other: &Mover<'_>) -> bool {
    let parent = other.collider.parent().and_then(|parent| search.context.bodies.get(parent));
    let dynamic = parent.filter(|parent| parent.is_dynamic());
    let counts = dynamic.is_none_or(|other| body.ccd_enabled || other.ccd_enabled);
    let hooks = mover.collider.active_hooks() | other.collider.active_hooks();
    counts
        && may_interact(mover.collider, other.collider)
        && (!hooks.contains(ActiveHooks::FILTER_INTERSECTION_PAIR)
            || search.context.hooks.filter_intersection_pair(&mover.filter_context(other, search)))
}

impl Mover<'_> {
    /// Returns whether the collider passes another one before the `stop`.
    fn passes(&self, other: &Mover<'_>, search: Search<'_>, stop: Real) -> bool {
        let shapes = [self.collider.shape(), other.collider.shape()];
        let tolerance = search.gap_min();
        passes(shapes, [&self.sweep, &other.sweep], stop, tolerance)
    }
}
