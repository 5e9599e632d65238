// Shapes: primitives, rounded ones, hulls, compounds.

import { add, addFloor, addPit, rock, turn, UPRIGHT, vec, X, Z } from "../kit.ts";
import type { ColliderDesc, Scene } from "../rapier.ts";

const group = "Shapes";

const all: Scene = {
    id: "shapes",
    title: "All shapes",
    description: "One of each kind of shape, and of those with round edges.",
    group,
    camera: { eye: [5, 7, 12], target: [0, 0.8, 0] },
    poster: 60,
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        const points = rock(context, 0.6, 10);
        const shapes: (ColliderDesc | null)[] = [
            RAPIER.ColliderDesc.ball(0.6),
            RAPIER.ColliderDesc.cuboid(0.55, 0.55, 0.55),
            RAPIER.ColliderDesc.capsule(0.4, 0.35),
            RAPIER.ColliderDesc.cylinder(0.5, 0.5),
            RAPIER.ColliderDesc.cone(0.6, 0.55),
            RAPIER.ColliderDesc.convexHull(points),
            RAPIER.ColliderDesc.roundCuboid(0.4, 0.4, 0.4, 0.15),
            RAPIER.ColliderDesc.roundCylinder(0.35, 0.4, 0.15),
            RAPIER.ColliderDesc.roundCone(0.45, 0.4, 0.12),
            RAPIER.ColliderDesc.roundConvexHull(points.map((value) => 0.8 * value), 0.12),
        ];
        shapes.forEach((shape, index) => {
            const at = vec(2 * ((index % 5) - 2), 1.4, index < 5 ? -1.2 : 1.2);
            if (shape) add(context, at, shape, turn(X, 0.35));
        });
    },
};

const rocks: Scene = {
    id: "rocks",
    title: "Convex hulls",
    description: "Two hundred different rocks fall into a pit.",
    group,
    camera: { eye: [7, 8, 10], target: [0, 1.4, 0] },
    poster: 240,
    setup(context) {
        addFloor(context);
        addPit(context, 3.2, 3);
        const { RAPIER, random, paint } = context;
        for (let index = 0; index < 200; index++) {
            const shape = RAPIER.ColliderDesc.convexHull(rock(context, random.between(0.25, 0.5), 8 + random.below(10)));
            const at = vec(random.between(-2.6, 2.6), 1.5 + 0.12 * index, random.between(-2.6, 2.6));
            if (shape) paint(add(context, at, shape), random.pick(["grey", "white", "teal", "dark"]));
        }
    },
};

const compounds: Scene = {
    id: "compounds",
    title: "Compounds",
    description: "Jacks, tables and dumbbells are bodies of several colliders.",
    group,
    camera: { eye: [7, 7, 9], target: [0, 1.2, 0] },
    poster: 240,
    setup(context) {
        addFloor(context);
        addPit(context, 3.5, 2.4);
        const { RAPIER, world, random } = context;
        const kinds: (() => ColliderDesc[])[] = [
            () => [RAPIER.ColliderDesc.capsule(0.4, 0.1), RAPIER.ColliderDesc.capsule(0.4, 0.1).setRotation(turn(X, Math.PI / 2)), RAPIER.ColliderDesc.capsule(0.4, 0.1).setRotation(turn(Z, Math.PI / 2))],
            () => [
                RAPIER.ColliderDesc.cuboid(0.5, 0.05, 0.4).setTranslation(0, 0.3, 0),
                ...[-1, 1].flatMap((x) => [-1, 1].map((z) => RAPIER.ColliderDesc.cuboid(0.05, 0.3, 0.05).setTranslation(0.42 * x, -0.02, 0.32 * z))),
            ],
            () => [RAPIER.ColliderDesc.cylinder(0.35, 0.08), RAPIER.ColliderDesc.ball(0.26).setTranslation(0, 0.4, 0), RAPIER.ColliderDesc.ball(0.26).setTranslation(0, -0.4, 0)],
        ];
        for (let index = 0; index < 72; index++) {
            const at = vec(random.between(-2.6, 2.6), 1.5 + 0.22 * index, random.between(-2.6, 2.6));
            const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(at.x, at.y, at.z);
            const body = world.createRigidBody(description.setRotation(turn(X, random.between(0, 3))));
            for (const collider of kinds[index % kinds.length]?.() ?? []) world.createCollider(collider, body);
        }
    },
};

const rings: Scene = {
    id: "rings",
    title: "Rings on pegs",
    description: "Rings of twelve pieces fall over pegs, and some of them stay there.",
    group,
    camera: { eye: [6, 6, 9], target: [0, 1.2, 0] },
    poster: 200,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, random, paint } = context;
        for (let peg = 0; peg < 9; peg++) {
            const body = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(1.7 * ((peg % 3) - 1), 1, 1.7 * (Math.floor(peg / 3) - 1)));
            world.createCollider(RAPIER.ColliderDesc.capsule(1, 0.12), body);
        }
        const pieces = 12;
        const shapes = Array.from({ length: pieces }, () => new RAPIER.Capsule(0.14, 0.09));
        const angles = shapes.map((_, index) => (2 * Math.PI * index) / pieces);
        const positions = angles.map((angle) => vec(0.52 * Math.cos(angle), 0, 0.52 * Math.sin(angle)));
        // A piece lies along the ring: the capsule's axis turns from y into the tangent.
        const rotations = angles.map((angle) => {
            const lie = turn(X, Math.PI / 2);
            const s = Math.sin(-angle / 2);
            const c = Math.cos(angle / 2);
            return { x: c * lie.x, y: s * lie.w, z: -s * lie.x, w: c * lie.w };
        });
        for (let ring = 0; ring < 45; ring++) {
            const at = vec(1.7 * (random.below(3) - 1) + random.between(-0.3, 0.3), 3.4 + 0.25 * ring, 1.7 * (random.below(3) - 1) + random.between(-0.3, 0.3));
            const body = add(context, at, RAPIER.ColliderDesc.compound(shapes, positions, rotations), UPRIGHT);
            paint(body, (["red", "orange", "yellow", "green", "teal", "blue", "purple"] as const)[ring % 7] ?? "red");
        }
    },
};

export const SHAPES: readonly Scene[] = [all, rocks, compounds, rings];
