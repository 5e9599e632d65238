//! Collision groups: filters of the pairs of colliders.
//!
//! Every collider is a member of some of 32 groups, and has a filter of groups. Two colliders are compared
//! twice with different settings: the *collision groups* decide whether contacts are computed, the *solver
//! groups* whether computed contacts exert forces.

bitflags::bitflags! {
    /// A set of up to 32 groups.
    #[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    pub struct Group: u32 {
        /// Group 1.
        const GROUP_1 = 1 << 0;
        /// Group 2.
        const GROUP_2 = 1 << 1;
        /// Group 3.
        const GROUP_3 = 1 << 2;
        /// Group 4.
        const GROUP_4 = 1 << 3;
        /// Group 5.
        const GROUP_5 = 1 << 4;
        /// Group 6.
        const GROUP_6 = 1 << 5;
        /// Group 7.
        const GROUP_7 = 1 << 6;
        /// Group 8.
        const GROUP_8 = 1 << 7;
        /// Group 9.
        const GROUP_9 = 1 << 8;
        /// Group 10.
        const GROUP_10 = 1 << 9;
        /// Group 11.
        const GROUP_11 = 1 << 10;
        /// Group 12.
        const GROUP_12 = 1 << 11;
        /// Group 13.
        const GROUP_13 = 1 << 12;
        /// Group 14.
        const GROUP_14 = 1 << 13;
        /// Group 15.
        const GROUP_15 = 1 << 14;
        /// Group 16.
        const GROUP_16 = 1 << 15;
        /// Group 17.
        const GROUP_17 = 1 << 16;
        /// Group 18.
        const GROUP_18 = 1 << 17;
        /// Group 19.
        const GROUP_19 = 1 << 18;
        /// Group 20.
        const GROUP_20 = 1 << 19;
        /// Group 21.
        const GROUP_21 = 1 << 20;
        /// Group 22.
        const GROUP_22 = 1 << 21;
        /// Group 23.
        const GROUP_23 = 1 << 22;
        /// Group 24.
        const GROUP_24 = 1 << 23;
        /// Group 25.
        const GROUP_25 = 1 << 24;
        /// Group 26.
        const GROUP_26 = 1 << 25;
        /// Group 27.
        const GROUP_27 = 1 << 26;
        /// Group 28.
        const GROUP_28 = 1 << 27;
        /// Group 29.
        const GROUP_29 = 1 << 28;
        /// Group 30.
        const GROUP_30 = 1 << 29;
        /// Group 31.
        const GROUP_31 = 1 << 30;
        /// Group 32.
        const GROUP_32 = 1 << 31;
        /// Every group.
        const ALL = u32::MAX;
        /// No group.
        const NONE = 0;
    }
}

impl Default for Group {
    fn default() -> Self {
        Self::ALL
    }
}

impl From<u32> for Group {
    fn from(bits: u32) -> Self {
        Self::from_bits_retain(bits)
    }
}

impl From<Group> for u32 {
    fn from(group: Group) -> Self {
        group.bits()
    }
}

/// Combination of the filters of two colliders.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum InteractionTestMode {
    /// Each filter must accept the other collider.
    #[default]
    And,
    /// One accepting filter is sufficient. This mode applies only if both colliders select it; otherwise
    /// [`Self::And`] applies.
    Or,
}

/// The groups of a collider, and its filter.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct InteractionGroups {
    /// The groups it belongs to.
    pub memberships: Group,
    /// The groups that the filter accepts.
    pub filter: Group,
    /// The condition under which two colliders interact.
    pub test_mode: InteractionTestMode,
}

impl Default for InteractionGroups {
    fn default() -> Self {
        Self::all()
    }
}

impl InteractionGroups {
    /// A member of `memberships` that interacts with members of `filter`, in one of the test modes.
    #[cfg(feature = "upstream-signatures")]
    pub const fn new(memberships: Group, filter: Group, test_mode: InteractionTestMode) -> Self {
        Self { memberships, filter, test_mode }
    }

    /// A member of `memberships` that interacts with members of `filter`, if their filters accept it.
    #[cfg(not(feature = "upstream-signatures"))]
    pub const fn new(memberships: Group, filter: Group) -> Self {
        Self { memberships, filter, test_mode: InteractionTestMode::And }
    }

    /// A member of every group that accepts all groups.
    pub const fn all() -> Self {
        Self { memberships: Group::ALL, filter: Group::ALL, test_mode: InteractionTestMode::And }
    }

    /// A member of no group that accepts none.
    pub const fn none() -> Self {
        Self { memberships: Group::NONE, filter: Group::NONE, test_mode: InteractionTestMode::And }
    }

    /// The same with other memberships.
    #[must_use]
    pub const fn with_memberships(mut self, memberships: Group) -> Self {
        self.memberships = memberships;
        self
    }

    /// The same with another filter.
    #[must_use]
    pub const fn with_filter(mut self, filter: Group) -> Self {
        self.filter = filter;
        self
    }

    /// The same with another test mode.
    #[must_use]
    pub const fn with_test_mode(mut self, test_mode: InteractionTestMode) -> Self {
        self.test_mode = test_mode;
        self
    }

    /// Groups that interact with all partners of these, of the others, or of both.
    pub(crate) const fn union(self, other: Self) -> Self {
        let test_mode = match (self.test_mode, other.test_mode) {
            (InteractionTestMode::And, InteractionTestMode::And) => InteractionTestMode::And,
            _ => InteractionTestMode::Or,
        };
        Self {
            memberships: self.memberships.union(other.memberships),
            filter: self.filter.union(other.filter),
            test_mode,
        }
    }

    /// Returns whether each filter accepts the other.
    #[inline]
    pub const fn test_and(self, other: Self) -> bool {
        self.accepts(other) && other.accepts(self)
    }

    /// Returns whether at least one filter accepts the other.
    #[inline]
    pub const fn test_or(self, other: Self) -> bool {
        self.accepts(other) || other.accepts(self)
    }

    /// Returns whether the two interact, given both test modes.
    #[inline]
    pub const fn test(self, other: Self) -> bool {
        match (self.test_mode, other.test_mode) {
            (InteractionTestMode::Or, InteractionTestMode::Or) => self.test_or(other),
            _ => self.test_and(other),
        }
    }

    /// Returns whether the filter accepts the memberships of the other.
    const fn accepts(self, other: Self) -> bool {
        self.filter.intersects(other.memberships)
    }
}

#[cfg(test)]
mod tests {
    use super::{Group, InteractionGroups, InteractionTestMode};

    #[test]
    fn groups_are_the_32_bits() {
        assert_eq!(Group::GROUP_1.bits(), 1);
        assert_eq!(Group::GROUP_32.bits(), 1 << 31);
        assert_eq!(Group::all(), Group::ALL);
        assert_eq!(Group::empty(), Group::NONE);
        assert_eq!(Group::from(0b101), Group::GROUP_1 | Group::GROUP_3);
    }

    #[test]
    fn both_must_agree_unless_both_have_the_or_test() {
        let a = InteractionGroups::new(Group::GROUP_1, Group::GROUP_2);
        let wanted_and_willing = InteractionGroups::new(Group::GROUP_2, Group::GROUP_1);
        let wanted_only = InteractionGroups::new(Group::GROUP_2, Group::GROUP_3);
        let neither = InteractionGroups::new(Group::GROUP_4, Group::GROUP_3);
        let or = InteractionTestMode::Or;

        assert!(a.test(wanted_and_willing) && wanted_and_willing.test(a));
        assert!(!a.test(wanted_only) && !wanted_only.test(a));
        assert!(a.test_or(wanted_only) && wanted_only.test_or(a));
        assert!(!a.with_test_mode(or).test(wanted_only), "one `Or` is not enough");
        assert!(a.with_test_mode(or).test(wanted_only.with_test_mode(or)));
        assert!(!a.with_test_mode(or).test(neither.with_test_mode(or)));
    }

    /// Each partner of one of two is a partner of their union: with all memberships, filters, and modes of
    /// three groups.
    #[test]
    fn a_union_of_groups_interacts_like_its_parts() {
        let mut all = Vec::new();
        for bits in 0..64 {
            let groups = InteractionGroups::new(Group::from(bits & 7), Group::from(bits >> 3));
            all.push(groups);
            all.push(groups.with_test_mode(InteractionTestMode::Or));
        }
        for &a in &all {
            for &b in &all {
                let union = a.union(b);
                for &c in &all {
                    assert!(union.test(c) || !(a.test(c) || b.test(c)), "{a:?} {b:?} {c:?}");
                }
            }
        }
    }

    #[test]
    fn all_interacts_with_all_and_none_with_none() {
        let (all, none) = (InteractionGroups::all(), InteractionGroups::none());
        assert!(all.test(all));
        assert!(!all.test(none) && !none.test(none));
        assert_eq!(InteractionGroups::default(), all);
        let changed = none.with_memberships(Group::GROUP_7).with_filter(Group::GROUP_8);
        assert_eq!(changed, InteractionGroups::new(Group::GROUP_7, Group::GROUP_8));
    }
}
