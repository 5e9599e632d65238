// Characters, vehicles and feedback controllers.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, c, fails, insert, box, makeGround, makeWorld, near, r, steps, v } from "./setup.mjs";

const { ColliderDesc, RigidBodyDesc } = RAPIER;

/** A character on the ground. */
function walker() {
    const { world, collider: ground } = makeGround();
    const body = world.createRigidBody(RigidBodyDesc.kinematicPositionBased().setTranslation(...c(0, 1.01)));
    const collider = world.createCollider(ColliderDesc.capsule(0.5, 0.5), body);
    const controller = world.createCharacterController(0.01);
    world.step();
    const walk = (delta, count = 1, ...filter) => {
        for (let step = 0; step < count; step += 1) {
            controller.computeColliderMovement(collider, delta, ...filter);
            const { x, y } = body.translation();
            const moved = controller.computedMovement();
            body.setNextKinematicTranslation({ ...body.translation(), x: x + moved.x, y: y + moved.y });
            world.step();
        }
    };
    return { world, ground, body, collider, controller, walk };
}

test("a character walks, and a wall stops it", () => {
    const { world, body, controller, walk } = walker();
    const wall = world.createCollider(box(0.5, 5, 5).setTranslation(...c(3, 5)));
    world.step();
    walk(v(0.05, -0.1), 20);
    assert.ok(controller.computedGrounded());
    near(body.translation().x, 1, 0.05);
    walk(v(0.05, -0.1), 60);
    near(body.translation().x, 2, 0.05);
    assert.ok(controller.numComputedCollisions() > 0);
    const met = Array.from({ length: controller.numComputedCollisions() }, (_, index) => controller.computedCollision(index).collider);
    assert.ok(met.includes(wall));
    assert.equal(controller.computedCollision(99), null);
    walk(v(0.05, -0.1), 40, undefined, undefined, (collider) => collider !== wall);
    assert.ok(body.translation().x > 3);
    world.free();
});

test("a character climbs steps only if it may", () => {
    for (const may of [true, false]) {
        const { world, body, controller, walk } = walker();
        world.createCollider(box(2, 0.15, 5).setTranslation(...c(3, 0.15)));
        world.step();
        if (may) {
            controller.enableAutostep(0.4, 0.2, true);
            assert.ok(controller.autostepEnabled());
            near(controller.autostepMaxHeight(), 0.4, 1e-6);
        }
        walk(v(0.05, -0.05), 60);
        assert.equal(body.translation().y > 1.2, may);
        world.free();
    }
});

test("sizes of steps that are not numbers are refused, and change nothing", () => {
    const world = makeWorld();
    const controller = world.createCharacterController(0.01);
    controller.enableAutostep(0.5, 0.25, true);
    controller.enableSnapToGround(0.5);
    assert.throws(() => controller.enableAutostep(NaN, 0.25, true), fails("InvalidValue", "maxHeight", "NaN"));
    assert.throws(() => controller.enableAutostep(0.5, NaN, true), fails("InvalidValue", "minWidth", "NaN"));
    assert.throws(() => controller.enableSnapToGround(NaN), fails("InvalidValue", "NaN"));
    assert.equal(controller.autostepMaxHeight(), 0.5);
    assert.equal(controller.snapToGroundDistance(), 0.5);
    controller.disableAutostep();
    controller.disableSnapToGround();
    assert.equal(controller.autostepMaxHeight(), null);
    assert.equal(controller.snapToGroundDistance(), null);
    world.free();
});

test("settings of a character come back as they went in", () => {
    const { world, controller } = walker();
    assert.equal(controller.snapToGroundDistance(), null);
    controller.enableSnapToGround(0.25);
    assert.equal(controller.snapToGroundDistance(), 0.25);
    controller.disableSnapToGround();
    assert.ok(!controller.snapToGroundEnabled());
    controller.setMaxSlopeClimbAngle(1);
    controller.setMinSlopeSlideAngle(0.5);
    near(controller.maxSlopeClimbAngle(), 1, 1e-6);
    near(controller.minSlopeSlideAngle(), 0.5, 1e-6);
    controller.setSlideEnabled(false);
    assert.ok(!controller.slideEnabled());
    controller.setUp(v(0, 2));
    assert.deepEqual({ ...controller.up() }, v(0, 2));
    assert.throws(() => controller.setUp(v(0, 0)), fails("InvalidValue", "up"));
    assert.throws(() => controller.setOffset(-1), fails("InvalidValue", "offset", "-1"));
    world.removeCharacterController(controller);
    assert.throws(() => controller.offset(), fails("Freed", "character controller"));
    world.free();
});

test("a character pushes what it meets", () => {
    const { world, controller, walk } = walker();
    const { body } = insert(world, 1.2, 0.5, box(0.5, 0.5));
    controller.setApplyImpulsesToDynamicBodies(true);
    controller.setCharacterMass(50);
    walk(v(0.05, 0), 30);
    assert.ok(body.translation().x > 1.4, `${body.translation().x}`);
    world.free();
});

test("a PID controller holds a body against gravity", () => {
    const world = makeWorld();
    const { body } = insert(world, 0, 0, ColliderDesc.ball(0.5));
    const pid = world.createPidController(60, 1, 0.8, RAPIER.PidAxesMask.All);
    const still = DIM === 2 ? 0 : v(0, 0);
    for (let step = 0; step < 240; step += 1) {
        pid.applyLinearCorrection(body, v(1, 2), v(0, 0));
        pid.applyAngularCorrection(body, r(0.5), still);
        world.step();
    }
    near(body.translation().x, 1, 0.02);
    near(body.translation().y, 2, 0.05);
    near(DIM === 2 ? body.rotation() : 2 * Math.atan2(body.rotation().z, body.rotation().w), 0.5, 0.02);
    near(pid.linearCorrection(body, v(1, 2), v(0, 0)).x, 0, 1);
    world.removePidController(pid);
    world.free();
});

test("a car drives and brakes", { skip: DIM === 2 }, () => {
    const { world } = makeGround();
    const { body } = insert(world, 0, 1.2, box(2, 0.3, 1).setDensity(20));
    const car = world.createVehicleController(body);
    for (const [x, z] of [[1.5, 1], [1.5, -1], [-1.5, 1], [-1.5, -1]]) {
        car.addWheel(v(x, -0.2, z), v(0, -1), { x: 0, y: 0, z: 1 }, 0.4, 0.3);
    }
    assert.equal(car.numWheels(), 4);
    car.setWheelSuspensionStiffness(0, 30);
    near(car.wheelSuspensionStiffness(0), 30, 1e-5);
    const drive = (count) => {
        for (let step = 0; step < count; step += 1) {
            car.updateVehicle(world.timestep, undefined, undefined, (collider) => collider.parent() !== body);
            world.step();
        }
    };
    drive(60);
    assert.ok(car.wheelIsInContact(0));
    assert.ok(car.wheelGroundObject(0));
    near(car.wheelContactNormal(0).y, 1, 1e-3);
    for (const wheel of [0, 1, 2, 3]) car.setWheelEngineForce(wheel, 100);
    drive(120);
    assert.ok(Math.abs(car.currentVehicleSpeed()) > 1, `${car.currentVehicleSpeed()}`);
    for (const wheel of [0, 1, 2, 3]) {
        car.setWheelEngineForce(wheel, 0);
        car.setWheelBrake(wheel, 5);
    }
    drive(300);
    near(car.currentVehicleSpeed(), 0, 0.05);
    assert.equal(car.wheelRadius(7), null);
    assert.throws(() => car.setWheelRadius(7, 1), fails("InvalidValue", "7", "less than 4"));
    assert.throws(() => (car.indexUpAxis = 5), fails("InvalidValue", "5"));
    world.removeVehicleController(car);
    assert.throws(() => car.numWheels(), fails("Freed", "vehicle"));
    world.free();
});

test("a predicate may free the controller that asks it", () => {
    const { world, collider, controller, walk } = walker();
    let asked = 0;
    const frees = () => {
        asked += 1;
        world.removeCharacterController(controller);
        throw new Error("of the predicate");
    };
    assert.throws(() => walk(v(0.05, -0.1), 1, undefined, undefined, frees), fails("Freed", "character controller"));
    assert.equal(asked, 1);
    // The exception of the predicate ends with the failed call.
    const next = world.createCharacterController(0.01);
    assert.equal(next.numComputedCollisions(), 0);
    next.computeColliderMovement(collider, v(0.05, -0.1), undefined, undefined, () => ((asked += 1), true));
    assert.ok(asked > 1 && next.computedGrounded());
    world.free();
});
