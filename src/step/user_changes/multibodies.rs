//! Multibodies that are new, edited or removed.

use super::UserChanges;
use crate::model::multibody::MultibodyEdits;

impl UserChanges<'_> {
    /// Makes the bodies of each multibody move and sleep as one.
    pub(super) fn apply_multibodies(&mut self) {
        let MultibodyEdits { cut, groups } = core::mem::take(&mut self.multibodies);
        for &(body, _) in &cut {
            self.structure.ungroup(body);
        }
        for (bodies, wake_up) in groups {
            let members = bodies.clone();
            self.structure.group(bodies);
            if wake_up {
                members.into_iter().for_each(|body| self.structure.wake_body(body));
            }
        }
        for (body, wake_up) in cut {
            if wake_up {
                self.structure.wake_body(body);
            }
        }
    }
}
