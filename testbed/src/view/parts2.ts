// Geometry of 2D shapes. Each triangle has a `rim` attribute: 0 at the outline, 1 inside. The shader draws
// the outline from its derivative, so lines are equally thick at each zoom and scale.

import { BufferGeometry, Float32BufferAttribute, Matrix4 } from "three";
import type { ShapeLike } from "../core/engine.ts";
import { contentKey, sizeKey, type Part } from "./parts.ts";

interface Vec2 {
    x: number;
    y: number;
}

type Fields = ShapeLike & {
    radius: number;
    halfHeight: number;
    borderRadius: number;
    halfExtents: Vec2;
    a: Vec2;
    b: Vec2;
    c: Vec2;
    normal: Vec2;
    vertices: Float32Array;
    indices?: Uint32Array | null;
    heights: Float32Array;
    scale: Vec2;
    data: ArrayLike<number>;
    voxelSize: Vec2;
    shapes: ShapeLike[];
    positions: Vec2[];
    rotations: number[];
};

const UNIT = [1, 1, 1] as const;
/** Half the width of polylines and segments, in metres. */
const LINE = 0.04;
/** Depth below the lowest point of the ground that a height field fills. */
const DEPTH = 6;
const SHADE = 0.78;

/** Collects triangles with a rim value and a tone for each corner. */
class Triangles {
    private readonly points: number[] = [];
    private readonly rims: number[] = [];
    private readonly tones: number[] = [];

    corner(at: Vec2, rim: number, tone = 1): void {
        this.points.push(at.x, at.y, 0);
        this.rims.push(rim);
        this.tones.push(tone, tone, tone);
    }

    /** A convex outline as a fan around its centre. */
    fan(outline: readonly Vec2[], tone: (index: number) => number = () => 1): this {
        const centre = { x: 0, y: 0 };
        for (const { x, y } of outline) {
            centre.x += x / outline.length;
            centre.y += y / outline.length;
        }
        outline.forEach((from, index) => {
            const to = outline[(index + 1) % outline.length] ?? from;
            this.corner(centre, 1, tone(index));
            this.corner(from, 0, tone(index));
            this.corner(to, 0, tone(index));
        });
        return this;
    }

    geometry(): BufferGeometry {
        const geometry = new BufferGeometry();
        geometry.setAttribute("position", new Float32BufferAttribute(this.points, 3));
        geometry.setAttribute("rim", new Float32BufferAttribute(this.rims, 1));
        geometry.setAttribute("color", new Float32BufferAttribute(this.tones, 3));
        return geometry;
    }
}

/** Points of an arc, both ends included. */
function arc(centre: Vec2, radius: number, from: number, to: number, pieces: number): Vec2[] {
    return Array.from({ length: pieces + 1 }, (_, index) => {
        const angle = from + ((to - from) * index) / pieces;
        return { x: centre.x + radius * Math.cos(angle), y: centre.y + radius * Math.sin(angle) };
    });
}

function ball(): BufferGeometry {
    const outline = arc({ x: 0, y: 0 }, 1, 0, 2 * Math.PI, 40).slice(0, 40);
    return new Triangles().fan(outline, (index) => (Math.floor(index / 10) % 2 === 0 ? 1 : SHADE)).geometry();
}

function capsule(radius: number, halfHeight: number): BufferGeometry {
    const top = arc({ x: 0, y: halfHeight }, radius, 0, Math.PI, 16);
    const bottom = arc({ x: 0, y: -halfHeight }, radius, Math.PI, 2 * Math.PI, 16);
    return new Triangles().fan([...top, ...bottom], (index) => (index < 17 ? 1 : SHADE)).geometry();
}

/** Vertices of a flat array, in counter-clockwise order. */
function outlineOf(vertices: ArrayLike<number>): Vec2[] {
    const points: Vec2[] = [];
    for (let at = 0; at + 1 < vertices.length; at += 2) points.push({ x: vertices[at] ?? 0, y: vertices[at + 1] ?? 0 });
    let area = 0;
    points.forEach((point, index) => {
        const next = points[(index + 1) % points.length] ?? point;
        area += point.x * next.y - next.x * point.y;
    });
    return area < 0 ? points.reverse() : points;
}

/** The convex hull of points in any order (Andrew's monotone chain). */
function hullOf(vertices: ArrayLike<number>): Vec2[] {
    const points = outlineOf(vertices).sort((a, b) => a.x - b.x || a.y - b.y);
    const chain = (ordered: readonly Vec2[]): Vec2[] => {
        const hull: Vec2[] = [];
        for (const point of ordered) {
            while (hull.length > 1 && !turnsLeft(hull[hull.length - 2]!, hull[hull.length - 1]!, point)) hull.pop();
            hull.push(point);
        }
        return hull.slice(0, -1);
    };
    return [...chain(points), ...chain(points.reverse())];
}

function turnsLeft(a: Vec2, b: Vec2, c: Vec2): boolean {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
}

/** A convex outline with its corners rounded by arcs. */
function rounded(outline: readonly Vec2[], border: number): Vec2[] {
    return outline.flatMap((point, index) => {
        const before = outline[(index + outline.length - 1) % outline.length] ?? point;
        const after = outline[(index + 1) % outline.length] ?? point;
        const from = Math.atan2(point.y - before.y, point.x - before.x) - Math.PI / 2;
        let to = Math.atan2(after.y - point.y, after.x - point.x) - Math.PI / 2;
        while (to < from) to += 2 * Math.PI;
        return arc(point, border, from, to, 6);
    });
}

/** Triangles whose edges are all visible. */
function mesh(vertices: ArrayLike<number>, indices: ArrayLike<number>): BufferGeometry {
    const triangles = new Triangles();
    for (let at = 0; at + 2 < indices.length; at += 3) {
        const corners = [0, 1, 2].map((corner) => {
            const from = (indices[at + corner] ?? 0) * 2;
            return { x: vertices[from] ?? 0, y: vertices[from + 1] ?? 0 };
        });
        triangles.fan(corners);
    }
    return triangles.geometry();
}

/** Lines as thin quads with round joints left out. */
function lines(vertices: ArrayLike<number>, indices: ArrayLike<number> | null): BufferGeometry {
    const triangles = new Triangles();
    const at = (index: number): Vec2 => ({ x: vertices[2 * index] ?? 0, y: vertices[2 * index + 1] ?? 0 });
    const pairs = indices ? indices.length / 2 : vertices.length / 2 - 1;
    for (let pair = 0; pair < pairs; pair++) {
        const a = at(indices ? (indices[2 * pair] ?? 0) : pair);
        const b = at(indices ? (indices[2 * pair + 1] ?? 0) : pair + 1);
        const length = Math.hypot(b.x - a.x, b.y - a.y) || 1;
        const [ux, uy] = [((b.x - a.x) / length) * LINE, ((b.y - a.y) / length) * LINE];
        for (const corner of [
            { x: a.x - ux + uy, y: a.y - uy - ux },
            { x: b.x + ux + uy, y: b.y + uy - ux },
            { x: b.x + ux - uy, y: b.y + uy + ux },
            { x: a.x - ux + uy, y: a.y - uy - ux },
            { x: b.x + ux - uy, y: b.y + uy + ux },
            { x: a.x - ux - uy, y: a.y - uy + ux },
        ]) {
            triangles.corner(corner, 1);
        }
    }
    return triangles.geometry();
}

/** The ground below a height field, with its outline at the surface alone. */
function heightfield(heights: Float32Array, scale: Vec2): BufferGeometry {
    const triangles = new Triangles();
    const cells = heights.length - 1;
    const base = Math.min(...heights) * scale.y - DEPTH;
    for (let cell = 0; cell < cells; cell++) {
        const [x0, x1] = [(cell / cells - 0.5) * scale.x, ((cell + 1) / cells - 0.5) * scale.x];
        const [y0, y1] = [(heights[cell] ?? 0) * scale.y, (heights[cell + 1] ?? 0) * scale.y];
        triangles.corner({ x: x0, y: base }, 1);
        triangles.corner({ x: x1, y: base }, 1);
        triangles.corner({ x: x1, y: y1 }, 0);
        triangles.corner({ x: x0, y: base }, 1);
        triangles.corner({ x: x1, y: y1 }, 0);
        triangles.corner({ x: x0, y: y0 }, 0);
    }
    return triangles.geometry();
}

function voxels(data: ArrayLike<number>, size: Vec2): BufferGeometry {
    const triangles = new Triangles();
    for (let at = 0; at + 1 < data.length; at += 2) {
        const [x, y] = [(data[at] ?? 0) * size.x, (data[at + 1] ?? 0) * size.y];
        triangles.fan([
            { x, y },
            { x: x + size.x, y },
            { x: x + size.x, y: y + size.y },
            { x, y: y + size.y },
        ]);
    }
    return triangles.geometry();
}

/** Half of a plane, as a large square below its surface. */
function halfSpace(normal: Vec2): Part {
    const reach = 200;
    const build = (): BufferGeometry => {
        const triangles = new Triangles();
        const [left, right] = [-reach, reach];
        triangles.corner({ x: left, y: -reach }, 1);
        triangles.corner({ x: right, y: -reach }, 1);
        triangles.corner({ x: right, y: 0 }, 0);
        triangles.corner({ x: left, y: -reach }, 1);
        triangles.corner({ x: right, y: 0 }, 0);
        triangles.corner({ x: left, y: 0 }, 0);
        return triangles.geometry();
    };
    const angle = Math.atan2(normal.y, normal.x) - Math.PI / 2;
    return { key: "halfspace", build, scale: UNIT, offset: new Matrix4().makeRotationZ(angle) };
}

function compound(shape: Fields, names: ReadonlyMap<number, string>): Part[] {
    return shape.shapes.flatMap((piece, index) => {
        const position = shape.positions[index] ?? { x: 0, y: 0 };
        const pose = new Matrix4().makeRotationZ(shape.rotations[index] ?? 0).setPosition(position.x, position.y, 0);
        return parts2(names.get(piece.type) ?? "", piece, names).map((part) => ({
            ...part,
            offset: part.offset ? pose.clone().multiply(part.offset) : pose,
        }));
    });
}

function boxOutline(x: number, y: number): Vec2[] {
    return [
        { x: -x, y: -y },
        { x, y: -y },
        { x, y },
        { x: -x, y },
    ];
}

function polygon(prefix: string, outline: Vec2[], border = 0): Part {
    const key = `${prefix} ${contentKey(outline.flatMap(({ x, y }) => [x, y]))} ${sizeKey(border)}`;
    const shown = border > 0 ? rounded(outline, border) : outline;
    return { key, build: () => new Triangles().fan(shown).geometry(), scale: UNIT };
}

function meshParts(name: string, shape: Fields): Part[] {
    switch (name) {
        case "TriMesh": {
            const indices = shape.indices ?? new Uint32Array();
            const key = `mesh ${contentKey(shape.vertices, indices)}`;
            return [{ key, build: () => mesh(shape.vertices, indices), scale: UNIT }];
        }
        case "Polyline": {
            const indices = shape.indices && shape.indices.length > 0 ? shape.indices : null;
            const key = `line ${contentKey(shape.vertices, indices ?? [])}`;
            return [{ key, build: () => lines(shape.vertices, indices), scale: UNIT }];
        }
        case "Segment": {
            const ends = [shape.a.x, shape.a.y, shape.b.x, shape.b.y];
            return [{ key: `line ${contentKey(ends)}`, build: () => lines(ends, null), scale: UNIT }];
        }
        case "HeightField": {
            const { heights, scale } = shape;
            const key = `field ${contentKey(heights)} ${sizeKey(scale.x, scale.y)}`;
            return [{ key, build: () => heightfield(heights, scale), scale: UNIT }];
        }
        case "Voxels": {
            const { data, voxelSize } = shape;
            return [{ key: `voxels ${contentKey(data)}`, build: () => voxels(data, voxelSize), scale: UNIT }];
        }
        default:
            return [];
    }
}

/** The parts of a 2D shape. */
export function parts2(name: string, shape: ShapeLike, names: ReadonlyMap<number, string>): Part[] {
    const fields = shape as Fields;
    const { radius, halfHeight, borderRadius } = fields;
    switch (name) {
        case "Ball":
            return [{ key: "ball", build: ball, scale: [radius, radius, 1] }];
        case "Cuboid": {
            const { x, y } = fields.halfExtents;
            const build = (): BufferGeometry => new Triangles().fan(boxOutline(0.5, 0.5)).geometry();
            return [{ key: "box", build, scale: [2 * x, 2 * y, 1] }];
        }
        case "Capsule": {
            const key = `capsule ${sizeKey(radius, halfHeight)}`;
            return [{ key, build: () => capsule(radius, halfHeight), scale: UNIT }];
        }
        case "RoundCuboid":
            return [polygon("roundbox", boxOutline(fields.halfExtents.x, fields.halfExtents.y), borderRadius)];
        case "Triangle":
        case "RoundTriangle": {
            const corners = [fields.a, fields.b, fields.c].flatMap(({ x, y }) => [x, y]);
            return [polygon(name, outlineOf(corners), name === "Triangle" ? 0 : borderRadius)];
        }
        case "ConvexPolygon":
            return [polygon(name, hullOf(fields.vertices))];
        case "RoundConvexPolygon":
            return [polygon(name, hullOf(fields.vertices), borderRadius)];
        case "HalfSpace":
            return [halfSpace(fields.normal)];
        case "Compound":
            return compound(fields, names);
        default:
            return meshParts(name, fields);
    }
}
