// Meshes, height fields and voxels.

import { add, addFixed, addFloor, addWalls, ORIGIN, vec } from "../kit.ts";
import type { Context, RigidBody, Scene } from "../rapier.ts";

/** Bodies of several shapes that fall from a height. */
function addRain(context: Context, count: number, spread: number, height: number): RigidBody[] {
    const { RAPIER, random } = context;
    return Array.from({ length: count }, (_, index) => {
        const shapes = [RAPIER.ColliderDesc.ball(0.25), RAPIER.ColliderDesc.cuboid(0.25, 0.25), RAPIER.ColliderDesc.capsule(0.2, 0.15)];
        return add(context, vec(random.between(-spread, spread), height + 0.15 * index), random.pick(shapes));
    });
}

function onGround(bodies: readonly RigidBody[], after: number) {
    const check = (): boolean | string => {
        const lost = bodies.filter((body) => body.translation().y < -4).length;
        return lost === 0 || `${lost} bodies fell through`;
    };
    return { text: "No body falls through the ground", after, check };
}

const landscape: Scene = {
    id: "heightfield",
    title: "Landscape",
    description: "Shapes roll into the valleys of a height field.",
    group: "Meshes and landscapes",
    camera: { target: [0, 1.6, 0], height: 10 },
    poster: 240,
    setup(context) {
        const heights = Float32Array.from({ length: 101 }, (_, index) => {
            const x = 0.24 * (index - 50);
            return 0.9 * Math.cos(1.1 * x) + 0.25 * Math.sin(3.1 * x) + 0.05 * x * x;
        });
        addFixed(context, ORIGIN, context.RAPIER.ColliderDesc.heightfield(heights, vec(24, 1)));
        return { claims: [onGround(addRain(context, 120, 6, 4), 300)] };
    },
};

const polyline: Scene = {
    id: "polyline",
    title: "Polyline",
    description: "Balls run down slides of line segments.",
    group: "Meshes and landscapes",
    camera: { target: [0, 4, 0], height: 11 },
    poster: 240,
    setup(context) {
        addFloor(context);
        addWalls(context, 8, 2);
        const { RAPIER, world, paint } = context;
        for (const [side, y] of [[1, 6], [-1, 4], [1, 2]] as const) {
            const points: number[] = [];
            for (let index = 0; index <= 40; index++) {
                const u = index / 40;
                const curl = u > 0.88 ? 3.6 * (u - 0.88) : 0;
                points.push(side * (6 - 10.5 * u), y + 1.9 * (1 - u) ** 1.4 + curl + (index === 0 ? 0.4 : 0));
            }
            addFixed(context, ORIGIN, RAPIER.ColliderDesc.polyline(new Float32Array(points)).setFriction(0.2));
        }
        const balls: RigidBody[] = [];
        return {
            update: (_time, step) => {
                if (step % 14 !== 0 || balls.length >= 70) return;
                const ball = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(5.4, 8.8).setCcdEnabled(true));
                world.createCollider(RAPIER.ColliderDesc.ball(0.22).setRestitution(0.2), ball);
                paint(ball, (["blue", "orange", "green", "red", "yellow"] as const)[balls.length % 5] ?? "blue");
                balls.push(ball);
            },
            claims: [onGround(balls, 400)],
        };
    },
};

const voxels: Scene = {
    id: "voxels",
    title: "Voxels",
    description: "A cave of squares is one collider, and balls roll over it without bumps at the seams.",
    group: "Meshes and landscapes",
    camera: { target: [0, 3.2, 0], height: 10 },
    poster: 240,
    setup(context) {
        const { RAPIER } = context;
        const cells: number[] = [];
        for (let x = -18; x < 18; x++) {
            const top = Math.round(3 + 2.2 * Math.sin(0.35 * x) + Math.max(0, Math.abs(x) - 12));
            for (let y = -4; y <= top; y++) {
                const cave = Math.hypot(x - 3, 1.4 * (y - 1)) < 2.6;
                if (!cave) cells.push(x, y);
            }
        }
        addFixed(context, ORIGIN, RAPIER.ColliderDesc.voxels(new Int32Array(cells), vec(0.5, 0.5)));
        return { claims: [onGround(addRain(context, 90, 5, 6), 300)] };
    },
};

const mesh: Scene = {
    id: "gears",
    title: "Gears of triangles",
    description: "Two meshes with teeth turn into each other and grind balls.",
    group: "Meshes and landscapes",
    camera: { target: [0, 3.4, 0], height: 10 },
    poster: 150,
    setup(context) {
        addFloor(context);
        addWalls(context, 5.2, 6);
        const { RAPIER, world, paint } = context;
        const teeth = 12;
        const vertices: number[] = [0, 0];
        const indices: number[] = [];
        for (let corner = 0; corner < 4 * teeth; corner++) {
            const angle = (2 * Math.PI * corner) / (4 * teeth);
            const radius = corner % 4 < 2 ? 1.95 : 1.5;
            vertices.push(radius * Math.cos(angle), radius * Math.sin(angle));
            indices.push(0, corner + 1, ((corner + 1) % (4 * teeth)) + 1);
        }
        for (const side of [-1, 1]) {
            const gear = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setTranslation(1.9 * side, 2.6).setAngvel(-0.7 * side));
            gear.setRotation(side > 0 ? Math.PI / teeth + 0.12 : 0.12, true);
            world.createCollider(RAPIER.ColliderDesc.trimesh(new Float32Array(vertices), new Uint32Array(indices)), gear);
            paint(gear, side < 0 ? "teal" : "purple");
        }
        addRain(context, 90, 4.5, 6);
    },
};

export const GROUND: readonly Scene[] = [landscape, polyline, voxels, mesh];
