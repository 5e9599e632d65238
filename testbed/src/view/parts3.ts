// Geometry of 3D shapes.

import {
    BoxGeometry,
    BufferGeometry,
    CapsuleGeometry,
    ConeGeometry,
    CylinderGeometry,
    Float32BufferAttribute,
    LatheGeometry,
    Matrix4,
    PlaneGeometry,
    Quaternion,
    SphereGeometry,
    Vector2,
    Vector3,
} from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import type { ShapeLike, Vec } from "../core/engine.ts";
import { contentKey, sizeKey, type Part } from "./parts.ts";

type Fields = ShapeLike & {
    radius: number;
    halfHeight: number;
    borderRadius: number;
    halfExtents: Vec;
    a: Vec;
    b: Vec;
    c: Vec;
    normal: Vec;
    vertices: Float32Array;
    indices?: Uint32Array | null;
    nrows: number;
    ncols: number;
    heights: Float32Array;
    scale: Vec;
    data: ArrayLike<number>;
    voxelSize: Vec;
    shapes: ShapeLike[];
    positions: Vec[];
    rotations: (Vec & { w: number })[];
};

/** Tone of the dark half of balls and wheels, which makes rotation visible. */
const SHADE = 0.72;
const UNIT = [1, 1, 1] as const;

/** Gives each triangle one tone by the position of its centre. */
function toned(source: BufferGeometry, shade: (x: number, y: number, z: number) => number): BufferGeometry {
    const geometry = source.index ? source.toNonIndexed() : source;
    const position = geometry.getAttribute("position");
    const colors = new Float32Array(position.count * 3);
    for (let first = 0; first < position.count; first += 3) {
        const centre = [0, 0, 0];
        for (let corner = first; corner < first + 3; corner++) {
            centre[0]! += position.getX(corner) / 3;
            centre[1]! += position.getY(corner) / 3;
            centre[2]! += position.getZ(corner) / 3;
        }
        colors.fill(shade(centre[0]!, centre[1]!, centre[2]!), first * 3, first * 3 + 9);
    }
    geometry.setAttribute("color", new Float32BufferAttribute(colors, 3));
    return geometry;
}

const plain = (geometry: BufferGeometry): BufferGeometry => toned(geometry, () => 1);
const quartered = (x: number, _: number, z: number): number => (x * z > 0 ? 1 : SHADE);

function ball(): BufferGeometry {
    return toned(new SphereGeometry(1, 24, 16), (x, y, z) => (x * y * z > 0 ? 1 : SHADE));
}

/** A surface without shared vertices, so that each triangle has its own normal. */
function faceted(vertices: ArrayLike<number>, indices: ArrayLike<number>): BufferGeometry {
    const points = new Float32Array(indices.length * 3);
    for (let corner = 0; corner < indices.length; corner++) {
        const from = (indices[corner] ?? 0) * 3;
        for (let axis = 0; axis < 3; axis++) points[corner * 3 + axis] = vertices[from + axis] ?? 0;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
    geometry.computeVertexNormals();
    return plain(geometry);
}

function hull(vertices: Float32Array, border = 0): BufferGeometry {
    const points: Vector3[] = [];
    const corners = border > 0 ? sphereDirections() : [new Vector3()];
    for (let at = 0; at + 2 < vertices.length; at += 3) {
        const centre = new Vector3(vertices[at], vertices[at + 1], vertices[at + 2]);
        for (const corner of corners) points.push(centre.clone().addScaledVector(corner, border));
    }
    return plain(new ConvexGeometry(points));
}

/** The directions of a coarse sphere, which rounds the corners of hulls. */
function sphereDirections(): Vector3[] {
    const directions: Vector3[] = [];
    const position = new SphereGeometry(1, 8, 6).getAttribute("position");
    for (let index = 0; index < position.count; index++) {
        directions.push(new Vector3().fromBufferAttribute(position, index));
    }
    return directions;
}

/** The height field's matrix is stored by columns: rows run along z, columns along x. */
function heightfield(shape: Fields): BufferGeometry {
    const { nrows, ncols, heights, scale } = shape;
    const vertices: number[] = [];
    const indices: number[] = [];
    for (let column = 0; column <= ncols; column++) {
        for (let row = 0; row <= nrows; row++) {
            const height = heights[column * (nrows + 1) + row] ?? 0;
            vertices.push((column / ncols - 0.5) * scale.x, height * scale.y, (row / nrows - 0.5) * scale.z);
        }
    }
    const at = (row: number, column: number): number => column * (nrows + 1) + row;
    for (let column = 0; column < ncols; column++) {
        for (let row = 0; row < nrows; row++) {
            const [a, b, c, d] = [at(row, column), at(row + 1, column), at(row, column + 1), at(row + 1, column + 1)];
            indices.push(a, b, c, c, b, d);
        }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(vertices, 3));
    geometry.setIndex(indices);
    geometry.computeVertexNormals();
    return plain(geometry);
}

/** Only the faces of voxels without a neighbour are drawn. */
function voxels(shape: Fields): BufferGeometry {
    const { data, voxelSize } = shape;
    const filled = new Set<string>();
    for (let at = 0; at + 2 < data.length; at += 3) filled.add(`${data[at]},${data[at + 1]},${data[at + 2]}`);
    const sides = [
        [1, 0, 0],
        [-1, 0, 0],
        [0, 1, 0],
        [0, -1, 0],
        [0, 0, 1],
        [0, 0, -1],
    ] as const;
    const points: number[] = [];
    for (let at = 0; at + 2 < data.length; at += 3) {
        const cell = [data[at] ?? 0, data[at + 1] ?? 0, data[at + 2] ?? 0] as const;
        for (const side of sides) {
            const neighbour = `${cell[0] + side[0]},${cell[1] + side[1]},${cell[2] + side[2]}`;
            if (!filled.has(neighbour)) pushFace(points, cell, side, voxelSize);
        }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
    geometry.computeVertexNormals();
    return plain(geometry);
}

type Triple = readonly [number, number, number];

function pushFace(points: number[], cell: Triple, side: Triple, size: Vec): void {
    const normal = new Vector3(...side);
    const u = new Vector3(side[1], side[2], side[0]);
    const v = new Vector3().crossVectors(normal, u);
    for (const [s, t] of [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, -1],
        [1, 1],
        [-1, 1],
    ] as const) {
        const corner = normal.clone().addScaledVector(u, s).addScaledVector(v, t).multiplyScalar(0.5);
        points.push(
            (cell[0] + 0.5 + corner.x) * size.x,
            (cell[1] + 0.5 + corner.y) * size.y,
            (cell[2] + 0.5 + corner.z) * size.z,
        );
    }
}

/** The outline of a cylinder or cone with a rounded border, turned about the y axis. */
function roundLathe(profile: readonly (readonly [number, number])[], border: number): BufferGeometry {
    const points: Vector2[] = [new Vector2(0, (profile[0]?.[1] ?? 0) - border)];
    profile.forEach(([x, y], index) => {
        const [from, to] = index === 0 ? [-Math.PI / 2, 0.2] : [0.2, Math.PI / 2];
        for (let step = 0; step <= 6; step++) {
            const angle = from + ((to - from) * step) / 6;
            points.push(new Vector2(x + border * Math.cos(angle), y + border * Math.sin(angle)));
        }
    });
    points.push(new Vector2(0, (profile[profile.length - 1]?.[1] ?? 0) + border));
    return toned(new LatheGeometry(points, 32), quartered);
}

function halfSpace(normal: Vec): Part {
    const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(normal.x, normal.y, normal.z));
    const offset = new Matrix4().makeRotationFromQuaternion(turn);
    return { key: "plane", build: () => plain(new PlaneGeometry(400, 400)), scale: UNIT, offset };
}

function compound(shape: Fields, names: ReadonlyMap<number, string>): Part[] {
    return shape.shapes.flatMap((piece, index) => {
        const position = shape.positions[index] ?? { x: 0, y: 0, z: 0 };
        const rotation = shape.rotations[index] ?? { x: 0, y: 0, z: 0, w: 1 };
        const pose = new Matrix4().compose(
            new Vector3(position.x, position.y, position.z),
            new Quaternion(rotation.x, rotation.y, rotation.z, rotation.w),
            new Vector3(1, 1, 1),
        );
        return parts3(names.get(piece.type) ?? "", piece, names).map((part) => ({
            ...part,
            offset: part.offset ? pose.clone().multiply(part.offset) : pose,
        }));
    });
}

/** The parts of shapes with rounded borders. */
function roundParts(name: string, shape: Fields): Part[] {
    const border = shape.borderRadius;
    if (name === "RoundCuboid") {
        const { x, y, z } = shape.halfExtents;
        const sizes = [x + border, y + border, z + border].map((half) => 2 * half) as [number, number, number];
        const build = (): BufferGeometry => plain(new RoundedBoxGeometry(...sizes, 3, border));
        return [{ key: `roundbox ${sizeKey(...sizes, border)}`, build, scale: UNIT }];
    }
    if (name === "RoundConvexPolyhedron") {
        const key = `roundhull ${contentKey(shape.vertices)} ${sizeKey(border)}`;
        return [{ key, build: () => hull(shape.vertices, border), scale: UNIT }];
    }
    if (name === "RoundTriangle") {
        const points = new Float32Array([shape.a, shape.b, shape.c].flatMap(({ x, y, z }) => [x, y, z]));
        return [{ key: `roundhull ${contentKey(points)}`, build: () => hull(points, border), scale: UNIT }];
    }
    const { radius, halfHeight } = shape;
    const top = name === "RoundCone" ? 0 : radius;
    const profile = [
        [radius, -halfHeight],
        [top, halfHeight],
    ] as const;
    const key = `${name} ${sizeKey(radius, halfHeight, border)}`;
    return [{ key, build: () => roundLathe(profile, border), scale: UNIT }];
}

/** The parts of meshes, whose geometry is the shape's own. */
function meshParts(name: string, shape: Fields): Part[] {
    switch (name) {
        case "ConvexPolyhedron":
            return [{ key: `hull ${contentKey(shape.vertices)}`, build: () => hull(shape.vertices), scale: UNIT }];
        case "TriMesh": {
            const indices = shape.indices ?? new Uint32Array();
            const key = `mesh ${contentKey(shape.vertices, indices)}`;
            return [{ key, build: () => faceted(shape.vertices, indices), scale: UNIT }];
        }
        case "Triangle": {
            const points = [shape.a, shape.b, shape.c].flatMap(({ x, y, z }) => [x, y, z]);
            const build = (): BufferGeometry => faceted(points, [0, 1, 2, 0, 2, 1]);
            return [{ key: `mesh ${contentKey(points)}`, build, scale: UNIT }];
        }
        case "HeightField": {
            const { x, y, z } = shape.scale;
            const key = `field ${contentKey(shape.heights)} ${sizeKey(x, y, z)}`;
            return [{ key, build: () => heightfield(shape), scale: UNIT }];
        }
        case "Voxels":
            return [{ key: `voxels ${contentKey(shape.data)}`, build: () => voxels(shape), scale: UNIT }];
        default:
            return [];
    }
}

/** The parts of a 3D shape; lines and unknown shapes have none. */
export function parts3(name: string, shape: ShapeLike, names: ReadonlyMap<number, string>): Part[] {
    const fields = shape as Fields;
    const { radius, halfHeight } = fields;
    switch (name) {
        case "Ball":
            return [{ key: "ball", build: ball, scale: [radius, radius, radius] }];
        case "Cuboid": {
            const { x, y, z } = fields.halfExtents;
            return [{ key: "box", build: () => plain(new BoxGeometry()), scale: [2 * x, 2 * y, 2 * z], box: true }];
        }
        case "Capsule": {
            const build = (): BufferGeometry => toned(new CapsuleGeometry(radius, 2 * halfHeight, 8, 20), quartered);
            return [{ key: `capsule ${sizeKey(radius, halfHeight)}`, build, scale: UNIT }];
        }
        case "Cylinder": {
            const build = (): BufferGeometry => toned(new CylinderGeometry(1, 1, 1, 32), quartered);
            return [{ key: "cylinder", build, scale: [radius, 2 * halfHeight, radius] }];
        }
        case "Cone": {
            const build = (): BufferGeometry => toned(new ConeGeometry(1, 1, 32), quartered);
            return [{ key: "cone", build, scale: [radius, 2 * halfHeight, radius] }];
        }
        case "HalfSpace":
            return [halfSpace(fields.normal)];
        case "Compound":
            return compound(fields, names);
        default:
            return name.startsWith("Round") ? roundParts(name, fields) : meshParts(name, fields);
    }
}
