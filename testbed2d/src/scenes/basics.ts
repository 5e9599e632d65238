// Shapes, materials, groups and forces.

import { add, addFixed, addFloor, addWalls, stone, vec } from "../kit.ts";
import type { ColliderDesc, Paint, RigidBody, Scene } from "../rapier.ts";

const shapes: Scene = {
    id: "shapes",
    title: "All shapes",
    description: "One of each kind of shape, and of those with round corners.",
    group: "Shapes",
    camera: { target: [0, 2.2, 0], height: 7 },
    poster: 50,
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        const points = stone(context, 0.6);
        const kinds: (ColliderDesc | null)[] = [
            RAPIER.ColliderDesc.ball(0.55),
            RAPIER.ColliderDesc.cuboid(0.5, 0.5),
            RAPIER.ColliderDesc.capsule(0.4, 0.3),
            RAPIER.ColliderDesc.triangle(vec(-0.6, -0.4), vec(0.6, -0.4), vec(0, 0.6)),
            RAPIER.ColliderDesc.convexHull(points),
            RAPIER.ColliderDesc.roundCuboid(0.35, 0.35, 0.15),
            RAPIER.ColliderDesc.roundTriangle(vec(-0.5, -0.3), vec(0.5, -0.3), vec(0, 0.5), 0.12),
            RAPIER.ColliderDesc.roundConvexHull(points.map((value) => 0.8 * value), 0.12),
        ];
        kinds.forEach((shape, index) => {
            if (shape) add(context, vec(1.7 * ((index % 4) - 1.5), index < 4 ? 2.8 : 1), shape, 0.2);
        });
    },
};

const stones: Scene = {
    id: "stones",
    title: "Convex stones",
    description: "Three hundred different stones fill a box.",
    group: "Shapes",
    camera: { target: [0, 4.4, 0], height: 12 },
    poster: 260,
    setup(context) {
        addFloor(context);
        addWalls(context, 6, 8);
        const { RAPIER, random, paint } = context;
        for (let index = 0; index < 300; index++) {
            const shape = RAPIER.ColliderDesc.convexHull(stone(context, random.between(0.2, 0.5), 4 + random.below(5)));
            const at = vec(random.between(-5.4, 5.4), 1 + 0.07 * index);
            if (shape) paint(add(context, at, shape), random.pick(["grey", "white", "teal", "dark"]));
        }
    },
};

const compounds: Scene = {
    id: "compounds",
    title: "Compounds",
    description: "Crosses, chairs and dumbbells are bodies of several colliders.",
    group: "Shapes",
    camera: { target: [0, 3.4, 0], height: 10 },
    poster: 240,
    setup(context) {
        addFloor(context);
        addWalls(context, 5, 6);
        const { RAPIER, world, random } = context;
        const kinds: (() => ColliderDesc[])[] = [
            () => [RAPIER.ColliderDesc.cuboid(0.5, 0.1), RAPIER.ColliderDesc.cuboid(0.1, 0.5)],
            () => [
                RAPIER.ColliderDesc.cuboid(0.4, 0.07),
                RAPIER.ColliderDesc.cuboid(0.07, 0.35).setTranslation(-0.33, -0.35),
                RAPIER.ColliderDesc.cuboid(0.07, 0.35).setTranslation(0.33, -0.35),
                RAPIER.ColliderDesc.cuboid(0.07, 0.4).setTranslation(-0.33, 0.4),
            ],
            () => [RAPIER.ColliderDesc.cuboid(0.4, 0.07), RAPIER.ColliderDesc.ball(0.22).setTranslation(-0.45, 0), RAPIER.ColliderDesc.ball(0.22).setTranslation(0.45, 0)],
        ];
        for (let index = 0; index < 90; index++) {
            const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(random.between(-4.2, 4.2), 1.5 + 0.22 * index);
            const body = world.createRigidBody(description.setRotation(random.between(0, 6)));
            for (const collider of kinds[index % 3]?.() ?? []) world.createCollider(collider, body);
        }
    },
};

const friction: Scene = {
    id: "friction",
    title: "Friction",
    description: "Boxes of friction 0 to 0.9 on slopes: the slippery ones slide, the others stay.",
    group: "Materials and groups",
    camera: { target: [0, 5.4, 0], height: 12 },
    poster: 80,
    setup(context) {
        addFloor(context);
        const { RAPIER, paint } = context;
        const slope = 0.45;
        const boxes: RigidBody[] = [];
        for (let index = 0; index < 10; index++) {
            const [x, y] = [5.4 * (index % 2 === 0 ? -0.5 : 0.5), 1.6 + 1.75 * Math.floor(index / 2)];
            addFixed(context, vec(x, y), RAPIER.ColliderDesc.cuboid(2.2, 0.06).setFriction(1), -slope);
            const at = vec(x - 1.5 * Math.cos(slope) + 0.26 * Math.sin(slope), y + 1.5 * Math.sin(slope) + 0.27 * Math.cos(slope));
            const shape = RAPIER.ColliderDesc.cuboid(0.3, 0.2).setFriction(0.1 * index);
            const box = add(context, at, shape.setFrictionCombineRule(RAPIER.CoefficientCombineRule.Min), -slope);
            paint(box, index < 5 ? "orange" : "teal");
            boxes.push(box);
        }
        const places = boxes.map((box) => box.translation());
        const check = (): boolean | string => {
            const slid = boxes.map((box, index) => Math.hypot(box.translation().x - places[index]!.x, box.translation().y - places[index]!.y) > 0.4);
            const wrong = slid.findIndex((moves, index) => moves !== index < 5);
            return wrong < 0 || `the box with friction ${(0.1 * wrong).toFixed(1)} ${slid[wrong] ? "slides" : "stays"}`;
        };
        return { claims: [{ text: "Boxes slide where friction is less than the slope of 0.48", after: 240, check }] };
    },
};

const restitution: Scene = {
    id: "restitution",
    title: "Restitution",
    description: "Balls of restitution 0 to 1 bounce, each one higher than the one before.",
    group: "Materials and groups",
    camera: { target: [0, 2.8, 0], height: 8 },
    poster: 76,
    setup(context) {
        addFloor(context);
        const { RAPIER, paint } = context;
        const paints: Paint[] = ["purple", "blue", "teal", "green", "yellow", "orange", "red"];
        const highest = new Array<number>(11).fill(0);
        const balls = highest.map((_, index) => {
            const shape = RAPIER.ColliderDesc.ball(0.4).setRestitution(0.1 * index);
            const ball = add(context, vec(1.1 * (index - 5), 4), shape.setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max));
            paint(ball, paints[Math.floor(index * 0.64)] ?? "red");
            return ball;
        });
        const check = (): boolean => highest.every((height, index) => index === 0 || height > highest[index - 1]! - 0.02);
        return {
            after: (time) => {
                balls.forEach((ball, index) => {
                    if (time > 0.95 && ball.linvel().y < 0.3) highest[index] = Math.max(highest[index]!, ball.translation().y);
                });
            },
            claims: [{ text: "Heights grow with restitution", after: 110, check }],
        };
    },
};

const groups: Scene = {
    id: "collision-groups",
    title: "Collision groups",
    description: "Each floor holds the balls of its own colour, and lets the others fall through.",
    group: "Materials and groups",
    camera: { target: [0, 3.6, 0], height: 10 },
    poster: 240,
    setup(context) {
        addFloor(context);
        const { RAPIER, paint, random } = context;
        const balls: [RigidBody, number][] = [];
        (["red", "yellow", "blue"] as const).forEach((colour, index) => {
            const bit = 1 << index;
            const y = 5 - 1.8 * index;
            // The upper half of the groups are the memberships, the lower half the filter.
            for (const [x, half, angle] of [[0, 4, 0], [-4, 0.5, Math.PI / 2], [4, 0.5, Math.PI / 2]] as const) {
                const floor = RAPIER.ColliderDesc.cuboid(half, 0.08).setCollisionGroups((bit << 16) | bit);
                paint(addFixed(context, vec(x, y + (angle === 0 ? 0 : 0.4)), floor, angle), colour);
            }
            for (let ball = 0; ball < 16; ball++) {
                const shape = RAPIER.ColliderDesc.ball(0.24).setCollisionGroups((bit << 16) | bit);
                const body = add(context, vec(random.between(-3.4, 3.4), 6.5 + 0.2 * ball), shape);
                paint(body, colour);
                balls.push([body, y]);
            }
        });
        const check = (): boolean => balls.filter(([ball, y]) => Math.abs(ball.translation().y - y) < 1).length > 36;
        return { claims: [{ text: "Balls lie on the floor of their colour", after: 240, check }] };
    },
};

const dominance: Scene = {
    id: "dominance",
    title: "Dominance",
    description: "A light ball of higher dominance pushes heavy boxes as if they weighed nothing.",
    group: "Materials and groups",
    camera: { target: [0, 2.4, 0], height: 8 },
    poster: 70,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        for (let index = 0; index < 20; index++) {
            add(context, vec(1 + 0.9 * (index % 4), 0.45 + 0.9 * Math.floor(index / 4)), RAPIER.ColliderDesc.cuboid(0.45, 0.45).setDensity(50));
        }
        const ball = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(-6, 1).setLinvel(7, 0).setDominanceGroup(10));
        world.createCollider(RAPIER.ColliderDesc.ball(1).setDensity(0.1), ball);
        paint(ball, "white");
        return { claims: [{ text: "The ball keeps its speed", after: 120, check: () => ball.translation().x > 3 }] };
    },
};

const planet: Scene = {
    id: "planet",
    title: "Small planet",
    description: "Bodies fall towards a planet from all sides, and pile up on it.",
    group: "Forces",
    camera: { target: [0, 0, 0], height: 15 },
    gravity: 0,
    poster: 300,
    setup(context) {
        const { RAPIER, world, random, paint } = context;
        const globe = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setAngvel(0.12));
        world.createCollider(RAPIER.ColliderDesc.ball(2.2).setFriction(1), globe);
        paint(globe, "teal");
        const bodies = Array.from({ length: 160 }, (_, index) => {
            const [angle, radius] = [random.between(0, 6.28), random.between(3.5, 9)];
            const half = random.between(0.15, 0.3);
            const at = vec(radius * Math.cos(angle), radius * Math.sin(angle));
            const shape = index % 2 === 0 ? RAPIER.ColliderDesc.ball(half) : RAPIER.ColliderDesc.cuboid(half, half);
            return add(context, at, shape.setFriction(1));
        });
        const check = (): boolean => bodies.every((body) => Math.hypot(body.translation().x, body.translation().y) < 10);
        return {
            update: () => {
                for (const body of bodies) {
                    const { x, y } = body.translation();
                    const pull = (-9.81 * body.mass()) / Math.hypot(x, y);
                    body.resetForces(false);
                    body.addForce(vec(pull * x, pull * y), true);
                }
            },
            claims: [{ text: "No body leaves the planet", after: 300, check }],
        };
    },
};

const explosion: Scene = {
    id: "explosions",
    title: "Explosions",
    description: "Every three seconds, impulses throw the boxes apart.",
    group: "Forces",
    camera: { target: [0, 4, 0], height: 12 },
    poster: 122,
    setup(context) {
        addFloor(context);
        addWalls(context, 8.5, 6);
        const { RAPIER } = context;
        const bodies = Array.from({ length: 80 }, (_, index) =>
            add(context, vec(0.82 * ((index % 10) - 4.5), 0.4 + 0.8 * Math.floor(index / 10)), RAPIER.ColliderDesc.cuboid(0.4, 0.4)),
        );
        return {
            update: (_time, step) => {
                if (step % 180 !== 100) return;
                for (const body of bodies) {
                    const at = body.translation();
                    const away = Math.hypot(at.x, at.y) + 0.3;
                    const impulse = (26 * body.mass()) / (1 + away);
                    body.applyImpulse(vec((impulse * at.x) / away, (impulse * (at.y + 0.8)) / away), true);
                    body.applyTorqueImpulse(0.2 * body.mass() * (at.x > 0 ? -1 : 1), true);
                }
            },
        };
    },
};

const fan: Scene = {
    id: "fountain",
    title: "Fountain",
    description: "A jet of air carries balls up in the middle.",
    group: "Forces",
    camera: { target: [0, 4, 0], height: 11 },
    poster: 300,
    parameters: { jet: { label: "Jet", value: 1, min: 0, max: 2, step: 0.05, live: true } },
    setup(context) {
        addFixed(context, vec(-5.1, 0.6), context.RAPIER.ColliderDesc.cuboid(4.6, 0.25), -0.25);
        addFixed(context, vec(5.1, 0.6), context.RAPIER.ColliderDesc.cuboid(4.6, 0.25), 0.25);
        addFloor(context);
        addWalls(context, 8.5, 8);
        const { RAPIER, random } = context;
        const balls = Array.from({ length: 120 }, () => add(context, vec(random.between(-7, 7), random.between(3, 8)), RAPIER.ColliderDesc.ball(random.between(0.15, 0.26))));
        return {
            update: () => {
                const jet = context.parameter<number>("jet");
                for (const ball of balls) {
                    const at = ball.translation();
                    const strength = 34 * jet * Math.exp(-((at.x / 0.8) ** 2)) * Math.max(0, 1 - at.y / 7);
                    ball.resetForces(false);
                    ball.addForce(vec(0, strength * ball.mass()), strength > 0.1);
                }
            },
            draw: (pen) => {
                for (const x of [-0.8, 0, 0.8]) pen.line(vec(x, 0), vec(x, 7 - Math.abs(3 * x)), "teal");
            },
        };
    },
};

export const SHAPES: readonly Scene[] = [shapes, stones, compounds];
export const MATERIALS: readonly Scene[] = [friction, restitution, groups, dominance];
export const FORCES: readonly Scene[] = [planet, explosion, fan];
