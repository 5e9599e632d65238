// Meshes, height fields and voxels.

import { add, addFixed, addFloor, ORIGIN, rock, turn, vec, X, Y } from "../kit.ts";
import type { Context, RigidBody, Scene } from "../rapier.ts";

const group = "Meshes and landscapes";

/** A surface of triangles, from a function of two parameters in the range 0 to 1. */
function surface(
    rows: number,
    columns: number,
    at: (u: number, v: number) => readonly [number, number, number],
): { vertices: Float32Array; indices: Uint32Array } {
    const vertices: number[] = [];
    const indices: number[] = [];
    for (let row = 0; row <= rows; row++) {
        for (let column = 0; column <= columns; column++) vertices.push(...at(row / rows, column / columns));
    }
    for (let row = 0; row < rows; row++) {
        for (let column = 0; column < columns; column++) {
            const a = row * (columns + 1) + column;
            const c = a + columns + 1;
            indices.push(a, a + 1, c, a + 1, c + 1, c);
        }
    }
    return { vertices: new Float32Array(vertices), indices: new Uint32Array(indices) };
}

/** Bodies of several shapes that fall from a height. */
function addRain(context: Context, count: number, spread: number, height: number): RigidBody[] {
    const { RAPIER, random } = context;
    return Array.from({ length: count }, (_, index) => {
        const at = vec(random.between(-spread, spread), height + 0.12 * index, random.between(-spread, spread));
        const shapes = [
            RAPIER.ColliderDesc.ball(0.35),
            RAPIER.ColliderDesc.cuboid(0.35, 0.35, 0.35),
            RAPIER.ColliderDesc.capsule(0.3, 0.2),
            RAPIER.ColliderDesc.cylinder(0.3, 0.3),
        ];
        return add(context, at, random.pick(shapes), turn(X, random.between(0, 3)));
    });
}

function onGround(bodies: readonly RigidBody[], after: number, floor: number) {
    const check = (): boolean | string => {
        const lost = bodies.filter((body) => {
            const { x, y, z } = body.translation();
            return y < floor && Math.abs(x) < 11 && Math.abs(z) < 11;
        }).length;
        return lost === 0 || `${lost} bodies fell through`;
    };
    return { text: "No body falls through the ground", after, check };
}

const landscape: Scene = {
    id: "heightfield",
    title: "Landscape",
    description: "Shapes roll down the hills of a height field.",
    group,
    camera: { eye: [13, 13, 16], target: [0, -1, 0] },
    poster: 200,
    setup(context) {
        const { RAPIER } = context;
        const [cells, size] = [40, 24];
        const heights = new Float32Array((cells + 1) ** 2);
        for (let column = 0; column <= cells; column++) {
            for (let row = 0; row <= cells; row++) {
                const [x, z] = [(column / cells - 0.5) * size, (row / cells - 0.5) * size];
                const rim = 0.4 * Math.max(0, Math.max(Math.abs(x), Math.abs(z)) - 9) ** 2;
                heights[column * (cells + 1) + row] = 0.9 * Math.sin(0.7 * x) * Math.cos(0.6 * z) + 0.25 * Math.sin(1.7 * x + z) + rim;
            }
        }
        addFixed(context, ORIGIN, RAPIER.ColliderDesc.heightfield(cells, cells, heights, vec(size, 1, size)));
        return { claims: [onGround(addRain(context, 120, 6, 3), 300, -4)] };
    },
};

const bowl: Scene = {
    id: "bowl",
    title: "Bowl",
    description: "Shapes gather in a bowl of thin triangles.",
    group,
    camera: { eye: [8, 9, 10], target: [0, 1, 0] },
    poster: 240,
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        const { vertices, indices } = surface(24, 48, (u, v) => {
            const [angle, radius] = [2 * Math.PI * v, 0.05 + 4.6 * u];
            return [radius * Math.cos(angle), 0.3 + 0.16 * radius * radius, radius * Math.sin(angle)];
        });
        context.paint(addFixed(context, ORIGIN, RAPIER.ColliderDesc.trimesh(vertices, indices)), "grey");
        return { claims: [onGround(addRain(context, 110, 2.5, 4), 300, 0.1)] };
    },
};

const slide: Scene = {
    id: "slide",
    title: "Spiral slide",
    description: "Balls run down a spiral of triangles, over smooth joints between them.",
    group,
    camera: { eye: [8, 10, 9], target: [0, 2.8, 0] },
    poster: 260,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const { vertices, indices } = surface(160, 8, (u, v) => {
            const angle = 6 * Math.PI * u;
            const across = v - 0.5;
            const radius = 2.6 + 1.6 * across;
            return [radius * Math.cos(angle), 6.5 - 6.2 * u + 2.2 * across * across, radius * Math.sin(angle)];
        });
        const flags = RAPIER.TriMeshFlags.FIX_INTERNAL_EDGES;
        paint(addFixed(context, ORIGIN, RAPIER.ColliderDesc.trimesh(vertices, indices, flags).setFriction(0.1)), "grey");
        for (const turnCount of [0, 1, 2, 3, 4, 5]) {
            const angle = (Math.PI / 3) * turnCount;
            addFixed(context, vec(1.5 * Math.cos(angle), 3, 1.5 * Math.sin(angle)), RAPIER.ColliderDesc.capsule(2.9, 0.06));
        }
        const balls: RigidBody[] = [];
        return {
            update: (_time, step) => {
                if (step % 24 !== 0 || balls.length >= 40) return;
                const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(2.6, 7, 0.4);
                const ball = world.createRigidBody(description.setLinvel(0, 0, 1.5));
                world.createCollider(RAPIER.ColliderDesc.ball(0.26).setFriction(0.3), ball);
                paint(ball, (["blue", "orange", "green", "red", "yellow"] as const)[balls.length % 5] ?? "blue");
                balls.push(ball);
            },
            claims: [onGround(balls, 600, -0.5)],
        };
    },
};

const knot: Scene = {
    id: "knot",
    title: "Trefoil knot",
    description: "Boxes fall over a knot, which is a closed mesh that turns.",
    group,
    camera: { eye: [8, 8, 11], target: [0, 2.5, 0] },
    poster: 150,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const centre = (t: number): readonly [number, number, number] => [
            Math.sin(t) + 2 * Math.sin(2 * t),
            Math.cos(t) - 2 * Math.cos(2 * t),
            -1.2 * Math.sin(3 * t),
        ];
        const { vertices, indices } = surface(90, 12, (u, v) => {
            const t = 2 * Math.PI * u;
            const [a, b] = [centre(t), centre(t + 0.01)];
            const way = [b[0] - a[0], b[1] - a[1], b[2] - a[2]] as const;
            const length = Math.hypot(...way);
            const [tx, ty, tz] = [way[0] / length, way[1] / length, way[2] / length];
            const flat = Math.hypot(tx, ty) || 1;
            const side = [-ty / flat, tx / flat, 0] as const;
            const up = [ty * side[2] - tz * side[1], tz * side[0] - tx * side[2], tx * side[1] - ty * side[0]] as const;
            const [c, s] = [0.5 * Math.cos(-2 * Math.PI * v), 0.5 * Math.sin(-2 * Math.PI * v)];
            return [a[0] + c * side[0] + s * up[0], a[1] + c * side[1] + s * up[1], a[2] + c * side[2] + s * up[2]];
        });
        const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setTranslation(0, 2.6, 0).setRotation(turn(X, Math.PI / 2)));
        world.createCollider(RAPIER.ColliderDesc.trimesh(vertices, indices), body);
        body.setAngvel(vec(0, 0.6, 0), true);
        paint(body, "purple");
        addRain(context, 60, 2.5, 6);
    },
};

const voxels: Scene = {
    id: "voxels",
    title: "Voxels",
    description: "A landscape of cubes is one collider, and balls roll over it without bumps at the seams.",
    group,
    camera: { eye: [11, 10, 13], target: [0, 0.5, 0] },
    poster: 150,
    setup(context) {
        const { RAPIER } = context;
        const cells: number[] = [];
        const half = 12;
        for (let x = -half; x < half; x++) {
            for (let z = -half; z < half; z++) {
                const rim = Math.max(Math.abs(x + 0.5), Math.abs(z + 0.5)) > half - 1 ? 3 : 0;
                const top = Math.round(1.6 + 1.5 * Math.sin(0.4 * x) * Math.cos(0.45 * z)) + rim;
                for (let y = 0; y <= top; y++) cells.push(x, y, z);
            }
        }
        const size = 0.7;
        addFixed(context, ORIGIN, RAPIER.ColliderDesc.voxels(new Int32Array(cells), vec(size, size, size)));
        return { claims: [onGround(addRain(context, 100, 6, 6), 300, 0)] };
    },
};

const pebbles: Scene = {
    id: "stairs-of-mesh",
    title: "Rocks on a ramp",
    description: "Convex rocks tumble down a rough ramp of triangles.",
    group,
    camera: { eye: [12, 8, 11], target: [0, 2, 0] },
    poster: 170,
    setup(context) {
        addFloor(context);
        const { RAPIER, random } = context;
        const bumps = Array.from({ length: 41 * 25 }, () => random.between(-0.14, 0.14));
        const { vertices, indices } = surface(40, 24, (u, v) => {
            const bump = bumps[Math.round(u * 40) * 25 + Math.round(v * 24)] ?? 0;
            return [-6 + 11 * u, 5.2 * (1 - u) ** 1.3 + bump, 6 * (v - 0.5)];
        });
        const ramp = addFixed(context, ORIGIN, RAPIER.ColliderDesc.trimesh(vertices, indices));
        context.paint(ramp, "grey");
        const rocks: RigidBody[] = [];
        for (let index = 0; index < 50; index++) {
            const shape = RAPIER.ColliderDesc.convexHull(rock(context, random.between(0.25, 0.5)));
            const at = vec(-5 + 0.5 * (index % 4), 6.2 + 0.35 * index, random.between(-2, 2));
            if (shape) rocks.push(add(context, at, shape, turn(Y, index)));
        }
        return { claims: [onGround(rocks, 420, -0.5)] };
    },
};

export const GROUND: readonly Scene[] = [landscape, bowl, slide, knot, voxels, pebbles];
