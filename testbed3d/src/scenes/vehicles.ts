// Vehicles.

import { add, addFixed, addFloor, ORIGIN, rotated, turn, vec, X, Y, Z } from "../kit.ts";
import type { Context, RevoluteImpulseJoint, RigidBody, Scene, Vector } from "../rapier.ts";

const group = "Vehicles";

/** Heights of smooth hills around a flat middle, by columns: rows run along z, columns along x. */
function hills(cells: number, size: number, rough: number): Float32Array {
    const heights = new Float32Array((cells + 1) * (cells + 1));
    for (let column = 0; column <= cells; column++) {
        for (let row = 0; row <= cells; row++) {
            const [x, z] = [(column / cells - 0.5) * size, (row / cells - 0.5) * size];
            const away = Math.min(1, Math.max(0, (Math.hypot(x, z) - 8) / 14));
            const height = 1.4 * Math.sin(0.22 * x + 1) * Math.cos(0.19 * z) + rough * Math.sin(0.9 * x) * Math.sin(0.8 * z);
            heights[column * (cells + 1) + row] = away * (height + 0.4);
        }
    }
    return heights;
}

function addHills(context: Context, rough: number): void {
    const { RAPIER } = context;
    const field = RAPIER.ColliderDesc.heightfield(64, 64, hills(64, 90, rough), vec(90, 1, 90));
    addFixed(context, ORIGIN, field.setFriction(1));
}

const WHEELS: readonly Vector[] = [vec(1.25, -0.1, 0.85), vec(1.25, -0.1, -0.85), vec(-1.25, -0.1, 0.85), vec(-1.25, -0.1, -0.85)];

const car: Scene = {
    id: "car",
    title: "Car on rays",
    description: "A car whose wheels are rays drives in the hills. Steer with the arrow keys, brake with J.",
    group,
    camera: { eye: [-9, 6, 10], target: [0, 0.5, 0] },
    steered: true,
    action: "Brake",
    poster: 150,
    setup(context) {
        addHills(context, 0.12);
        const { RAPIER, world, input, paint } = context;
        const body = add(context, vec(0, 1.4, 0), RAPIER.ColliderDesc.roundCuboid(1.85, 0.2, 0.75, 0.1).setMass(900));
        const cabin = RAPIER.ColliderDesc.roundCuboid(0.85, 0.22, 0.62, 0.08).setTranslation(-0.3, 0.5, 0).setMass(60);
        paint(body, "red");
        paint(world.createCollider(cabin, body), "white");
        const vehicle = world.createVehicleController(body);
        vehicle.indexUpAxis = 1;
        vehicle.setIndexForwardAxis = 0;
        const radius = 0.42;
        const tyres = WHEELS.map((place, wheel) => {
            vehicle.addWheel(place, vec(0, -1, 0), vec(0, 0, 1), 0.35, radius);
            vehicle.setWheelSuspensionStiffness(wheel, 32);
            vehicle.setWheelFrictionSlip(wheel, 1.8);
            vehicle.setWheelMaxSuspensionTravel(wheel, 0.3);
            // Tyres are visible only: they have no mass and no collisions.
            const tyre = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(0, 1, 0));
            world.createCollider(RAPIER.ColliderDesc.cylinder(0.15, radius).setCollisionGroups(0), tyre);
            paint(tyre, "dark");
            return tyre;
        });
        for (let box = 0; box < 20; box++) {
            const at = vec(7 + (box % 4), 1.2 + 0.8 * Math.floor(box / 4), 7);
            add(context, at, RAPIER.ColliderDesc.cuboid(0.4, 0.4, 0.4).setDensity(0.2));
        }
        const placeTyres = (): void => {
            const [at, q] = [body.translation(), body.rotation()];
            tyres.forEach((tyre, wheel) => {
                const hang = WHEELS[wheel] ?? ORIGIN;
                const drop = vehicle.wheelSuspensionLength(wheel) ?? 0.3;
                const place = rotated(q, vec(hang.x, hang.y - drop, hang.z));
                tyre.setNextKinematicTranslation(vec(at.x + place.x, at.y + place.y, at.z + place.z));
                const steer = multiply(q, turn(Y, vehicle.wheelSteering(wheel) ?? 0));
                const roll = multiply(steer, turn(Z, -(vehicle.wheelRotation(wheel) ?? 0)));
                tyre.setNextKinematicRotation(multiply(roll, turn(X, Math.PI / 2)));
            });
        };
        return {
            update: (time) => {
                const [gas, steer] = input.used ? [input.y, -0.5 * input.x] : [0.7, 0.28 * Math.sin(0.35 * time)];
                for (let wheel = 0; wheel < 4; wheel++) {
                    vehicle.setWheelEngineForce(wheel, 750 * gas);
                    vehicle.setWheelBrake(wheel, input.action ? 20 : 0);
                    if (wheel < 2) vehicle.setWheelSteering(wheel, steer);
                }
                vehicle.updateVehicle(world.timestep, RAPIER.QueryFilterFlags.ONLY_FIXED);
                placeTyres();
            },
            follow: () => body.translation(),
            caption: () => `${Math.abs(3.6 * vehicle.currentVehicleSpeed()).toFixed(0)} km/h`,
            claims: [
                { text: "The car drives", after: 180, check: () => Math.abs(vehicle.currentVehicleSpeed()) > 2 },
                { text: "The car is upright", after: 180, check: () => rotated(body.rotation(), Y).y > 0.7 },
                { text: "The car stays on the ground", after: 180, check: () => body.translation().y < 4 },
            ],
        };
    },
};

type Quaternion = { x: number; y: number; z: number; w: number };

function multiply(a: Quaternion, b: Quaternion): Quaternion {
    return {
        x: a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
        y: a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
        z: a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
        w: a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
    };
}

/** A chassis on four wheels, which hang on sliders with springs and turn on hinges. */
function addBuggy(context: Context, at: Vector): { body: RigidBody; motors: RevoluteImpulseJoint[] } {
    const { RAPIER, world, paint } = context;
    const body = add(context, at, RAPIER.ColliderDesc.roundCuboid(1.3, 0.15, 0.55, 0.1).setDensity(2));
    paint(body, "teal");
    const motors = WHEELS.map(({ x, z }) => {
        const hub = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(at.x + x, at.y - 0.35, at.z + z).setAdditionalMass(0.8));
        world.createCollider(RAPIER.ColliderDesc.cuboid(0.08, 0.08, 0.08).setCollisionGroups(0), hub);
        const slide = RAPIER.JointData.prismatic(vec(x, -0.35, z), ORIGIN, Y);
        slide.limitsEnabled = true;
        slide.limits = [-0.2, 0.3];
        const slider = world.createImpulseJoint(slide, body, hub, true) as RevoluteImpulseJoint;
        slider.configureMotorModel(RAPIER.MotorModel.AccelerationBased);
        slider.configureMotorPosition(-0.05, 300, 26);
        const shape = RAPIER.ColliderDesc.roundCylinder(0.13, 0.4, 0.04).setFriction(1.6).setDensity(1.2);
        const wheel = add(context, vec(at.x + x, at.y - 0.35, at.z + z + 0.25 * Math.sign(z)), shape, turn(X, Math.PI / 2));
        paint(wheel, "dark");
        const axle = RAPIER.JointData.revoluteWithAxes(vec(0, 0, 0.25 * Math.sign(z)), ORIGIN, Z, Y);
        const motor = world.createImpulseJoint(axle, hub, wheel, true) as RevoluteImpulseJoint;
        motor.setContactsEnabled(false);
        return motor;
    });
    return { body, motors };
}

const buggy: Scene = {
    id: "buggy",
    title: "Buggy of joints",
    description: "Wheels are bodies on sliders and hinges with motors. Arrow keys give gas.",
    group,
    camera: { eye: [-10, 5, 8], target: [-4, 0.5, 0] },
    steered: true,
    poster: 150,
    setup(context) {
        addFloor(context, 120);
        const { RAPIER, input } = context;
        for (let bump = 0; bump < 30; bump++) {
            const shape = RAPIER.ColliderDesc.cylinder(1.6, 0.25 + 0.05 * (bump % 3));
            addFixed(context, vec(4 + 2.4 * bump, -0.12, 0.5 * Math.sin(bump)), shape.setFriction(1), turn(X, Math.PI / 2));
        }
        const { body, motors } = addBuggy(context, vec(-4, 1.2, 0));
        return {
            update: () => {
                const gas = input.used ? input.y : 0.5;
                for (const motor of motors) motor.configureMotorVelocity(-18 * gas, 60);
            },
            follow: () => body.translation(),
            claims: [{ text: "The buggy drives over the bumps", after: 300, check: () => body.translation().x > 4 }],
        };
    },
};

const train: Scene = {
    id: "train",
    title: "Road train",
    description: "A tractor pulls five trailers, which are coupled by ball-and-socket joints.",
    group,
    camera: { eye: [2, 9, 16], target: [2, 0.5, 0] },
    poster: 200,
    setup(context) {
        addFloor(context, 120);
        const { RAPIER, world, paint } = context;
        const { body, motors } = addBuggy(context, vec(8, 1.2, 0));
        let previous = body;
        for (let index = 0; index < 5; index++) {
            const at = vec(4.2 - 3.2 * index, 0.75, 0);
            const trailer = add(context, at, RAPIER.ColliderDesc.cuboid(1.1, 0.15, 0.6).setDensity(0.8));
            paint(trailer, "yellow");
            const hitch = RAPIER.JointData.spherical(vec(index === 0 ? -1.9 : -1.6, index === 0 ? -0.45 : 0, 0), vec(1.6, 0, 0));
            world.createImpulseJoint(hitch, previous, trailer, true);
            for (const side of [-1, 1]) {
                const wheel = add(context, vec(at.x - 0.2, 0.4, 0.8 * side), RAPIER.ColliderDesc.cylinder(0.1, 0.4).setFriction(1.2), turn(X, Math.PI / 2));
                paint(wheel, "dark");
                const axle = RAPIER.JointData.revoluteWithAxes(vec(-0.2, -0.35, 0.8 * side), ORIGIN, Z, Y);
                world.createImpulseJoint(axle, trailer, wheel, true).setContactsEnabled(false);
            }
            for (let box = 0; box < 3; box++) add(context, vec(at.x - 0.6 + 0.6 * box, 1.25, 0), RAPIER.ColliderDesc.cuboid(0.25, 0.3, 0.3).setDensity(0.3));
            previous = trailer;
        }
        return {
            update: (time) => {
                for (const motor of motors) motor.configureMotorVelocity(-10 * Math.min(1, time / 2), 150);
            },
            follow: () => ({ x: body.translation().x - 8, y: 0, z: body.translation().z }),
            claims: [{ text: "The train moves", after: 300, check: () => body.translation().x > 10 }],
        };
    },
};

export const VEHICLES: readonly Scene[] = [car, buggy, train];
