import {
    type AngVector,
    type AngularInertia,
    type AxisFlags,
    type AxisFlagsAndWakeUp,
    type Components,
    type MassProperties,
    type MassPropertiesAndWakeUp,
    ROTATIONS,
    type Rotation,
    RotationOps,
    TRANSLATIONS,
    type Vector,
    VectorOps,
    copyAngular,
    copyRotation,
    getAngular,
    getAngularInertia,
    getRotation,
    getVector,
    lockedBits,
    putAngular,
    putMassProperties,
    putRotation,
    putVector,
    splitLast,
    vectorOf,
    zeroAngular,
} from "#dim";
import { integer, real, requireCount } from "./arguments.js";
import type { Collider } from "./collider.js";
import { putNumber, raw } from "./raw.js";
import type { World } from "./world.js";

/** Identifies a rigid body of a world: slot and generation as the bits of a double. */
export type RigidBodyHandle = number;

/** Cause of a rigid body's motion. */
export enum RigidBodyType {
    /** Forces, contacts and joints. */
    Dynamic = 0,
    /** None: the body does not move. */
    Fixed = 1,
    /** The program, which sets the pose after the next step. */
    KinematicPositionBased = 2,
    /** The program, which sets the velocity. */
    KinematicVelocityBased = 3,
}

/** The settings that are numbers, in the order of crates/wasm/src/body.rs. */
const Setting = {
    gravityScale: 0,
    linearDamping: 1,
    angularDamping: 2,
    softCcdPrediction: 3,
    dominanceGroup: 4,
    additionalSolverIterations: 5,
} as const;

/** Bits of a body's state. */
const Flag = { enabled: 1, sleeping: 2, moving: 4, ccd: 8, quarantined: 16 } as const;

/** A rigid body of a world. */
export class RigidBody {
    /** The world of the body. */
    readonly world: World;
    /** Identifies the body in its world. */
    readonly handle: RigidBodyHandle;
    /** Data of the program. The engine does not read it. */
    userData?: unknown;

    private pgsIterations = 0;

    /** @internal Worlds make bodies: `World.createRigidBody`. */
    constructor(world: World, handle: RigidBodyHandle, desc?: RigidBodyDesc) {
        this.world = world;
        this.handle = handle;
        if (desc) {
            this.userData = desc.userData;
            this.pgsIterations = desc.additionalPgsIterations;
        }
    }

    /** Returns whether the body is still in its world. */
    isValid(): boolean {
        return this.world.isAlive() && raw.bodies_contain(this.world.id, this.handle) !== 0;
    }

    private flag(flag: number): boolean {
        return (raw.body_flags(this.world.id, this.handle) & flag) !== 0;
    }

    // ---- Locked axes ----

    /** Locks or unlocks all translations. */
    lockTranslations(locked: boolean, wakeUp: boolean): void {
        raw.body_set_locked_axes(this.world.id, this.handle, TRANSLATIONS, locked ? TRANSLATIONS : 0, +wakeUp);
    }

    /** Locks or unlocks all rotations. */
    lockRotations(locked: boolean, wakeUp: boolean): void {
        raw.body_set_locked_axes(this.world.id, this.handle, ROTATIONS, locked ? ROTATIONS : 0, +wakeUp);
    }

    /** Sets the axes along which the body can move. */
    setEnabledTranslations(...flags: AxisFlagsAndWakeUp): void {
        const [enabled, wakeUp] = splitLast<boolean, boolean>(flags);
        raw.body_set_locked_axes(this.world.id, this.handle, TRANSLATIONS, lockedBits(enabled as AxisFlags), +wakeUp);
    }

    /** The same as `setEnabledTranslations`. */
    restrictTranslations(...flags: AxisFlagsAndWakeUp): void {
        this.setEnabledTranslations(...flags);
    }

    // ---- Settings ----

    private setting(setting: number): number {
        return raw.body_setting(this.world.id, this.handle, setting);
    }

    private setSetting(name: keyof typeof Setting, value: number, wakeUp = false): void {
        raw.body_set_setting(this.world.id, this.handle, Setting[name], real(value, name), +wakeUp);
    }

    /** The dominance group: contacts do not push bodies of higher groups. */
    dominanceGroup(): number {
        return this.setting(Setting.dominanceGroup);
    }

    /** Sets the dominance group, from -128 to 127. */
    setDominanceGroup(group: number): void {
        this.setSetting("dominanceGroup", integer(group, "dominanceGroup"));
    }

    /** Solver iterations beyond those of the world. */
    additionalSolverIterations(): number {
        return this.setting(Setting.additionalSolverIterations) - this.pgsIterations;
    }

    /** Sets the solver iterations beyond those of the world. */
    setAdditionalSolverIterations(iters: number): void {
        this.setSetting("additionalSolverIterations", requireCount(iters, "additionalSolverIterations") + this.pgsIterations);
    }

    /** Iterations in a substep beyond those of the world. */
    additionalPgsIterations(): number {
        return this.pgsIterations;
    }

    /**
     * Sets the iterations in a substep beyond those of the world. The engine makes an additional solver
     * iteration of each, which is more accurate. A restored world reports them as such.
     */
    setAdditionalPgsIterations(iterations: number): void {
        const others = this.additionalSolverIterations();
        this.setSetting("additionalSolverIterations", others + requireCount(iterations, "additionalPgsIterations"));
        this.pgsIterations = iterations;
    }

    /** Enables or disables continuous collision detection. */
    enableCcd(enabled: boolean): void {
        raw.body_set_ccd(this.world.id, this.handle, +enabled);
    }

    /** Returns whether continuous collision detection is enabled. */
    isCcdEnabled(): boolean {
        return this.flag(Flag.ccd);
    }

    /** Sets the prediction distance of contacts ahead of the body. 0 disables the prediction. */
    setSoftCcdPrediction(distance: number): void {
        this.setSetting("softCcdPrediction", distance);
    }

    /** The prediction distance of contacts ahead of the body. */
    softCcdPrediction(): number {
        return this.setting(Setting.softCcdPrediction);
    }

    /** The factor of gravity. */
    gravityScale(): number {
        return this.setting(Setting.gravityScale);
    }

    /** Sets the factor of gravity. */
    setGravityScale(factor: number, wakeUp: boolean): void {
        this.setSetting("gravityScale", factor, wakeUp);
    }

    /** The fraction of the linear velocity that is lost per second. */
    linearDamping(): number {
        return this.setting(Setting.linearDamping);
    }

    /** Sets the fraction of the linear velocity that is lost per second. */
    setLinearDamping(factor: number): void {
        this.setSetting("linearDamping", factor);
    }

    /** The fraction of the angular velocity that is lost per second. */
    angularDamping(): number {
        return this.setting(Setting.angularDamping);
    }

    /** Sets the fraction of the angular velocity that is lost per second. */
    setAngularDamping(factor: number): void {
        this.setSetting("angularDamping", factor);
    }

    // ---- Motion ----

    /** The translation. With a target, no object is created. */
    translation(target?: Vector): Vector {
        raw.body_translation(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** The rotation. With a target, no object is created. */
    rotation(target?: Rotation): Rotation {
        raw.body_rotation(this.world.id, this.handle);
        return getRotation(0, target);
    }

    /** The translation that a kinematic body has after the next step. */
    nextTranslation(target?: Vector): Vector {
        raw.body_next_translation(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** The rotation that a kinematic body has after the next step. */
    nextRotation(target?: Rotation): Rotation {
        raw.body_next_rotation(this.world.id, this.handle);
        return getRotation(0, target);
    }

    /** Moves the body at once. */
    setTranslation(tra: Vector, wakeUp: boolean): void {
        putVector(0, tra, "translation");
        raw.body_set_translation(this.world.id, this.handle, +wakeUp);
    }

    /** Rotates the body at once. */
    setRotation(rot: Rotation, wakeUp: boolean): void {
        putRotation(0, rot, "rotation");
        raw.body_set_rotation(this.world.id, this.handle, +wakeUp);
    }

    /** Sets the translation that a kinematic body has after the next step. */
    setNextKinematicTranslation(t: Vector): void {
        putVector(0, t, "translation");
        raw.body_set_next_translation(this.world.id, this.handle);
    }

    /** Sets the rotation that a kinematic body has after the next step. */
    setNextKinematicRotation(rot: Rotation): void {
        putRotation(0, rot, "rotation");
        raw.body_set_next_rotation(this.world.id, this.handle);
    }

    /** The velocity of the centre of mass. */
    linvel(target?: Vector): Vector {
        raw.body_linvel(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** Sets the velocity of the centre of mass. */
    setLinvel(vel: Vector, wakeUp: boolean): void {
        putVector(0, vel, "linvel");
        raw.body_set_linvel(this.world.id, this.handle, +wakeUp);
    }

    /** The angular velocity. */
    angvel(target?: AngVector): AngVector {
        raw.body_angvel(this.world.id, this.handle);
        return getAngular(0, target);
    }

    /** Sets the angular velocity. */
    setAngvel(vel: AngVector, wakeUp: boolean): void {
        putAngular(0, vel, "angvel");
        raw.body_set_angvel(this.world.id, this.handle, +wakeUp);
    }

    /** The velocity of a point of the body. The point is in world space. */
    velocityAtPoint(point: Vector, target?: Vector): Vector {
        putVector(0, point, "point");
        raw.body_velocity_at_point(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** The kinetic energy. */
    kineticEnergy(): number {
        return raw.body_kinetic_energy(this.world.id, this.handle);
    }

    // ---- Mass ----

    /** The mass of the body with its colliders. */
    mass(): number {
        return raw.body_mass(this.world.id, this.handle);
    }

    /** The inverse of the mass. */
    invMass(): number {
        return raw.body_inv_mass(this.world.id, this.handle);
    }

    /** The inverse mass along each world axis, with locked axes and the type of the body considered. */
    effectiveInvMass(target?: Vector): Vector {
        raw.body_effective_inv_mass(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** The centre of mass in the frame of the body. */
    localCom(target?: Vector): Vector {
        raw.body_local_com(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** The centre of mass in world space. */
    worldCom(target?: Vector): Vector {
        raw.body_world_com(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** The inverse of the principal inertia. */
    invPrincipalInertia(target?: AngVector): AngVector {
        raw.body_inv_principal_inertia(this.world.id, this.handle);
        return getAngular(0, target);
    }

    /** The principal inertia. */
    principalInertia(target?: AngVector): AngVector {
        raw.body_principal_inertia(this.world.id, this.handle);
        return getAngular(0, target);
    }

    /** The inverse inertia in world space, with locked axes and the type of the body considered. */
    effectiveWorldInvInertia(target?: AngularInertia): AngularInertia {
        raw.body_effective_world_inv_inertia(this.world.id, this.handle);
        return getAngularInertia(target);
    }

    /** The inertia in world space, with locked axes and the type of the body considered. */
    effectiveAngularInertia(target?: AngularInertia): AngularInertia {
        raw.body_effective_angular_inertia(this.world.id, this.handle);
        return getAngularInertia(target);
    }

    /** Computes the mass properties from the colliders at once. A step does it, too. */
    recomputeMassPropertiesFromColliders(): void {
        raw.body_recompute_mass(this.world.id, this.handle);
    }

    /** Sets the mass that is added to that of the colliders. */
    setAdditionalMass(mass: number, wakeUp: boolean): void {
        raw.body_set_additional_mass(this.world.id, this.handle, real(mass, "mass"), +wakeUp);
    }

    /** Sets the mass properties that are added to those of the colliders. */
    setAdditionalMassProperties(...properties: MassPropertiesAndWakeUp): void {
        const [values, wakeUp] = splitLast<unknown, boolean>(properties);
        const mass = values as unknown as MassProperties;
        putMassProperties(0, mass);
        raw.body_set_additional_mass_properties(this.world.id, this.handle, mass[0], +wakeUp);
    }

    // ---- State ----

    /** Puts the body to sleep. */
    sleep(): void {
        raw.body_sleep(this.world.id, this.handle);
    }

    /** Wakes the body. */
    wakeUp(): void {
        raw.body_wake_up(this.world.id, this.handle);
    }

    /** Returns whether the body sleeps. */
    isSleeping(): boolean {
        return this.flag(Flag.sleeping);
    }

    /** Returns whether the body has a velocity. */
    isMoving(): boolean {
        return this.flag(Flag.moving);
    }

    /** Enables or disables the body with its colliders and joints. */
    setEnabled(enabled: boolean): void {
        raw.body_set_enabled(this.world.id, this.handle, +enabled);
    }

    /** Returns whether the body is enabled. */
    isEnabled(): boolean {
        return this.flag(Flag.enabled);
    }

    /** Returns whether a step disabled the body, because its numbers had overflowed. */
    isQuarantined(): boolean {
        return this.flag(Flag.quarantined);
    }

    /** The type of the body. */
    bodyType(): RigidBodyType {
        return raw.body_type(this.world.id, this.handle);
    }

    /** Changes the type of the body. */
    setBodyType(type: RigidBodyType, wakeUp: boolean): void {
        raw.body_set_type(this.world.id, this.handle, integer(type, "type"), +wakeUp);
    }

    /** Returns whether the body is fixed. */
    isFixed(): boolean {
        return this.bodyType() === RigidBodyType.Fixed;
    }

    /** Returns whether the body is kinematic. */
    isKinematic(): boolean {
        const type = this.bodyType();
        return type === RigidBodyType.KinematicPositionBased || type === RigidBodyType.KinematicVelocityBased;
    }

    /** Returns whether the body is dynamic. */
    isDynamic(): boolean {
        return this.bodyType() === RigidBodyType.Dynamic;
    }

    /** The number of colliders. */
    numColliders(): number {
        return raw.body_collider_count(this.world.id, this.handle);
    }

    /** A collider of the body, by its index. */
    collider(i: number): Collider {
        return this.world.colliders.get(raw.body_collider(this.world.id, this.handle, integer(i, "i")))!;
    }

    // ---- Forces ----

    /** Resets the added forces. */
    resetForces(wakeUp: boolean): void {
        raw.body_reset_forces(this.world.id, this.handle, +wakeUp);
    }

    /** Resets the added torques. */
    resetTorques(wakeUp: boolean): void {
        raw.body_reset_torques(this.world.id, this.handle, +wakeUp);
    }

    /** Adds a force on the centre of mass. It acts in every step until `resetForces`. */
    addForce(force: Vector, wakeUp: boolean): void {
        putVector(0, force, "force");
        raw.body_add_force(this.world.id, this.handle, +wakeUp);
    }

    /** Changes the velocity by an impulse on the centre of mass. */
    applyImpulse(impulse: Vector, wakeUp: boolean): void {
        putVector(0, impulse, "impulse");
        raw.body_apply_impulse(this.world.id, this.handle, +wakeUp);
    }

    /** Adds a torque. It acts in every step until `resetTorques`. */
    addTorque(torque: AngVector, wakeUp: boolean): void {
        putAngular(0, torque, "torque");
        raw.body_add_torque(this.world.id, this.handle, +wakeUp);
    }

    /** Changes the angular velocity by an angular impulse. */
    applyTorqueImpulse(torqueImpulse: AngVector, wakeUp: boolean): void {
        putAngular(0, torqueImpulse, "torqueImpulse");
        raw.body_apply_torque_impulse(this.world.id, this.handle, +wakeUp);
    }

    /** Adds a force on a point in world space. */
    addForceAtPoint(force: Vector, point: Vector, wakeUp: boolean): void {
        putVector(0, force, "force");
        putVector(1, point, "point");
        raw.body_add_force_at_point(this.world.id, this.handle, +wakeUp);
    }

    /** Changes the velocities by an impulse on a point in world space. */
    applyImpulseAtPoint(impulse: Vector, point: Vector, wakeUp: boolean): void {
        putVector(0, impulse, "impulse");
        putVector(1, point, "point");
        raw.body_apply_impulse_at_point(this.world.id, this.handle, +wakeUp);
    }

    /** The force that was added. */
    userForce(target?: Vector): Vector {
        raw.body_user_force(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** The torque that was added. */
    userTorque(target?: AngVector): AngVector {
        raw.body_user_torque(this.world.id, this.handle);
        return getAngular(0, target);
    }
}

/** Bits of a description, in the order of crates/wasm/src/body.rs. */
const DescFlag = { enabled: 1, canSleep: 2, sleeping: 4, ccd: 8, mass: 16, massProperties: 32 } as const;

/** Describes a rigid body. `World.createRigidBody` makes bodies of it. */
export class RigidBodyDesc {
    enabled = true;
    translation: Vector = VectorOps.zeros();
    rotation: Rotation = RotationOps.identity();
    gravityScale = 1;
    /** Mass beyond that of the colliders. */
    mass = 0;
    /** Whether only the mass is given, and not the other mass properties. */
    massOnly = false;
    centerOfMass: Vector = VectorOps.zeros();
    translationsEnabledX = true;
    translationsEnabledY = true;
    linvel: Vector = VectorOps.zeros();
    angvel: AngVector = zeroAngular();
    principalAngularInertia: AngVector = zeroAngular();
    linearDamping = 0;
    angularDamping = 0;
    status: RigidBodyType;
    canSleep = true;
    sleeping = false;
    ccdEnabled = false;
    softCcdPrediction = 0;
    dominanceGroup = 0;
    additionalSolverIterations = 0;
    additionalPgsIterations = 0;
    userData?: unknown;
    /** Whether mass properties are given. */
    protected hasMassProperties = false;

    constructor(status: RigidBodyType) {
        this.status = status;
    }

    setDominanceGroup(group: number): this {
        this.dominanceGroup = group;
        return this;
    }

    setAdditionalSolverIterations(iters: number): this {
        this.additionalSolverIterations = iters;
        return this;
    }

    /** Sets the iterations in a substep beyond those of the world: see `RigidBody`. */
    setAdditionalPgsIterations(iters: number): this {
        this.additionalPgsIterations = iters;
        return this;
    }

    setEnabled(enabled: boolean): this {
        this.enabled = enabled;
        return this;
    }

    setTranslation(...components: Components): this {
        this.translation = vectorOf(components);
        return this;
    }

    setRotation(rot: Rotation): this {
        this.rotation = copyRotation(rot, "rotation");
        return this;
    }

    setGravityScale(scale: number): this {
        this.gravityScale = scale;
        return this;
    }

    /** Sets the mass that is added to that of the colliders. */
    setAdditionalMass(mass: number): this {
        this.mass = mass;
        this.massOnly = true;
        return this;
    }

    setLinvel(...components: Components): this {
        this.linvel = vectorOf(components);
        return this;
    }

    setAngvel(vel: AngVector): this {
        this.angvel = copyAngular(vel, "angvel");
        return this;
    }

    setLinearDamping(damping: number): this {
        this.linearDamping = damping;
        return this;
    }

    setAngularDamping(damping: number): this {
        this.angularDamping = damping;
        return this;
    }

    setCanSleep(can: boolean): this {
        this.canSleep = can;
        return this;
    }

    setSleeping(sleeping: boolean): this {
        this.sleeping = sleeping;
        return this;
    }

    setCcdEnabled(enabled: boolean): this {
        this.ccdEnabled = enabled;
        return this;
    }

    setSoftCcdPrediction(distance: number): this {
        this.softCcdPrediction = distance;
        return this;
    }

    setUserData(data?: unknown): this {
        this.userData = data;
        return this;
    }

    /** The bits of locked axes. */
    protected lockedAxes(): number {
        return 0;
    }

    /** The mass properties as arguments. */
    protected massProperties(): MassProperties {
        return [this.mass, this.centerOfMass, this.principalAngularInertia] as unknown as MassProperties;
    }

    /** @internal Creates the body. Returns its handle. */
    create(world: number): RigidBodyHandle {
        putVector(0, this.translation, "translation");
        putRotation(1, this.rotation, "rotation");
        putVector(2, this.linvel, "linvel");
        putAngular(3, this.angvel, "angvel");
        putMassProperties(4, this.massProperties());
        putNumber(7, 0, real(this.gravityScale, "gravityScale"));
        putNumber(7, 1, real(this.linearDamping, "linearDamping"));
        putNumber(7, 2, real(this.angularDamping, "angularDamping"));
        putNumber(7, 3, real(this.softCcdPrediction, "softCcdPrediction"));
        putNumber(8, 0, this.mass);
        const flags =
            (this.enabled ? DescFlag.enabled : 0) |
            (this.canSleep ? DescFlag.canSleep : 0) |
            (this.sleeping ? DescFlag.sleeping : 0) |
            (this.ccdEnabled ? DescFlag.ccd : 0) |
            (this.hasMassProperties && !this.massOnly ? DescFlag.massProperties : 0) |
            (this.massOnly ? DescFlag.mass : 0);
        const iterations = requireCount(this.additionalSolverIterations, "additionalSolverIterations")
            + requireCount(this.additionalPgsIterations, "additionalPgsIterations");
        const [status, dominance] = [integer(this.status, "status"), integer(this.dominanceGroup, "dominanceGroup")];
        return raw.body_create(world, status, flags, this.lockedAxes(), dominance, iterations);
    }
}
