// Descriptions of colliders in 3D.

import {
    type HalfExtents,
    type HalfExtentsAndBorder,
    type MassProperties,
    type PolylineFlags,
    type Rotation,
    RotationOps,
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
    type HeightFieldFlags,
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
import { Cone, ConvexPolyhedron, Cylinder, Heightfield, RoundCone, RoundConvexPolyhedron, RoundCylinder } from "./shape3.js";

/** Describes a collider. `World.createCollider` makes colliders of it. */
export class ColliderDesc extends ColliderDescBase {
    angularInertiaLocalFrame: Rotation = RotationOps.identity();

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

    /** A surface from heights on a grid of `nrows` times `ncols` cells, by columns. */
    static heightfield(
        nrows: number,
        ncols: number,
        heights: ArrayLike<number>,
        scale: Vector,
        flags?: HeightFieldFlags,
    ): ColliderDesc {
        return new ColliderDesc(new Heightfield(nrows, ncols, heights, scale, flags));
    }

    /** A cylinder along the y axis. */
    static cylinder(halfHeight: number, radius: number): ColliderDesc {
        return new ColliderDesc(new Cylinder(halfHeight, radius));
    }

    /** A cylinder along the y axis with a round border. */
    static roundCylinder(halfHeight: number, radius: number, borderRadius: number): ColliderDesc {
        return new ColliderDesc(new RoundCylinder(halfHeight, radius, borderRadius));
    }

    /** A cone along the y axis, its tip up. */
    static cone(halfHeight: number, radius: number): ColliderDesc {
        return new ColliderDesc(new Cone(halfHeight, radius));
    }

    /** A cone along the y axis with a round border. */
    static roundCone(halfHeight: number, radius: number, borderRadius: number): ColliderDesc {
        return new ColliderDesc(new RoundCone(halfHeight, radius, borderRadius));
    }

    /** The convex hull of points. Null if they span no volume. */
    static convexHull(points: ArrayLike<number>): ColliderDesc | null {
        return orNull(new ConvexPolyhedron(points), (shape) => new ColliderDesc(shape));
    }

    /** A convex mesh. Without indices, it is the hull of the vertices. Null if it encloses no volume. */
    static convexMesh(vertices: ArrayLike<number>, indices?: Uint32Array | null): ColliderDesc | null {
        return orNull(new ConvexPolyhedron(vertices, indices), (shape) => new ColliderDesc(shape));
    }

    /** The convex hull of points with a round border. Null if they span no volume. */
    static roundConvexHull(points: ArrayLike<number>, borderRadius: number): ColliderDesc | null {
        return orNull(new RoundConvexPolyhedron(points, null, borderRadius), (shape) => new ColliderDesc(shape));
    }

    /** A convex mesh with a round border. Null if it encloses no volume. */
    static roundConvexMesh(vertices: ArrayLike<number>, indices: Uint32Array | null, borderRadius: number): ColliderDesc | null {
        return orNull(new RoundConvexPolyhedron(vertices, indices, borderRadius), (shape) => new ColliderDesc(shape));
    }

    override setMassProperties(...properties: MassProperties): this {
        super.setMassProperties(...properties);
        this.angularInertiaLocalFrame = properties[3];
        return this;
    }

    protected override massProperties(): MassProperties {
        return [this.mass, this.centerOfMass, this.principalAngularInertia, this.angularInertiaLocalFrame];
    }
}
