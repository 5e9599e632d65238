// Shapes that only 3D has.

import { ShapeType, type Vector, getVector, putVector } from "#dim";
import { integer, real, requireCount } from "./arguments.js";
import { getNumber, integersCopy, putIntegers, putReals, raw, realsCopy } from "./raw.js";
import type { RealArray } from "#real";
import { Code, type HeightFieldFlags, SIZES, Shape, putSizes, setReader } from "./shape.js";

/** A convex polyhedron: the hull of points, or a closed mesh. */
export class ConvexPolyhedron extends Shape {
    readonly type = ShapeType.ConvexPolyhedron;
    vertices: RealArray;
    indices?: Uint32Array | null;

    /** Without indices, the shape is the hull of the vertices. */
    constructor(vertices: ArrayLike<number>, indices?: Uint32Array | null) {
        super();
        this.vertices = vertices as RealArray;
        this.indices = indices ?? null;
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putReals(this.vertices, "vertices");
        putIntegers(this.indices ?? [], "indices");
        return raw.shape_new(Code.convex, 0, +!!this.indices);
    }
}

/** A convex polyhedron with a round border. */
export class RoundConvexPolyhedron extends Shape {
    readonly type = ShapeType.RoundConvexPolyhedron;
    vertices: RealArray;
    indices?: Uint32Array;
    borderRadius: number;

    /** Without indices, the shape is the hull of the vertices. */
    constructor(vertices: ArrayLike<number>, indices: Uint32Array | null | undefined, borderRadius: number) {
        super();
        this.vertices = vertices as RealArray;
        if (indices) {
            this.indices = indices;
        }
        this.borderRadius = borderRadius;
    }

    /** @internal */
    register(): number {
        putSizes(0, 0, real(this.borderRadius, "borderRadius"));
        putReals(this.vertices, "vertices");
        putIntegers(this.indices ?? [], "indices");
        return raw.shape_new(Code.roundConvex, 0, +!!this.indices);
    }
}

/** A surface over a rectangle of the x-z plane, from heights on a grid. */
export class Heightfield extends Shape {
    readonly type = ShapeType.HeightField;
    /** Cells along z. */
    nrows: number;
    /** Cells along x. */
    ncols: number;
    /** The heights by columns: `(nrows + 1) * (ncols + 1)` numbers. */
    heights: RealArray;
    /** The sides of the rectangle in x and z, and the factor of the heights in y. */
    scale: Vector;
    flags: HeightFieldFlags;

    constructor(nrows: number, ncols: number, heights: ArrayLike<number>, scale: Vector, flags?: HeightFieldFlags) {
        super();
        this.nrows = nrows;
        this.ncols = ncols;
        this.heights = heights as RealArray;
        this.scale = scale;
        this.flags = flags ?? (0 as HeightFieldFlags);
    }

    /** @internal */
    register(): number {
        putSizes(0);
        putVector(0, this.scale, "scale");
        putReals(this.heights, "heights");
        putIntegers([requireCount(this.nrows, "nrows"), requireCount(this.ncols, "ncols")], "the cells");
        return raw.shape_new(Code.heightfield, integer(this.flags, "flags"), 0);
    }
}

/** A shape of revolution about the y axis. */
abstract class Revolved extends Shape {
    radius: number;
    halfHeight: number;

    constructor(halfHeight: number, radius: number) {
        super();
        this.halfHeight = halfHeight;
        this.radius = radius;
    }

    protected abstract get code(): number;

    /** @internal */
    register(): number {
        putSizes(real(this.radius, "radius"), real(this.halfHeight, "halfHeight"));
        return raw.shape_new(this.code, 0, 0);
    }
}

/** A shape of revolution about the y axis with a round border. */
abstract class RoundRevolved extends Revolved {
    borderRadius: number;

    constructor(halfHeight: number, radius: number, borderRadius: number) {
        super(halfHeight, radius);
        this.borderRadius = borderRadius;
    }

    /** @internal */
    override register(): number {
        putSizes(real(this.radius, "radius"), real(this.halfHeight, "halfHeight"), real(this.borderRadius, "borderRadius"));
        return raw.shape_new(this.code, 0, 0);
    }
}

/** A cylinder along the y axis. */
export class Cylinder extends Revolved {
    readonly type: ShapeType.Cylinder = ShapeType.Cylinder;

    protected get code(): number {
        return Code.cylinder;
    }
}

/** A cylinder along the y axis with a round border. */
export class RoundCylinder extends RoundRevolved {
    readonly type: ShapeType.RoundCylinder = ShapeType.RoundCylinder;

    protected get code(): number {
        return Code.roundCylinder;
    }
}

/** A cone along the y axis, its tip up. */
export class Cone extends Revolved {
    readonly type: ShapeType.Cone = ShapeType.Cone;

    protected get code(): number {
        return Code.cone;
    }
}

/** A cone along the y axis with a round border. */
export class RoundCone extends RoundRevolved {
    readonly type: ShapeType.RoundCone = ShapeType.RoundCone;

    protected get code(): number {
        return Code.roundCone;
    }
}

/** The triangles of a described polyhedron. A plate has none: it is the hull of its points. */
function indicesOrNull(): Uint32Array | null {
    const indices = integersCopy();
    return indices.length === 0 ? null : indices;
}

setReader((code) => {
    const [radius, halfHeight, border] = [0, 1, 2].map((component) => getNumber(SIZES, component)) as [number, number, number];
    switch (code) {
        case Code.cylinder:
            return new Cylinder(halfHeight, radius);
        case Code.roundCylinder:
            return new RoundCylinder(halfHeight, radius, border);
        case Code.cone:
            return new Cone(halfHeight, radius);
        case Code.roundCone:
            return new RoundCone(halfHeight, radius, border);
        case Code.convex:
            return new ConvexPolyhedron(realsCopy(), indicesOrNull());
        case Code.roundConvex:
            return new RoundConvexPolyhedron(realsCopy(), indicesOrNull(), border);
        case Code.heightfield: {
            const [rows, columns, flags] = integersCopy();
            return new Heightfield(rows!, columns!, realsCopy(), getVector(0), flags);
        }
        default:
            return undefined;
    }
});
