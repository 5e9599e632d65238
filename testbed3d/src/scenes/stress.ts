// Large scenes.

import { add, addFixed, addFloor, addHook, addPit, ORIGIN, turn, vec, X } from "../kit.ts";
import { addRagdoll } from "../ragdoll.ts";
import type { RigidBody, Scene } from "../rapier.ts";

const group = "Stress tests";

const rain: Scene = {
    id: "thousand-boxes",
    title: "A thousand boxes",
    description: "A block of a thousand boxes falls and spreads.",
    group,
    camera: { eye: [17, 15, 22], target: [0, 4, 0] },
    poster: 150,
    parameters: { count: { label: "Boxes", value: 1000, min: 100, max: 8000, step: 100 } },
    setup(context) {
        addFloor(context, 100);
        const side = 10;
        for (let index = 0; index < context.parameter<number>("count"); index++) {
            const [x, y, z] = [index % side, Math.floor(index / (side * side)), Math.floor(index / side) % side];
            const shift = 0.2 * (y % 3);
            add(context, vec(1.3 * (x - 4.5) + shift, 1 + 1.25 * y, 1.3 * (z - 4.5) - shift), context.RAPIER.ColliderDesc.cuboid(0.5, 0.5, 0.5));
        }
    },
};

const mixture: Scene = {
    id: "mixture",
    title: "Shapes in a pit",
    description: "Eight hundred shapes of six kinds fill a pit.",
    group,
    camera: { eye: [11, 10, 14], target: [0, 2.5, 0] },
    poster: 300,
    setup(context) {
        addFloor(context);
        addPit(context, 4.5, 5);
        const { RAPIER, random } = context;
        const shapes = [
            () => RAPIER.ColliderDesc.ball(0.35),
            () => RAPIER.ColliderDesc.cuboid(0.35, 0.25, 0.4),
            () => RAPIER.ColliderDesc.capsule(0.25, 0.2),
            () => RAPIER.ColliderDesc.cylinder(0.3, 0.3),
            () => RAPIER.ColliderDesc.cone(0.4, 0.35),
            () => RAPIER.ColliderDesc.roundCuboid(0.22, 0.22, 0.22, 0.08),
        ];
        for (let index = 0; index < 800; index++) {
            const at = vec(random.between(-4, 4), 1 + 0.045 * index, random.between(-4, 4));
            add(context, at, random.pick(shapes)(), turn(X, random.between(0, 3)));
        }
    },
};

const grid: Scene = {
    id: "joint-grid",
    title: "Grid of joints",
    description: "Four hundred bodies hang in a sheet of 760 joints.",
    group,
    camera: { eye: [12, 9, 15], target: [0, 3, 0] },
    poster: 150,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const side = 20;
        const bodies: RigidBody[][] = [];
        for (let i = 0; i < side; i++) {
            bodies.push([]);
            for (let k = 0; k < side; k++) {
                const fixed = i === 0 && (k === 0 || k === side - 1 || k === Math.floor(side / 2));
                const at = vec(0.55 * (k - side / 2), 8, 0.55 * i - 4);
                const description = fixed ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic();
                const body = world.createRigidBody(description.setTranslation(at.x, at.y, at.z));
                world.createCollider(RAPIER.ColliderDesc.ball(0.2), body);
                paint(body, fixed ? "white" : (i + k) % 2 === 0 ? "teal" : "blue");
                bodies[i]?.push(body);
                const [back, left] = [bodies[i - 1]?.[k], bodies[i]?.[k - 1]];
                if (back) world.createImpulseJoint(RAPIER.JointData.spherical(vec(0, 0, 0.55), ORIGIN), back, body, true);
                if (left) world.createImpulseJoint(RAPIER.JointData.spherical(vec(0.55, 0, 0), ORIGIN), left, body, true);
            }
        }
    },
};

const city: Scene = {
    id: "city",
    title: "City of towers",
    description: "A wrecking ball swings through twenty-five towers.",
    group,
    camera: { eye: [16, 13, 19], target: [0, 3, 0] },
    poster: 170,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        for (let tower = 0; tower < 25; tower++) {
            const [x, z] = [3 * ((tower % 5) - 2), 3 * (Math.floor(tower / 5) - 2)];
            const floors = 5 + ((tower * 7) % 6);
            for (let floor = 0; floor < floors; floor++) {
                const slab = RAPIER.ColliderDesc.cuboid(0.8, 0.08, 0.8);
                for (const corner of [0, 1, 2, 3]) {
                    const [cx, cz] = [0.6 * ((corner % 2) * 2 - 1), 0.6 * (Math.floor(corner / 2) * 2 - 1)];
                    const column = add(context, vec(x + cx, 0.32 + 0.82 * floor, z + cz), RAPIER.ColliderDesc.cuboid(0.12, 0.32, 0.12));
                    paint(column, "white");
                }
                paint(add(context, vec(x, 0.73 + 0.82 * floor, z), slab), floor % 2 === 0 ? "blue" : "teal");
            }
        }
        const hook = addHook(context, vec(0, 15, 0), 0.2);
        const ball = add(context, vec(-12, 10, 0.4), RAPIER.ColliderDesc.ball(1.1).setDensity(20));
        paint(ball, "dark");
        world.createImpulseJoint(RAPIER.JointData.rope(13, ORIGIN, ORIGIN), hook, ball, true);
        return { draw: (pen) => pen.line(hook.translation(), ball.translation(), "grey") };
    },
};

const crowd: Scene = {
    id: "people-rain",
    title: "Rain of people",
    description: "Sixty people of eleven limbs fall onto balls.",
    group,
    camera: { eye: [9, 9, 12], target: [0, 1.6, 0] },
    poster: 200,
    setup(context) {
        addFloor(context);
        addPit(context, 4, 2.5);
        const { RAPIER } = context;
        for (let ball = 0; ball < 9; ball++) {
            addFixed(context, vec(2.4 * ((ball % 3) - 1), 0.5, 2.4 * (Math.floor(ball / 3) - 1)), RAPIER.ColliderDesc.ball(0.8));
        }
        for (let index = 0; index < 60; index++) {
            const at = vec(1.8 * ((index % 4) - 1.5), 2.5 + 0.55 * index, 1.8 * ((Math.floor(index / 4) % 4) - 1.5));
            addRagdoll(context, at, turn(X, context.random.between(0, 6)));
        }
    },
};

const pyramids: Scene = {
    id: "many-pyramids",
    title: "Many pyramids",
    description: "Sixteen pyramids of 55 boxes stand, and most of them fall asleep.",
    group,
    camera: { eye: [25, 17, 17], target: [0, 1.5, 0] },
    poster: 60,
    setup(context) {
        addFloor(context);
        const first: RigidBody[] = [];
        for (let pyramid = 0; pyramid < 16; pyramid++) {
            const z = 2.2 * (pyramid - 7.5);
            for (let row = 0; row < 10; row++) {
                for (let column = 0; column < 10 - row; column++) {
                    const at = vec(0.82 * (column - (9 - row) / 2), 0.4 + 0.8 * row, z);
                    const box = add(context, at, context.RAPIER.ColliderDesc.cuboid(0.4, 0.4, 0.4));
                    if (row === 9) first.push(box);
                }
            }
        }
        const check = (): boolean => first.every((box) => box.translation().y > 7);
        return { claims: [{ text: "All pyramids stand after 3 s", after: 180, check }] };
    },
};

export const STRESS: readonly Scene[] = [rain, mixture, grid, city, crowd, pyramids];
