// Continuous collision detection.

import { add, addFixed, addFloor, speed, turn, vec, Y } from "../kit.ts";
import type { RigidBody, Scene } from "../rapier.ts";

const group = "Fast bodies";

const bullets: Scene = {
    id: "bullets",
    title: "Bullets",
    description: "Balls at 400 m/s hit a thin plate: green ones have continuous detection, red ones do not.",
    group,
    camera: { eye: [-5.5, 3.8, 7.5], target: [1, 1.5, 0] },
    poster: 200,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        paint(addFixed(context, vec(2, 2, 0), RAPIER.ColliderDesc.cuboid(0.02, 2, 4)), "glass");
        const shots: { body: RigidBody; careful: boolean }[] = [];
        const fire = (index: number): void => {
            const careful = index % 2 === 0;
            const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(-8, 1 + 0.2 * (index % 9), 0.7 * ((index % 8) - 3.5));
            const body = world.createRigidBody(description.setLinvel(400, 0, 0).setCcdEnabled(careful));
            world.createCollider(RAPIER.ColliderDesc.ball(0.12).setDensity(5), body);
            paint(body, careful ? "green" : "red");
            shots.push({ body, careful });
        };
        const check = (): boolean => shots.filter(({ careful }) => careful).every(({ body }) => body.translation().x < 2.5);
        return {
            update: (_time, step) => {
                if (step % 8 === 0 && shots.length < 60) fire(shots.length);
            },
            claims: [{ text: "No green ball passes the plate", after: 300, check }],
        };
    },
};

const rattle: Scene = {
    id: "rattle",
    title: "Rattle",
    description: "Fast elastic balls stay inside a thin glass box.",
    group,
    camera: { eye: [7, 7, 9], target: [0, 2.5, 0] },
    gravity: 0,
    setup(context) {
        const { RAPIER, world, paint } = context;
        addFixed(context, vec(0, -0.2, 0), RAPIER.ColliderDesc.cuboid(6, 0.1, 6));
        const half = 2;
        const walls = [
            [vec(-half, 2.2, 0), vec(0.02, half, half)],
            [vec(half, 2.2, 0), vec(0.02, half, half)],
            [vec(0, 2.2 - half, 0), vec(half, 0.02, half)],
            [vec(0, 2.2 + half, 0), vec(half, 0.02, half)],
            [vec(0, 2.2, -half), vec(half, half, 0.02)],
            [vec(0, 2.2, half), vec(half, half, 0.02)],
        ] as const;
        for (const [at, size] of walls) {
            paint(addFixed(context, at, RAPIER.ColliderDesc.cuboid(size.x, size.y, size.z).setRestitution(1)), "glass");
        }
        const balls = Array.from({ length: 30 }, () => {
            const { random } = context;
            const at = vec(random.between(-1.5, 1.5), random.between(1, 3.5), random.between(-1.5, 1.5));
            const velocity = [random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)].map((v) => 80 * v);
            const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(at.x, at.y, at.z).setCcdEnabled(true);
            const body = world.createRigidBody(description.setLinvel(velocity[0]!, velocity[1]!, velocity[2]!));
            world.createCollider(RAPIER.ColliderDesc.ball(0.14).setRestitution(1).setFriction(0), body);
            return body;
        });
        const check = (): boolean =>
            balls.every((ball) => {
                const { x, y, z } = ball.translation();
                return Math.max(Math.abs(x), Math.abs(y - 2.2), Math.abs(z)) < half + 0.1;
            });
        return { claims: [{ text: "No ball leaves the box", after: 300, check }] };
    },
};

const saw: Scene = {
    id: "spinning-bar",
    title: "Spinning bar",
    description: "A bar at fifteen turns a second sweeps boxes off a table.",
    group,
    camera: { eye: [6, 6, 9], target: [0, 1, 0] },
    poster: 40,
    setup(context) {
        addFloor(context);
        const { RAPIER, paint } = context;
        addFixed(context, vec(0, 0.5, 0), RAPIER.ColliderDesc.cylinder(0.5, 3));
        const bar = add(context, vec(0, 1.5, 0), RAPIER.ColliderDesc.cuboid(1.6, 0.1, 0.05).setDensity(20), turn(Y, 0.2));
        bar.enableCcd(true);
        bar.setGravityScale(0, true);
        bar.setAngvel(vec(0, 94, 0), true);
        paint(bar, "white");
        const boxes: RigidBody[] = [];
        for (let index = 0; index < 24; index++) {
            const angle = (2 * Math.PI * index) / 24;
            const body = add(context, vec(2.2 * Math.cos(angle), 1.32, 2.2 * Math.sin(angle)), RAPIER.ColliderDesc.cuboid(0.2, 0.3, 0.2), turn(Y, -angle));
            boxes.push(body);
            body.setLinvel(vec(-1.2 * Math.cos(angle), 0, -1.2 * Math.sin(angle)), true);
        }
        const check = (): boolean => boxes.every((box) => speed(box.linvel()) < 400);
        return { claims: [{ text: "Speeds stay below that of the bar's end", after: 120, check }] };
    },
};

export const BULLETS: readonly Scene[] = [bullets, rattle, saw];
