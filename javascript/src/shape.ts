// Shapes that both dimensions have. shape2.ts and shape3.ts add their own.

import {
    type Components,
    DIM,
    type PolylineFlags,
    ROTATION,
    type Rotation,
    ShapeType,
    type TriMeshFlags,
    type Vector,
    getVector,
    pushRotation,
    pushVector,
    putRotation,
    putVector,
    rotationAt,
    vectorAt,
    vectorOf,
} from "#dim";
import { integer, real, requireClass, requireLimits, requireList, requireObject } from "./arguments.js";
import { RapierError } from "./error.js";
import { PointProjection, type Ray, RayIntersection, ShapeCastHit, ShapeContact, putRay } from "./geometry_results.js";
import { getNumber, integersCopy, putIntegers, putNumber, putReals, raw, realsCopy } from "./raw.js";
import type { RealArray } from "#real";

/** The kinds of shapes in the module: crates/wasm/src/shape.rs. */
export const Code = {
    ball: 0,
    cuboid: 1,
    capsule: 2,
    segment: 3,
    polyline: 4,
    triangle: 5,
    trimesh: 6,
    heightfield: 7,
    compound: 8,
    convex: 9,
    cylinder: 10,
    cone: 11,
    roundCuboid: 12,
    roundTriangle: 13,
    roundCylinder: 14,
    roundCone: 15,
    roundConvex: 16,
    halfspace: 17,
    voxels: 18,
    decomposition: 19,
} as const;

/** The place of radius, half height and border radius, and of flags. */
export const SIZES = 3;

/** Options for height fields. */
export enum HeightFieldFlags {
    FIX_INTERNAL_EDGES = 1,
}

/** Options for compounds. */
export enum CompoundFlags {
    FIX_INTERNAL_EDGES = 1,
}

/** Writes radius, half height and border radius. */
export function putSizes(radius: number, halfHeight = 0, borderRadius = 0): void {
    putNumber(SIZES, 0, radius);
    putNumber(SIZES, 1, halfHeight);
    putNumber(SIZES, 2, borderRadius);
}

/** Writes the pose of a shape. */
export function putPose(place: number, position: Vector, rotation: Rotation, names: readonly [position: string, rotation: string]): void {
    putVector(place, position, names[0]);
    putRotation(place + 1, rotation, names[1]);
}

/** A geometric shape. */
export abstract class Shape {
    /** The kind of the shape. */
    abstract get type(): ShapeType;

    /** @internal Makes the shape in the module. Returns its number. */
    abstract register(): number;

    /** The hit of this shape and another one, both moving. */
    castShape(
        shapePos1: Vector,
        shapeRot1: Rotation,
        shapeVel1: Vector,
        shape2: Shape,
        shapePos2: Vector,
        shapeRot2: Rotation,
        shapeVel2: Vector,
        targetDistance: number,
        maxToi: number,
        stopAtPenetration: boolean,
        target?: ShapeCastHit,
    ): ShapeCastHit | null {
        requireLimits(targetDistance, maxToi);
        return this.use((one) =>
            useShape(shape2, "shape2", (other) => {
                putPose(8, shapePos1, shapeRot1, ["shapePos1", "shapeRot1"]);
                putPose(10, shapePos2, shapeRot2, ["shapePos2", "shapeRot2"]);
                putVector(0, shapeVel1, "shapeVel1");
                putVector(1, shapeVel2, "shapeVel2");
                const hits = raw.subjects_cast(0, one, 0, other, targetDistance, maxToi, +stopAtPenetration);
                return hits ? ShapeCastHit.read(target) : null;
            }),
        );
    }

    /** Returns whether this shape and another one touch. */
    intersectsShape(shapePos1: Vector, shapeRot1: Rotation, shape2: Shape, shapePos2: Vector, shapeRot2: Rotation): boolean {
        return this.use((one) =>
            useShape(shape2, "shape2", (other) => {
                putPose(8, shapePos1, shapeRot1, ["shapePos1", "shapeRot1"]);
                putPose(10, shapePos2, shapeRot2, ["shapePos2", "shapeRot2"]);
                return raw.subjects_intersect(0, one, 0, other) !== 0;
            }),
        );
    }

    /** The contact of this shape and another one, or null if they are farther apart than the prediction. */
    contactShape(
        shapePos1: Vector,
        shapeRot1: Rotation,
        shape2: Shape,
        shapePos2: Vector,
        shapeRot2: Rotation,
        prediction: number,
        target?: ShapeContact,
    ): ShapeContact | null {
        return this.use((one) =>
            useShape(shape2, "shape2", (other) => {
                putPose(8, shapePos1, shapeRot1, ["shapePos1", "shapeRot1"]);
                putPose(10, shapePos2, shapeRot2, ["shapePos2", "shapeRot2"]);
                return raw.subjects_contact(0, one, 0, other, real(prediction, "prediction")) ? ShapeContact.read(target) : null;
            }),
        );
    }

    /** Returns whether a point is inside the shape. */
    containsPoint(shapePos: Vector, shapeRot: Rotation, point: Vector): boolean {
        return this.use((number) => {
            putPose(8, shapePos, shapeRot, ["shapePos", "shapeRot"]);
            putVector(0, point, "point");
            return raw.subject_contains_point(0, number) !== 0;
        });
    }

    /** The point of the shape that is nearest to a point. */
    projectPoint(shapePos: Vector, shapeRot: Rotation, point: Vector, solid: boolean, target?: PointProjection): PointProjection {
        return this.use((number) => {
            putPose(8, shapePos, shapeRot, ["shapePos", "shapeRot"]);
            putVector(0, point, "point");
            return PointProjection.read(raw.subject_project_point(0, number, +solid) !== 0, target);
        });
    }

    /** Returns whether a ray hits the shape. */
    intersectsRay(ray: Ray, shapePos: Vector, shapeRot: Rotation, maxToi: number): boolean {
        return this.use((number) => {
            putPose(8, shapePos, shapeRot, ["shapePos", "shapeRot"]);
            putRay(ray);
            return raw.subject_intersects_ray(0, number, real(maxToi, "maxToi")) !== 0;
        });
    }

    /** The time at which a ray hits the shape, or -1. */
    castRay(ray: Ray, shapePos: Vector, shapeRot: Rotation, maxToi: number, solid: boolean): number {
        return this.use((number) => {
            putPose(8, shapePos, shapeRot, ["shapePos", "shapeRot"]);
            putRay(ray);
            return raw.subject_cast_ray(0, number, real(maxToi, "maxToi"), +solid);
        });
    }

    /** The hit of a ray on the shape. Null if there is none. */
    castRayAndGetNormal(
        ray: Ray,
        shapePos: Vector,
        shapeRot: Rotation,
        maxToi: number,
        solid: boolean,
        target?: RayIntersection,
    ): RayIntersection {
        return this.use((number) => {
            putPose(8, shapePos, shapeRot, ["shapePos", "shapeRot"]);
            putRay(ray);
            return raw.subject_cast_ray_and_get_normal(0, number, real(maxToi, "maxToi"), +solid) ? RayIntersection.read(target) : null!;
        });
    }

    /** @internal Runs work with the shape in the module. */
    use<R>(work: (shape: number) => R): R {
        const number = this.register();
        try {
            return work(number);
        } finally {
            raw.shape_free(number);
        }
    }
}

/** Runs work with a shape of the program in the module. */
export function useShape<R>(shape: Shape, name: string, work: (shape: number) => R): R {
    requireClass(shape, Shape, name, "a Shape");
    return shape.use(work);
}

/** A ball. */
export class Ball extends Shape {
    readonly type = ShapeType.Ball;
    radius: number;

    constructor(radius: number) {
        super();
        this.radius = radius;
    }

    /** @internal */
    register(): number {
        putSizes(real(this.radius, "radius"));
        return raw.shape_new(Code.ball, 0, 0);
    }
}

/** Everything below a plane through the origin. */
export class HalfSpace extends Shape {
    readonly type = ShapeType.HalfSpace;
    /** The normal that points out of the solid side. */
    normal: Vector;

    constructor(normal: Vector) {
        super();
        this.normal = normal;
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putVector(0, this.normal, "normal");
        return raw.shape_new(Code.halfspace, 0, 0);
    }
}

/** A box. */
export class Cuboid extends Shape {
    readonly type = ShapeType.Cuboid;
    halfExtents: Vector;

    constructor(...halfExtents: Components) {
        super();
        this.halfExtents = vectorOf(halfExtents);
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putVector(0, this.halfExtents, "halfExtents");
        return raw.shape_new(Code.cuboid, 0, 0);
    }
}

/** A box with a round border. */
export class RoundCuboid extends Shape {
    readonly type = ShapeType.RoundCuboid;
    halfExtents: Vector;
    borderRadius: number;

    constructor(...sizes: [...halfExtents: Components, borderRadius: number]) {
        super();
        this.halfExtents = vectorOf(sizes.slice(0, DIM) as Components);
        this.borderRadius = sizes[DIM]!;
    }

    /** @internal */
    register(): number {
        putSizes(0, 0, real(this.borderRadius, "borderRadius"));
        putVector(0, this.halfExtents, "halfExtents");
        return raw.shape_new(Code.roundCuboid, 0, 0);
    }
}

/** A capsule along the y axis. */
export class Capsule extends Shape {
    readonly type = ShapeType.Capsule;
    radius: number;
    halfHeight: number;

    constructor(halfHeight: number, radius: number) {
        super();
        this.halfHeight = halfHeight;
        this.radius = radius;
    }

    /** @internal */
    register(): number {
        putSizes(real(this.radius, "radius"), real(this.halfHeight, "halfHeight"));
        return raw.shape_new(Code.capsule, 0, 0);
    }
}

/** A segment. */
export class Segment extends Shape {
    readonly type = ShapeType.Segment;
    a: Vector;
    b: Vector;

    constructor(a: Vector, b: Vector) {
        super();
        this.a = a;
        this.b = b;
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putVector(0, this.a, "a");
        putVector(1, this.b, "b");
        return raw.shape_new(Code.segment, 0, 0);
    }
}

/** A triangle. */
export class Triangle extends Shape {
    readonly type = ShapeType.Triangle;
    a: Vector;
    b: Vector;
    c: Vector;

    constructor(a: Vector, b: Vector, c: Vector) {
        super();
        this.a = a;
        this.b = b;
        this.c = c;
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putVector(0, this.a, "a");
        putVector(1, this.b, "b");
        putVector(2, this.c, "c");
        return raw.shape_new(Code.triangle, 0, 0);
    }
}

/** A triangle with a round border. */
export class RoundTriangle extends Shape {
    readonly type = ShapeType.RoundTriangle;
    a: Vector;
    b: Vector;
    c: Vector;
    borderRadius: number;

    constructor(a: Vector, b: Vector, c: Vector, borderRadius: number) {
        super();
        this.a = a;
        this.b = b;
        this.c = c;
        this.borderRadius = borderRadius;
    }

    /** @internal */
    register(): number {
        putSizes(0, 0, real(this.borderRadius, "borderRadius"));
        putVector(0, this.a, "a");
        putVector(1, this.b, "b");
        putVector(2, this.c, "c");
        return raw.shape_new(Code.roundTriangle, 0, 0);
    }
}

/** A chain of segments. */
export class Polyline extends Shape {
    readonly type = ShapeType.Polyline;
    vertices: RealArray;
    indices: Uint32Array;
    flags: PolylineFlags;

    /** Without indices, each vertex is joined to the next one. */
    constructor(vertices: ArrayLike<number>, indices?: Uint32Array | null, flags?: PolylineFlags) {
        super();
        this.vertices = vertices as RealArray;
        this.indices = indices ?? new Uint32Array(0);
        this.flags = flags ?? (0 as PolylineFlags);
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putReals(this.vertices, "vertices");
        putIntegers(this.indices, "indices");
        return raw.shape_new(Code.polyline, integer(this.flags, "flags"), +(this.indices.length > 0));
    }
}

/** Boxes of one size on a grid. */
export class Voxels extends Shape {
    readonly type = ShapeType.Voxels;
    /** Grid coordinates (integers), or points of which each fills its box. */
    data: RealArray | Float32Array | Int32Array;
    voxelSize: Vector;

    constructor(data: Float32Array | Float64Array | Int32Array, voxelSize: Vector) {
        super();
        this.data = data as RealArray | Int32Array;
        this.voxelSize = voxelSize;
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putVector(0, this.voxelSize, "voxelSize");
        const byCoordinates = this.data instanceof Int32Array;
        if (byCoordinates) {
            putIntegers(this.data, "data");
        } else {
            putReals(this.data, "data");
        }
        return raw.shape_new(Code.voxels, 0, +byCoordinates);
    }
}

/** Several shapes that move as one. */
export class Compound extends Shape {
    readonly type = ShapeType.Compound;
    shapes: Shape[];
    positions: Vector[];
    rotations: Rotation[];
    flags: CompoundFlags;

    constructor(shapes: Shape[], positions: Vector[], rotations: Rotation[], flags?: CompoundFlags) {
        super();
        this.shapes = shapes;
        this.positions = positions;
        this.rotations = rotations;
        this.flags = flags ?? (0 as CompoundFlags);
    }

    /** @internal */
    register(): number {
        const { shapes, positions, rotations } = this;
        Object.entries({ shapes, positions, rotations }).forEach(([name, list]) => requireList(list, name));
        if (positions.length !== shapes.length || rotations.length !== shapes.length) {
            const lengths = `${shapes.length}, ${positions.length} and ${rotations.length}`;
            throw new RapierError("InvalidValue", `shapes, positions and rotations of the compound have different lengths: ${lengths}`);
        }
        const numbers: number[] = [];
        try {
            for (const shape of shapes) {
                requireClass(shape, Shape, "a shape of the compound", "a Shape");
                numbers.push(shape.register());
            }
            const poses: number[] = [];
            positions.forEach((position, index) => {
                pushVector(poses, position, "a position of the compound");
                pushRotation(poses, rotations[index]!, "a rotation of the compound");
            });
            putSizes(0);
            putIntegers(numbers, "shapes");
            putReals(poses, "positions");
            return raw.shape_new(Code.compound, integer(this.flags, "flags"), 0);
        } finally {
            numbers.forEach((number) => raw.shape_free(number));
        }
    }
}

/** A surface of triangles. */
export class TriMesh extends Shape {
    readonly type = ShapeType.TriMesh;
    vertices: RealArray;
    indices: Uint32Array;
    flags: TriMeshFlags;

    constructor(vertices: ArrayLike<number>, indices: Uint32Array, flags?: TriMeshFlags) {
        super();
        this.vertices = vertices as RealArray;
        this.indices = indices;
        this.flags = flags ?? (0 as TriMeshFlags);
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putReals(this.vertices, "vertices");
        putIntegers(this.indices, "indices");
        return raw.shape_new(Code.trimesh, integer(this.flags, "flags"), 1);
    }
}

/** Parameters of a convex decomposition. Omitted ones keep their defaults. */
export interface VHACDParameters {
    alpha?: number;
    beta?: number;
    concavity?: number;
    planeDownsampling?: number;
    convexHullDownsampling?: number;
    maxConvexHulls?: number;
    resolution?: number;
    convexHullApproximation?: boolean;
}

/** The compound of convex parts of the volume inside a surface. */
export function decompose(vertices: ArrayLike<number>, indices: Uint32Array, parameters: VHACDParameters = {}, flags = 0): Shape {
    requireObject(parameters, "params", "an object of VHACDParameters");
    const { concavity, alpha, beta, resolution, planeDownsampling, convexHullDownsampling, maxConvexHulls } = parameters;
    const numbers = [concavity, alpha, beta, resolution, planeDownsampling, convexHullDownsampling, maxConvexHulls];
    numbers.push(+(parameters.convexHullApproximation ?? true));
    putSizes(0);
    numbers.forEach((number, index) => putNumber(4 + (index >> 2), index & 3, number === undefined ? NaN : real(number, "a parameter of the decomposition")));
    putReals(vertices, "vertices");
    putIntegers(indices, "indices");
    const number = raw.shape_new(Code.decomposition, integer(flags, "flags"), 1);
    try {
        return read(raw.shape_describe(number));
    } finally {
        raw.shape_free(number);
    }
}

/** Reads shapes that only one dimension has. */
let readOwn: (code: number) => Shape | undefined = () => undefined;

/** Adds the shapes that only one dimension has. */
export function setReader(reader: (code: number) => Shape | undefined): void {
    readOwn = reader;
}

/** The shape that the module has just described. */
export function read(code: number): Shape {
    const border = getNumber(SIZES, 2);
    switch (code) {
        case Code.ball:
            return new Ball(getNumber(SIZES, 0));
        case Code.cuboid:
            return Object.assign(Object.create(Cuboid.prototype) as Cuboid, { type: ShapeType.Cuboid, halfExtents: getVector(0) });
        case Code.roundCuboid: {
            const fields = { type: ShapeType.RoundCuboid, halfExtents: getVector(0), borderRadius: border };
            return Object.assign(Object.create(RoundCuboid.prototype) as RoundCuboid, fields);
        }
        case Code.capsule:
            return new Capsule(getNumber(SIZES, 1), getNumber(SIZES, 0));
        case Code.segment:
            return new Segment(getVector(0), getVector(1));
        case Code.triangle:
            return new Triangle(getVector(0), getVector(1), getVector(2));
        case Code.roundTriangle:
            return new RoundTriangle(getVector(0), getVector(1), getVector(2), border);
        case Code.halfspace:
            return new HalfSpace(getVector(0));
        case Code.polyline:
            return new Polyline(realsCopy(), integersCopy(), getNumber(SIZES, 3));
        case Code.trimesh:
            return new TriMesh(realsCopy(), integersCopy(), getNumber(SIZES, 3));
        case Code.voxels:
            return new Voxels(new Int32Array(integersCopy().buffer), getVector(0));
        case Code.compound:
            return readCompound();
        default: {
            const shape = readOwn(code);
            if (!shape) {
                throw new RapierError("WrongShape", `the shape of kind ${code} has no description in JavaScript`);
            }
            return shape;
        }
    }
}

function readCompound(): Compound {
    const [numbers, poses, flags] = [integersCopy(), realsCopy(), getNumber(SIZES, 3)];
    const stride = DIM + ROTATION;
    const shapes = Array.from(numbers, (number) => {
        try {
            return read(raw.shape_describe(number));
        } finally {
            raw.shape_free(number);
        }
    });
    const positions = shapes.map((_, index) => vectorAt(poses, index * stride));
    const rotations = shapes.map((_, index) => rotationAt(poses, index * stride + DIM));
    return new Compound(shapes, positions, rotations, flags);
}
