//! Intersection tests of pairs with a sensor.

use super::update::{Outcome, Update, Worker};
use super::view::PairView;
use crate::collide::shapes_intersect;
use crate::model::collider::ActiveHooks;
use crate::model::contact::{IntersectionPair, PairId, SLACK_DUE};
use crate::step::notes::PairChange;

impl Update for IntersectionPair {
    fn update(&mut self, _: PairId, view: &PairView<'_>, _: Outcome, _: &mut Worker) -> Outcome {
        if !view.boxes_overlap() {
            return Outcome::APART;
        }
        let [c1, c2] = view.colliders;
        let is_selected = !view.has_hooks(ActiveHooks::FILTER_INTERSECTION_PAIR) || {
            let context = view.filter_context([self.collider1, self.collider2]);
            view.context.hooks.filter_intersection_pair(&context)
        };
        self.intersecting = is_selected && shapes_intersect(&view.pose12, c1.shape(), c2.shape());
        // Any motion may begin or end an intersection; without motion nothing can.
        let filtered = view.has_hooks(ActiveHooks::FILTER_INTERSECTION_PAIR);
        Outcome {
            change: Some(PairChange::Computed),
            slack: if filtered { SLACK_DUE } else { 0.0 },
            reports_force: false,
            is_renewed: false,
            non_dynamic_side: None,
        }
    }
}
