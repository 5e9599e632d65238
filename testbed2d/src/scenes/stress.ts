// Large scenes.

import { add, addFixed, addFloor, ORIGIN, vec } from "../kit.ts";
import type { RigidBody, Scene } from "../rapier.ts";

const rain: Scene = {
    id: "thousand-boxes",
    title: "A thousand boxes",
    description: "A block of a thousand boxes falls and spreads.",
    group: "Stress tests",
    camera: { target: [0, 10, 0], height: 30 },
    poster: 200,
    parameters: { count: { label: "Boxes", value: 1000, min: 100, max: 8000, step: 100 } },
    setup(context) {
        addFloor(context, 150);
        for (let index = 0; index < context.parameter<number>("count"); index++) {
            const [x, y] = [index % 25, Math.floor(index / 25)];
            add(context, vec(1.15 * (x - 12) + 0.2 * (y % 3), 1 + 1.1 * y), context.RAPIER.ColliderDesc.cuboid(0.45, 0.45));
        }
    },
};

const grid: Scene = {
    id: "joint-grid",
    title: "Grid of joints",
    description: "Six hundred and twenty-five balls hang in a sheet of 1,200 joints.",
    group: "Stress tests",
    camera: { target: [0, 6, 0], height: 16 },
    poster: 120,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const side = 25;
        const bodies: RigidBody[][] = [];
        for (let row = 0; row < side; row++) {
            bodies.push([]);
            for (let column = 0; column < side; column++) {
                const fixed = row === 0 && column % 8 === 0;
                const description = fixed ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic();
                const body = world.createRigidBody(description.setTranslation(0.45 * (column - 12), 12.5 - 0.45 * row));
                world.createCollider(RAPIER.ColliderDesc.ball(0.15), body);
                paint(body, fixed ? "white" : (row + column) % 2 === 0 ? "teal" : "blue");
                bodies[row]?.push(body);
                const [above, left] = [bodies[row - 1]?.[column], bodies[row]?.[column - 1]];
                if (above) world.createImpulseJoint(RAPIER.JointData.revolute(ORIGIN, vec(0, 0.45)), above, body, true);
                if (left) world.createImpulseJoint(RAPIER.JointData.revolute(vec(0.45, 0), ORIGIN), left, body, true);
            }
        }
        const ball = add(context, vec(-11, 7), RAPIER.ColliderDesc.ball(1).setDensity(3));
        ball.setLinvel(vec(11, 4), true);
        paint(ball, "orange");
    },
};

const pyramids: Scene = {
    id: "many-pyramids",
    title: "Many pyramids",
    description: "Twenty pyramids of 45 boxes stand, and fall asleep.",
    group: "Stress tests",
    camera: { target: [0, 11, 0], height: 30 },
    poster: 60,
    setup(context) {
        addFloor(context);
        const tops: [RigidBody, number][] = [];
        for (let pyramid = 0; pyramid < 20; pyramid++) {
            const [x, y] = [8.6 * ((pyramid % 5) - 2), 6 * Math.floor(pyramid / 5)];
            if (y > 0) addFixed(context, vec(x, y - 0.1), context.RAPIER.ColliderDesc.cuboid(4, 0.1));
            for (let row = 0; row < 9; row++) {
                for (let column = 0; column < 9 - row; column++) {
                    const at = vec(x + 0.62 * (column - (8 - row) / 2), y + 0.3 + 0.6 * row);
                    const box = add(context, at, context.RAPIER.ColliderDesc.cuboid(0.3, 0.3));
                    if (row === 8) tops.push([box, at.y]);
                }
            }
        }
        const check = (): boolean => tops.every(([box, y]) => Math.abs(box.translation().y - y) < 0.3);
        return { claims: [{ text: "All pyramids stand after 3 s", after: 180, check }] };
    },
};

export const STRESS: readonly Scene[] = [rain, grid, pyramids];
