// Continuous collision detection.

import { addFixed, addFloor, ORIGIN, vec } from "../kit.ts";
import type { RigidBody, Scene } from "../rapier.ts";

const bullets: Scene = {
    id: "bullets",
    title: "Bullets",
    description: "Balls at 400 m/s hit a thin wall: green ones have continuous detection, red ones do not.",
    group: "Fast bodies",
    camera: { target: [0, 3.2, 0], height: 9 },
    poster: 200,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        addFixed(context, vec(2, 2.5), RAPIER.ColliderDesc.cuboid(0.03, 2.5));
        const shots: { body: RigidBody; careful: boolean }[] = [];
        const check = (): boolean => shots.filter(({ careful }) => careful).every(({ body }) => body.translation().x < 2.5);
        return {
            update: (_time, step) => {
                if (step % 8 !== 0 || shots.length >= 60) return;
                const careful = shots.length % 2 === 0;
                const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(-6, 1 + 0.35 * (shots.length % 9));
                const body = world.createRigidBody(description.setLinvel(400, 0).setCcdEnabled(careful));
                world.createCollider(RAPIER.ColliderDesc.ball(0.12).setDensity(5), body);
                paint(body, careful ? "green" : "red");
                shots.push({ body, careful });
            },
            claims: [{ text: "No green ball passes the wall", after: 300, check }],
        };
    },
};

const rattle: Scene = {
    id: "rattle",
    title: "Rattle",
    description: "Fast elastic balls stay inside a box of thin lines.",
    group: "Fast bodies",
    camera: { target: [0, 0, 0], height: 8 },
    gravity: 0,
    setup(context) {
        const { RAPIER, world, random } = context;
        const outline = new Float32Array([-4, -3, 4, -3, 4, 3, -4, 3, -4, -3]);
        addFixed(context, ORIGIN, RAPIER.ColliderDesc.polyline(outline).setRestitution(1));
        addFixed(context, ORIGIN, RAPIER.ColliderDesc.ball(0.8).setRestitution(1));
        const balls = Array.from({ length: 40 }, () => {
            const side = random.below(2) === 0 ? -1 : 1;
            const description = RAPIER.RigidBodyDesc.dynamic().setTranslation(side * random.between(1.2, 3.6), random.between(-2.6, 2.6));
            const body = world.createRigidBody(description.setLinvel(random.between(-60, 60), random.between(-60, 60)).setCcdEnabled(true));
            world.createCollider(RAPIER.ColliderDesc.ball(0.14).setRestitution(1).setFriction(0), body);
            return body;
        });
        const check = (): boolean => balls.every((ball) => Math.abs(ball.translation().x) < 4.1 && Math.abs(ball.translation().y) < 3.1);
        return { claims: [{ text: "No ball leaves the box", after: 300, check }] };
    },
};

export const FAST: readonly Scene[] = [bullets, rattle];
