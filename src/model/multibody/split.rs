//! Taking multibodies apart.

use super::record::Dof;
use super::{Multibody, MultibodyDofCoupling, MultibodyJoint, MultibodyLink};
use crate::dim::joint_axes::JointAxesMask;
use crate::model::joint::GenericJoint;

impl Multibody {
    /// Cuts the joints of some links (to their parents). Returns the parts in the order of their roots: the
    /// first has the old root.
    ///
    /// Joints that stay keep their coordinates and velocities, and couplings whose two joints stay in one
    /// part are kept. Roots move on as their bodies did.
    pub(super) fn split(self, is_cut: impl Fn(&MultibodyLink) -> bool) -> Vec<Self> {
        let Self { links, dofs, lists, couplings, .. } = self;
        let mut parts: Vec<Self> = Vec::new();
        // By link: its part, and its position there.
        let mut places: Vec<(usize, usize)> = Vec::with_capacity(links.len());
        let mut kept: Vec<Vec<usize>> = Vec::new();
        for mut link in links {
            let parent = link.parent.filter(|_| !is_cut(&link)).map(|parent| places[parent]);
            let old_dofs = link.dofs();
            let part = match parent {
                Some((part, position)) => {
                    link.parent = Some(position);
                    part
                }
                None => {
                    if link.parent.is_some() {
                        make_root(&mut link);
                    }
                    parts.push(Self {
                        self_contacts_enabled: self.self_contacts_enabled,
                        energy_error: 0.0,
                        ..Self::new()
                    });
                    kept.push(Vec::new());
                    parts.len() - 1
                }
            };
            let target = &mut parts[part];
            link.id = target.links.len();
            places.push((part, link.id));
            if link.free.bits().count_ones() as usize == old_dofs.len() {
                target
                    .dofs
                    .extend(dofs[old_dofs.clone()].iter().map(|dof| Dof { link: link.id, ..*dof }));
                kept[part].extend(old_dofs);
            }
            target.links.push(link);
        }
        for (part, kept) in parts.iter_mut().zip(kept) {
            part.lists = lists.select(&kept);
            part.renumber();
            part.simplify_exclusions();
        }
        for coupling in couplings {
            let [(part, link1), (other, link2)] =
                [coupling.link1, coupling.link2].map(|link| places[link]);
            let links = &parts[part].links;
            if part == other && [link1, link2].iter().all(|&link| links[link].parent.is_some()) {
                let moved = MultibodyDofCoupling { link1, link2, ..coupling };
                parts[part].couplings.push(moved);
            }
        }
        parts
    }
}

/// Disconnects a link from its parent. The next step updates its degrees of freedom.
fn make_root(link: &mut MultibodyLink) {
    link.joint = MultibodyJoint::new(GenericJoint::default(), false);
    (link.parent, link.handle, link.seen_pose, link.seen_velocity) = (None, None, None, None);
    (link.free, link.is_preview) = (JointAxesMask::empty(), false);
}
