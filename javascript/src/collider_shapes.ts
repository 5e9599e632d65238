// Descriptions of shapes that both dimensions have. collider_desc2.ts and collider_desc3.ts add their own.

import type { ColliderDesc } from "#collider_desc";
import {
    type HalfExtents,
    type HalfExtentsAndBorder,
    type PolylineFlags,
    type Rotation,
    type TriMeshFlags,
    type Vector,
} from "#dim";
import { requireList } from "./arguments.js";
import { ColliderDescBase } from "./collider_desc.js";
import {
    Ball,
    Capsule,
    Compound,
    type CompoundFlags,
    Cuboid,
    HalfSpace,
    Polyline,
    RoundCuboid,
    RoundTriangle,
    Segment,
    type Shape,
    TriMesh,
    Triangle,
    type VHACDParameters,
    Voxels,
    decompose,
} from "./shape.js";

/** Makes a description of the dimension. */
let describe: (shape: Shape) => ColliderDesc;

/** Sets how a description is made. */
export function setDescription(make: (shape: Shape) => ColliderDesc): void {
    describe = make;
}

/** Describes a collider, by a shape that both dimensions have. */
export class ColliderShapes extends ColliderDescBase {
    /** A ball. */
    static ball(radius: number): ColliderDesc {
        return describe(new Ball(radius));
    }

    /** A capsule along the y axis. */
    static capsule(halfHeight: number, radius: number): ColliderDesc {
        return describe(new Capsule(halfHeight, radius));
    }

    /** A segment. */
    static segment(a: Vector, b: Vector): ColliderDesc {
        return describe(new Segment(a, b));
    }

    /** A triangle. */
    static triangle(a: Vector, b: Vector, c: Vector): ColliderDesc {
        return describe(new Triangle(a, b, c));
    }

    /** A triangle with a round border. */
    static roundTriangle(a: Vector, b: Vector, c: Vector, borderRadius: number): ColliderDesc {
        return describe(new RoundTriangle(a, b, c, borderRadius));
    }

    /** A chain of segments. Without indices, each vertex is joined to the next one. */
    static polyline(vertices: ArrayLike<number>, indices?: Uint32Array | null, flags?: PolylineFlags): ColliderDesc {
        return describe(new Polyline(vertices, indices, flags));
    }

    /** Boxes of one size on a grid: at grid coordinates (integers), or around points. */
    static voxels(voxels: Float32Array | Float64Array | Int32Array, voxelSize: Vector): ColliderDesc {
        return describe(new Voxels(voxels, voxelSize));
    }

    /** A surface of triangles. */
    static trimesh(vertices: ArrayLike<number>, indices: Uint32Array, flags?: TriMeshFlags): ColliderDesc {
        return describe(new TriMesh(vertices, indices, flags));
    }

    /** Everything below a plane through the origin. */
    static halfspace(normal: Vector): ColliderDesc {
        return describe(new HalfSpace(normal));
    }

    /** A box, by half its sides. */
    static cuboid(...halfExtents: HalfExtents): ColliderDesc {
        return describe(new Cuboid(...halfExtents));
    }

    /** A box with a round border, by half its sides. */
    static roundCuboid(...sizes: HalfExtentsAndBorder): ColliderDesc {
        return describe(new RoundCuboid(...sizes));
    }

    /** Several shapes that move as one. */
    static compound(shapes: Shape[], positions: Vector[], rotations: Rotation[], flags?: CompoundFlags): ColliderDesc {
        return describe(new Compound(shapes, positions, rotations, flags));
    }

    /** The convex parts of the volume inside a surface. Null if it encloses no volume. */
    static convexDecomposition(
        vertices: ArrayLike<number>,
        indices: Uint32Array,
        params?: VHACDParameters,
        flags?: CompoundFlags,
    ): ColliderDesc | null {
        requireList(vertices, "vertices");
        requireList(indices, "indices");
        try {
            return describe(decompose(vertices, indices, params, flags));
        } catch {
            return null;
        }
    }
}
