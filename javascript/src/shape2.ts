// Shapes that only 2D has.

import { ShapeType, type Vector, getVector, putVector } from "#dim";
import { real } from "./arguments.js";
import { getNumber, putReals, raw, realsCopy } from "./raw.js";
import type { RealArray } from "#real";
import { Code, SIZES, Shape, putSizes, setReader } from "./shape.js";

/** A convex polygon: the hull of points, or an outline. */
export class ConvexPolygon extends Shape {
    readonly type = ShapeType.ConvexPolygon;
    vertices: RealArray;
    /** Whether the vertices are the outline in order. Otherwise the shape is their hull. */
    skipConvexHullComputation: boolean;

    constructor(vertices: ArrayLike<number>, skipConvexHullComputation: boolean) {
        super();
        this.vertices = vertices as RealArray;
        this.skipConvexHullComputation = skipConvexHullComputation;
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putReals(this.vertices, "vertices");
        return raw.shape_new(Code.convex, +this.skipConvexHullComputation, 0);
    }
}

/** A convex polygon with a round border. */
export class RoundConvexPolygon extends Shape {
    readonly type = ShapeType.RoundConvexPolygon;
    vertices: RealArray;
    borderRadius: number;
    /** Whether the vertices are the outline in order. Otherwise the shape is their hull. */
    skipConvexHullComputation: boolean;

    constructor(vertices: ArrayLike<number>, borderRadius: number, skipConvexHullComputation: boolean) {
        super();
        this.vertices = vertices as RealArray;
        this.borderRadius = borderRadius;
        this.skipConvexHullComputation = skipConvexHullComputation;
    }

    /** @internal */
    register(): number {
        putSizes(0, 0, real(this.borderRadius, "borderRadius"));
        putReals(this.vertices, "vertices");
        return raw.shape_new(Code.roundConvex, +this.skipConvexHullComputation, 0);
    }
}

/** A chain of segments over an interval of the x axis, from heights at regular distances. */
export class Heightfield extends Shape {
    readonly type = ShapeType.HeightField;
    heights: RealArray;
    /** The length of the interval in x, and the factor of the heights in y. */
    scale: Vector;

    constructor(heights: ArrayLike<number>, scale: Vector) {
        super();
        this.heights = heights as RealArray;
        this.scale = scale;
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putVector(0, this.scale, "scale");
        putReals(this.heights, "heights");
        return raw.shape_new(Code.heightfield, 0, 0);
    }
}

setReader((code) => {
    switch (code) {
        case Code.convex:
            return new ConvexPolygon(realsCopy(), true);
        case Code.roundConvex:
            return new RoundConvexPolygon(realsCopy(), getNumber(SIZES, 2), true);
        case Code.heightfield:
            return new Heightfield(realsCopy(), getVector(0));
        default:
            return undefined;
    }
});
