// Parts that depend on the dimension: vectors, rotations, and enumerations. dim3.ts has the same names.

import { real, requireComponents, requireList, requireObject, wrong } from "./arguments.js";
import { scratch } from "./raw.js";
import type { RealArray } from "#real";

/** The number of dimensions. */
export const DIM = 2;
/** Numbers of a rotation. */
export const ROTATION = 1;
/** Numbers of an angular velocity. */
export const ANGULAR = 1;

/** A vector. */
export interface Vector {
    x: number;
    y: number;
}

/** The components of a vector as arguments. */
export type Components = [x: number, y: number];
/** One flag for each axis, as arguments. */
export type AxisFlags = [enableX: boolean, enableY: boolean];
/** The same, with a last argument. */
export type AxisFlagsAndWakeUp = [enableX: boolean, enableY: boolean, wakeUp: boolean];
/** Half the sides of a box as arguments. */
export type HalfExtents = [hx: number, hy: number];
/** Half the sides of a box and its border as arguments. */
export type HalfExtentsAndBorder = [hx: number, hy: number, borderRadius: number];
/** Mass properties as arguments. */
export type MassProperties = [mass: number, centerOfMass: Vector, principalAngularInertia: number];
/** Mass properties as arguments, with a last one. */
export type MassPropertiesAndWakeUp = [mass: number, centerOfMass: Vector, principalAngularInertia: number, wakeUp: boolean];

/** A vector. */
export class Vector2 implements Vector {
    x: number;
    y: number;

    constructor(x: number, y: number) {
        this.x = x;
        this.y = y;
    }
}

/** Operations on vectors. */
export class VectorOps {
    /** A vector from its components. */
    static new(x: number, y: number): Vector {
        return new Vector2(x, y);
    }

    /** The zero vector. */
    static zeros(): Vector {
        return new Vector2(0, 0);
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
    }
}

/** A rotation: an angle in radians. */
export type Rotation = number;

/** Operations on rotations. */
export class RotationOps {
    /** The rotation by no angle. */
    static identity(): number {
        return 0;
    }
}

/** An angular velocity, torque or principal inertia. */
export type AngVector = number;

/** An angular inertia. */
export type AngularInertia = number;

function fill(target: Vector, numbers: ArrayLike<number>, at: number): Vector {
    requireVector(target, "target");
    target.x = numbers[at]!;
    target.y = numbers[at + 1]!;
    return target;
}

function requireVector(value: unknown, name: string): void {
    requireObject(value, name, "an object with x and y");
}

/** Copies the components of a vector argument to a position of an array. */
function store(numbers: { [index: number]: number }, at: number, vector: Vector, name: string): void {
    requireVector(vector, name);
    const { x, y } = vector;
    if (!(Number.isFinite(x) && Number.isFinite(y))) {
        requireComponents([x, y], name);
    }
    numbers[at] = x;
    numbers[at + 1] = y;
}

/** A copy of a vector. Vectors of other libraries may have accessors, which a spread omits. */
export function copyVector(vector: Vector, name: string): Vector {
    requireVector(vector, name);
    return new Vector2(vector.x, vector.y);
}

/** An angle, angular velocity or inertia argument. */
function finite(value: number, name: string): number {
    if (!Number.isFinite(real(value, name))) {
        throw wrong(name, value, "a finite number");
    }
    return value;
}

/** A copy of an angular quantity. In 2D it is a number. */
export function copyAngular(value: AngVector, name: string): AngVector {
    return real(value, name);
}

/** A copy of a rotation. In 2D it is a number. */
export function copyRotation(rotation: Rotation, name: string): Rotation {
    return real(rotation, name);
}

/** The vector at a position of an array. */
export function vectorAt(numbers: ArrayLike<number>, at: number, target?: Vector): Vector {
    return fill(target ?? VectorOps.zeros(), numbers, at);
}

/** The rotation at a position of an array. */
export function rotationAt(numbers: ArrayLike<number>, at: number, _target?: Rotation): Rotation {
    return numbers[at]!;
}

/** Writes the rotation between two at a position of arrays: the shorter way round, `share` of it. */
export function blendRotation(out: RealArray, at: number, from: ArrayLike<number>, to: ArrayLike<number>, share: number): void {
    const turn = to[at]! - from[at]!;
    out[at] = from[at]! + (turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI))) * share;
}

/** Appends the components of a vector. */
export function pushVector(numbers: number[], vector: Vector, name: string): void {
    store(numbers, numbers.length, vector, name);
}

/** Appends the components of a rotation. */
export function pushRotation(numbers: number[], rotation: Rotation, name: string): void {
    numbers.push(finite(rotation, name));
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
    scratch()[4 * place] = finite(rotation, name);
}

/** Reads a rotation of the scratch block. */
export function getRotation(place: number, _target?: Rotation): Rotation {
    return scratch()[4 * place]!;
}

/** Writes an angular quantity into the scratch block. */
export const putAngular: (place: number, value: AngVector, name: string) => void = putRotation;

/** Reads an angular quantity of the scratch block. */
export const getAngular: (place: number, target?: AngVector) => AngVector = getRotation;

/** Reads an angular inertia of the scratch block. */
export function getAngularInertia(_target?: AngularInertia): AngularInertia {
    return scratch()[0]!;
}

/** An angular quantity of zero. */
export function zeroAngular(): AngVector {
    return 0;
}

/** A point of a ray. */
export function alongRay(origin: Vector, dir: Vector, t: number): Vector {
    return new Vector2(origin.x + dir.x * t, origin.y + dir.y * t);
}

/** Writes mass properties into the scratch block: three places. */
export function putMassProperties(place: number, [mass, centerOfMass, inertia]: MassProperties): void {
    real(mass, "mass");
    putVector(place, centerOfMass, "centerOfMass");
    putAngular(place + 1, inertia, "principalAngularInertia");
}

/** A vector from arguments. */
export function vectorOf([x, y]: Components): Vector {
    return new Vector2(x, y);
}

/** The bits of axes that are not enabled. */
export function lockedBits([x, y]: AxisFlags): number {
    return Number(!x) | (Number(!y) << 1);
}

/** The elements before the last one, and the last one. */
export function splitLast<T, L>(list: readonly [...T[], L]): [T[], L] {
    return [list.slice(0, -1) as T[], list[list.length - 1] as L];
}

/** Bits of all translations among the locked axes. */
export const TRANSLATIONS = 0b11;
/** Bits of all rotations among the locked axes. */
export const ROTATIONS = 0b100_000;
/** The lowest bit of the rotations. */
export const ROTATION_SHIFT = 5;

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
    ConvexPolygon = 9,
    RoundCuboid = 10,
    RoundTriangle = 11,
    RoundConvexPolygon = 12,
    HalfSpace = 13,
    Voxels = 14,
}

/** The kinds of shapes by the numbers of the module. */
export const SHAPE_TYPES: readonly (ShapeType | undefined)[] = [
    ShapeType.Ball,
    ShapeType.Cuboid,
    ShapeType.Capsule,
    ShapeType.Segment,
    ShapeType.Polyline,
    ShapeType.Triangle,
    ShapeType.TriMesh,
    ShapeType.HeightField,
    ShapeType.Compound,
    ShapeType.ConvexPolygon,
    undefined,
    undefined,
    ShapeType.RoundCuboid,
    ShapeType.RoundTriangle,
    undefined,
    undefined,
    ShapeType.RoundConvexPolygon,
    ShapeType.HalfSpace,
    ShapeType.Voxels,
];

/** The parts of a shape that a query can hit. */
export enum FeatureType {
    Vertex = 0,
    Face = 1,
    Unknown = 2,
}

/** The features by the numbers of the module: vertex, edge, face, unknown. */
export const FEATURE_TYPES = [FeatureType.Vertex, FeatureType.Face, FeatureType.Face, FeatureType.Unknown] as const;

/** The axes of a joint. */
export enum JointAxis {
    LinX = 0,
    LinY = 1,
    AngX = 2,
}

/** Sets of axes of a joint. The values are those of 3D. */
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
    AngZ = 32,
    AllLin = 3,
    AllAng = 32,
    All = 35,
}

/** The kinds of joints. */
export enum JointType {
    Revolute = 0,
    Fixed = 1,
    Prismatic = 2,
    Rope = 3,
    Spring = 4,
    Generic = 6,
    Gear = 7,
    Rack = 8,
    Pulley = 9,
}

/** Arguments of gears. */
export type GearArguments = [ratio: number];
/** Arguments of a pinion and a rack: the axis of the rack, in its body's frame. */
export type RackArguments = [axis: Vector, radius: number];

/** The axes of gears, and their ratio. */
export function gearParts([ratio]: GearArguments): [axis1: Vector, axis2: Vector, ratio: number] {
    return [new Vector2(1, 0), new Vector2(1, 0), ratio];
}

/** The axes of a pinion and a rack, and the radius. */
export function rackParts([axis, radius]: RackArguments): [axis1: Vector, axis2: Vector, radius: number] {
    requireVector(axis, "axis");
    return [axis, axis, radius];
}

/** The axis of the rotation of a revolute joint. */
export const ANGULAR_AXIS = JointAxis.AngX;

/** Options for lines of segments. */
export enum PolylineFlags {
    ORIENTED = 1,
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
export type VoxelArguments = [ix: number, iy: number, filled: boolean];
/** Coordinates of a voxel and a shift as arguments. */
export type VoxelAndShift = [ix: number, iy: number, shift_x: number, shift_y: number];
/** A shift of voxels as arguments. */
export type VoxelShift = [shift_x: number, shift_y: number];
