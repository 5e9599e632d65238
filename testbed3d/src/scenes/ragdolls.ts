// Ragdolls.

import { addFixed, addFloor, addPit, distance, speed, turn, vec, X, Y } from "../kit.ts";
import { addRagdoll } from "../ragdoll.ts";
import type { RigidBody, Scene } from "../rapier.ts";

const group = "Ragdolls";

/** A claim that no limb left its person. */
function together(dolls: readonly RigidBody[][], after: number) {
    const check = (): boolean | string => {
        const far = dolls.flatMap((limbs) => limbs.map((limb) => distance(limb.translation(), limbs[0]!.translation())));
        const most = Math.max(...far);
        return most < 1.3 || `a limb is ${most.toFixed(2)} m away`;
    };
    return { text: "Limbs stay with their person", after, check };
}

const stairs: Scene = {
    id: "ragdoll-stairs",
    title: "Down the stairs",
    description: "People of eleven limbs tumble down a flight of stairs.",
    group,
    camera: { eye: [10, 8, 11], target: [0, 2, 0] },
    poster: 130,
    setup(context) {
        addFloor(context);
        for (let step = 0; step < 12; step++) {
            const height = 0.22 * (12 - step);
            const shape = context.RAPIER.ColliderDesc.cuboid(0.3, height, 2.5);
            addFixed(context, vec(-4 + 0.6 * step, height, 0), shape);
        }
        const dolls = Array.from({ length: 6 }, (_, index) => {
            const doll = addRagdoll(context, vec(-3.8 + 0.2 * (index % 2), 6.4 + 1.1 * index, 1.6 * ((index % 3) - 1)), turn(Y, Math.PI / 2));
            for (const limb of doll) limb.setLinvel(vec(2.5, 0, 0), true);
            return doll;
        });
        return { claims: [together(dolls, 300)] };
    },
};

const heap: Scene = {
    id: "ragdoll-heap",
    title: "Heap of people",
    description: "Thirty people fall into a pit and come to rest in a heap.",
    group,
    camera: { eye: [6, 8, 9], target: [0, 1, 0] },
    poster: 240,
    parameters: { count: { label: "People", value: 30, min: 1, max: 120, step: 1 } },
    setup(context) {
        addFloor(context);
        addPit(context, 2.4, 2.5);
        const dolls = Array.from({ length: context.parameter<number>("count") }, (_, index) => {
            const at = vec(1.1 * ((index % 3) - 1), 2 + 0.7 * index, 1.1 * ((Math.floor(index / 3) % 3) - 1));
            return addRagdoll(context, at, turn(X, context.random.between(0, 6)));
        });
        return { claims: [together(dolls, 300)] };
    },
};

const trampoline: Scene = {
    id: "ragdoll-trampoline",
    title: "Trampoline",
    description: "A springy deck throws people up again and again.",
    group,
    camera: { eye: [7, 6, 9], target: [0, 1.8, 0] },
    poster: 90,
    setup(context) {
        addFloor(context);
        const { RAPIER, paint } = context;
        const deck = RAPIER.ColliderDesc.cuboid(2.2, 0.1, 2.2).setRestitution(1.05);
        const body = addFixed(context, vec(0, 0.6, 0), deck.setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max));
        paint(body, "blue");
        const dolls = [-1, 0, 1].map((x) => addRagdoll(context, vec(1.3 * x, 4 + 0.6 * x, 0), turn(X, 0.3 * x)));
        const check = (): boolean => dolls.flat().every((limb) => speed(limb.linvel()) < 40);
        return { claims: [together(dolls, 240), { text: "No ragdoll is flung away", after: 240, check }] };
    },
};

export const RAGDOLLS: readonly Scene[] = [stairs, heap, trampoline];
