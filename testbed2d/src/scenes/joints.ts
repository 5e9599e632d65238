// Joints and motors.

import { hangingArc } from "../../../testbed/src/core/arc.ts";
import { add, addFixed, addFloor, addHook, drawJoints, ORIGIN, vec } from "../kit.ts";
import type { Paint, PrismaticImpulseJoint, RevoluteImpulseJoint, RigidBody, Scene } from "../rapier.ts";

const group = "Joints and motors";

const bridge: Scene = {
    id: "bridge",
    title: "Hanging bridge",
    description: "Planks on hinges carry a load of boxes and balls.",
    group,
    camera: { target: [0, 3, 0], height: 12 },
    poster: 200,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint, random } = context;
        const [planks, pitch, height] = [20, 0.7, 3.9];
        const arc = hangingArc(planks, pitch, 15);
        const ends = [-1, 1].map((sign) => addFixed(context, vec((arc.bank + 1) * sign, 2), RAPIER.ColliderDesc.cuboid(1, 2)));
        let previous = ends[0]!;
        let anchor = vec(1, height - 2);
        let lowest = previous;
        for (let index = 0; index < planks; index++) {
            const { angle, x, y } = arc.place(index);
            const plank = add(context, vec(x, height + y), RAPIER.ColliderDesc.cuboid(0.34, 0.09).setDensity(3), angle);
            paint(plank, index % 2 === 0 ? "orange" : "yellow");
            world.createImpulseJoint(RAPIER.JointData.revolute(anchor, vec(-pitch / 2, 0)), previous, plank, true);
            if (index === planks / 2) lowest = plank;
            previous = plank;
            anchor = vec(pitch / 2, 0);
        }
        world.createImpulseJoint(RAPIER.JointData.revolute(anchor, vec(-1, height - 2)), previous, ends[1]!, true);
        for (let load = 0; load < 24; load++) {
            const shape = load % 2 === 0 ? RAPIER.ColliderDesc.ball(0.35) : RAPIER.ColliderDesc.cuboid(0.35, 0.35);
            add(context, vec(random.between(-4, 4), 5 + 0.5 * load), shape);
        }
        const check = (): boolean => {
            const { y } = lowest.translation();
            return y > 0.5 && y < height - 1 && previous.translation().y > y;
        };
        return { claims: [{ text: "The bridge hangs and holds for 10 s", after: 600, check }] };
    },
};

const kinds: Scene = {
    id: "joints",
    title: "Kinds of joints",
    description: "Fixed, hinge, slider, rope and spring, from left to right.",
    group,
    camera: { target: [0, 3.4, 0], height: 9 },
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const [top, up] = [vec(0, -0.9), vec(0, 0.5)];
        const slider = RAPIER.JointData.prismatic(top, up, vec(0, 1));
        slider.limitsEnabled = true;
        slider.limits = [-0.8, 0.6];
        const joints = [
            RAPIER.JointData.fixed(top, 0, up, 0),
            RAPIER.JointData.revolute(top, up),
            slider,
            RAPIER.JointData.rope(1.6, ORIGIN, ORIGIN),
            RAPIER.JointData.spring(1.4, 60, 2, ORIGIN, ORIGIN),
        ];
        const paints: Paint[] = ["red", "orange", "yellow", "teal", "blue"];
        const bodies = joints.map((data, index) => {
            const x = 2.4 * (index - 2);
            const hook = addHook(context, vec(x, 6));
            const body = add(context, vec(x, 4.6), RAPIER.ColliderDesc.cuboid(0.35, 0.5));
            paint(body, paints[index] ?? "white");
            body.setLinvel(vec(2, 1), true);
            world.createImpulseJoint(data, hook, body, true);
            return body;
        });
        const check = (): boolean => Math.hypot(bodies[0]!.translation().x + 4.8, bodies[0]!.translation().y - 4.6) < 0.05;
        return {
            draw: (pen) => drawJoints(context, pen.line),
            claims: [{ text: "The fixed joint holds its body in place", after: 300, check }],
        };
    },
};

const cradle: Scene = {
    id: "cradle",
    title: "Newton's cradle",
    description: "Steel balls hand an impulse through the row.",
    group,
    camera: { target: [0, 2.6, 0], height: 7 },
    poster: 20,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const [balls, radius, length] = [6, 0.4, 3];
        for (let index = 0; index < balls; index++) {
            const x = (index - (balls - 1) / 2) * 2 * radius;
            const hook = addHook(context, vec(x, 4.5));
            const angle = index === 0 ? -1 : 0;
            const at = vec(x + length * Math.sin(angle), 4.5 - length * Math.cos(angle));
            const shape = RAPIER.ColliderDesc.ball(radius).setRestitution(1).setFriction(0);
            const ball = add(context, at, shape.setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max), angle);
            paint(ball, "white");
            world.createImpulseJoint(RAPIER.JointData.revolute(ORIGIN, vec(0, length)), hook, ball, true);
        }
        return { draw: (pen) => drawJoints(context, pen.line) };
    },
};

const wrecking: Scene = {
    id: "wrecking-ball",
    title: "Wrecking ball",
    description: "A chain swings a heavy ball into a wall.",
    group,
    camera: { target: [1, 5, 0], height: 14 },
    poster: 110,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        let previous = addHook(context, vec(-2, 10));
        let anchor = ORIGIN;
        for (let link = 0; link < 12; link++) {
            const body = add(context, vec(-2.3 - 0.6 * link, 10), RAPIER.ColliderDesc.capsule(0.22, 0.08).setDensity(20), Math.PI / 2);
            paint(body, "grey");
            world.createImpulseJoint(RAPIER.JointData.revolute(anchor, vec(0, -0.3)), previous, body, true);
            previous = body;
            anchor = vec(0, 0.3);
        }
        const ball = add(context, vec(-10.2, 10), RAPIER.ColliderDesc.ball(1).setDensity(8));
        paint(ball, "dark");
        world.createImpulseJoint(RAPIER.JointData.revolute(anchor, vec(0.7, 0)), previous, ball, true);
        for (let row = 0; row < 10; row++) {
            for (let column = 0; column < 4; column++) {
                add(context, vec(2 + 1.02 * column + (row % 2) * 0.5, 0.4 + 0.8 * row), RAPIER.ColliderDesc.cuboid(0.5, 0.4));
            }
        }
    },
};

const motors: Scene = {
    id: "motors",
    title: "Motors",
    description: "Hinges turn their bars at speeds from slow to fast.",
    group,
    camera: { target: [0, 2.6, 0], height: 7.5 },
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const bars = Array.from({ length: 6 }, (_, index) => {
            const x = 2 * (index - 2.5);
            const hook = addHook(context, vec(x, 3));
            const bar = add(context, vec(x, 3), RAPIER.ColliderDesc.cuboid(0.16, 0.85));
            const joint = world.createImpulseJoint(RAPIER.JointData.revolute(ORIGIN, ORIGIN), hook, bar, true);
            (joint as RevoluteImpulseJoint).configureMotorVelocity(1 + 1.5 * index, 50);
            return bar;
        });
        const check = (): boolean => bars.every((bar, index) => Math.abs(bar.angvel() - (1 + 1.5 * index)) < 0.3);
        return { claims: [{ text: "Each motor has its speed after 3 s", after: 180, check }] };
    },
};

const arm: Scene = {
    id: "robot-arm",
    title: "Robot arm",
    description: "Position motors move an arm of four joints from pose to pose.",
    group,
    camera: { target: [0.6, 2.4, 0], height: 8 },
    poster: 150,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        let previous = addFixed(context, vec(0, 0.3), RAPIER.ColliderDesc.cuboid(0.7, 0.3));
        paint(previous, "grey");
        let top = 0.3;
        const joints = [1.3, 1.1, 0.8, 0.4].map((length, index) => {
            const half = length / 2;
            const at = vec(0, 0.3 + top + half);
            const link = add(context, at, RAPIER.ColliderDesc.capsule(half, 0.2 - 0.03 * index));
            paint(link, index === 3 ? "white" : "orange");
            const anchor = vec(0, index === 0 ? 0.3 : [1.3, 1.1, 0.8][index - 1]! / 2);
            const joint = world.createImpulseJoint(RAPIER.JointData.revolute(anchor, vec(0, -half)), previous, link, true) as RevoluteImpulseJoint;
            joint.setContactsEnabled(false);
            joint.configureMotorModel(RAPIER.MotorModel.AccelerationBased);
            previous = link;
            top += length;
            return joint;
        });
        for (let box = 0; box < 5; box++) add(context, vec(2.6, 0.25 + 0.5 * box), RAPIER.ColliderDesc.cuboid(0.25, 0.25).setDensity(0.3));
        const poses = [
            [-0.4, -0.7, -0.6, -0.3],
            [0.5, 0.6, 0.7, 0.4],
            [-0.7, -0.4, -0.9, -0.2],
            [0.1, -0.2, 0.3, -0.3],
        ] as const;
        return {
            update: (time) => {
                const pose = poses[Math.floor(time / 1.5) % poses.length] ?? poses[0];
                joints.forEach((joint, index) => joint.configureMotorPosition(pose[index] ?? 0, 300, 36));
            },
        };
    },
};

const lifts: Scene = {
    id: "lifts",
    title: "Lifts",
    description: "Motors of sliders raise platforms with boxes on them, and lower them.",
    group,
    camera: { target: [0, 3, 0], height: 9 },
    poster: 200,
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const joints = Array.from({ length: 4 }, (_, index) => {
            const x = 3 * (index - 1.5);
            const hook = addHook(context, vec(x, 0.1));
            const deck = add(context, vec(x, 0.4), RAPIER.ColliderDesc.cuboid(1.2, 0.15).setDensity(2));
            const data = RAPIER.JointData.prismatic(ORIGIN, ORIGIN, vec(0, 1));
            data.limitsEnabled = true;
            data.limits = [0.2, 6];
            const joint = world.createImpulseJoint(data, hook, deck, true) as PrismaticImpulseJoint;
            joint.configureMotorModel(RAPIER.MotorModel.ForceBased);
            for (let box = 0; box < 4; box++) add(context, vec(x, 0.9 + 0.7 * box), RAPIER.ColliderDesc.cuboid(0.35, 0.35));
            return joint;
        });
        return {
            update: (time) =>
                joints.forEach((joint, index) => {
                    const height = 2.2 + 1.9 * Math.sin(0.9 * time + 1.3 * index - 1.5);
                    joint.configureMotorPosition(0.2 + (height - 0.2) * Math.min(1, time / 3), 900, 160);
                }),
        };
    },
};

const engine: Scene = {
    id: "piston",
    title: "Piston engine",
    description: "Cranks, rods and sliders turn rotation into strokes.",
    group,
    camera: { target: [0, 2.6, 0], height: 8 },
    poster: 80,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const pistons: RigidBody[] = [];
        for (let index = 0; index < 3; index++) {
            const x = 3 * (index - 1);
            const hook = addHook(context, vec(x, 1.3));
            const phase = (2 * Math.PI * index) / 3;
            const crank = add(context, vec(x, 1.3), RAPIER.ColliderDesc.ball(0.8).setCollisionGroups(0), phase);
            const pin = vec(x - 0.6 * Math.sin(phase), 1.3 + 0.6 * Math.cos(phase));
            const height = pin.y + Math.sqrt(1.9 ** 2 - (pin.x - x) ** 2);
            const lean = Math.atan2(pin.x - x, height - pin.y);
            const rod = add(context, vec((pin.x + x) / 2, (pin.y + height) / 2), RAPIER.ColliderDesc.cuboid(0.1, 0.95).setCollisionGroups(0), lean);
            const piston = add(context, vec(x, height), RAPIER.ColliderDesc.cuboid(0.6, 0.35));
            paint(crank, "dark");
            paint(rod, "grey");
            paint(piston, "orange");
            const drive = world.createImpulseJoint(RAPIER.JointData.revolute(ORIGIN, ORIGIN), hook, crank, true);
            (drive as RevoluteImpulseJoint).configureMotorVelocity(5, 800);
            world.createImpulseJoint(RAPIER.JointData.revolute(vec(0, 0.6), vec(0, -0.95)), crank, rod, true);
            world.createImpulseJoint(RAPIER.JointData.revolute(vec(0, 0.95), ORIGIN), rod, piston, true);
            world.createImpulseJoint(RAPIER.JointData.prismatic(ORIGIN, ORIGIN, vec(0, 1)), hook, piston, true);
            add(context, vec(x, height + 1), RAPIER.ColliderDesc.cuboid(0.3, 0.3));
            pistons.push(piston);
        }
        const check = (): boolean => pistons.every((piston, index) => Math.abs(piston.translation().x - 3 * (index - 1)) < 0.1);
        return { claims: [{ text: "Pistons stay on their lines", after: 300, check }] };
    },
};

const spider: Scene = {
    id: "soft-ring",
    title: "Tyres of springs",
    description: "Rings of boxes with springs across roll down a slope.",
    group,
    camera: { target: [0, 2.4, 0], height: 9.5 },
    poster: 110,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        addFixed(context, vec(-5, 1.2), RAPIER.ColliderDesc.cuboid(5, 0.3), -0.3);
        for (let ring = 0; ring < 3; ring++) {
            const centre = vec(-7 + 2.4 * ring, 5 - 0.7 * ring);
            const pieces = 14;
            const bodies = Array.from({ length: pieces }, (_, index) => {
                const angle = (2 * Math.PI * index) / pieces;
                const at = vec(centre.x + 1 * Math.cos(angle), centre.y + Math.sin(angle));
                const body = add(context, at, RAPIER.ColliderDesc.roundCuboid(0.1, 0.17, 0.04).setFriction(1), angle);
                paint(body, (["teal", "orange", "purple"] as const)[ring] ?? "teal");
                return body;
            });
            const half = Math.tan(Math.PI / pieces);
            bodies.forEach((body, index) => {
                const next = bodies[(index + 1) % pieces]!;
                world.createImpulseJoint(RAPIER.JointData.revolute(vec(0, half), vec(0, -half)), body, next, true);
                if (index < pieces / 2) {
                    const across = bodies[index + pieces / 2]!;
                    world.createImpulseJoint(RAPIER.JointData.spring(2, 14, 0.6, ORIGIN, ORIGIN), body, across, true);
                }
            });
        }
        return { draw: (pen) => drawJoints(context, pen.line) };
    },
};

export const JOINTS: readonly Scene[] = [bridge, kinds, cradle, wrecking, motors, arm, lifts, engine, spider];
