// Joints: their descriptions, and the joints of a world.

import {
    ANGULAR_AXIS,
    type AngVector,
    type GearArguments,
    JointAxesMask,
    JointAxis,
    JointType,
    type RackArguments,
    type Rotation,
    RotationOps,
    type Vector,
    VectorOps,
    gearParts,
    getAngular,
    getRotation,
    getVector,
    putRotation,
    putVector,
    rackParts,
} from "#dim";
import type { RigidBody } from "#rigid_body";
import { integer, real, requireClass, requireFunction, requireObject } from "./arguments.js";
import type { MotorModel } from "./enums.js";
import { getNumber, listCopy, putNumber, raw } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";
import type { World } from "./world.js";

/** Identifies an impulse joint of a world. */
export type ImpulseJointHandle = number;
/** Identifies a multibody joint of a world. */
export type MultibodyJointHandle = number;

/** The sets of joints, in the order of crates/wasm/src/joint.rs. */
const Set = { impulse: 0, multibody: 1 } as const;
/** Bits of the parts of a frame that a change gives. */
const Given = { anchor: 1, rotation: 2 } as const;
/** The number of ball joints, which 2D does not have. */
const SPHERICAL = 5;

/** A joint of a world. */
abstract class Joint {
    /** The world of the joint. */
    readonly world: World;
    /** Identifies the joint in its set. */
    handle: number;
    /** @internal */
    abstract readonly set: number;

    /** @internal Worlds make joints. */
    constructor(world: World, handle: number) {
        this.world = world;
        this.handle = handle;
    }

    /** Returns whether the joint is still in its world. */
    isValid(): boolean {
        return this.world.isAlive() && raw.joint_exists(this.world.id, this.set, this.handle) !== 0;
    }

    /** The first body. */
    body1(): RigidBody {
        return this.world.bodies.get(raw.joint_body(this.world.id, this.set, this.handle, 0))!;
    }

    /** The second body. */
    body2(): RigidBody {
        return this.world.bodies.get(raw.joint_body(this.world.id, this.set, this.handle, 1))!;
    }

    /** The kind of the joint. */
    type(): JointType {
        return raw.joint_kind(this.world.id, this.set, this.handle) as JointType;
    }

    private frame(side: number): void {
        raw.joint_frame(this.world.id, this.set, this.handle, side);
    }

    private setAnchor(side: number, anchor: Vector, given: number = Given.anchor): void {
        putVector(0, anchor, "anchor");
        raw.joint_set_frame(this.world.id, this.set, this.handle, side, given);
    }

    private setRotation(side: number, rotation: Rotation): void {
        putRotation(1, rotation, "rotation");
        raw.joint_set_frame(this.world.id, this.set, this.handle, side, Given.rotation);
    }

    private setFrame(side: number, anchor: Vector, rotation: Rotation): void {
        putRotation(1, rotation, "rotation");
        this.setAnchor(side, anchor, Given.anchor | Given.rotation);
    }

    /** The rotation of the joint's frame on the first body. */
    frameX1(target?: Rotation): Rotation {
        this.frame(0);
        return getRotation(1, target);
    }

    /** The rotation of the joint's frame on the second body. */
    frameX2(target?: Rotation): Rotation {
        this.frame(1);
        return getRotation(1, target);
    }

    /** The anchor on the first body. */
    anchor1(target?: Vector): Vector {
        this.frame(0);
        return getVector(0, target);
    }

    /** The anchor on the second body. */
    anchor2(target?: Vector): Vector {
        this.frame(1);
        return getVector(0, target);
    }

    /** Sets the anchor on the first body. */
    setAnchor1(newPos: Vector): void {
        this.setAnchor(0, newPos);
    }

    /** Sets the anchor on the second body. */
    setAnchor2(newPos: Vector): void {
        this.setAnchor(1, newPos);
    }

    /** Sets the rotation of the joint's frame on the first body. */
    setFrameX1(rot: Rotation): void {
        this.setRotation(0, rot);
    }

    /** Sets the rotation of the joint's frame on the second body. */
    setFrameX2(rot: Rotation): void {
        this.setRotation(1, rot);
    }

    /** Sets the joint's frame on the first body. */
    setLocalFrame1(anchor: Vector, rot: Rotation): void {
        this.setFrame(0, anchor, rot);
    }

    /** Sets the joint's frame on the second body. */
    setLocalFrame2(anchor: Vector, rot: Rotation): void {
        this.setFrame(1, anchor, rot);
    }

    /** Sets whether the two bodies collide. */
    setContactsEnabled(enabled: boolean): void {
        raw.joint_set_contacts_enabled(this.world.id, this.set, this.handle, +enabled);
    }

    /** Returns whether the two bodies collide. */
    contactsEnabled(): boolean {
        return raw.joint_contacts_enabled(this.world.id, this.set, this.handle) !== 0;
    }

    /** Returns whether an axis has limits. */
    axisLimitsEnabled(axis: JointAxis): boolean {
        return raw.joint_limits(this.world.id, this.set, this.handle, integer(axis, "axis")) !== 0;
    }

    /** The limits of an axis, or null. */
    axisLimits(axis: JointAxis): [min: number, max: number] | null {
        return this.axisLimitsEnabled(axis) ? [getNumber(0, 0), getNumber(0, 1)] : null;
    }

    /** Sets the limits of an axis. */
    setAxisLimits(axis: JointAxis, min: number, max: number): void {
        raw.joint_set_limits(this.world.id, this.set, this.handle, integer(axis, "axis"), real(min, "min"), real(max, "max"));
    }

    /** Sets the model of an axis's motor. */
    setAxisMotorModel(axis: JointAxis, model: MotorModel): void {
        raw.joint_set_motor_model(this.world.id, this.set, this.handle, integer(axis, "axis"), integer(model, "model"));
    }

    /** Sets the largest force of an axis's motor. */
    setAxisMotorMaxForce(axis: JointAxis, maxForce: number): void {
        raw.joint_set_motor_max_force(this.world.id, this.set, this.handle, integer(axis, "axis"), real(maxForce, "maxForce"));
    }

    /** Drives an axis at a velocity. */
    setAxisMotorVelocity(axis: JointAxis, targetVel: number, factor: number): void {
        raw.joint_set_motor_velocity(this.world.id, this.set, this.handle, integer(axis, "axis"), real(targetVel, "targetVel"), real(factor, "factor"));
    }

    /** Drives an axis to a position. */
    setAxisMotorPosition(axis: JointAxis, targetPos: number, stiffness: number, damping: number): void {
        raw.joint_set_motor_position(this.world.id, this.set, this.handle, integer(axis, "axis"), real(targetPos, "targetPos"), real(stiffness, "stiffness"), real(damping, "damping"));
    }

    /** Drives an axis to a position at a velocity. */
    setAxisMotor(axis: JointAxis, targetPos: number, targetVel: number, stiffness: number, damping: number): void {
        raw.joint_set_motor(this.world.id, this.set, this.handle, integer(axis, "axis"), real(targetPos, "targetPos"), real(targetVel, "targetVel"), real(stiffness, "stiffness"), real(damping, "damping"));
    }
}

/** A joint that the solver enforces by impulses. */
export class ImpulseJoint extends Joint {
    /** @internal */
    readonly set = Set.impulse;

    /** The force on the second body, the mean of the last step. */
    force(target?: Vector): Vector {
        raw.joint_reaction(this.world.id, this.handle);
        return getVector(0, target);
    }

    /** The torque on the second body, the mean of the last step. */
    torque(target?: AngVector): AngVector {
        raw.joint_reaction(this.world.id, this.handle);
        return getAngular(1, target);
    }
}

/** A joint with one free axis. */
export class UnitImpulseJoint extends ImpulseJoint {
    /** The free axis. */
    protected rawAxis?(): JointAxis;

    private axis(): JointAxis {
        return this.rawAxis!();
    }

    /** Returns whether the joint has limits. */
    limitsEnabled(): boolean {
        return this.axisLimitsEnabled(this.axis());
    }

    /** The lower limit. */
    limitsMin(): number {
        return this.axisLimits(this.axis())?.[0] ?? -Infinity;
    }

    /** The upper limit. */
    limitsMax(): number {
        return this.axisLimits(this.axis())?.[1] ?? Infinity;
    }

    /** Sets the limits. */
    setLimits(min: number, max: number): void {
        this.setAxisLimits(this.axis(), min, max);
    }

    /** Sets the model of the motor. */
    configureMotorModel(model: MotorModel): void {
        this.setAxisMotorModel(this.axis(), model);
    }

    /** Sets the largest force of the motor. */
    setMotorMaxForce(maxForce: number): void {
        this.setAxisMotorMaxForce(this.axis(), maxForce);
    }

    /** Drives the joint at a velocity. */
    configureMotorVelocity(targetVel: number, factor: number): void {
        this.setAxisMotorVelocity(this.axis(), targetVel, factor);
    }

    /** Drives the joint to a position. */
    configureMotorPosition(targetPos: number, stiffness: number, damping: number): void {
        this.setAxisMotorPosition(this.axis(), targetPos, stiffness, damping);
    }

    /** Drives the joint to a position at a velocity. */
    configureMotor(targetPos: number, targetVel: number, stiffness: number, damping: number): void {
        this.setAxisMotor(this.axis(), targetPos, targetVel, stiffness, damping);
    }
}

/** A joint without free axes. */
export class FixedImpulseJoint extends ImpulseJoint {}
/** A joint that limits a distance. */
export class RopeImpulseJoint extends ImpulseJoint {}
/** A joint that drives a distance. */
export class SpringImpulseJoint extends ImpulseJoint {}
/** A joint with user-defined axes. */
export class GenericImpulseJoint extends ImpulseJoint {}

/** Two wheels whose rotations are in a constant ratio. */
export class GearImpulseJoint extends ImpulseJoint {
    /** Rotation of the first wheel per rotation of the second one, in the opposite direction. */
    ratio(): number {
        return raw.joint_ratio(this.world.id, this.handle);
    }

    /** Sets the ratio (1e-6 to 1e6 in size). A negative ratio is that of an internal gear, a belt or a chain. */
    setRatio(ratio: number): void {
        raw.joint_set_ratio(this.world.id, this.handle, real(ratio, "ratio"));
    }

    /** The angle (radians) by which the first wheel can rotate while the second one stands still. */
    backlash(): number {
        return raw.joint_backlash(this.world.id, this.handle);
    }

    /** Sets the angle (radians, default: 0) by which the first wheel can rotate while the second one stands still. */
    setBacklash(angle: number): void {
        raw.joint_set_backlash(this.world.id, this.handle, real(angle, "angle"));
    }
}

/** A pinion that moves a rack. */
export class RackImpulseJoint extends ImpulseJoint {
    /** Displacement of the rack per radian of the pinion (length units). */
    radius(): number {
        return raw.joint_radius(this.world.id, this.handle);
    }

    /** Sets the displacement of the rack per radian of the pinion (1e-6 to 1e6 in size): negative if the rack moves against its axis. */
    setRadius(radius: number): void {
        raw.joint_set_radius(this.world.id, this.handle, real(radius, "radius"));
    }
}

/** Two bodies on the ends of a rope that runs over two points of the world. */
export class PulleyImpulseJoint extends ImpulseJoint {
    /** The length of the rope: the largest `distance1 + ratio · distance2` (length units). */
    length(): number {
        return raw.joint_length(this.world.id, this.handle);
    }

    /** Sets the length of the rope. */
    setLength(length: number): void {
        raw.joint_set_length(this.world.id, this.handle, real(length, "length"));
    }

    /** Factor of the second distance. */
    ratio(): number {
        return raw.joint_ratio(this.world.id, this.handle);
    }

    /** Sets the factor of the second distance (1e-6 to 1e6). */
    setRatio(ratio: number): void {
        raw.joint_set_ratio(this.world.id, this.handle, real(ratio, "ratio"));
    }

    /** The point of the world over which the rope runs to the first body. */
    over1(target?: Vector): Vector {
        raw.joint_over(this.world.id, this.handle, 0);
        return getVector(0, target);
    }

    /** The point of the world over which the rope runs to the second body. */
    over2(target?: Vector): Vector {
        raw.joint_over(this.world.id, this.handle, 1);
        return getVector(0, target);
    }

    /** Sets the point of the world over which the rope runs to the first body. */
    setOver1(over: Vector): void {
        putVector(0, over, "over");
        raw.joint_set_over(this.world.id, this.handle, 0);
    }

    /** Sets the point of the world over which the rope runs to the second body. */
    setOver2(over: Vector): void {
        putVector(0, over, "over");
        raw.joint_set_over(this.world.id, this.handle, 1);
    }
}

/** A slider. */
export class PrismaticImpulseJoint extends UnitImpulseJoint {
    /** The free axis. */
    override rawAxis(): JointAxis {
        return JointAxis.LinX;
    }
}

/** A hinge. */
export class RevoluteImpulseJoint extends UnitImpulseJoint {
    /** The free axis. */
    override rawAxis(): JointAxis {
        return ANGULAR_AXIS;
    }
}

/** A ball in a socket (3D). */
export class SphericalImpulseJoint extends ImpulseJoint {
    /** Sets the model of an axis's motor. */
    configureMotorModel(axis: JointAxis, model: MotorModel): void {
        this.setAxisMotorModel(axis, model);
    }

    /** Sets the largest torque of an axis's motor. */
    setMotorMaxForce(axis: JointAxis, maxForce: number): void {
        this.setAxisMotorMaxForce(axis, maxForce);
    }

    /** Drives an axis at a velocity. */
    configureMotorVelocity(axis: JointAxis, targetVel: number, factor: number): void {
        this.setAxisMotorVelocity(axis, targetVel, factor);
    }

    /** Drives an axis to an angle. */
    configureMotorPosition(axis: JointAxis, targetPos: number, stiffness: number, damping: number): void {
        this.setAxisMotorPosition(axis, targetPos, stiffness, damping);
    }

    /** Drives an axis to an angle at a velocity. */
    configureMotor(axis: JointAxis, targetPos: number, targetVel: number, stiffness: number, damping: number): void {
        this.setAxisMotor(axis, targetPos, targetVel, stiffness, damping);
    }
}

/** A joint of a multibody: it has coordinates, and never drifts apart. */
export class MultibodyJoint extends Joint {
    /** @internal */
    readonly set = Set.multibody;
}

/** A multibody joint with one free axis. */
export class UnitMultibodyJoint extends MultibodyJoint {
    /** The free axis. */
    protected rawAxis?(): JointAxis;
}

/** A multibody joint without free axes. */
export class FixedMultibodyJoint extends MultibodyJoint {}

/** A slider. */
export class PrismaticMultibodyJoint extends UnitMultibodyJoint {
    /** The free axis. */
    override rawAxis(): JointAxis {
        return JointAxis.LinX;
    }
}

/** A hinge. */
export class RevoluteMultibodyJoint extends UnitMultibodyJoint {
    /** The free axis. */
    override rawAxis(): JointAxis {
        return ANGULAR_AXIS;
    }
}

/** A ball in a socket (3D). */
export class SphericalMultibodyJoint extends MultibodyJoint {}

/** Describes a joint. */
export class JointData {
    anchor1: Vector = VectorOps.zeros();
    anchor2: Vector = VectorOps.zeros();
    axis: Vector = xAxis();
    axis1: Vector = this.axis;
    axis2: Vector = this.axis;
    frame1: Rotation = RotationOps.identity();
    frame2: Rotation = RotationOps.identity();
    jointType: JointType;
    limitsEnabled = false;
    limits: Array<number> = [0, 0];
    axesMask: JointAxesMask = 0 as JointAxesMask;
    stiffness = 0;
    damping = 0;
    length = 0;
    ratio = 1;
    radius = 1;
    over1: Vector = VectorOps.zeros();
    over2: Vector = VectorOps.zeros();

    private constructor(jointType: number, anchor1: Vector, anchor2: Vector) {
        this.jointType = jointType as JointType;
        this.anchor1 = anchor1;
        this.anchor2 = anchor2;
    }

    private withAxes(axis1: Vector, axis2: Vector): JointData {
        this.axis = axis1;
        this.axis1 = axis1;
        this.axis2 = axis2;
        return this;
    }

    /** A joint without free axes. */
    static fixed(anchor1: Vector, frame1: Rotation, anchor2: Vector, frame2: Rotation): JointData {
        const data = new JointData(JointType.Fixed, anchor1, anchor2);
        data.frame1 = frame1;
        data.frame2 = frame2;
        return data;
    }

    /** A joint that drives the distance of the anchors to a rest length. */
    static spring(rest_length: number, stiffness: number, damping: number, anchor1: Vector, anchor2: Vector): JointData {
        const data = new JointData(JointType.Spring, anchor1, anchor2);
        data.length = rest_length;
        data.stiffness = stiffness;
        data.damping = damping;
        return data;
    }

    /** A joint that keeps the distance of the anchors below a length. */
    static rope(length: number, anchor1: Vector, anchor2: Vector): JointData {
        const data = new JointData(JointType.Rope, anchor1, anchor2);
        data.length = length;
        return data;
    }

    /**
     * Two wheels whose rotations are in a constant ratio, `angle1 + ratio · angle2 = 0`, about an axis in the frame of
     * each body (3D). The ratio is that of the teeth, second to first; a negative one is that of an internal gear, a
     * belt or a chain. Each wheel has a joint of its own that holds it. The angles are relative to the world, so the
     * housing must stand still. The two bodies do not collide.
     */
    static gear(...parts: GearArguments): JointData {
        const [axis1, axis2, ratio] = gearParts(parts);
        const data = new JointData(JointType.Gear, VectorOps.zeros(), VectorOps.zeros()).withAxes(axis1, axis2);
        data.ratio = ratio;
        return data;
    }

    /**
     * A pinion that moves a rack, `displacement = radius · angle`: the first body rotates about its axis (3D), the
     * second one moves along its axis, each in the body's frame. Each has a joint of its own that holds it. The
     * coordinates are relative to the world, so the housing must stand still. The two bodies do not collide.
     */
    static rack(...parts: RackArguments): JointData {
        const [axis1, axis2, radius] = rackParts(parts);
        const data = new JointData(JointType.Rack, VectorOps.zeros(), VectorOps.zeros()).withAxes(axis1, axis2);
        data.radius = radius;
        return data;
    }

    /**
     * Two bodies on the ends of a rope that runs over two points of the world, `distance1 + ratio · distance2 ≤ length`
     * with the distances of the anchors from these points. With a ratio of 2 the second body hangs on a loop of two
     * strands: it moves half as far as the first one, and gets twice the force.
     */
    static pulley(anchor1: Vector, anchor2: Vector, over1: Vector, over2: Vector, length: number, ratio: number): JointData {
        const data = new JointData(JointType.Pulley, anchor1, anchor2);
        data.over1 = over1;
        data.over2 = over2;
        data.length = length;
        data.ratio = ratio;
        return data;
    }

    /** A joint that locks some axes of a frame whose x axis is given. */
    static generic(anchor1: Vector, anchor2: Vector, axis: Vector, axesMask: JointAxesMask): JointData {
        const data = new JointData(6, anchor1, anchor2).withAxes(axis, axis);
        data.axesMask = axesMask;
        return data;
    }

    /** A ball in a socket (3D). */
    static spherical(anchor1: Vector, anchor2: Vector): JointData {
        return new JointData(SPHERICAL, anchor1, anchor2);
    }

    /** A slider along an axis. */
    static prismatic(anchor1: Vector, anchor2: Vector, axis: Vector): JointData {
        return new JointData(JointType.Prismatic, anchor1, anchor2).withAxes(axis, axis);
    }

    /** A hinge. In 3D the axis is the same in the frames of both bodies. */
    static revolute(anchor1: Vector, anchor2: Vector, axis: Vector = xAxis()): JointData {
        return new JointData(JointType.Revolute, anchor1, anchor2).withAxes(axis, axis);
    }

    /** A hinge about an axis in the frame of each body. */
    static revoluteWithAxes(anchor1: Vector, anchor2: Vector, axis1: Vector, axis2: Vector): JointData {
        requireObject(axis1, "axis1", "a vector");
        requireObject(axis2, "axis2", "a vector");
        return new JointData(JointType.Revolute, anchor1, anchor2).withAxes(axis1, axis2);
    }

    /** @internal Creates the joint. Returns its handle. */
    create(world: number, set: number, body1: RigidBodyHandle, body2: RigidBodyHandle, wakeUp: boolean): number {
        putVector(0, this.anchor1, "anchor1");
        putVector(1, this.anchor2, "anchor2");
        if (this.jointType === JointType.Fixed) {
            putRotation(2, this.frame1, "frame1");
            putRotation(3, this.frame2, "frame2");
        } else {
            // A program may set the one axis, or both.
            putVector(2, this.axis1 ?? this.axis, "axis1");
            putVector(3, this.axis2 ?? this.axis, "axis2");
        }
        putNumber(4, 0, real(this.length, "length"));
        putNumber(4, 1, real(this.stiffness, "stiffness"));
        putNumber(4, 2, real(this.damping, "damping"));
        putNumber(5, 0, this.limits[0] ?? NaN);
        putNumber(5, 1, this.limits[1] ?? NaN);
        putNumber(4, 3, real(this.ratio, "ratio"));
        putNumber(5, 2, real(this.radius, "radius"));
        putVector(6, this.over1, "over1");
        putVector(7, this.over2, "over2");
        return raw.joint_create(world, set, integer(this.jointType, "jointType"), integer(this.axesMask, "axesMask"), +this.limitsEnabled, body1, body2, +wakeUp);
    }
}

function xAxis(): Vector {
    const axis = VectorOps.zeros();
    axis.x = 1;
    return axis;
}

type Maker<T> = new (world: World, handle: number) => T;

const IMPULSE_JOINTS: Record<number, Maker<ImpulseJoint>> = {
    [JointType.Revolute]: RevoluteImpulseJoint,
    [JointType.Fixed]: FixedImpulseJoint,
    [JointType.Prismatic]: PrismaticImpulseJoint,
    [JointType.Rope]: RopeImpulseJoint,
    [JointType.Spring]: SpringImpulseJoint,
    [SPHERICAL]: SphericalImpulseJoint,
    [JointType.Gear]: GearImpulseJoint,
    [JointType.Rack]: RackImpulseJoint,
    [JointType.Pulley]: PulleyImpulseJoint,
};

const MULTIBODY_JOINTS: Record<number, Maker<MultibodyJoint>> = {
    [JointType.Revolute]: RevoluteMultibodyJoint,
    [JointType.Fixed]: FixedMultibodyJoint,
    [JointType.Prismatic]: PrismaticMultibodyJoint,
    [SPHERICAL]: SphericalMultibodyJoint,
};

/** The joints of a set. */
abstract class JointSet<T extends Joint> {
    /** @internal */
    readonly world: World;
    private readonly set: number;
    private readonly map = new Map<number, T>();

    /** @internal */
    constructor(world: World, set: number) {
        this.world = world;
        this.set = set;
    }

    /** The object of a joint. */
    protected abstract make(kind: number, handle: number): T;

    /** Joins two bodies. */
    protected insert(desc: JointData, parent1: RigidBodyHandle, parent2: RigidBodyHandle, wakeUp: boolean): T {
        requireClass(desc, JointData, "params", "a JointData");
        const handle = desc.create(this.world.id, this.set, parent1, parent2, wakeUp);
        const joint = this.make(desc.jointType, handle);
        this.map.set(handle, joint);
        return joint;
    }

    /** @internal The object of a joint that is in the module. */
    adopt(handle: number): void {
        this.map.set(handle, this.make(raw.joint_kind(this.world.id, this.set, handle), handle));
    }

    /** Removes a joint. A stale handle has no effect, as any in a freed world. */
    remove(handle: number, wakeUp = true): void {
        if (!this.world.isAlive()) {
            return;
        }
        raw.joint_remove(this.world.id, this.set, handle, +wakeUp);
        this.map.delete(handle);
    }

    /** Calls a function with the handle of each joint of a body. */
    forEachJointHandleAttachedToRigidBody(handle: RigidBodyHandle, f: (handle: number) => void): void {
        requireFunction(f, "f");
        listCopy(raw.joints_of_body(this.world.id, this.set, handle)).forEach((joint) => f(joint));
    }

    /** Removes the object of a joint that the module no longer contains. */
    unmap(handle: number): void {
        this.map.delete(handle);
    }

    /** The number of joints. */
    len(): number {
        return this.map.size;
    }

    /** Returns whether a handle finds a joint. */
    contains(handle: number): boolean {
        return this.map.has(handle);
    }

    /** The joint of a handle, or null. */
    get(handle: number): T | null {
        return this.map.get(handle) ?? null;
    }

    /** Calls a function with each joint. */
    forEach(f: (joint: T) => void): void {
        requireFunction(f, "f");
        this.map.forEach((joint) => f(joint));
    }

    /** All joints. */
    getAll(): T[] {
        return [...this.map.values()];
    }

    /** @internal */
    clear(): void {
        this.map.clear();
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}

/** The impulse joints of a world. */
export class ImpulseJointSet extends JointSet<ImpulseJoint> {
    /** @internal Worlds make their sets. */
    constructor(world: World) {
        super(world, Set.impulse);
    }

    protected make(kind: number, handle: number): ImpulseJoint {
        return new (IMPULSE_JOINTS[kind] ?? GenericImpulseJoint)(this.world, handle);
    }

    /** Joins two bodies. */
    createJoint(_bodies: unknown, desc: JointData, parent1: RigidBodyHandle, parent2: RigidBodyHandle, wakeUp: boolean): ImpulseJoint {
        return this.insert(desc, parent1, parent2, wakeUp);
    }
}

/** The multibody joints of a world. */
export class MultibodyJointSet extends JointSet<MultibodyJoint> {
    /** @internal Worlds make their sets. */
    constructor(world: World) {
        super(world, Set.multibody);
    }

    protected make(kind: number, handle: number): MultibodyJoint {
        return new (MULTIBODY_JOINTS[kind] ?? MultibodyJoint)(this.world, handle);
    }

    /** Makes the second body a child of the first one. */
    createJoint(desc: JointData, parent1: RigidBodyHandle, parent2: RigidBodyHandle, wakeUp: boolean): MultibodyJoint {
        return this.insert(desc, parent1, parent2, wakeUp);
    }
}
