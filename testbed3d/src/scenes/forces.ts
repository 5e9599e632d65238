// Forces, gravity and impulses.

import { add, addFloor, addPit, distance, rotated, speed, turn, vec, X, Y, Z } from "../kit.ts";
import type { RigidBody, Scene } from "../rapier.ts";
import { DAMPING } from "./materials.ts";

const group = "Forces";

const planets: Scene = {
    id: "planet",
    title: "Small planet",
    description: "Bodies fall towards a planet from all sides, and pile up on it.",
    group,
    camera: { eye: [8, 6, 10], target: [0, 0, 0] },
    gravity: 0,
    poster: 260,
    setup(context) {
        const { RAPIER, world, random, paint } = context;
        const planet = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setAngvel(vec(0, 0.15, 0)));
        world.createCollider(RAPIER.ColliderDesc.ball(2.2).setFriction(1), planet);
        paint(planet, "teal");
        const bodies = Array.from({ length: 150 }, () => {
            const [y, angle, radius] = [random.between(-1, 1), random.between(0, 6.28), random.between(4, 8)];
            const around = radius * Math.sqrt(1 - y * y);
            const at = vec(around * Math.cos(angle), radius * y, around * Math.sin(angle));
            const half = random.between(0.15, 0.3);
            const shape = random.below(2) === 0 ? RAPIER.ColliderDesc.ball(half) : RAPIER.ColliderDesc.cuboid(half, half, half);
            return add(context, at, shape.setFriction(1));
        });
        const check = (): boolean => bodies.every((body) => distance(body.translation(), planet.translation()) < 9);
        return {
            update: () => {
                for (const body of bodies) {
                    const { x, y, z } = body.translation();
                    const pull = (-9.81 * body.mass()) / Math.hypot(x, y, z);
                    body.resetForces(false);
                    body.addForce(vec(pull * x, pull * y, pull * z), true);
                }
            },
            claims: [{ text: "No body leaves the planet", after: 300, check }],
        };
    },
};

const whirl: Scene = {
    id: "whirlwind",
    title: "Whirlwind",
    description: "A field of forces lifts boxes and carries them around.",
    group,
    camera: { eye: [9, 8, 12], target: [0, 3, 0] },
    poster: 240,
    parameters: { strength: { label: "Strength", value: 1, min: 0, max: 2, step: 0.05, live: true } },
    setup(context) {
        addFloor(context);
        const { RAPIER, random } = context;
        const bodies = Array.from({ length: 160 }, () => {
            const at = vec(random.between(-5, 5), random.between(0.3, 4), random.between(-5, 5));
            const half = random.between(0.12, 0.28);
            return add(context, at, RAPIER.ColliderDesc.cuboid(half, half, half));
        });
        return {
            update: () => {
                const strength = context.parameter<number>("strength");
                for (const body of bodies) {
                    const [at, v] = [body.translation(), body.linvel()];
                    const radius = Math.hypot(at.x, at.z) + 0.3;
                    const [tx, tz] = [-at.z / radius, at.x / radius];
                    // Air moves in circles and upwards; drag carries bodies along.
                    const swirl = (6 * strength * radius) / (1 + 0.25 * radius * radius);
                    const inward = -3.4 * strength * Math.max(0, 1 - at.y / 4);
                    const lift = strength * 8 * Math.exp(-0.12 * radius * radius) * Math.max(0, 1 - at.y / 7);
                    const air = vec(swirl * tx + (inward * at.x) / radius, lift, swirl * tz + (inward * at.z) / radius);
                    const drag = 3 * body.mass();
                    body.resetForces(false);
                    body.addForce(vec(drag * (air.x - v.x), drag * (air.y - v.y) + 0.6 * strength * drag, drag * (air.z - v.z)), true);
                }
            },
        };
    },
};

const explosion: Scene = {
    id: "explosions",
    title: "Explosions",
    description: "Every three seconds, impulses throw the boxes apart.",
    group,
    camera: { eye: [9, 8, 12], target: [0, 1.5, 0] },
    poster: 130,
    setup(context) {
        addFloor(context);
        addPit(context, 6, 1.5);
        const { RAPIER } = context;
        const bodies: RigidBody[] = [];
        for (let index = 0; index < 125; index++) {
            const [x, y, z] = [index % 5, Math.floor(index / 25), Math.floor(index / 5) % 5];
            bodies.push(add(context, vec(0.82 * (x - 2), 0.4 + 0.8 * y, 0.82 * (z - 2)), RAPIER.ColliderDesc.cuboid(0.4, 0.4, 0.4)));
        }
        return {
            update: (_time, step) => {
                if (step % 180 !== 100) return;
                for (const body of bodies) {
                    const at = body.translation();
                    const away = Math.hypot(at.x, at.y + 0.5, at.z) + 0.3;
                    const impulse = (14 * body.mass()) / (1 + away);
                    body.applyImpulseAtPoint(
                        vec((impulse * at.x) / away, (impulse * (at.y + 1.2)) / away, (impulse * at.z) / away),
                        vec(at.x, at.y - 0.2, at.z),
                        true,
                    );
                }
            },
        };
    },
};

const handle: Scene = {
    id: "t-handle",
    title: "T-handle in space",
    description: "A handle that turns about its middle axis flips over again and again.",
    group,
    camera: { eye: [2.6, 3, 4.6], target: [0, 1.6, 0] },
    gravity: 0,
    poster: 20,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 1.6, 0).setAngvel(vec(9, 0.05, 0.02)).setCanSleep(false);
        const body = world.createRigidBody(description);
        world.createCollider(RAPIER.ColliderDesc.cylinder(0.8, 0.12), body);
        world.createCollider(RAPIER.ColliderDesc.cylinder(0.4, 0.12).setRotation(turn(Z, Math.PI / 2)).setTranslation(0.5, 0, 0), body);
        paint(body, "orange");
        let flips = 0;
        let before = 1;
        return {
            after: () => {
                const side = Math.sign(rotated(body.rotation(), X).x);
                if (side !== before) flips += 1;
                before = side;
            },
            caption: () => `${flips} flips`,
            claims: [
                { text: "The handle flips", after: 600, check: () => flips > 0 },
                { text: "The handle still turns", after: 600, check: () => speed(body.angvel()) > 4 },
            ],
        };
    },
};

const gravity: Scene = {
    id: "gravity-scale",
    title: "Gravity scale",
    description: "Boxes fall, float and rise, each one with its own share of gravity.",
    group,
    camera: { eye: [4, 5, 12], target: [0, 3, 0] },
    poster: 60,
    setup(context) {
        addFloor(context);
        const { RAPIER } = context;
        const boxes = Array.from({ length: 9 }, (_, index) => {
            const box = add(context, vec(1.1 * (index - 4), 3, 0), RAPIER.ColliderDesc.cuboid(0.35, 0.35, 0.35), turn(Y, 0.3));
            box.setGravityScale(0.05 * (4 - index), true);
            box.setLinearDamping(0.2);
            return box;
        });
        const check = (): boolean => boxes[0]!.translation().y < 2 && boxes[8]!.translation().y > 4;
        return { claims: [{ text: "The first falls and the last rises", after: 120, check }] };
    },
};

const locked: Scene = {
    id: "locked-axes",
    title: "Locked axes",
    description: "Boxes that cannot rotate, slide along a line, or only turn about the vertical.",
    group,
    camera: { eye: [6, 6, 10], target: [0, 1.2, 0] },
    poster: 100,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint, random } = context;
        const upright = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(-3, 1.2, 0).lockRotations());
        world.createCollider(RAPIER.ColliderDesc.cuboid(0.3, 1.2, 0.3), upright);
        const rail = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 1.5, 0).lockRotations().enabledTranslations(true, false, false));
        world.createCollider(RAPIER.ColliderDesc.cuboid(0.9, 0.15, 0.9), rail);
        const turnstile = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(3, 1, 0).lockTranslations().enabledRotations(false, true, false));
        world.createCollider(RAPIER.ColliderDesc.cuboid(1.4, 0.6, 0.1), turnstile);
        paint(upright, "red");
        paint(rail, "yellow");
        paint(turnstile, "teal");
        for (let index = 0; index < 40; index++) {
            const at = vec(random.between(-4, 4), 3 + 0.2 * index, random.between(-1.2, 1.2));
            paint(add(context, at, RAPIER.ColliderDesc.ball(0.28)), "blue");
        }
        const check = (): boolean => Math.abs(rail.translation().y - 1.5) < 1e-3 && rotated(upright.rotation(), Y).y > 0.9999;
        return { claims: [{ text: "Locked axes do not move", after: 240, check }] };
    },
};

export const FORCES: readonly Scene[] = [gravity, DAMPING, locked, planets, whirl, explosion, handle];
