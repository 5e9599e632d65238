// Events, sensors and hooks.

import { add, addFixed, addFloor, addWalls, vec } from "../kit.ts";
import type { Scene } from "../rapier.ts";

const sensors: Scene = {
    id: "sensors",
    title: "Sensors",
    description: "Balls change their colour while they are inside of a sensor.",
    group: "Events and sensors",
    camera: { target: [0, 3.4, 0], height: 10 },
    poster: 260,
    setup(context) {
        addFloor(context);
        addWalls(context, 7, 4);
        const { RAPIER, world, paint, random } = context;
        const events = new RAPIER.EventQueue(true);
        for (let peg = 0; peg < 11; peg++) addFixed(context, vec(1.2 * (peg - 5), 1 + 0.6 * (peg % 2)), RAPIER.ColliderDesc.ball(0.2));
        const zones = new Set([-3.5, 0, 3.5].map((x) => {
            const shape = RAPIER.ColliderDesc.cuboid(1.1, 0.8).setSensor(true).setTranslation(x, 3.6);
            return world.createCollider(shape.setActiveEvents(RAPIER.ActiveEvents.COLLISION_EVENTS)).handle;
        }));
        let entries = 0;
        return {
            events,
            update: (_time, step) => {
                if (step % 12 === 0 && step < 1200) paint(add(context, vec(random.between(-6, 6), 8), RAPIER.ColliderDesc.ball(0.25)), "blue");
            },
            after: () =>
                events.drainCollisionEvents((first, second, started) => {
                    const collider = world.getCollider(zones.has(first) ? second : first);
                    if (collider) paint(collider, started ? "orange" : "blue");
                    if (started) entries += 1;
                }),
            caption: () => `${entries} entries`,
            claims: [{ text: "Balls have entered sensors", after: 240, check: () => entries > 3 }],
        };
    },
};

const forces: Scene = {
    id: "contact-forces",
    title: "Contact forces",
    description: "Boxes light up by the force that acts on them at an impact.",
    group: "Events and sensors",
    camera: { target: [0, 3.4, 0], height: 9.5 },
    poster: 90,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const events = new RAPIER.EventQueue(true);
        for (let index = 0; index < 30; index++) {
            const shape = RAPIER.ColliderDesc.cuboid(0.4, 0.4).setActiveEvents(RAPIER.ActiveEvents.CONTACT_FORCE_EVENTS);
            paint(add(context, vec(0.82 * ((index % 6) - 2.5), 0.4 + 0.8 * Math.floor(index / 6)), shape.setContactForceEventThreshold(20)), "blue");
        }
        const heavy = add(context, vec(0.3, 9), RAPIER.ColliderDesc.ball(0.8).setDensity(6));
        paint(heavy, "white");
        let most = 0;
        return {
            events,
            after: () =>
                events.drainContactForceEvents((event) => {
                    const force = event.maxForceMagnitude();
                    most = Math.max(most, force);
                    for (const handle of [event.collider1(), event.collider2()]) {
                        const collider = world.getCollider(handle);
                        const body = collider?.parent();
                        if (!collider || !body?.isDynamic() || body.handle === heavy.handle) continue;
                        paint(collider, force > 800 ? "red" : force > 200 ? "orange" : force > 60 ? "yellow" : "teal");
                    }
                }),
            caption: () => `largest force ${most.toFixed(0)} N`,
            claims: [{ text: "The impact is reported", after: 150, check: () => most > 300 }],
        };
    },
};

const hooks: Scene = {
    id: "one-way",
    title: "One-way floors",
    description: "A hook lets balls pass the floors upwards, and holds them from falling back.",
    group: "Events and sensors",
    camera: { target: [0, 4, 0], height: 10.5 },
    poster: 200,
    setup(context) {
        addFloor(context);
        addWalls(context, 5, 8);
        const { RAPIER, paint, random } = context;
        const floors = new Map([2, 4, 6].map((y) => {
            const shape = RAPIER.ColliderDesc.cuboid(5, 0.08).setActiveHooks(RAPIER.ActiveHooks.FILTER_CONTACT_PAIRS);
            const floor = addFixed(context, vec(0, y), shape);
            paint(floor, "teal");
            return [floor.collider(0).handle, y] as const;
        }));
        const balls = Array.from({ length: 30 }, () => {
            const ball = add(context, vec(random.between(-4.5, 4.5), 0.4), RAPIER.ColliderDesc.ball(0.25));
            ball.setLinvel(vec(0, random.between(6, 13)), true);
            return ball;
        });
        // Bodies cannot be read during a step: the hook uses values from before the step.
        const above = new Map<number, Set<number>>();
        const reached = (): number => balls.filter((ball) => ball.translation().y > 1.9).length;
        return {
            hooks: {
                filterContactPair: (first, second, body1, body2) => {
                    const floor = floors.has(first) ? first : second;
                    const body = floors.has(first) ? body2 : body1;
                    return above.get(floor)?.has(body) ? RAPIER.SolverFlags.COMPUTE_IMPULSE : null;
                },
                filterIntersectionPair: () => true,
            },
            // The published package calls hooks only in steps with an event queue.
            events: new RAPIER.EventQueue(true),
            update: () => {
                for (const [floor, y] of floors) {
                    const known = above.get(floor) ?? new Set<number>();
                    for (const ball of balls) {
                        const at = ball.translation();
                        if (at.y > y + 0.3 && ball.linvel().y < 1) known.add(ball.handle);
                        if (at.y < y - 0.2) known.delete(ball.handle);
                    }
                    above.set(floor, known);
                }
            },
            caption: () => `${reached()} balls upstairs`,
            claims: [{ text: "Balls stay upstairs", after: 300, check: () => reached() > 8 }],
        };
    },
};

export const EVENTS: readonly Scene[] = [sensors, forces, hooks];
