// Characters and controllers.

import { add, addFixed, addFloor, ORIGIN, turn, vec, Z } from "../kit.ts";
import type { Context, RigidBody, Scene } from "../rapier.ts";

const group = "Characters";

/** A course of steps, a ramp, a wall and boxes. */
function addCourse(context: Context): void {
    const { RAPIER } = context;
    addFloor(context);
    for (let step = 0; step < 8; step++) {
        const height = 0.1 * (step + 1);
        addFixed(context, vec(2.3 + 0.5 * step, height, 0), RAPIER.ColliderDesc.cuboid(0.25, height, 1.4));
    }
    addFixed(context, vec(7.4, 0.8, 0), RAPIER.ColliderDesc.cuboid(1.35, 0.8, 1.4));
    addFixed(context, vec(10.1, 0.69, 0), RAPIER.ColliderDesc.cuboid(1.55, 0.1, 1.4), turn(Z, -0.53));
    addFixed(context, vec(0, 0.7, -4), RAPIER.ColliderDesc.cuboid(6, 0.7, 0.2));
    for (let box = 0; box < 10; box++) {
        add(context, vec(-3 - 0.9 * (box % 3), 0.35 + 0.7 * Math.floor(box / 3), 1.2), RAPIER.ColliderDesc.cuboid(0.35, 0.35, 0.35).setDensity(0.3));
    }
}

const character: Scene = {
    id: "character",
    title: "Character",
    description: "A character climbs steps, walks down a ramp and pushes boxes. Arrow keys walk, J jumps.",
    group,
    camera: { eye: [1, 6.5, 11], target: [2, 0.8, 0] },
    steered: true,
    action: "Jump",
    poster: 160,
    setup(context) {
        addCourse(context);
        const { RAPIER, world, input, paint } = context;
        const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(0, 0.9, 0));
        const collider = world.createCollider(RAPIER.ColliderDesc.capsule(0.45, 0.3), body);
        paint(body, "orange");
        const controller = world.createCharacterController(0.02);
        controller.enableAutostep(0.35, 0.15, true);
        controller.enableSnapToGround(0.3);
        controller.setMaxSlopeClimbAngle(0.8);
        controller.setApplyImpulsesToDynamicBodies(true);
        let fall = 0;
        let highest = 0;
        return {
            update: (time) => {
                const dt = world.timestep;
                // Without input it walks over the steps and back.
                const back = Math.floor(time / 5) % 2 === 1;
                const [x, y] = input.used ? [input.x, input.y] : [back ? -1 : 1, 0];
                const grounded = controller.computedGrounded();
                if (grounded) fall = input.action ? 5 : -0.5;
                else fall -= 9.81 * dt;
                const wish = vec(2.6 * x * dt, fall * dt, -2.6 * y * dt);
                controller.computeColliderMovement(collider, wish);
                const way = controller.computedMovement();
                const at = body.translation();
                body.setNextKinematicTranslation(vec(at.x + way.x, at.y + way.y, at.z + way.z));
                highest = Math.max(highest, at.y);
            },
            caption: () => (controller.computedGrounded() ? "on the ground" : "in the air"),
            follow: () => ({ ...body.translation(), y: 0 }),
            claims: [{ text: "It has climbed the steps", after: 240, check: () => highest > 2.2 }],
        };
    },
};

const crowd: Scene = {
    id: "crowd",
    title: "Crowd",
    description: "Forty characters walk in circles, and slide past each other.",
    group,
    camera: { eye: [9, 11, 13], target: [0, 0, 0] },
    poster: 120,
    setup(context) {
        addFloor(context);
        const { RAPIER, world } = context;
        for (let post = 0; post < 9; post++) {
            addFixed(context, vec(2.4 * ((post % 3) - 1), 0.8, 2.4 * (Math.floor(post / 3) - 1)), RAPIER.ColliderDesc.cylinder(0.8, 0.35));
        }
        const controller = world.createCharacterController(0.02);
        const walkers = Array.from({ length: 40 }, (_, index) => {
            const [angle, radius] = [0.157 * index * 5, 4.5 + 0.55 * (index % 5)];
            const start = vec(radius * Math.cos(angle), 0.75, radius * Math.sin(angle));
            const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(start.x, start.y, start.z));
            return { body, collider: world.createCollider(RAPIER.ColliderDesc.capsule(0.4, 0.28), body), way: index % 2 === 0 ? 1 : -1 };
        });
        walkers.forEach(({ body }, index) => context.paint(body, index % 2 === 0 ? "orange" : "teal"));
        return {
            update: () => {
                for (const { body, collider, way } of walkers) {
                    const at = body.translation();
                    const distance = Math.hypot(at.x, at.z);
                    const pull = 0.25 * (5 - distance);
                    const [x, z] = [(-way * at.z) / distance + (pull * at.x) / distance, (way * at.x) / distance + (pull * at.z) / distance];
                    const step = 1.8 * world.timestep;
                    controller.computeColliderMovement(collider, vec(x * step, -0.01, z * step));
                    const moved = controller.computedMovement();
                    body.setNextKinematicTranslation(vec(at.x + moved.x, at.y + moved.y, at.z + moved.z));
                }
            },
        };
    },
};

const drone: Scene = {
    id: "drones",
    title: "Drones (PID)",
    description: "A PID controller keeps each drone at a moving target, with a load on a rope.",
    group,
    camera: { eye: [6, 6, 11], target: [0, 3, 0] },
    poster: 150,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const drones: RigidBody[] = [];
        for (let index = 0; index < 5; index++) {
            const body = add(context, vec(2 * (index - 2), 2, 0), RAPIER.ColliderDesc.roundCylinder(0.06, 0.45, 0.06).setDensity(6));
            paint(body, index % 2 === 0 ? "teal" : "orange");
            const load = add(context, vec(2 * (index - 2), 1, 0), RAPIER.ColliderDesc.cuboid(0.2, 0.2, 0.2).setDensity(0.7));
            world.createImpulseJoint(RAPIER.JointData.rope(1.2, ORIGIN, vec(0, 0.2, 0)), body, load, true);
            drones.push(body);
        }
        const pid = drones.map(() => world.createPidController(60, 1, 0.8, RAPIER.PidAxesMask.AllLin));
        const goal = (index: number, time: number) =>
            vec(2 * (index - 2), 3.5 + 0.8 * Math.sin(0.7 * time + index), Math.cos(0.6 * time + index));
        let now = 0;
        return {
            update: (time) => {
                now = time;
                drones.forEach((drone, index) => {
                    pid[index]!.applyLinearCorrection(drone, goal(index, time), ORIGIN);
                    drone.setAngvel(ORIGIN, true);
                });
            },
            draw: (pen) => {
                drones.forEach((_, index) => pen.cross(goal(index, now), 0.15, "yellow"));
                world.impulseJoints.forEach((joint) => pen.line(joint.body1().translation(), joint.body2().translation(), "grey"));
            },
        };
    },
};

export const CHARACTERS: readonly Scene[] = [character, crowd, drone];
