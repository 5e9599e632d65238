//! A generic joint seen as one with a name.

use super::{FixedJoint, PrismaticJoint, RevoluteJoint, RopeJoint};
use crate::dim::joint_axes::JointAxesMask;

/// `as_name` and `as_name_mut` for the joints that lock these axes and couple those.
macro_rules! joint_view {
    ($name:ident, $name_mut:ident, $joint:ident, $locked:expr, $coupled:expr) => {
        impl $crate::model::joint::GenericJoint {
            #[doc = concat!("This joint as a [`", stringify!($joint), "`], if it is one.")]
            pub fn $name(&self) -> Option<&$joint> {
                let same = $crate::model::joint::views::has_axes(self, $locked, $coupled);
                same.then(|| $crate::model::joint::views::Named::named(self))
            }

            #[doc = concat!("This joint as a [`", stringify!($joint), "`], if it is one.")]
            pub fn $name_mut(&mut self) -> Option<&mut $joint> {
                let same = $crate::model::joint::views::has_axes(self, $locked, $coupled);
                same.then(|| $crate::model::joint::views::Named::named_mut(self))
            }
        }
    };
}
pub(crate) use joint_view;

/// Returns whether a joint locks and couples exactly these axes, and is no transmission.
pub(crate) fn has_axes(
    joint: &super::GenericJoint,
    locked: JointAxesMask,
    coupled: JointAxesMask,
) -> bool {
    joint.locked_axes == locked && joint.coupled_axes == coupled && joint.transmission.is_none()
}

/// A named joint: a generic one and nothing else.
///
/// # Safety
/// The type is a transparent wrapper of [`GenericJoint`](super::GenericJoint), and any value of that
/// will do.
pub(crate) unsafe trait Named: Sized {
    /// The generic joint as this one.
    fn named(joint: &super::GenericJoint) -> &Self {
        // SAFETY: the trait's promise: both have one layout.
        unsafe { &*core::ptr::from_ref(joint).cast() }
    }

    /// The generic joint as this one.
    fn named_mut(joint: &mut super::GenericJoint) -> &mut Self {
        // SAFETY: the trait's promise: both have one layout, and take all values of the other.
        unsafe { &mut *core::ptr::from_mut(joint).cast() }
    }
}

joint_view!(
    as_fixed,
    as_fixed_mut,
    FixedJoint,
    JointAxesMask::LOCKED_FIXED_AXES,
    JointAxesMask::empty()
);
joint_view!(
    as_revolute,
    as_revolute_mut,
    RevoluteJoint,
    JointAxesMask::LOCKED_REVOLUTE_AXES,
    JointAxesMask::empty()
);
joint_view!(
    as_prismatic,
    as_prismatic_mut,
    PrismaticJoint,
    JointAxesMask::LOCKED_PRISMATIC_AXES,
    JointAxesMask::empty()
);
joint_view!(as_rope, as_rope_mut, RopeJoint, JointAxesMask::empty(), JointAxesMask::LIN_AXES);
