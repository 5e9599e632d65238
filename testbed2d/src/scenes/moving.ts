// Ragdolls, vehicles, characters and kinematic platforms.

import { add, addFixed, addFloor, addWalls, distance, ORIGIN, vec } from "../kit.ts";
import type { Context, RevoluteImpulseJoint, RigidBody, Scene, Vector } from "../rapier.ts";

/** A person from the side, of ten capsules; returns the limbs, the body first. */
export function addRagdoll(context: Context, at: Vector): RigidBody[] {
    const { RAPIER, world, paint, random } = context;
    const limbs: RigidBody[] = [];
    const limb = (x: number, y: number, half: number, radius: number): RigidBody => {
        // Limbs of one person do not collide: they lie over each other in the plane.
        const shape = RAPIER.ColliderDesc.capsule(half, radius).setCollisionGroups(0x0002_0001);
        const body = add(context, vec(at.x + x, at.y + y), shape.setFriction(0.7));
        body.setAngularDamping(1);
        limbs.push(body);
        return body;
    };
    const join = (first: RigidBody, second: RigidBody, anchor1: Vector, anchor2: Vector, low: number, high: number): void => {
        const data = RAPIER.JointData.revolute(anchor1, anchor2);
        data.limitsEnabled = true;
        data.limits = [low, high];
        world.createImpulseJoint(data, first, second, true).setContactsEnabled(false);
    };
    const chest = limb(0, 0, 0.28, 0.16);
    const head = limb(0, 0.66, 0.02, 0.16);
    join(chest, head, vec(0, 0.45), vec(0, -0.2), -0.5, 0.5);
    for (const side of [0, 1]) {
        const upper = limb(0, 0.12, 0.14, 0.06);
        const lower = limb(0, -0.26, 0.16, 0.05);
        join(chest, upper, vec(0, 0.32), vec(0, 0.2), -2.6, 1.2);
        join(upper, lower, vec(0, -0.19), vec(0, 0.19), 0, 2.2);
        const thigh = limb(0, -0.62, 0.18, 0.09);
        const shin = limb(0, -1.1, 0.2, 0.07);
        join(chest, thigh, vec(0, -0.36), vec(0, 0.26), -0.6, 1.8);
        join(thigh, shin, vec(0, -0.24), vec(0, 0.24), -2.2, 0);
        const trousers = side === 0 ? "dark" : "grey";
        for (const leg of [thigh, shin]) paint(leg, trousers);
    }
    const shirt = random.pick(["blue", "teal", "red", "purple", "green"] as const);
    paint(chest, shirt);
    paint(head, "yellow");
    for (const index of [2, 6]) paint(limbs[index]!, shirt);
    for (const index of [3, 7]) paint(limbs[index]!, "yellow");
    return limbs;
}

function together(dolls: readonly RigidBody[][], after: number) {
    const check = (): boolean | string => {
        const most = Math.max(...dolls.flatMap((limbs) => limbs.map((limb) => distance(limb.translation(), limbs[0]!.translation()))));
        return most < 1.5 || `a limb is ${most.toFixed(2)} m away`;
    };
    return { text: "Limbs stay with their person", after, check };
}

const stairs: Scene = {
    id: "ragdoll-stairs",
    title: "Down the stairs",
    description: "People of ten limbs tumble down a flight of stairs.",
    group: "Ragdolls",
    camera: { target: [0, 3.4, 0], height: 10.5 },
    poster: 150,
    setup(context) {
        addFloor(context);
        for (let step = 0; step < 12; step++) {
            const height = 0.2 * (12 - step);
            const shape = context.RAPIER.ColliderDesc.cuboid(0.4, height);
            addFixed(context, vec(-5 + 0.8 * step, height), shape);
        }
        const dolls = Array.from({ length: 5 }, (_, index) => {
            const doll = addRagdoll(context, vec(-5 + 0.7 * index, 6.6 + 1.2 * (index % 3)));
            for (const limb of doll) limb.setLinvel(vec(2.5, 0), true);
            return doll;
        });
        return { claims: [together(dolls, 300)] };
    },
};

const pit: Scene = {
    id: "ragdoll-pit",
    title: "Heap of people",
    description: "Twenty people fall over pegs into a pit.",
    group: "Ragdolls",
    camera: { target: [0, 4.4, 0], height: 12 },
    poster: 120,
    setup(context) {
        addFloor(context);
        addWalls(context, 5, 6);
        for (let peg = 0; peg < 7; peg++) {
            addFixed(context, vec(1.5 * (peg - 3), 3.2 + (peg % 2)), context.RAPIER.ColliderDesc.ball(0.3));
        }
        const dolls = Array.from({ length: 20 }, (_, index) => addRagdoll(context, vec(1.7 * ((index % 5) - 2), 6 + 1.1 * index)));
        return { claims: [together(dolls, 400)] };
    },
};

/** Heights of hills that grow towards the right. */
function hills(cells: number): Float32Array {
    const heights = new Float32Array(cells + 1);
    for (let index = 0; index <= cells; index++) {
        const x = (index / cells) * 120;
        heights[index] = x < 12 ? 0 : 0.9 * Math.sin(0.45 * (x - 12)) * Math.min(1, (x - 12) / 25) + 0.3 * Math.sin(1.3 * x);
    }
    return heights;
}

const car: Scene = {
    id: "car",
    title: "Car",
    description: "A car on two sprung wheels drives over hills. Steer with the arrow keys.",
    group: "Vehicles and characters",
    camera: { target: [-50, 1.5, 0], height: 10 },
    steered: true,
    poster: 200,
    setup(context) {
        const { RAPIER, world, input, paint } = context;
        addFixed(context, ORIGIN, RAPIER.ColliderDesc.heightfield(hills(240), vec(120, 1)).setFriction(1.2));
        addFixed(context, vec(-60.5, 3), RAPIER.ColliderDesc.cuboid(0.5, 4));
        const hull = RAPIER.ColliderDesc.convexHull(new Float32Array([-1.5, -0.3, 1.6, -0.3, 1.6, 0.1, 0.8, 0.25, 0.3, 0.75, -0.8, 0.75, -1.5, 0.25]));
        if (!hull) throw new Error("the car has no hull");
        // Wheels reach into the body: their groups exclude each other.
        const body = add(context, vec(-50, 1.4), hull.setDensity(2).setCollisionGroups(0x0002_fffb));
        paint(body, "red");
        const wheels = [-1, 1.05].map((x) => {
            const hub = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(-50 + x, 0.85).setAdditionalMass(1));
            world.createCollider(RAPIER.ColliderDesc.ball(0.08).setCollisionGroups(0), hub);
            const slide = RAPIER.JointData.prismatic(vec(x, -0.55), ORIGIN, vec(0, 1));
            slide.limitsEnabled = true;
            slide.limits = [-0.25, 0.3];
            const strut = world.createImpulseJoint(slide, body, hub, true) as PrismaticMotor;
            strut.configureMotorModel(RAPIER.MotorModel.AccelerationBased);
            strut.configureMotorPosition(-0.05, 260, 22);
            const wheel = add(context, vec(-50 + x, 0.85), RAPIER.ColliderDesc.ball(0.48).setFriction(1.6).setDensity(1.5).setCollisionGroups(0x0004_fffd));
            paint(wheel, "dark");
            const axle = world.createImpulseJoint(RAPIER.JointData.revolute(ORIGIN, ORIGIN), hub, wheel, true) as RevoluteImpulseJoint;
            axle.setContactsEnabled(false);
            return axle;
        });
        for (let box = 0; box < 12; box++) {
            add(context, vec(-36 + 0.7 * (box % 3), 0.5 + 0.6 * Math.floor(box / 3)), RAPIER.ColliderDesc.cuboid(0.3, 0.3).setDensity(0.2));
        }
        return {
            update: () => {
                const gas = input.used ? input.x || input.y : 0.8;
                for (const wheel of wheels) wheel.configureMotorVelocity(-22 * gas, gas === 0 ? 5 : 160);
            },
            follow: () => body.translation(),
            caption: () => `${Math.abs(3.6 * body.linvel().x).toFixed(0)} km/h`,
            claims: [{ text: "The car drives at least 10 m in 5 s", after: 300, check: () => body.translation().x > -40 }],
        };
    },
};

type PrismaticMotor = RevoluteImpulseJoint;

const character: Scene = {
    id: "character",
    title: "Character",
    description: "A character climbs steps and slopes and pushes boxes. Arrow keys walk, J jumps.",
    group: "Vehicles and characters",
    camera: { target: [0, 2, 0], height: 9 },
    steered: true,
    action: "Jump",
    poster: 150,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, input, paint } = context;
        for (let step = 0; step < 8; step++) {
            const height = 0.1 * (step + 1);
            addFixed(context, vec(2 + 0.5 * step, height), RAPIER.ColliderDesc.cuboid(0.25, height));
        }
        addFixed(context, vec(7, 0.8), RAPIER.ColliderDesc.cuboid(1.25, 0.8));
        addFixed(context, vec(9.7, 0.74), RAPIER.ColliderDesc.cuboid(1.6, 0.1), -0.52);
        for (let box = 0; box < 6; box++) add(context, vec(-4 - 0.8 * (box % 3), 0.35 + 0.7 * Math.floor(box / 3)), RAPIER.ColliderDesc.cuboid(0.35, 0.35).setDensity(0.3));
        const lift = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(-8.5, 0.5));
        world.createCollider(RAPIER.ColliderDesc.cuboid(1, 0.15), lift);
        paint(lift, "teal");
        const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(0, 0.8));
        const collider = world.createCollider(RAPIER.ColliderDesc.capsule(0.4, 0.3), body);
        paint(body, "orange");
        const controller = world.createCharacterController(0.02);
        controller.enableAutostep(0.35, 0.15, true);
        controller.enableSnapToGround(0.3);
        controller.setApplyImpulsesToDynamicBodies(true);
        let fall = 0;
        let highest = 0;
        return {
            update: (time) => {
                const dt = world.timestep;
                lift.setNextKinematicTranslation(vec(-8.5, 1.6 + 1.2 * Math.sin(time)));
                const back = Math.floor(time / 5) % 2 === 1;
                const x = input.used ? input.x : back ? -1 : 1;
                if (controller.computedGrounded()) fall = input.action || input.y > 0.5 ? 5.5 : -0.5;
                else fall -= 9.81 * dt;
                controller.computeColliderMovement(collider, vec(2.6 * x * dt, fall * dt));
                const way = controller.computedMovement();
                const at = body.translation();
                body.setNextKinematicTranslation(vec(at.x + way.x, at.y + way.y));
                highest = Math.max(highest, at.y);
            },
            follow: () => vec(body.translation().x, 2),
            caption: () => (controller.computedGrounded() ? "on the ground" : "in the air"),
            claims: [{ text: "It has climbed the steps", after: 240, check: () => highest > 2.1 }],
        };
    },
};

const platforms: Scene = {
    id: "platforms",
    title: "Platforms",
    description: "Kinematic platforms carry boxes up, along and around.",
    group: "Kinematic platforms",
    camera: { target: [0, 2.8, 0], height: 9 },
    poster: 120,
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint } = context;
        const platform = (x: number): RigidBody => {
            const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(x, 1.5));
            world.createCollider(RAPIER.ColliderDesc.cuboid(1.5, 0.12).setFriction(1), body);
            for (let box = 0; box < 6; box++) add(context, vec(x + 0.65 * ((box % 2) - 0.5), 2 + 0.62 * Math.floor(box / 2)), RAPIER.ColliderDesc.cuboid(0.3, 0.3).setFriction(1));
            return body;
        };
        const [lift, shuttle, rocker] = [platform(-4.5), platform(0), platform(4.5)];
        paint(lift, "teal");
        paint(shuttle, "orange");
        paint(rocker, "purple");
        return {
            update: (time) => {
                lift.setNextKinematicTranslation(vec(-4.5, 2 + 1.2 * Math.sin(1.2 * time)));
                shuttle.setNextKinematicTranslation(vec(Math.sin(1.1 * time), 1.5));
                rocker.setNextKinematicRotation(0.3 * Math.sin(0.9 * time));
            },
        };
    },
};

const washer: Scene = {
    id: "washer",
    title: "Washing machine",
    description: "A drum with ribs turns a load of boxes and balls.",
    group: "Kinematic platforms",
    camera: { target: [0, 4.6, 0], height: 10.5 },
    poster: 200,
    parameters: { speed: { label: "Turns a minute", value: 14, min: 0, max: 90, step: 1, live: true } },
    setup(context) {
        addFloor(context);
        const { RAPIER, world, paint, random } = context;
        const drum = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicVelocityBased().setTranslation(0, 4.6));
        const [sides, radius] = [28, 4.2];
        for (let side = 0; side < sides; side++) {
            const angle = (2 * Math.PI * side) / sides;
            const [c, s] = [Math.cos(angle), Math.sin(angle)];
            world.createCollider(RAPIER.ColliderDesc.cuboid(0.12, 0.5).setTranslation(radius * c, radius * s).setRotation(angle), drum);
            if (side % 7 === 0) {
                world.createCollider(RAPIER.ColliderDesc.cuboid(0.45, 0.08).setTranslation((radius - 0.5) * c, (radius - 0.5) * s).setRotation(angle), drum);
            }
        }
        paint(drum, "grey");
        const load = Array.from({ length: 180 }, (_, index) => {
            const half = random.between(0.12, 0.25);
            const at = vec(random.between(-2.2, 2.2), 4.6 + random.between(-2.2, 2.2));
            return add(context, at, index % 3 === 0 ? RAPIER.ColliderDesc.ball(half) : RAPIER.ColliderDesc.cuboid(half, half));
        });
        const check = (): boolean => load.every((one) => distance(one.translation(), vec(0, 4.6)) < 4.6);
        return {
            update: () => drum.setAngvel((context.parameter<number>("speed") * 2 * Math.PI) / 60, true),
            claims: [{ text: "The load stays in the drum", after: 400, check }],
        };
    },
};

export const RAGDOLLS: readonly Scene[] = [stairs, pit];
export const VEHICLES: readonly Scene[] = [car, character];
export const PLATFORMS: readonly Scene[] = [platforms, washer];
