// Descriptions of colliders in 2D.

import {
    type HalfExtents,
    type HalfExtentsAndBorder,
    type PolylineFlags,
    type Rotation,
    type TriMeshFlags,
    type Vector,
} from "#dim";
import { ColliderDescBase, orNull } from "./collider_desc.js";
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
import { ConvexPolygon, Heightfield, RoundConvexPolygon } from "./shape2.js";

/** Describes a collider. `World.createCollider` makes colliders of it. */
export class ColliderDesc extends ColliderDescBase {
    /** A ball. */
    static ball(radius: number): ColliderDesc {
        return new ColliderDesc(new Ball(radius));
    }

    /** A capsule along the y axis. */
    static capsule(halfHeight: number, radius: number): ColliderDesc {
        return new ColliderDesc(new Capsule(halfHeight, radius));
    }

    /** A segment. */
    static segment(a: Vector, b: Vector): ColliderDesc {
        return new ColliderDesc(new Segment(a, b));
    }

    /** A triangle. */
    static triangle(a: Vector, b: Vector, c: Vector): ColliderDesc {
        return new ColliderDesc(new Triangle(a, b, c));
    }

    /** A triangle with a round border. */
    static roundTriangle(a: Vector, b: Vector, c: Vector, borderRadius: number): ColliderDesc {
        return new ColliderDesc(new RoundTriangle(a, b, c, borderRadius));
    }

    /** A chain of segments. Without indices, each vertex is joined to the next one. */
    static polyline(vertices: ArrayLike<number>, indices?: Uint32Array | null, flags?: PolylineFlags): ColliderDesc {
        return new ColliderDesc(new Polyline(vertices, indices, flags));
    }

    /** Boxes of one size on a grid: at grid coordinates (integers), or around points. */
    static voxels(voxels: Float32Array | Float64Array | Int32Array, voxelSize: Vector): ColliderDesc {
        return new ColliderDesc(new Voxels(voxels, voxelSize));
    }

    /** A surface of triangles. */
    static trimesh(vertices: ArrayLike<number>, indices: Uint32Array, flags?: TriMeshFlags): ColliderDesc {
        return new ColliderDesc(new TriMesh(vertices, indices, flags));
    }

    /** Everything below a plane through the origin. */
    static halfspace(normal: Vector): ColliderDesc {
        return new ColliderDesc(new HalfSpace(normal));
    }

    /** A box, by half its sides. */
    static cuboid(...halfExtents: HalfExtents): ColliderDesc {
        return new ColliderDesc(new Cuboid(...halfExtents));
    }

    /** A box with a round border, by half its sides. */
    static roundCuboid(...sizes: HalfExtentsAndBorder): ColliderDesc {
        return new ColliderDesc(new RoundCuboid(...sizes));
    }

    /** Several shapes that move as one. */
    static compound(shapes: Shape[], positions: Vector[], rotations: Rotation[], flags?: CompoundFlags): ColliderDesc {
        return new ColliderDesc(new Compound(shapes, positions, rotations, flags));
    }

    /** The convex parts that fill what a surface encloses. Null if it encloses nothing. */
    static convexDecomposition(
        vertices: ArrayLike<number>,
        indices: Uint32Array,
        params?: VHACDParameters,
        flags?: CompoundFlags,
    ): ColliderDesc | null {
        try {
            return new ColliderDesc(decompose(vertices, indices, params, flags));
        } catch {
            return null;
        }
    }

    /** A chain of segments from heights at regular distances. */
    static heightfield(heights: ArrayLike<number>, scale: Vector): ColliderDesc {
        return new ColliderDesc(new Heightfield(heights, scale));
    }

    /** The convex hull of points. Null if they span no area. */
    static convexHull(points: ArrayLike<number>): ColliderDesc | null {
        return orNull(new ConvexPolygon(points, false), (shape) => new ColliderDesc(shape));
    }

    /** A convex outline. Null if it is not convex or has no area. */
    static convexPolyline(vertices: ArrayLike<number>): ColliderDesc | null {
        return orNull(new ConvexPolygon(vertices, true), (shape) => new ColliderDesc(shape));
    }

    /** The convex hull of points with a round border. Null if they span no area. */
    static roundConvexHull(points: ArrayLike<number>, borderRadius: number): ColliderDesc | null {
        return orNull(new RoundConvexPolygon(points, borderRadius, false), (shape) => new ColliderDesc(shape));
    }

    /** A convex outline with a round border. Null if it is not convex or has no area. */
    static roundConvexPolyline(vertices: ArrayLike<number>, borderRadius: number): ColliderDesc | null {
        return orNull(new RoundConvexPolygon(vertices, borderRadius, true), (shape) => new ColliderDesc(shape));
    }
}
