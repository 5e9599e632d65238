//! Multibodies that are new, edited or removed.

use super::UserChanges;
use crate::model::body::RigidBodyHandle;
use crate::model::multibody::MultibodyEdits;

impl UserChanges<'_> {
    /// Makes the bodies of each multibody move and sleep as one, and collide as it is set.
    pub(super) fn apply_multibodies(&mut self) {
        let MultibodyEdits { cut, groups } = core::mem::take(&mut self.multibodies);
        let membership = |changes: &Self, body: RigidBodyHandle| {
            changes.structure.islands.groups.membership(body.into_raw_parts().0)
        };
        let links = groups.iter().flat_map(|(members, _)| members).map(|member| member.body);
        let edited = cut.iter().map(|&(body, _)| body).chain(links);
        let before: Vec<_> = edited.map(|body| (body, membership(self, body))).collect();
        for &(body, _) in &cut {
            self.structure.ungroup(body);
        }
        for (members, wake_up) in groups {
            self.structure.group(&members);
            if wake_up {
                members.iter().for_each(|member| self.structure.wake_body(member.body));
            }
        }
        for (body, wake_up) in cut {
            if wake_up {
                self.structure.wake_body(body);
            }
        }
        // Whether two bodies collide follows from their memberships.
        for (body, before) in before {
            if membership(self, body) != before {
                self.update_partners(body);
            }
        }
    }
}
