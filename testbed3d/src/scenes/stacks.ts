// Stacks and piles.

import { add, addFloor, addPit, distance, turn, vec, X, Y, Z } from "../kit.ts";
import type { RigidBody, Scene, Vector } from "../rapier.ts";

const group = "Stacks and piles";

/** The largest distance of bodies from the places where they began. */
function moved(bodies: readonly RigidBody[], places: readonly Vector[]): number {
    return Math.max(...bodies.map((body, index) => distance(body.translation(), places[index] ?? vec(0, 0, 0))));
}

/** A claim that bodies stay within a distance of their first places. */
function stands(text: string, bodies: readonly RigidBody[], after: number, limit: number) {
    const places = bodies.map((body) => body.translation());
    const check = (): boolean | string => {
        const way = moved(bodies, places);
        return way < limit || `a body moved ${way.toFixed(2)} m`;
    };
    return { text, after, check };
}

const tower: Scene = {
    id: "tower",
    title: "Tower",
    description: "Single boxes stand on each other, and the tower does not sway.",
    group,
    camera: { eye: [9, 7, 17], target: [0, 5, 0] },
    parameters: { height: { label: "Boxes", value: 12, min: 2, max: 40, step: 1 } },
    setup(context) {
        addFloor(context);
        const boxes: RigidBody[] = [];
        for (let floor = 0; floor < context.parameter<number>("height"); floor++) {
            boxes.push(add(context, vec(0, 0.5 + floor, 0), context.RAPIER.ColliderDesc.cuboid(0.5, 0.5, 0.5)));
        }
        return { claims: [stands("The tower stands after 10 s", boxes, 600, 0.3)] };
    },
};

const wall: Scene = {
    id: "pyramid",
    title: "Pyramid",
    description: "A pyramid that is one box thick. Throw a ball at it with the space bar.",
    group,
    camera: { eye: [9, 10, 23], target: [0, 5.6, 0] },
    parameters: { base: { label: "Boxes in the lowest row", value: 14, min: 2, max: 40, step: 1 } },
    setup(context) {
        addFloor(context);
        const base = context.parameter<number>("base");
        const boxes: RigidBody[] = [];
        for (let row = 0; row < base; row++) {
            for (let column = 0; column < base - row; column++) {
                const x = column - (base - row - 1) / 2;
                boxes.push(add(context, vec(x * 1.02, 0.5 + row, 0), context.RAPIER.ColliderDesc.cuboid(0.5, 0.5, 0.5)));
            }
        }
        return { claims: [stands("The pyramid stands after 5 s", boxes, 300, 0.5)] };
    },
};

const pyramid: Scene = {
    id: "ziggurat",
    title: "Ziggurat",
    description: "Square layers of boxes, each one box smaller than the layer below.",
    group,
    camera: { eye: [13, 10, 17], target: [0, 3, 0] },
    setup(context) {
        addFloor(context);
        const boxes: RigidBody[] = [];
        for (let layer = 0; layer < 9; layer++) {
            const side = 9 - layer;
            for (let i = 0; i < side * side; i++) {
                const [x, z] = [(i % side) - (side - 1) / 2, Math.floor(i / side) - (side - 1) / 2];
                boxes.push(add(context, vec(x * 1.05, 0.5 + layer, z * 1.05), context.RAPIER.ColliderDesc.cuboid(0.5, 0.5, 0.5)));
            }
        }
        return { claims: [stands("The ziggurat stands after 3 s", boxes, 180, 0.4)] };
    },
};

const jenga: Scene = {
    id: "blocks",
    title: "Wooden blocks",
    description: "Three blocks a layer, crosswise. Pull one out with the pointer.",
    group,
    camera: { eye: [5, 4.5, 8], target: [0, 2.2, 0] },
    setup(context) {
        addFloor(context);
        const blocks: RigidBody[] = [];
        for (let layer = 0; layer < 16; layer++) {
            for (let column = -1; column <= 1; column++) {
                const cross = layer % 2 === 1;
                const at = cross ? vec(0, 0.15 + 0.3 * layer, column * 0.502) : vec(column * 0.502, 0.15 + 0.3 * layer, 0);
                const shape = context.RAPIER.ColliderDesc.cuboid(cross ? 0.75 : 0.25, 0.15, cross ? 0.25 : 0.75);
                const block = add(context, at, shape.setFriction(0.6));
                context.paint(block, layer % 3 === 0 ? "orange" : layer % 3 === 1 ? "yellow" : "white");
                blocks.push(block);
            }
        }
        return { claims: [stands("The blocks stand after 10 s", blocks, 600, 0.1)] };
    },
};

const dominoes: Scene = {
    id: "dominoes",
    title: "Dominoes",
    description: "A spiral of dominoes falls, one after the other.",
    group,
    camera: { eye: [7, 11, 13], target: [0, 0, 0] },
    poster: 260,
    setup(context) {
        addFloor(context);
        const stones: RigidBody[] = [];
        let angle = 0;
        for (let stone = 0; stone < 150; stone++) {
            const radius = 7 - 0.04 * stone;
            angle += 0.42 / radius;
            const shape = context.RAPIER.ColliderDesc.cuboid(0.06, 0.45, 0.22);
            const at = vec(radius * Math.cos(angle), 0.45, radius * Math.sin(angle));
            stones.push(add(context, at, shape, turn(Y, -angle - Math.PI / 2)));
        }
        const first = stones[0];
        const last = stones[stones.length - 1];
        first?.setAngvel(vec(2.6 * Math.cos(angle * 0 + 0.06), 0, 2.6 * Math.sin(0.06)), true);
        const check = (): boolean => (last?.translation().y ?? 1) < 0.35;
        return { claims: [{ text: "The last domino has fallen after 30 s", after: 1800, check }] };
    },
};

const arch: Scene = {
    id: "arch",
    title: "Roman arch",
    description: "Wedges without mortar hold each other by their weight.",
    group,
    camera: { eye: [4, 4.5, 11.5], target: [0, 2.3, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        const [count, inner, outer, depth] = [15, 3.6, 4.8, 0.8];
        const stones: RigidBody[] = [];
        for (let stone = 0; stone < count; stone++) {
            const [from, to] = [stone, stone + 1].map((edge) => (Math.PI * edge) / count);
            const corners = [from, to].flatMap((angle) =>
                [inner, outer].flatMap((radius) =>
                    [-depth, depth].flatMap((z) => [radius * Math.cos(angle ?? 0), radius * Math.sin(angle ?? 0), z]),
                ),
            );
            const centre = ((from ?? 0) + (to ?? 0)) / 2;
            const middle = vec(4.2 * Math.cos(centre), 4.2 * Math.sin(centre), 0);
            const local = corners.map((value, index) => value - [middle.x, middle.y, 0][index % 3]!);
            const shape = RAPIER.ColliderDesc.convexHull(new Float32Array(local));
            if (shape) stones.push(add(context, middle, shape.setFriction(0.8)));
        }
        stones.forEach((stone, index) => context.paint(stone, index === 7 ? "orange" : index % 2 === 0 ? "white" : "grey"));
        return { claims: [stands("The arch stands after 5 s", stones, 300, 0.3)] };
    },
};

const cards: Scene = {
    id: "cards",
    title: "House of cards",
    description: "Leaning cards carry four storeys of cards.",
    group,
    camera: { eye: [2.4, 3.2, 6.6], target: [0, 1.75, 0] },
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        const [lean, height, storeys] = [0.24, 0.5, 4];
        // The cards of a pair touch at their upper corners, a millimetre apart.
        const thin = 0.015;
        const rise = 2 * (height * Math.cos(lean) + thin * Math.sin(lean)) + 2 * thin + 0.002;
        const reach = 2 * (height * Math.sin(lean) + thin * Math.cos(lean)) + 0.001;
        const house: RigidBody[] = [];
        const card = (at: Vector, half: [number, number], angle: number): RigidBody => {
            const body = add(context, at, RAPIER.ColliderDesc.cuboid(half[0], half[1], 0.36).setFriction(0.9), turn(Z, angle));
            house.push(body);
            return body;
        };
        for (let storey = 0; storey < storeys; storey++) {
            const pairs = storeys - storey;
            for (let pair = 0; pair < pairs; pair++) {
                const x = (pair - (pairs - 1) / 2) * 2 * reach;
                const y = storey * rise + rise / 2 - thin;
                context.paint(card(vec(x - reach / 2, y, 0), [thin, height], -lean), "red");
                context.paint(card(vec(x + reach / 2, y, 0), [thin, height], lean), "white");
                if (pair < pairs - 1) {
                    context.paint(card(vec(x + reach, (storey + 1) * rise - thin - 0.001, 0), [reach, thin], 0), "blue");
                }
            }
        }
        return { claims: [stands("The house stands after 5 s", house, 300, 0.2)] };
    },
};

const pile: Scene = {
    id: "pile",
    title: "Pile of boxes",
    description: "Boxes of different sizes fall into a glass pit.",
    group,
    camera: { eye: [10, 9, 14], target: [0, 2, 0] },
    poster: 200,
    parameters: { count: { label: "Boxes", value: 400, min: 10, max: 3000, step: 10 } },
    setup(context) {
        addFloor(context);
        addPit(context, 4, 4);
        for (let box = 0; box < context.parameter<number>("count"); box++) {
            const half = context.random.between(0.2, 0.45);
            const [x, z] = [context.random.between(-3.4, 3.4), context.random.between(-3.4, 3.4)];
            const shape = context.RAPIER.ColliderDesc.cuboid(half, half * context.random.between(0.5, 1), half);
            add(context, vec(x, 1.5 + 0.09 * box, z), shape, turn(X, context.random.between(0, 3)));
        }
    },
};

export const STACKS: readonly Scene[] = [tower, wall, pyramid, jenga, dominoes, arch, cards, pile];
