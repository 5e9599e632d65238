//! Change flags since the last step, so that a step visits changed bodies alone.

bitflags::bitflags! {
    /// Edits of a body since the last step.
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Default)]
    pub struct RigidBodyChanges: u32 {
        /// The set's list of modified bodies contains the body's handle.
        const IN_MODIFIED_SET = 1 << 0;
        /// The pose, or the next pose of a kinematic body.
        const POSITION = 1 << 1;
        /// Whether the body sleeps.
        const SLEEP = 1 << 2;
        /// The attached colliders, or their poses on the body.
        const COLLIDERS = 1 << 3;
        /// The body type.
        const TYPE = 1 << 4;
        /// The dominance group.
        const DOMINANCE = 1 << 5;
        /// A property that determines the mass, centre of mass or inertia.
        const LOCAL_MASS_PROPERTIES = 1 << 6;
        /// Whether the body takes part in the simulation.
        const ENABLED_OR_DISABLED = 1 << 7;
        /// No step has seen the body yet, and colliders were attached at most: the body is being assembled.
        const ASSEMBLY = 1 << 8;
    }
}

impl RigidBodyChanges {
    /// Edits that affect the lists of the body and the pairs of its colliders.
    pub(crate) const KIND: Self = Self::TYPE.union(Self::ENABLED_OR_DISABLED);

    /// All changes, for a body that is new to the step.
    pub(crate) fn everything() -> Self {
        Self::all() - Self::IN_MODIFIED_SET
    }

    /// The changes of a body that is enabled or disabled.
    ///
    /// The step skips changes of a disabled body, so it must process all of them afterwards.
    pub(crate) fn of_switch(enabled: bool) -> Self {
        match enabled {
            true => Self::everything() - Self::ASSEMBLY,
            false => Self::ENABLED_OR_DISABLED,
        }
    }
}
