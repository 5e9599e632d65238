// Kinematic bodies.

import { add, addFloor, addPit, turn, vec, X, Y, Z } from "../kit.ts";
import type { RigidBody, Scene } from "../rapier.ts";

const group = "Kinematic platforms";

const platforms: Scene = {
    id: "platforms",
    title: "Platforms",
    description: "Platforms move by position or by velocity, and carry boxes.",
    group,
    camera: { eye: [8, 7, 12], target: [0, 2, 0] },
    poster: 120,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const add3 = (description: ReturnType<typeof RAPIER.RigidBodyDesc.fixed>, x: number): RigidBody => {
            const body = world.createRigidBody(description.setTranslation(x, 1.5, 0));
            world.createCollider(RAPIER.ColliderDesc.cuboid(1.2, 0.12, 1.2).setFriction(1), body);
            return body;
        };
        const lift = add3(RAPIER.RigidBodyDesc.kinematicPositionBased(), -3.5);
        const shuttle = add3(RAPIER.RigidBodyDesc.kinematicVelocityBased(), 0);
        const rocker = add3(RAPIER.RigidBodyDesc.kinematicPositionBased(), 3.5);
        paint(lift, "teal");
        paint(shuttle, "orange");
        paint(rocker, "purple");
        const boxes = [-3.5, 0, 3.5].flatMap((x) =>
            Array.from({ length: 8 }, (_, index) =>
                add(context, vec(x + 0.35 * ((index % 2) * 2 - 1), 2 + 0.62 * Math.floor(index / 4), 0.35 * ((Math.floor(index / 2) % 2) * 2 - 1)), RAPIER.ColliderDesc.cuboid(0.3, 0.3, 0.3).setFriction(1)),
            ),
        );
        const check = (): boolean => boxes.slice(0, 8).every((box) => Math.abs(box.translation().x + 3.5) < 1.3);
        return {
            update: (time) => {
                lift.setNextKinematicTranslation(vec(-3.5, 2 + 1.2 * Math.sin(1.2 * time), 0));
                shuttle.setLinvel(vec(0, 0, 1.6 * Math.cos(1.1 * time)), true);
                rocker.setNextKinematicRotation(turn(Z, 0.3 * Math.sin(0.9 * time)));
            },
            claims: [{ text: "The lift keeps its boxes", after: 300, check }],
        };
    },
};

const drum: Scene = {
    id: "washer",
    title: "Washing machine",
    description: "A drum with ribs turns a load of boxes and balls.",
    group,
    camera: { eye: [4, 5, 12], target: [0, 3.2, 0] },
    poster: 160,
    parameters: { speed: { label: "Turns a minute", value: 16, min: 0, max: 90, step: 1, live: true } },
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint, random } = context;
        const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setTranslation(0, 3.2, 0));
        const [sides, radius] = [24, 2.8];
        for (let side = 0; side < sides; side++) {
            const angle = (2 * Math.PI * side) / sides;
            const wall = RAPIER.ColliderDesc.cuboid(0.12, 0.4, 1.6).setTranslation(radius * Math.cos(angle), radius * Math.sin(angle), 0);
            world.createCollider(wall.setRotation(turn(Z, angle)), body);
            if (side % 6 !== 0) continue;
            const rib = RAPIER.ColliderDesc.cuboid(0.35, 0.08, 1.5).setTranslation((radius - 0.4) * Math.cos(angle), (radius - 0.4) * Math.sin(angle), 0);
            world.createCollider(rib.setRotation(turn(Z, angle)), body);
        }
        paint(body, "grey");
        for (const z of [-1.7, 1.7]) {
            const lid = RAPIER.ColliderDesc.cylinder(0.1, radius).setRotation(turn(X, Math.PI / 2)).setTranslation(0, 0, z);
            paint(world.createCollider(lid, body), "glass");
        }
        const load = Array.from({ length: 140 }, (_, index) => {
            const at = vec(random.between(-1.3, 1.3), 3.2 + random.between(-1.3, 1.3), random.between(-1.3, 1.3));
            const half = random.between(0.16, 0.26);
            return add(context, at, index % 3 === 0 ? RAPIER.ColliderDesc.ball(half) : RAPIER.ColliderDesc.cuboid(half, half, half));
        });
        const check = (): boolean => load.every((one) => Math.hypot(one.translation().x, one.translation().y - 3.2) < 3.2);
        return {
            update: () => body.setAngvel(vec(0, 0, (context.parameter<number>("speed") * 2 * Math.PI) / 60), true),
            claims: [{ text: "The load stays in the drum", after: 400, check }],
        };
    },
};

const sweeper: Scene = {
    id: "junkyard",
    title: "Scrapyard",
    description: "A blade sweeps through five hundred pieces of scrap.",
    group,
    camera: { eye: [10, 11, 13], target: [0, 0.5, 0] },
    poster: 220,
    setup(context) {
        addFloor(context);
        addPit(context, 6.5, 2);
        const { RAPIER, world, paint, random } = context;
        const blade = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setTranslation(0, 0.65, 0).setAngvel(vec(0, 0.7, 0)));
        world.createCollider(RAPIER.ColliderDesc.cuboid(6, 0.6, 0.15), blade);
        paint(blade, "red");
        for (let index = 0; index < 500; index++) {
            const shapes = [RAPIER.ColliderDesc.cuboid(0.3, 0.1, 0.2), RAPIER.ColliderDesc.cuboid(0.2, 0.2, 0.2), RAPIER.ColliderDesc.cylinder(0.2, 0.18), RAPIER.ColliderDesc.capsule(0.25, 0.1)];
            const at = vec(random.between(-6, 6), 1.6 + 0.015 * index, random.between(-6, 6));
            const body = add(context, at, random.pick(shapes), turn(Y, random.between(0, 3)));
            paint(body, random.pick(["teal", "blue", "grey", "white"]));
        }
    },
};

export const PLATFORMS: readonly Scene[] = [platforms, drum, sweeper];
