// Descriptions of colliders in 3D.

import { type MassProperties, type Rotation, RotationOps, type Vector, copyRotation } from "#dim";
import { orNull } from "./collider_desc.js";
import { ColliderShapes, setDescription } from "./collider_shapes.js";
import type { HeightFieldFlags } from "./shape.js";
import { Cone, ConvexPolyhedron, Cylinder, Heightfield, RoundCone, RoundConvexPolyhedron, RoundCylinder } from "./shape3.js";

/** Describes a collider. `World.createCollider` makes colliders of it. */
export class ColliderDesc extends ColliderShapes {
    angularInertiaLocalFrame: Rotation = RotationOps.identity();

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

    /** The convex hull of points. Points in a plane make a plate. Null if they lie on a line. */
    static convexHull(points: ArrayLike<number>): ColliderDesc | null {
        return orNull(new ConvexPolyhedron(points), (shape) => new ColliderDesc(shape));
    }

    /** A convex mesh. Without indices, it is the hull of the vertices. Null if it encloses no volume. */
    static convexMesh(vertices: ArrayLike<number>, indices?: Uint32Array | null): ColliderDesc | null {
        return orNull(new ConvexPolyhedron(vertices, indices), (shape) => new ColliderDesc(shape));
    }

    /** The convex hull of points with a round border. Points in a plane make a plate. Null if they lie on a line. */
    static roundConvexHull(points: ArrayLike<number>, borderRadius: number): ColliderDesc | null {
        return orNull(new RoundConvexPolyhedron(points, null, borderRadius), (shape) => new ColliderDesc(shape));
    }

    /** A convex mesh with a round border. Null if it encloses no volume. */
    static roundConvexMesh(vertices: ArrayLike<number>, indices: Uint32Array | null, borderRadius: number): ColliderDesc | null {
        return orNull(new RoundConvexPolyhedron(vertices, indices, borderRadius), (shape) => new ColliderDesc(shape));
    }

    override setMassProperties(...properties: MassProperties): this {
        super.setMassProperties(...properties);
        this.angularInertiaLocalFrame = copyRotation(properties[3], "angularInertiaLocalFrame");
        return this;
    }

    protected override massProperties(): MassProperties {
        return [this.mass, this.centerOfMass, this.principalAngularInertia, this.angularInertiaLocalFrame];
    }
}

setDescription((shape) => new ColliderDesc(shape));
