// Events, sensors and hooks.

import { add, addFixed, addFloor, addPit, turn, vec, X } from "../kit.ts";
import type { PhysicsHooks, RigidBody, Scene } from "../rapier.ts";

const group = "Events and sensors";

const gate: Scene = {
    id: "sensors",
    title: "Sensors",
    description: "Balls change their colour while they are inside of a sensor.",
    group,
    camera: { eye: [8, 7, 12], target: [0, 2, 0] },
    poster: 150,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint, random } = context;
        const events = new RAPIER.EventQueue(true);
        addFixed(context, vec(0, 2.2, 0), RAPIER.ColliderDesc.cuboid(6, 0.1, 1.5), turn(vec(0, 0, 1), -0.35));
        for (const z of [-1.6, 1.6]) paint(addFixed(context, vec(0, 2.6, z), RAPIER.ColliderDesc.cuboid(6, 0.5, 0.1), turn(vec(0, 0, 1), -0.35)), "glass");
        const sensors = new Set([-2.5, 0, 2.5].map((x) => {
            const shape = RAPIER.ColliderDesc.cuboid(0.6, 1.1, 1.5).setSensor(true).setActiveEvents(RAPIER.ActiveEvents.COLLISION_EVENTS);
            return world.createCollider(shape.setTranslation(x, 3.2 - 0.365 * x, 0)).handle;
        }));
        let passed = 0;
        return {
            events,
            update: (_time, step) => {
                if (step % 30 !== 0 || step > 1500) return;
                const ball = add(context, vec(-5.4, 5.6, random.between(-1, 1)), RAPIER.ColliderDesc.ball(0.3));
                paint(ball, "blue");
            },
            after: () =>
                events.drainCollisionEvents((first, second, started) => {
                    const other = sensors.has(first) ? second : first;
                    const collider = world.getCollider(other);
                    if (collider) paint(collider, started ? "orange" : "blue");
                    if (started) passed += 1;
                }),
            caption: () => `${passed} entries`,
            claims: [{ text: "Balls have entered sensors", after: 240, check: () => passed > 3 }],
        };
    },
};

const tiles: Scene = {
    id: "collision-events",
    title: "Collision events",
    description: "Tiles take the colour of the ball that touched them last.",
    group,
    camera: { eye: [7, 8, 10], target: [0, 0.5, 0] },
    poster: 240,
    setup(context) {
        const { RAPIER, world, paint, random } = context;
        const events = new RAPIER.EventQueue(true);
        addFloor(context);
        addPit(context, 4.5, 2);
        const tileHandles = new Set<number>();
        for (let index = 0; index < 81; index++) {
            const at = vec((index % 9) - 4, 0.1, Math.floor(index / 9) - 4);
            const tile = addFixed(context, at, RAPIER.ColliderDesc.cuboid(0.48, 0.1, 0.48));
            paint(tile, "grey");
            tileHandles.add(tile.collider(0).handle);
        }
        const paints = ["red", "orange", "yellow", "green", "teal", "blue", "purple", "pink"] as const;
        const colours = new Map<number, (typeof paints)[number]>();
        for (const colour of paints) {
            const shape = RAPIER.ColliderDesc.ball(0.35).setRestitution(1).setActiveEvents(RAPIER.ActiveEvents.COLLISION_EVENTS);
            const ball = add(context, vec(random.between(-3, 3), random.between(3, 6), random.between(-3, 3)), shape.setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max));
            ball.setLinvel(vec(random.between(-3, 3), 0, random.between(-3, 3)), true);
            paint(ball, colour);
            colours.set(ball.collider(0).handle, colour);
        }
        let touched = 0;
        return {
            events,
            after: () =>
                events.drainCollisionEvents((first, second, started) => {
                    const tile = tileHandles.has(first) ? first : second;
                    const colour = colours.get(tileHandles.has(first) ? second : first);
                    const collider = tileHandles.has(tile) ? world.getCollider(tile) : null;
                    if (!started || colour === undefined || !collider) return;
                    paint(collider, colour);
                    touched += 1;
                }),
            caption: () => `${touched} touches`,
            claims: [{ text: "Balls have touched tiles", after: 180, check: () => touched > 5 }],
        };
    },
};

const forces: Scene = {
    id: "contact-forces",
    title: "Contact forces",
    description: "Boxes light up by the force that acts on them at an impact.",
    group,
    camera: { eye: [6, 6, 10], target: [0, 1.6, 0] },
    poster: 100,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const events = new RAPIER.EventQueue(true);
        for (let index = 0; index < 36; index++) {
            const shape = RAPIER.ColliderDesc.cuboid(0.4, 0.4, 0.4).setActiveEvents(RAPIER.ActiveEvents.CONTACT_FORCE_EVENTS);
            const at = vec(0.82 * ((index % 6) - 2.5), 0.4 + 0.8 * Math.floor(index / 6), 0);
            paint(add(context, at, shape.setContactForceEventThreshold(15)), "blue");
        }
        const heavy = add(context, vec(0.3, 9, 0), RAPIER.ColliderDesc.ball(0.8).setDensity(8));
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
                        if (!collider || collider.parent()?.handle === heavy.handle || !collider.parent()?.isDynamic()) continue;
                        paint(collider, force > 600 ? "red" : force > 150 ? "orange" : force > 50 ? "yellow" : "teal");
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
    description: "A hook lets balls pass the glass floors upwards, and holds them from falling back.",
    group,
    camera: { eye: [6, 7, 12], target: [0, 3.5, 0] },
    poster: 200,
    setup(context) {
        addFloor(context);
        const { RAPIER, paint, random } = context;
        const floors = new Map<number, number>();
        for (const y of [2, 4, 6]) {
            const shape = RAPIER.ColliderDesc.cuboid(2.5, 0.1, 2.5).setActiveHooks(RAPIER.ActiveHooks.FILTER_CONTACT_PAIRS);
            const floor = addFixed(context, vec(0, y, 0), shape);
            paint(floor, "glass");
            floors.set(floor.collider(0).handle, y);
        }
        const balls = Array.from({ length: 24 }, () => {
            const ball = add(context, vec(random.between(-2, 2), 0.4, random.between(-2, 2)), RAPIER.ColliderDesc.ball(0.25));
            ball.setLinvel(vec(0, random.between(6, 13), 0), true);
            return ball;
        });
        // Bodies cannot be read during a step: the hook uses values from before the step.
        const above = new Map<number, Set<number>>();
        const filter: PhysicsHooks = {
            filterContactPair: (first, second, body1, body2) => {
                const floor = floors.has(first) ? first : second;
                const body = floors.has(first) ? body2 : body1;
                return above.get(floor)?.has(body) ? RAPIER.SolverFlags.COMPUTE_IMPULSE : null;
            },
            filterIntersectionPair: () => true,
        };
        const reached = (): number => balls.filter((ball) => ball.translation().y > 1.9).length;
        return {
            hooks: filter,
            // The published package calls hooks only in steps with an event queue.
            events: new RAPIER.EventQueue(true),
            update: () => {
                for (const [floor, y] of floors) {
                    const bodies = balls.filter((ball) => ball.translation().y > y + 0.3 && ball.linvel().y < 1);
                    const known = above.get(floor) ?? new Set<number>();
                    for (const ball of bodies) known.add(ball.handle);
                    for (const ball of balls) if (ball.translation().y < y - 0.2) known.delete(ball.handle);
                    above.set(floor, known);
                }
            },
            caption: () => `${reached()} balls upstairs`,
            claims: [{ text: "Balls stay upstairs", after: 300, check: () => reached() > 8 }],
        };
    },
};

const counter: Scene = {
    id: "black-hole",
    title: "Recycler",
    description: "A sensor removes every body that falls in, and a new one appears above.",
    group,
    camera: { eye: [8, 9, 14], target: [0, 1.4, 0] },
    poster: 200,
    setup(context) {
        const { RAPIER, world, paint, random } = context;
        const events = new RAPIER.EventQueue(true);
        addFixed(context, vec(-3.5, -0.5, 0), RAPIER.ColliderDesc.cuboid(2.5, 0.5, 5), turn(vec(0, 0, 1), -0.25));
        addFixed(context, vec(3.5, -0.5, 0), RAPIER.ColliderDesc.cuboid(2.5, 0.5, 5), turn(vec(0, 0, 1), 0.25));
        for (const z of [-5, 5]) paint(addFixed(context, vec(0, 0, z), RAPIER.ColliderDesc.cuboid(6, 1.5, 0.1)), "glass");
        const hole = RAPIER.ColliderDesc.cuboid(8, 0.3, 6).setSensor(true).setTranslation(0, -4, 0);
        const sensor = world.createCollider(hole.setActiveEvents(RAPIER.ActiveEvents.COLLISION_EVENTS));
        paint(sensor, "purple");
        const drop = (y: number): RigidBody => {
            const at = vec(random.between(-5, 5), y, random.between(-4.5, 4.5));
            const shapes = [RAPIER.ColliderDesc.ball(0.3), RAPIER.ColliderDesc.cuboid(0.3, 0.3, 0.3), RAPIER.ColliderDesc.capsule(0.2, 0.2)];
            return add(context, at, random.pick(shapes), turn(X, random.between(0, 3)));
        };
        for (let index = 0; index < 80; index++) drop(2 + 0.15 * index);
        let recycled = 0;
        return {
            events,
            after: () => {
                const fallen: RigidBody[] = [];
                events.drainCollisionEvents((first, second, started) => {
                    const body = world.getCollider(first === sensor.handle ? second : first)?.parent();
                    if (started && body) fallen.push(body);
                });
                for (const body of fallen) {
                    world.removeRigidBody(body);
                    drop(7);
                    recycled += 1;
                }
            },
            caption: () => `${recycled} bodies replaced`,
            claims: [{ text: "Bodies are replaced", after: 300, check: () => recycled > 5 }],
        };
    },
};

export const EVENTS: readonly Scene[] = [gate, tiles, forces, hooks, counter];
