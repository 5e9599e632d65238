// Parts that depend on the dimension: vectors, rotations, and enumerations. dim2.ts has the same names.

import { real, requireClass, requireComponents, requireList, requireObject } from "./arguments.js";
import { scratch } from "./raw.js";
import type { RealArray } from "#real";

/** The number of dimensions. */
export const DIM = 3;
/** Numbers of a rotation. */
export const ROTATION = 4;
/** Numbers of an angular velocity. */
export const ANGULAR = 3;

/** A vector. */
export interface Vector {
    x: number;
    y: number;
    z: number;
}

/** The components of a vector as arguments. */
export type Components = [x: number, y: number, z: number];
/** One flag for each axis, as arguments. */
export type AxisFlags = [enableX: boolean, enableY: boolean, enableZ: boolean];
/** The same, with a last argument. */
export type AxisFlagsAndWakeUp = [enableX: boolean, enableY: boolean, enableZ: boolean, wakeUp: boolean];
/** Half the sides of a box as arguments. */
export type HalfExtents = [hx: number, hy: number, hz: number];
/** Half the sides of a box and its border as arguments. */
export type HalfExtentsAndBorder = [hx: number, hy: number, hz: number, borderRadius: number];
/** Mass properties as arguments. */
export type MassProperties = [mass: number, centerOfMass: Vector, principalAngularInertia: Vector, angularInertiaLocalFrame: Rotation];
/** Mass properties as arguments, with a last one. */
export type MassPropertiesAndWakeUp = [
    mass: number,
    centerOfMass: Vector,
    principalAngularInertia: Vector,
    angularInertiaLocalFrame: Rotation,
    wakeUp: boolean,
];

/** A vector. */
export class Vector3 implements Vector {
    x: number;
    y: number;
    z: number;

    constructor(x: number, y: number, z: number) {
        this.x = x;
        this.y = y;
        this.z = z;
    }
}

/** Operations on vectors. */
export class VectorOps {
    /** A vector from its components. */
    static new(x: number, y: number, z: number): Vector {
        return new Vector3(x, y, z);
    }

    /** The zero vector. */
    static zeros(): Vector {
        return new Vector3(0, 0, 0);
    }

    /** The vector at the beginning of an array. */
    static fromBuffer(buffer: ArrayLike<number>, target?: Vector): Vector {
        requireList(buffer, "buffer");
        return fill(target ?? VectorOps.zeros(), buffer, 0);
    }

    /** Copies a vector into another one. */
    static copy(out: Vector, input: Vector): void {
        requireVector(out, "out");
        requireVector(input, "input");
        out.x = input.x;
        out.y = input.y;
        out.z = input.z;
    }
}

/** A rotation: a quaternion of unit length. */
export interface Rotation {
    x: number;
    y: number;
    z: number;
    w: number;
}

/** A quaternion. */
export class Quaternion implements Rotation {
    x: number;
    y: number;
    z: number;
    w: number;

    constructor(x: number, y: number, z: number, w: number) {
        this.x = x;
        this.y = y;
        this.z = z;
        this.w = w;
    }
}

/** Operations on rotations. */
export class RotationOps {
    /** The rotation by no angle. */
    static identity(): Rotation {
        return new Quaternion(0, 0, 0, 1);
    }

    /** The rotation at the beginning of an array. */
    static fromBuffer(buffer: ArrayLike<number>, target?: Rotation): Rotation {
        requireList(buffer, "buffer");
        return fillRotation(target ?? RotationOps.identity(), buffer, 0);
    }

    /** Copies a rotation into another one. */
    static copy(out: Rotation, input: Rotation): void {
        requireRotation(out, "out");
        requireRotation(input, "input");
        out.x = input.x;
        out.y = input.y;
        out.z = input.z;
        out.w = input.w;
    }
}

/** An angular velocity, torque or principal inertia. */
export type AngVector = Vector;

/** A symmetric matrix of three rows. */
export class SdpMatrix3 {
    /** The upper triangle by rows: m11, m12, m13, m22, m23, m33. */
    elements: Float32Array | Float64Array;

    constructor(elements: Float32Array | Float64Array) {
        this.elements = elements;
    }

    get m11(): number {
        return this.elements[0]!;
    }

    get m12(): number {
        return this.elements[1]!;
    }

    get m21(): number {
        return this.m12;
    }

    get m13(): number {
        return this.elements[2]!;
    }

    get m31(): number {
        return this.m13;
    }

    get m22(): number {
        return this.elements[3]!;
    }

    get m23(): number {
        return this.elements[4]!;
    }

    get m32(): number {
        return this.m23;
    }

    get m33(): number {
        return this.elements[5]!;
    }
}

/** Operations on symmetric matrices. */
export class SdpMatrix3Ops {
    /** The matrix at the beginning of an array. */
    static fromBuffer(buffer: Float32Array | Float64Array, target?: SdpMatrix3): SdpMatrix3 {
        requireList(buffer, "buffer");
        const matrix = target ?? new SdpMatrix3(buffer.slice(0, 6));
        requireClass(matrix, SdpMatrix3, "target", "an SdpMatrix3");
        matrix.elements.set(buffer.subarray(0, 6));
        return matrix;
    }
}

/** An angular inertia. */
export type AngularInertia = SdpMatrix3;

function fill(target: Vector, numbers: ArrayLike<number>, at: number): Vector {
    requireVector(target, "target");
    target.x = numbers[at]!;
    target.y = numbers[at + 1]!;
    target.z = numbers[at + 2]!;
    return target;
}

function fillRotation(target: Rotation, numbers: ArrayLike<number>, at: number): Rotation {
    requireRotation(target, "target");
    target.x = numbers[at]!;
    target.y = numbers[at + 1]!;
    target.z = numbers[at + 2]!;
    target.w = numbers[at + 3]!;
    return target;
}

function requireVector(value: unknown, name: string): void {
    requireObject(value, name, "an object with x, y and z");
}

function requireRotation(value: unknown, name: string): void {
    requireObject(value, name, "an object with x, y, z and w");
}

/** Copies the components of a vector argument to a position of an array. */
function store(numbers: { [index: number]: number }, at: number, vector: Vector, name: string): void {
    requireVector(vector, name);
    const { x, y, z } = vector;
    if (!(Number.isFinite(x) && Number.isFinite(y) && Number.isFinite(z))) {
        requireComponents([x, y, z], name);
    }
    numbers[at] = x;
    numbers[at + 1] = y;
    numbers[at + 2] = z;
}

/** Copies the components of a rotation argument to a position of an array. */
function storeRotation(numbers: { [index: number]: number }, at: number, rotation: Rotation, name: string): void {
    requireRotation(rotation, name);
    const { x, y, z, w } = rotation;
    if (!(Number.isFinite(x) && Number.isFinite(y) && Number.isFinite(z) && Number.isFinite(w))) {
        requireComponents([x, y, z, w], name);
    }
    numbers[at] = x;
    numbers[at + 1] = y;
    numbers[at + 2] = z;
    numbers[at + 3] = w;
}

/** A copy of a vector. Vectors of other libraries may have accessors, which a spread omits. */
export function copyVector(vector: Vector, name: string): Vector {
    requireVector(vector, name);
    return new Vector3(vector.x, vector.y, vector.z);
}

/** A copy of an angular quantity. */
export const copyAngular: (value: AngVector, name: string) => AngVector = copyVector;

/** A copy of a rotation. */
export function copyRotation(rotation: Rotation, name: string): Rotation {
    requireRotation(rotation, name);
    return new Quaternion(rotation.x, rotation.y, rotation.z, rotation.w);
}

/** The vector at a position of an array. */
export function vectorAt(numbers: ArrayLike<number>, at: number, target?: Vector): Vector {
    return fill(target ?? VectorOps.zeros(), numbers, at);
}

/** The rotation at a position of an array. */
export function rotationAt(numbers: ArrayLike<number>, at: number, target?: Rotation): Rotation {
    return fillRotation(target ?? RotationOps.identity(), numbers, at);
}

/** Writes the rotation between two at a position of arrays: the shorter way round, `share` of it. */
export function blendRotation(out: RealArray, at: number, from: ArrayLike<number>, to: ArrayLike<number>, share: number): void {
    let [dot, square] = [0, 0];
    for (let component = at; component < at + ROTATION; component += 1) {
        dot += from[component]! * to[component]!;
    }
    const end = dot < 0 ? -share : share;
    for (let component = at; component < at + ROTATION; component += 1) {
        const value = from[component]! * (1 - share) + to[component]! * end;
        out[component] = value;
        square += value * value;
    }
    const scale = 1 / Math.sqrt(square);
    for (let component = at; component < at + ROTATION; component += 1) {
        out[component] = out[component]! * scale;
    }
}

/** Appends the components of a vector. */
export function pushVector(numbers: number[], vector: Vector, name: string): void {
    store(numbers, numbers.length, vector, name);
}

/** Appends the components of a rotation. */
export function pushRotation(numbers: number[], rotation: Rotation, name: string): void {
    storeRotation(numbers, numbers.length, rotation, name);
}

/** Writes a vector into the scratch block. The name is for the error of another value. */
export function putVector(place: number, vector: Vector, name: string): void {
    store(scratch(), 4 * place, vector, name);
}

/** Reads a vector of the scratch block. */
export function getVector(place: number, target?: Vector): Vector {
    return fill(target ?? VectorOps.zeros(), scratch(), 4 * place);
}

/** Writes a rotation into the scratch block. */
export function putRotation(place: number, rotation: Rotation, name: string): void {
    storeRotation(scratch(), 4 * place, rotation, name);
}

/** Reads a rotation of the scratch block. */
export function getRotation(place: number, target?: Rotation): Rotation {
    return fillRotation(target ?? RotationOps.identity(), scratch(), 4 * place);
}

/** Writes an angular quantity into the scratch block. */
export const putAngular: (place: number, value: AngVector, name: string) => void = putVector;

/** Reads an angular quantity of the scratch block. */
export const getAngular: (place: number, target?: AngVector) => AngVector = getVector;

/** Reads an angular inertia of the scratch block. */
export function getAngularInertia(target?: AngularInertia): AngularInertia {
    return SdpMatrix3Ops.fromBuffer(scratch(), target);
}

/** An angular quantity of zero. */
export function zeroAngular(): AngVector {
    return VectorOps.zeros();
}

/** A point of a ray. */
export function alongRay(origin: Vector, dir: Vector, t: number): Vector {
    return new Vector3(origin.x + dir.x * t, origin.y + dir.y * t, origin.z + dir.z * t);
}

/** Writes mass properties into the scratch block: three places. */
export function putMassProperties(place: number, [mass, centerOfMass, inertia, frame]: MassProperties): void {
    real(mass, "mass");
    putVector(place, centerOfMass, "centerOfMass");
    putAngular(place + 1, inertia, "principalAngularInertia");
    putRotation(place + 2, frame, "angularInertiaLocalFrame");
}

/** A vector from arguments. */
export function vectorOf([x, y, z]: Components): Vector {
    return new Vector3(x, y, z);
}

/** The bits of axes that are not enabled. */
export function lockedBits([x, y, z]: AxisFlags): number {
    return Number(!x) | (Number(!y) << 1) | (Number(!z) << 2);
}

/** The elements before the last one, and the last one. */
export function splitLast<T, L>(list: readonly [...T[], L]): [T[], L] {
    return [list.slice(0, -1) as T[], list[list.length - 1] as L];
}

/** Bits of all translations among the locked axes. */
export const TRANSLATIONS = 0b111;
/** Bits of all rotations among the locked axes. */
export const ROTATIONS = 0b111_000;
/** The lowest bit of the rotations. */
export const ROTATION_SHIFT = 3;

/** The kinds of shapes. */
export enum ShapeType {
    Ball = 0,
    Cuboid = 1,
    Capsule = 2,
    Segment = 3,
    Polyline = 4,
    Triangle = 5,
    TriMesh = 6,
    HeightField = 7,
    Compound = 8,
    ConvexPolyhedron = 9,
    Cylinder = 10,
    Cone = 11,
    RoundCuboid = 12,
    RoundTriangle = 13,
    RoundCylinder = 14,
    RoundCone = 15,
    RoundConvexPolyhedron = 16,
    HalfSpace = 17,
    Voxels = 18,
}

/** The kinds of shapes by the numbers of the module. */
export const SHAPE_TYPES: readonly ShapeType[] = Array.from({ length: 19 }, (_, code) => code);

/** The parts of a shape that a query can hit. */
export enum FeatureType {
    Vertex = 0,
    Edge = 1,
    Face = 2,
    Unknown = 3,
}

/** The features by the numbers of the module: vertex, edge, face, unknown. */
export const FEATURE_TYPES = [FeatureType.Vertex, FeatureType.Edge, FeatureType.Face, FeatureType.Unknown] as const;

/** The axes of a joint. */
export enum JointAxis {
    LinX = 0,
    LinY = 1,
    LinZ = 2,
    AngX = 3,
    AngY = 4,
    AngZ = 5,
}

/** Sets of axes of a joint. */
export enum JointAxesMask {
    LinX = 1,
    LinY = 2,
    LinZ = 4,
    AngX = 8,
    AngY = 16,
    AngZ = 32,
}

/** Sets of axes that a PID controller corrects. */
export enum PidAxesMask {
    None = 0,
    LinX = 1,
    LinY = 2,
    LinZ = 4,
    AngX = 8,
    AngY = 16,
    AngZ = 32,
    AllLin = 7,
    AllAng = 56,
    All = 63,
}

/** The kinds of joints. */
export enum JointType {
    Revolute = 0,
    Fixed = 1,
    Prismatic = 2,
    Rope = 3,
    Spring = 4,
    Spherical = 5,
    Generic = 6,
    Gear = 7,
    Rack = 8,
    Pulley = 9,
}

/** Arguments of gears: the axis of each wheel, in its body's frame. */
export type GearArguments = [axis1: Vector, axis2: Vector, ratio: number];
/** Arguments of a pinion and a rack: the axes of both, each in its body's frame. */
export type RackArguments = [axis1: Vector, axis2: Vector, radius: number];

/** The axes of gears, and their ratio. */
export function gearParts([axis1, axis2, ratio]: GearArguments): [axis1: Vector, axis2: Vector, ratio: number] {
    requireVector(axis1, "axis1");
    requireVector(axis2, "axis2");
    return [axis1, axis2, ratio];
}

/** The axes of a pinion and a rack, and the radius. */
export const rackParts: (parts: RackArguments) => [axis1: Vector, axis2: Vector, radius: number] = gearParts;

/** The axis of the rotation of a revolute joint. */
export const ANGULAR_AXIS = JointAxis.AngX;

/** Options for lines of segments. */
export enum PolylineFlags {
    DEFORMABLE = 2,
}

/** Options for triangle meshes. */
export enum TriMeshFlags {
    DELETE_BAD_TOPOLOGY_TRIANGLES = 4,
    ORIENTED = 8,
    MERGE_DUPLICATE_VERTICES = 16,
    DELETE_DEGENERATE_TRIANGLES = 32,
    DELETE_DUPLICATE_TRIANGLES = 64,
    FIX_INTERNAL_EDGES = 144,
    DEFORMABLE = 256,
    FIX_INTERNAL_EDGES_TWO_SIDED = 656,
}

/** The coordinates of a voxel, and whether it is filled, as arguments. */
export type VoxelArguments = [ix: number, iy: number, iz: number, filled: boolean];
/** Coordinates of a voxel and a shift as arguments. */
export type VoxelAndShift = [ix: number, iy: number, iz: number, shift_x: number, shift_y: number, shift_z: number];
/** A shift of voxels as arguments. */
export type VoxelShift = [shift_x: number, shift_y: number, shift_z: number];
