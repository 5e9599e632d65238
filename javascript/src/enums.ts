/** Rules that combine the coefficients of two colliders. The rule with the higher number takes precedence. */
export enum CoefficientCombineRule {
    Average = 0,
    Min = 1,
    Multiply = 2,
    Max = 3,
    /** The sum, at most 1. Not in the published packages. */
    ClampedSum = 4,
    /** The square root of the product. Not in the published packages. */
    GeometricMean = 5,
}

/** Pairs of body types that collide. */
export enum ActiveCollisionTypes {
    DYNAMIC_DYNAMIC = 1,
    DYNAMIC_KINEMATIC = 12,
    DYNAMIC_FIXED = 2,
    KINEMATIC_KINEMATIC = 52224,
    KINEMATIC_FIXED = 8704,
    FIXED_FIXED = 32,
    DEFAULT = 15,
    ALL = 60975,
}

/** The events of a collider. */
export enum ActiveEvents {
    NONE = 0,
    COLLISION_EVENTS = 1,
    CONTACT_FORCE_EVENTS = 2,
}

/** The hooks of a collider. */
export enum ActiveHooks {
    NONE = 0,
    FILTER_CONTACT_PAIRS = 1,
    FILTER_INTERSECTION_PAIRS = 2,
    /** Not in the published packages. */
    MODIFY_SOLVER_CONTACTS = 4,
}

/** Treatment of a pair by the solver. */
export enum SolverFlags {
    /** Contacts are computed and reported, and the bodies pass through each other. */
    EMPTY = 0,
    COMPUTE_IMPULSE = 1,
}

/** Modes of a collider's mass. */
export enum MassPropsMode {
    Density = 0,
    Mass = 1,
    MassProps = 2,
}

/** Colliders that a query excludes. */
export enum QueryFilterFlags {
    EXCLUDE_FIXED = 1,
    EXCLUDE_KINEMATIC = 2,
    EXCLUDE_DYNAMIC = 4,
    EXCLUDE_SENSORS = 8,
    EXCLUDE_SOLIDS = 16,
    ONLY_DYNAMIC = 3,
    ONLY_KINEMATIC = 5,
    ONLY_FIXED = 6,
}

/** Dependence of a motor's strength on masses. */
export enum MotorModel {
    AccelerationBased = 0,
    ForceBased = 1,
}

/**
 * Two masks of 16 bits: the memberships above the filter. Two colliders interact if each is a member of a
 * group that the filter of the other one has.
 */
export type InteractionGroups = number;
