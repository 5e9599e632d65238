// Motors of joints.

import { add, addFixed, addFloor, addHook, ORIGIN, turn, vec, X, Y, Z } from "../kit.ts";
import type { PrismaticImpulseJoint, RevoluteImpulseJoint, RigidBody, Scene } from "../rapier.ts";

const group = "Motors";

const wheels: Scene = {
    id: "motors",
    title: "Motors",
    description: "Hinges turn their bars at speeds from slow to fast.",
    group,
    camera: { eye: [3, 4.5, 13], target: [0, 3, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const bars: RigidBody[] = [];
        for (let index = 0; index < 6; index++) {
            const x = 1.9 * (index - 2.5);
            const hook = addHook(context, vec(x, 3, 0));
            const bar = add(context, vec(x, 3, 0.3), RAPIER.ColliderDesc.cuboid(0.16, 0.85, 0.1));
            const joint = world.createImpulseJoint(RAPIER.JointData.revolute(vec(0, 0, 0.3), ORIGIN, Z), hook, bar, true);
            (joint as RevoluteImpulseJoint).configureMotorVelocity(1 + 1.5 * index, 50);
            bars.push(bar);
        }
        const check = (): boolean | string => {
            const wrong = bars.findIndex((bar, index) => Math.abs(bar.angvel().z - (1 + 1.5 * index)) > 0.3);
            return wrong < 0 || `motor ${wrong} turns at ${bars[wrong]!.angvel().z.toFixed(2)} rad/s`;
        };
        return { claims: [{ text: "Each motor has its speed after 3 s", after: 180, check }] };
    },
};

const arm: Scene = {
    id: "robot-arm",
    title: "Robot arm",
    description: "Position motors move an arm of four joints from pose to pose.",
    group,
    camera: { eye: [5, 5, 8.5], target: [0.6, 1.9, 0] },
    poster: 160,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const base = addFixed(context, vec(0, 0.3, 0), RAPIER.ColliderDesc.cylinder(0.3, 0.7));
        paint(base, "grey");
        const turret = add(context, vec(0, 0.9, 0), RAPIER.ColliderDesc.cylinder(0.3, 0.45).setDensity(5));
        const upper = add(context, vec(0, 2.2, 0), RAPIER.ColliderDesc.capsule(0.75, 0.22));
        const fore = add(context, vec(0, 4, 0), RAPIER.ColliderDesc.capsule(0.65, 0.18));
        const hand = add(context, vec(0, 5.1, 0), RAPIER.ColliderDesc.cuboid(0.35, 0.15, 0.3).setDensity(0.5));
        paint(turret, "dark");
        paint(upper, "orange");
        paint(fore, "orange");
        paint(hand, "white");
        const chain = [
            [base, turret, RAPIER.JointData.revolute(vec(0, 0.3, 0), vec(0, -0.3, 0), Y)],
            [turret, upper, RAPIER.JointData.revolute(vec(0, 0.3, 0), vec(0, -1, 0), Z)],
            [upper, fore, RAPIER.JointData.revolute(vec(0, 1, 0), vec(0, -0.8, 0), Z)],
            [fore, hand, RAPIER.JointData.revolute(vec(0, 0.9, 0), vec(0, -0.2, 0), Z)],
        ] as const;
        const joints = chain.map(([first, second, data]) => {
            const joint = world.createImpulseJoint(data, first, second, true) as RevoluteImpulseJoint;
            joint.setContactsEnabled(false);
            joint.configureMotorModel(RAPIER.MotorModel.AccelerationBased);
            return joint;
        });
        for (let box = 0; box < 5; box++) add(context, vec(3.1, 0.25 + 0.5 * box, 0.4 * (box % 2)), RAPIER.ColliderDesc.cuboid(0.25, 0.25, 0.25));
        const poses = [
            [0, -0.5, -0.8, -0.6],
            [1.3, -0.8, -0.5, -0.9],
            [2.5, -0.2, -1.3, -0.4],
            [0.6, -0.9, -0.7, -0.3],
        ] as const;
        return {
            update: (time) => {
                const pose = poses[Math.floor(time / 1.6) % poses.length] ?? poses[0];
                joints.forEach((joint, index) => joint.configureMotorPosition(pose[index] ?? 0, 300, 36));
            },
        };
    },
};

const lift: Scene = {
    id: "lift",
    title: "Lifts",
    description: "Motors of sliders raise platforms with boxes on them, and lower them.",
    group,
    camera: { eye: [7, 6, 13], target: [0, 2.5, 0] },
    poster: 120,
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const lifts: PrismaticImpulseJoint[] = [];
        for (let index = 0; index < 4; index++) {
            const x = 2.6 * (index - 1.5);
            const hook = addHook(context, vec(x, 0.1, 0));
            const deck = add(context, vec(x, 0.4, 0), RAPIER.ColliderDesc.cuboid(1, 0.12, 1).setDensity(2));
            const data = RAPIER.JointData.prismatic(ORIGIN, ORIGIN, Y);
            data.limitsEnabled = true;
            data.limits = [0.2, 5];
            const joint = world.createImpulseJoint(data, hook, deck, true) as PrismaticImpulseJoint;
            joint.configureMotorModel(RAPIER.MotorModel.ForceBased);
            lifts.push(joint);
            for (let box = 0; box < 3; box++) add(context, vec(x, 0.9 + 0.7 * box, 0), RAPIER.ColliderDesc.cuboid(0.35, 0.35, 0.35));
        }
        return {
            update: (time) =>
                lifts.forEach((joint, index) => {
                    const height = 2.4 + 2 * Math.sin(0.9 * time + 1.3 * index - 1.5);
                    joint.configureMotorPosition(0.2 + (height - 0.2) * Math.min(1, time / 3), 900, 160);
                }),
        };
    },
};

const mixer: Scene = {
    id: "mixer",
    title: "Mixer",
    description: "A motor turns paddles through a bowl of balls.",
    group,
    camera: { eye: [6, 8, 9], target: [0, 1.4, 0] },
    poster: 240,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        for (let side = 0; side < 16; side++) {
            const angle = (2 * Math.PI * side) / 16;
            const at = vec(3.1 * Math.cos(angle), 1.2, 3.1 * Math.sin(angle));
            paint(addFixed(context, at, RAPIER.ColliderDesc.cuboid(0.1, 1.2, 0.65), turn(Y, -angle)), "glass");
        }
        const hook = addHook(context, vec(0, 3.2, 0));
        const stirrer = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 1.2, 0));
        world.createCollider(RAPIER.ColliderDesc.cylinder(1.6, 0.12).setTranslation(0, 0.4, 0), stirrer);
        for (let paddle = 0; paddle < 3; paddle++) {
            const angle = (2 * Math.PI * paddle) / 3;
            const shape = RAPIER.ColliderDesc.cuboid(1.3, 0.25, 0.08).setRotation(turn(Y, -angle));
            world.createCollider(shape.setTranslation(1.4 * Math.cos(angle), -0.75, 1.4 * Math.sin(angle)).setDensity(5), stirrer);
        }
        paint(stirrer, "orange");
        const joint = world.createImpulseJoint(RAPIER.JointData.revolute(ORIGIN, vec(0, 2, 0), Y), hook, stirrer, true);
        (joint as RevoluteImpulseJoint).configureMotorVelocity(2.2, 400);
        for (let ball = 0; ball < 200; ball++) {
            const [angle, radius] = [context.random.between(0, 6.28), context.random.between(0.5, 2.4)];
            const at = vec(radius * Math.cos(angle), 2 + 0.04 * ball, radius * Math.sin(angle));
            add(context, at, RAPIER.ColliderDesc.ball(context.random.between(0.18, 0.3)));
        }
        const check = (): boolean => Math.abs(stirrer.angvel().y) > 0.5;
        return { claims: [{ text: "The stirrer still turns after 5 s", after: 300, check }] };
    },
};

const walker: Scene = {
    id: "walker",
    title: "Crawler",
    description: "A long body on six cranks crawls over rubble.",
    group,
    camera: { eye: [-1, 5, 8.5], target: [-4, 0.6, 0] },
    poster: 200,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const body = add(context, vec(-5, 1.3, 0), RAPIER.ColliderDesc.roundCuboid(1.4, 0.12, 0.4, 0.1).setDensity(2));
        paint(body, "teal");
        for (let leg = 0; leg < 6; leg++) {
            const side = leg % 2 === 0 ? 1 : -1;
            const x = 1.2 * (Math.floor(leg / 2) - 1);
            const crank = add(context, vec(-5 + x, 1.3, side * 0.75), RAPIER.ColliderDesc.capsule(0.5, 0.12).setFriction(1.4), turn(Z, leg * 1.05));
            paint(crank, "orange");
            const data = RAPIER.JointData.revolute(vec(x, 0, side * 0.75), vec(0, 0, 0), Z);
            const joint = world.createImpulseJoint(data, body, crank, true) as RevoluteImpulseJoint;
            joint.configureMotorVelocity(-4, 60);
            joint.setContactsEnabled(false);
        }
        for (let stone = 0; stone < 40; stone++) {
            const at = vec(context.random.between(-3, 8), 0.1, context.random.between(-1.6, 1.6));
            const shape = RAPIER.ColliderDesc.cuboid(0.3, context.random.between(0.05, 0.16), 0.3);
            addFixed(context, at, shape, turn(X, context.random.between(-0.2, 0.2)));
        }
        const check = (): boolean => body.translation().x > -4;
        return {
            follow: () => ({ ...body.translation(), y: 0 }),
            claims: [{ text: "It has crawled at least a metre after 5 s", after: 300, check }],
        };
    },
};

export const MOTORS: readonly Scene[] = [wheels, arm, lift, mixer, walker];
