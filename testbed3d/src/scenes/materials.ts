// Materials and collision groups.

import { add, addFixed, addFloor, speed, turn, vec, Z } from "../kit.ts";
import type { Paint, RigidBody, Scene } from "../rapier.ts";

const group = "Materials and groups";

const friction: Scene = {
    id: "friction",
    title: "Friction",
    description: "Boxes of friction 0 to 0.9 on a slope: the slippery ones slide, the others stay.",
    group,
    camera: { eye: [9, 6, 12], target: [0, 1.6, 0] },
    poster: 70,
    setup(context) {
        addFloor(context);
        const { RAPIER, paint } = context;
        const slope = 0.45;
        addFixed(context, vec(0, 2, 0), RAPIER.ColliderDesc.cuboid(4.5, 0.1, 5).setFriction(1), turn(Z, -slope));
        const boxes: RigidBody[] = [];
        for (let index = 0; index < 10; index++) {
            const shape = RAPIER.ColliderDesc.cuboid(0.35, 0.2, 0.35).setFriction(0.1 * index);
            const at = vec(-3.4, 2 + 3.4 * Math.tan(slope) + 0.36, index - 4.5);
            const box = add(context, at, shape.setFrictionCombineRule(RAPIER.CoefficientCombineRule.Min), turn(Z, -slope));
            paint(box, index < 5 ? "orange" : "teal");
            boxes.push(box);
        }
        const check = (): boolean | string => {
            const slid = boxes.map((box) => box.translation().x > -2.8);
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
    group,
    camera: { eye: [3, 4, 12], target: [0, 2, 0] },
    poster: 76,
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        const paints: Paint[] = ["purple", "blue", "teal", "green", "yellow", "orange", "red"];
        const highest = new Array<number>(11).fill(0);
        const balls = highest.map((_, index) => {
            const shape = RAPIER.ColliderDesc.ball(0.35).setRestitution(0.1 * index);
            const ball = add(context, vec(0.95 * (index - 5), 4, 0), shape.setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max));
            context.paint(ball, paints[Math.floor(index * 0.64)] ?? "red");
            return ball;
        });
        const check = (): boolean => highest.every((height, index) => index === 0 || height > highest[index - 1]! - 0.02);
        return {
            after: (time) => {
                // The first bounce ends the fall of 0.86 s.
                balls.forEach((ball, index) => {
                    if (time > 0.95 && ball.linvel().y < 0.3) highest[index] = Math.max(highest[index]!, ball.translation().y);
                });
            },
            claims: [{ text: "Heights grow with restitution", after: 110, check }],
        };
    },
};

const mixture: Scene = {
    id: "conveyor",
    title: "Turntables",
    description: "Kinematic discs carry boxes by friction.",
    group,
    camera: { eye: [8, 8, 10], target: [0, 0.4, 0] },
    poster: 150,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, random } = context;
        for (let disc = 0; disc < 4; disc++) {
            const [x, z] = [2.55 * (disc % 2 === 0 ? -1 : 1), 2.55 * (disc < 2 ? -1 : 1)];
            const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setTranslation(x, 0.25, z));
            world.createCollider(RAPIER.ColliderDesc.cylinder(0.2, 2.5).setFriction(0.9), body);
            body.setAngvel(vec(0, disc === 0 || disc === 3 ? 0.8 : -0.8, 0), true);
            context.paint(body, disc === 0 || disc === 3 ? "teal" : "purple");
            for (let box = 0; box < 8; box++) {
                const at = vec(x + random.between(-1.5, 1.5), 0.8 + 0.7 * box, z + random.between(-1.5, 1.5));
                context.paint(add(context, at, RAPIER.ColliderDesc.cuboid(0.3, 0.3, 0.3).setFriction(0.9)), "orange");
            }
        }
    },
};

const GROUPS = [
    ["red", 1],
    ["yellow", 2],
    ["blue", 4],
] as const;

const groups: Scene = {
    id: "collision-groups",
    title: "Collision groups",
    description: "Each floor holds the balls of its own colour, and lets the others fall through.",
    group,
    camera: { eye: [7, 7, 11], target: [0, 2.6, 0] },
    poster: 200,
    setup(context) {
        addFloor(context);
        const { RAPIER, paint, random } = context;
        const balls: [RigidBody, number][] = [];
        GROUPS.forEach(([colour, bit], index) => {
            // The upper half of the groups are the memberships, the lower half the filter.
            const floor = RAPIER.ColliderDesc.cuboid(2.4, 0.08, 2.4).setCollisionGroups((bit << 16) | bit);
            paint(addFixed(context, vec(0, 4.6 - 1.6 * index, 0), floor), colour);
            for (let ball = 0; ball < 20; ball++) {
                const at = vec(random.between(-1.8, 1.8), 6 + 0.25 * ball + 0.1 * index, random.between(-1.8, 1.8));
                const shape = RAPIER.ColliderDesc.ball(0.25).setFriction(1).setCollisionGroups((bit << 16) | (bit | 8));
                const body = add(context, at, shape);
                body.setAngularDamping(6);
                body.setLinearDamping(0.2);
                paint(body, colour);
                balls.push([body, 4.6 - 1.6 * index]);
            }
        });
        const check = (): boolean => balls.filter(([ball, floor]) => Math.abs(ball.translation().y - floor) < 1.4).length > 20;
        return { claims: [{ text: "Balls lie on the floor of their colour", after: 180, check }] };
    },
};

const dominance: Scene = {
    id: "dominance",
    title: "Dominance",
    description: "A light ball of higher dominance pushes heavy boxes as if they weighed nothing.",
    group,
    camera: { eye: [8, 6, 10], target: [0, 0.8, 0] },
    poster: 60,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        for (let index = 0; index < 30; index++) {
            const at = vec(1 + 0.82 * (index % 3), 0.4 + 0.8 * Math.floor(index / 15), 0.85 * ((Math.floor(index / 3) % 5) - 2));
            add(context, at, RAPIER.ColliderDesc.cuboid(0.4, 0.4, 0.4).setDensity(50));
        }
        const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(-5, 0.7, 0).setLinvel(7, 0, 0).setDominanceGroup(10);
        const ball = world.createRigidBody(description);
        world.createCollider(RAPIER.ColliderDesc.ball(0.7).setDensity(0.1), ball);
        paint(ball, "white");
        return { claims: [{ text: "The ball keeps its speed", after: 120, check: () => ball.translation().x > 3 }] };
    },
};

const scale: Scene = {
    id: "damping",
    title: "Damping",
    description: "Spinning tops with growing damping slow down, from left to right.",
    group: "Forces",
    camera: { eye: [3, 4, 10], target: [0, 0.8, 0] },
    poster: 60,
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        const tops: RigidBody[] = [];
        for (let index = 0; index < 8; index++) {
            const shape = RAPIER.ColliderDesc.roundCylinder(0.2, 0.4, 0.05).setFriction(0.05);
            const top = add(context, vec(1.3 * (index - 3.5), 0.26, 0), shape);
            top.setAngvel(vec(0, 20, 0), true);
            top.setAngularDamping(0.3 * index);
            tops.push(top);
        }
        const check = (): boolean =>
            tops.every((top, index) => index === 0 || speed(top.angvel()) <= speed(tops[index - 1]!.angvel()) + 0.05);
        return { claims: [{ text: "More damping leaves less speed", after: 120, check }] };
    },
};

export const MATERIALS: readonly Scene[] = [friction, restitution, mixture, groups, dominance];
export const DAMPING: Scene = scale;
