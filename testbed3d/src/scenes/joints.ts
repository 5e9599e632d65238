// Joints.

import { hangingArc } from "../../../testbed/src/core/arc.ts";
import { add, addFloor, addHook, distance, ORIGIN, turn, UPRIGHT, vec, Y, Z } from "../kit.ts";
import type { Context, ImpulseJoint, Paint, RigidBody, Scene, Vector } from "../rapier.ts";

const group = "Joints";

const bridge: Scene = {
    id: "bridge",
    title: "Hanging bridge",
    description: "Planks on hinges carry a load of boxes and balls.",
    group,
    camera: { eye: [9, 8, 14], target: [0, 2.5, 0] },
    poster: 220,
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const [planks, pitch, height] = [20, 0.6, 3.9];
        const arc = hangingArc(planks, pitch, 12);
        const towers = [-1, 1].map((sign) => {
            const shape = RAPIER.ColliderDesc.cuboid(0.4, 2, 1.4);
            const tower = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(sign * (arc.bank + 0.4), 2, 0));
            world.createCollider(shape, tower);
            return tower;
        });
        let previous = towers[0]!;
        let anchor = vec(0.4, height - 2, 0);
        let lowest = previous;
        for (let plank = 0; plank < planks; plank++) {
            const { angle, x, y } = arc.place(plank);
            const body = add(context, vec(x, height + y, 0), RAPIER.ColliderDesc.cuboid(0.28, 0.08, 1.2).setDensity(2), turn(Z, angle));
            context.paint(body, plank % 2 === 0 ? "orange" : "yellow");
            world.createImpulseJoint(RAPIER.JointData.revolute(anchor, vec(-pitch / 2, 0, 0), Z), previous, body, true);
            if (plank === planks / 2) lowest = body;
            previous = body;
            anchor = vec(pitch / 2, 0, 0);
        }
        world.createImpulseJoint(RAPIER.JointData.revolute(anchor, vec(-0.4, height - 2, 0), Z), previous, towers[1]!, true);
        for (let load = 0; load < 16; load++) {
            const at = vec(context.random.between(-4, 4), 6 + 0.6 * load, context.random.between(-0.7, 0.7));
            const ball = RAPIER.ColliderDesc.ball(0.3);
            add(context, at, load % 2 === 0 ? ball : RAPIER.ColliderDesc.cuboid(0.3, 0.3, 0.3));
        }
        const check = (): boolean => {
            const { y } = lowest.translation();
            return y > 0.8 && y < height - 1 && previous.translation().y > y;
        };
        return { claims: [{ text: "The bridge hangs and holds for 10 s", after: 600, check }] };
    },
};

const cradle: Scene = {
    id: "cradle",
    title: "Newton's cradle",
    description: "Steel balls hand an impulse through the row.",
    group,
    camera: { eye: [3, 4, 10], target: [0, 2.4, 0] },
    poster: 30,
    parameters: { raised: { label: "Raised balls", value: 1, min: 1, max: 4, step: 1 } },
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const [balls, radius, length] = [6, 0.4, 2.6];
        for (let ball = 0; ball < balls; ball++) {
            const x = (ball - (balls - 1) / 2) * 2 * radius;
            const top = vec(x, 4, 0);
            const hook = addHook(context, top, 0.08);
            const angle = ball < context.parameter<number>("raised") ? -0.9 : 0;
            const at = vec(x + length * Math.sin(angle), 4 - length * Math.cos(angle), 0);
            const shape = RAPIER.ColliderDesc.ball(radius).setRestitution(1).setFriction(0).setDensity(7.8);
            const body = add(context, at, shape.setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max), turn(Z, angle));
            body.setLinearDamping(0);
            context.paint(body, "white");
            world.createImpulseJoint(RAPIER.JointData.revolute(ORIGIN, vec(0, length, 0), Z), hook, body, true);
        }
        return { draw: (pen) => drawJoints(context, pen.line) };
    },
};

type DrawLine = (from: Vector, to: Vector, paint: Paint) => void;

/** Draws a line from the first body of each joint to the second. */
function drawJoints({ world }: Context, line: DrawLine): void {
    world.impulseJoints.forEach((joint: ImpulseJoint) => {
        line(joint.body1().translation(), joint.body2().translation(), "grey");
    });
}

const kinds: Scene = {
    id: "joints",
    title: "Kinds of joints",
    description: "Fixed, hinge, slider, ball and socket, rope and spring, from left to right.",
    group,
    camera: { eye: [3, 5, 12], target: [0, 3, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const top = vec(0, -0.9, 0);
        const up = vec(0, 0.5, 0);
        const joints = [
            RAPIER.JointData.fixed(top, UPRIGHT, up, UPRIGHT),
            RAPIER.JointData.revolute(top, up, Z),
            RAPIER.JointData.prismatic(top, up, Y),
            RAPIER.JointData.spherical(top, up),
            RAPIER.JointData.rope(1.6, ORIGIN, ORIGIN),
            RAPIER.JointData.spring(1.4, 60, 2, ORIGIN, ORIGIN),
        ];
        const slider = joints[2];
        if (slider) {
            slider.limitsEnabled = true;
            slider.limits = [-0.8, 0.6];
        }
        const paints: Paint[] = ["red", "orange", "yellow", "green", "teal", "blue"];
        const bodies = joints.map((data, index) => {
            const x = 2 * (index - 2.5);
            const hook = addHook(context, vec(x, 5, 0));
            const body = add(context, vec(x, 3.6, 0), RAPIER.ColliderDesc.cuboid(0.35, 0.5, 0.35));
            context.paint(body, paints[index] ?? "white");
            body.setLinvel(vec(2, 1, index === 3 ? 2 : 0.4), true);
            world.createImpulseJoint(data, hook, body, true);
            return body;
        });
        const check = (): boolean => distance(bodies[0]!.translation(), vec(-5, 3.6, 0)) < 0.05;
        return {
            draw: (pen) => drawJoints(context, pen.line),
            claims: [{ text: "The fixed joint holds its body in place", after: 300, check }],
        };
    },
};

const net: Scene = {
    id: "net",
    title: "Net",
    description: "A net of balls on ball-and-socket joints catches boxes.",
    group,
    camera: { eye: [9, 9, 12], target: [0, 3, 0] },
    poster: 220,
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const [side, space] = [15, 0.55];
        const grid: RigidBody[][] = [];
        for (let i = 0; i < side; i++) {
            grid.push([]);
            for (let k = 0; k < side; k++) {
                const border = i === 0 || k === 0 || i === side - 1 || k === side - 1;
                const at = vec((i - (side - 1) / 2) * space, 4, (k - (side - 1) / 2) * space);
                const description = border ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic();
                const body = world.createRigidBody(description.setTranslation(at.x, at.y, at.z));
                world.createCollider(RAPIER.ColliderDesc.ball(0.2).setDensity(3), body);
                context.paint(body, border ? "grey" : "teal");
                grid[i]?.push(body);
                const joint = RAPIER.JointData.spherical(vec(space, 0, 0), ORIGIN);
                const cross = RAPIER.JointData.spherical(vec(0, 0, space), ORIGIN);
                const [left, back] = [grid[i - 1]?.[k], grid[i]?.[k - 1]];
                if (left && !(border && k !== 0 && k !== side - 1 && i !== side - 1)) world.createImpulseJoint(joint, left, body, true);
                if (back && !(border && i !== 0 && i !== side - 1 && k !== side - 1)) world.createImpulseJoint(cross, back, body, true);
            }
        }
        const loads: RigidBody[] = [];
        for (let load = 0; load < 9; load++) {
            const at = vec(context.random.between(-1.5, 1.5), 6 + load, context.random.between(-1.5, 1.5));
            loads.push(add(context, at, RAPIER.ColliderDesc.cuboid(0.45, 0.45, 0.45).setDensity(0.5)));
        }
        const check = (): boolean => loads.filter((load) => load.translation().y > 1).length >= 6;
        return {
            draw: (pen) => drawJoints(context, pen.line),
            claims: [{ text: "The net holds most boxes for 6 s", after: 360, check }],
        };
    },
};

const wrecking: Scene = {
    id: "wrecking-ball",
    title: "Wrecking ball",
    description: "A chain swings a heavy ball into a wall.",
    group,
    camera: { eye: [8, 8, 19], target: [0, 4, 0] },
    poster: 110,
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const links = 12;
        let previous = addHook(context, vec(-2, 10, 0));
        let anchor = ORIGIN;
        for (let link = 0; link < links; link++) {
            const at = vec(-2.3 - 0.6 * link, 10, 0);
            const body = add(context, at, RAPIER.ColliderDesc.capsule(0.22, 0.08).setDensity(20), turn(Z, Math.PI / 2));
            context.paint(body, "grey");
            world.createImpulseJoint(RAPIER.JointData.spherical(anchor, vec(0, -0.3, 0)), previous, body, true);
            previous = body;
            anchor = vec(0, 0.3, 0);
        }
        const ball = add(context, vec(-2.6 - 0.6 * links - 0.4, 10, 0), RAPIER.ColliderDesc.ball(0.9).setDensity(12));
        context.paint(ball, "dark");
        world.createImpulseJoint(RAPIER.JointData.spherical(anchor, vec(0.7, 0, 0)), previous, ball, true);
        for (let row = 0; row < 9; row++) {
            for (let column = 0; column < 6; column++) {
                const z = column - 2.5 + (row % 2 === 0 ? 0 : 0.5) - 0.25;
                add(context, vec(2.5, 0.4 + 0.8 * row, 1.01 * z), RAPIER.ColliderDesc.cuboid(0.4, 0.4, 0.5));
            }
        }
        return { draw: (pen) => drawJoints(context, pen.line) };
    },
};

const springs: Scene = {
    id: "springs",
    title: "Springs",
    description: "Equal weights hang on springs of growing stiffness.",
    group,
    camera: { eye: [3, 5, 13], target: [0, 3.2, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const weights: RigidBody[] = [];
        for (let index = 0; index < 9; index++) {
            const x = 1.1 * (index - 4);
            const hook = addHook(context, vec(x, 6, 0));
            const weight = add(context, vec(x, 4.5, 0), RAPIER.ColliderDesc.cuboid(0.35, 0.35, 0.35).setMass(1));
            const spring = RAPIER.JointData.spring(1.5, 5 * 1.45 ** index, 0.4, ORIGIN, ORIGIN);
            world.createImpulseJoint(spring, hook, weight, true);
            weights.push(weight);
        }
        const check = (): boolean =>
            weights.every((weight, index) => index === 0 || weight.translation().y > weights[index - 1]!.translation().y - 0.05);
        return {
            draw: (pen) => drawJoints(context, pen.line),
            claims: [{ text: "A stiffer spring stretches less", after: 1500, check }],
        };
    },
};

const mobile: Scene = {
    id: "mobile",
    title: "Mobile",
    description: "Rods on ball-and-socket joints balance each other and turn slowly.",
    group,
    camera: { eye: [7, 6, 12], target: [0, 4.5, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        const hang = (parent: RigidBody, anchor: Vector, at: Vector, depth: number): void => {
            const drop = 0.7;
            if (depth === 0) {
                const weight = add(context, vec(at.x, at.y - drop, at.z), RAPIER.ColliderDesc.ball(0.22).setDensity(4));
                world.createImpulseJoint(RAPIER.JointData.spherical(anchor, vec(0, drop, 0)), parent, weight, true);
                return;
            }
            const half = 0.55 * 2 ** (depth - 1) * 0.9;
            const rod = add(context, vec(at.x, at.y - drop, at.z), RAPIER.ColliderDesc.cuboid(half, 0.04, 0.04), turn(Y, 0.5 * depth));
            rod.setAngularDamping(0.3);
            rod.setAngvel(vec(0, depth % 2 === 0 ? 0.9 : -0.7, 0), true);
            world.createImpulseJoint(RAPIER.JointData.spherical(anchor, vec(0, drop, 0)), parent, rod, true);
            const [c, s] = [Math.cos(0.5 * depth), Math.sin(0.5 * depth)];
            for (const side of [-half, half]) {
                hang(rod, vec(side, 0, 0), vec(at.x + side * c, at.y - drop, at.z - side * s), depth - 1);
            }
        };
        hang(addHook(context, vec(0, 8, 0)), ORIGIN, vec(0, 8, 0), 4);
        return { draw: (pen) => drawJoints(context, pen.line) };
    },
};

const multibody: Scene = {
    id: "multibody",
    title: "Multibody chain",
    description: "A long chain in reduced coordinates: its joints cannot come apart.",
    group,
    camera: { eye: [3, 8, 11], target: [-0.5, 7, 0] },
    poster: 70,
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        let previous = addHook(context, vec(-2, 9, 0));
        const links: RigidBody[] = [previous];
        for (let link = 0; link < 12; link++) {
            const body = add(context, vec(-1.8 + 0.36 * link, 9, 0), RAPIER.ColliderDesc.capsule(0.1, 0.08), turn(Z, -Math.PI / 2));
            const from = link === 0 ? ORIGIN : vec(0, 0.18, 0);
            const joint = world.createMultibodyJoint(RAPIER.JointData.spherical(from, vec(0, -0.18, 0)), previous, body, true);
            joint.setContactsEnabled(false);
            previous = body;
            links.push(body);
        }
        const ball = add(context, vec(-1.8 + 0.36 * 12 + 0.3, 9, 0), RAPIER.ColliderDesc.ball(0.3).setDensity(0.3));
        context.paint(ball, "orange");
        const end = RAPIER.JointData.spherical(vec(0, 0.18, 0), vec(-0.35, 0, 0));
        world.createMultibodyJoint(end, previous, ball, true).setContactsEnabled(false);
        const check = (): boolean | string => {
            const gap = Math.max(...links.slice(2).map((link, index) => Math.abs(distance(link.translation(), links[index + 1]!.translation()))));
            return gap < 0.365 || `a gap of ${gap.toFixed(4)} m`;
        };
        return { claims: [{ text: "Links stay together", after: 300, check }] };
    },
};

export const JOINTS: readonly Scene[] = [bridge, cradle, kinds, net, wrecking, springs, mobile, multibody];
