// Descriptions of colliders in 2D.

import type { Vector } from "#dim";
import { orNull } from "./collider_desc.js";
import { ColliderShapes, setDescription } from "./collider_shapes.js";
import { ConvexPolygon, Heightfield, RoundConvexPolygon } from "./shape2.js";

/** Describes a collider. `World.createCollider` makes colliders of it. */
export class ColliderDesc extends ColliderShapes {
    /** A chain of segments from heights at regular distances. */
    static heightfield(heights: ArrayLike<number>, scale: Vector): ColliderDesc {
        return new ColliderDesc(new Heightfield(heights, scale));
    }

    /** The convex hull of points. Points on a line make a segment. Null if they coincide. */
    static convexHull(points: ArrayLike<number>): ColliderDesc | null {
        return orNull(new ConvexPolygon(points, false), (shape) => new ColliderDesc(shape));
    }

    /** A convex outline. Null if it is not convex or has no area. */
    static convexPolyline(vertices: ArrayLike<number>): ColliderDesc | null {
        return orNull(new ConvexPolygon(vertices, true), (shape) => new ColliderDesc(shape));
    }

    /** The convex hull of points with a round border. Points on a line make a capsule. Null if they coincide. */
    static roundConvexHull(points: ArrayLike<number>, borderRadius: number): ColliderDesc | null {
        return orNull(new RoundConvexPolygon(points, borderRadius, false), (shape) => new ColliderDesc(shape));
    }

    /** A convex outline with a round border. Null if it is not convex or has no area. */
    static roundConvexPolyline(vertices: ArrayLike<number>, borderRadius: number): ColliderDesc | null {
        return orNull(new RoundConvexPolygon(vertices, borderRadius, true), (shape) => new ColliderDesc(shape));
    }
}

setDescription((shape) => new ColliderDesc(shape));
