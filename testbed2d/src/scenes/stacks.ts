// Stacks and piles.

import { add, addFloor, addWalls, distance, ORIGIN, vec } from "../kit.ts";
import type { RigidBody, Scene } from "../rapier.ts";

const group = "Stacks and piles";

/** A claim that bodies stay within a distance of their first places. */
function stands(text: string, bodies: readonly RigidBody[], after: number, limit: number) {
    const places = bodies.map((body) => body.translation());
    const check = (): boolean | string => {
        const way = Math.max(...bodies.map((body, index) => distance(body.translation(), places[index] ?? ORIGIN)));
        return way < limit || `a body moved ${way.toFixed(2)} m`;
    };
    return { text, after, check };
}

const pyramid: Scene = {
    id: "pyramid",
    title: "Pyramid",
    description: "A pyramid of boxes. Throw a ball at it with the space bar.",
    group,
    camera: { target: [0, 6, 0], height: 17 },
    parameters: { base: { label: "Boxes in the lowest row", value: 12, min: 2, max: 50, step: 1 } },
    setup(context) {
        addFloor(context);
        const base = context.parameter<number>("base");
        const boxes: RigidBody[] = [];
        for (let row = 0; row < base; row++) {
            for (let column = 0; column < base - row; column++) {
                const x = 1.05 * (column - (base - row - 1) / 2);
                boxes.push(add(context, vec(x, 0.5 + row), context.RAPIER.ColliderDesc.cuboid(0.5, 0.5)));
            }
        }
        return { claims: [stands("The pyramid stands after 5 s", boxes, 300, 0.4)] };
    },
};

const tower: Scene = {
    id: "tower",
    title: "Tower",
    description: "Single boxes stand on each other, and the tower does not sway.",
    group,
    camera: { target: [0, 6.5, 0], height: 17 },
    parameters: { height: { label: "Boxes", value: 12, min: 2, max: 40, step: 1 } },
    setup(context) {
        addFloor(context);
        const boxes = Array.from({ length: context.parameter<number>("height") }, (_, floor) =>
            add(context, vec(0, 0.5 + floor), context.RAPIER.ColliderDesc.cuboid(0.5, 0.5)),
        );
        return { claims: [stands("The tower stands after 10 s", boxes, 600, 0.3)] };
    },
};

const arch: Scene = {
    id: "arch",
    title: "Roman arch",
    description: "Wedges without mortar hold each other by their weight.",
    group,
    camera: { target: [0, 3, 0], height: 10 },
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        const [count, inner, outer] = [13, 3.4, 4.7];
        const stones: RigidBody[] = [];
        for (let wedge = 0; wedge < count; wedge++) {
            const [from, to] = [(Math.PI * wedge) / count, (Math.PI * (wedge + 1)) / count];
            const middle = (from + to) / 2;
            const centre = vec(4.05 * Math.cos(middle), 4.05 * Math.sin(middle));
            const corners = [from, to].flatMap((angle) =>
                [inner, outer].flatMap((radius) => [radius * Math.cos(angle) - centre.x, radius * Math.sin(angle) - centre.y]),
            );
            const shape = RAPIER.ColliderDesc.convexHull(new Float32Array(corners));
            if (shape) stones.push(add(context, centre, shape.setFriction(0.8)));
        }
        stones.forEach((one, index) => context.paint(one, index === 6 ? "orange" : index % 2 === 0 ? "white" : "grey"));
        return { claims: [stands("The arch stands after 5 s", stones, 300, 0.3)] };
    },
};

const cards: Scene = {
    id: "cards",
    title: "House of cards",
    description: "Leaning cards carry five storeys of cards.",
    group,
    camera: { target: [0, 2.3, 0], height: 6.6 },
    setup(context) {
        addFloor(context);
        const { RAPIER, paint } = context;
        const [lean, half, storeys] = [0.24, 0.5, 5];
        // The cards of a pair touch at their upper corners, a millimetre apart.
        const thin = 0.015;
        const rise = 2 * (half * Math.cos(lean) + thin * Math.sin(lean)) + 2 * thin + 0.002;
        const reach = 2 * (half * Math.sin(lean) + thin * Math.cos(lean)) + 0.001;
        const house: RigidBody[] = [];
        const card = (x: number, y: number, hx: number, hy: number, angle: number): RigidBody => {
            const body = add(context, vec(x, y), RAPIER.ColliderDesc.cuboid(hx, hy).setFriction(0.9), angle);
            house.push(body);
            return body;
        };
        for (let storey = 0; storey < storeys; storey++) {
            for (let pair = 0; pair < storeys - storey; pair++) {
                const x = (pair - (storeys - storey - 1) / 2) * 2 * reach;
                const y = storey * rise + rise / 2 - thin;
                paint(card(x - reach / 2, y, thin, half, -lean), "red");
                paint(card(x + reach / 2, y, thin, half, lean), "white");
                if (pair < storeys - storey - 1) {
                    paint(card(x + reach, (storey + 1) * rise - thin - 0.001, reach, thin, 0), "blue");
                }
            }
        }
        return { claims: [stands("The house stands after 5 s", house, 300, 0.2)] };
    },
};

const dominoes: Scene = {
    id: "dominoes",
    title: "Dominoes",
    description: "A row of dominoes falls, each one larger than the one before.",
    group,
    camera: { target: [0, 2.4, 0], height: 9 },
    poster: 120,
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        let x = -6.5;
        const stones: RigidBody[] = [];
        for (let index = 0; index < 15; index++) {
            const half = 0.3 * 1.11 ** index;
            stones.push(add(context, vec(x, half), RAPIER.ColliderDesc.cuboid(0.14 * half, half)));
            x += half * 0.9;
        }
        stones[0]?.setAngvel(-5, true);
        const last = stones[stones.length - 1];
        const check = (): boolean => Math.abs(last?.rotation() ?? 0) > 0.6;
        return { claims: [{ text: "The largest domino falls", after: 600, check }] };
    },
};

const heavy: Scene = {
    id: "heavy-on-light",
    title: "Heavy on light",
    description: "A box carries another one that is forty times as heavy.",
    group,
    camera: { target: [0, 3, 0], height: 10 },
    setup(context) {
        addFloor(context);
        const { RAPIER, paint } = context;
        const stacks = [1, 10, 40].map((ratio, index) => {
            const x = 3.6 * (index - 1);
            const light = add(context, vec(x, 0.5), RAPIER.ColliderDesc.cuboid(0.5, 0.5));
            const load = add(context, vec(x, 2), RAPIER.ColliderDesc.cuboid(1, 1).setDensity(ratio / 4));
            paint(light, "blue");
            paint(load, "dark");
            return load;
        });
        const check = (): boolean => stacks.every((load) => load.translation().y > 1.8);
        return { claims: [{ text: "The loads stay on top", after: 300, check }] };
    },
};

const pile: Scene = {
    id: "pile",
    title: "Pile",
    description: "Boxes and balls of different sizes fill a box.",
    group,
    camera: { target: [0, 5, 0], height: 14 },
    poster: 260,
    parameters: { count: { label: "Bodies", value: 350, min: 10, max: 3000, step: 10 } },
    setup(context) {
        addFloor(context);
        addWalls(context, 7, 9);
        const { RAPIER, random } = context;
        for (let index = 0; index < context.parameter<number>("count"); index++) {
            const half = random.between(0.15, 0.4);
            const at = vec(random.between(-6.4, 6.4), 1 + 0.07 * index);
            add(context, at, index % 2 === 0 ? RAPIER.ColliderDesc.cuboid(half, half) : RAPIER.ColliderDesc.ball(half));
        }
    },
};

export const STACKS: readonly Scene[] = [pyramid, tower, arch, cards, dominoes, heavy, pile];
