// Queries before any step, and between steps: they find what the program inserted, moved, changed or removed.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, box, c, makeGround, makeWorld, near, r, steps, v } from "./setup.mjs";

const none = DIM === 2 ? 0 : { x: 0, y: 0, z: 0, w: 1 };

/** The results of all queries about the place (x, y): the handles that they find. */
function found(world, x, y) {
    const ray = new RAPIER.Ray(v(x, y + 10), v(0, -1));
    const ball = new RAPIER.Ball(0.25);
    const handles = (query) => {
        const list = [];
        query((part) => (list.push((part.collider ?? part).handle), true));
        return list.sort().join();
    };
    const near10 = (projection) => (projection && Math.hypot(projection.point.x - x, projection.point.y - y) < 1.5 ? projection.collider.handle : undefined);
    return [
        world.castRay(ray, 12, true)?.collider.handle,
        world.castRayAndGetNormal(ray, 12, true)?.collider.handle,
        handles((see) => world.intersectionsWithRay(ray, 12, true, see)),
        near10(world.projectPoint(v(x, y), true)),
        near10(world.projectPointAndGetFeature(v(x, y))),
        handles((see) => world.intersectionsWithPoint(v(x, y), see)),
        world.intersectionWithShape(v(x, y), none, ball)?.handle,
        handles((see) => world.intersectionsWithShape(v(x, y), none, ball, see)),
        world.castShape(v(x, y + 5), none, v(0, -1), ball, 0, 10, true)?.collider.handle,
        handles((see) => world.collidersWithAabbIntersectingAabb(v(x, y), v(0.1, 0.1, 0.1), see)),
    ];
}

function expectAt(world, x, y, collider) {
    const { handle } = collider;
    assert.deepEqual(found(world, x, y), [handle, handle, `${handle}`, handle, handle, `${handle}`, handle, `${handle}`, handle, `${handle}`]);
}

function expectNothing(world, x, y) {
    const nothing = found(world, x, y);
    assert.ok(nothing.every((result) => result === undefined || result === ""), `${nothing}`);
}

const CALLS = {
    "no call": () => {},
    updateSceneQueries: (world) => world.updateSceneQueries(),
    propagateModifiedBodyPositionsToColliders: (world) => world.propagateModifiedBodyPositionsToColliders(),
};

for (const [name, update] of Object.entries(CALLS)) {
    for (const stepsBefore of [0, 3]) {
        test(`queries see edits after ${stepsBefore} steps, with ${name}`, () => {
            const world = makeWorld(0);
            steps(world, stepsBefore);
            const bodies = [RAPIER.RigidBodyDesc.dynamic(), RAPIER.RigidBodyDesc.fixed(), RAPIER.RigidBodyDesc.kinematicPositionBased()];
            const made = bodies.map((desc, index) => {
                const body = world.createRigidBody(desc.setTranslation(...c(10 * index, 0)));
                return { body, collider: world.createCollider(box(0.5, 0.5), body) };
            });
            const alone = world.createCollider(box(0.5, 0.5).setTranslation(...c(30, 0)));
            update(world);
            made.forEach(({ collider }, index) => expectAt(world, 10 * index, 0, collider));
            expectAt(world, 30, 0, alone);

            steps(world, stepsBefore);
            made.forEach(({ body }, index) => body.setTranslation(v(10 * index, 100), true));
            alone.setTranslation(v(30, 100));
            update(world);
            made.forEach(({ collider }, index) => {
                expectNothing(world, 10 * index, 0);
                expectAt(world, 10 * index, 100, collider);
            });
            expectNothing(world, 30, 0);
            expectAt(world, 30, 100, alone);

            made[0].collider.setShape(new RAPIER.Cuboid(...c(2, 0.5, 0.5)));
            made[1].body.setRotation(r(Math.PI / 4), true);
            made[2].collider.setEnabled(false);
            world.removeRigidBody(made[2].body);
            world.removeCollider(alone, true);
            update(world);
            expectAt(world, 1.75, 100, made[0].collider);
            near(world.castRay(new RAPIER.Ray(v(10, 110), v(0, -1)), 20, true).timeOfImpact, 10 - Math.SQRT1_2, 1e-4);
            expectNothing(world, 20, 100);
            expectNothing(world, 30, 100);
            world.free();
        });
    }
}

test("a moved body is found where it is, before its collider's pose is read", () => {
    const { world, ground, collider } = makeGround();
    ground.setTranslation(v(0, 20), true);
    expectAt(world, 0, 20, collider);
    assert.equal(collider.translation().y, 20);
    world.free();
});

test("queries change no later step, and no hash", () => {
    const run = (query) => {
        const { world } = makeGround();
        const boxes = Array.from({ length: 8 }, (_, index) => {
            const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...c(index / 4, 1 + index)));
            world.createCollider(box(0.5, 0.5), body);
            return body;
        });
        const hashes = [];
        for (let step = 0; step < 60; step += 1) {
            if (step % 7 === 3) {
                boxes[step % 8].setTranslation(v(step / 30, 9), true);
            }
            query(world);
            hashes.push(world.hash());
            world.step();
            query(world);
        }
        return hashes;
    };
    const ray = new RAPIER.Ray(v(0, 20), v(0, -1));
    assert.deepEqual(run((world) => world.castRay(ray, 30, true)), run(() => {}));
});

test("characters and vehicles see what was inserted before any step", () => {
    const { world } = makeGround();
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(...c(0, 1)));
    const collider = world.createCollider(box(0.5, 0.5), body);
    const controller = world.createCharacterController(0.01);
    controller.computeColliderMovement(collider, v(0, -5));
    near(controller.computedMovement().y, -0.49, 2e-3);
    body.setTranslation(v(0, 3), true);
    controller.computeColliderMovement(collider, v(0, -5));
    near(controller.computedMovement().y, -2.49, 2e-3);
    if (DIM === 3) {
        const chassis = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(10, 1, 0));
        world.createCollider(box(1, 0.25), chassis);
        const vehicle = world.createVehicleController(chassis);
        vehicle.addWheel(v(0, 0), v(0, -1), v(1, 0), 0.5, 0.6);
        vehicle.updateVehicle(1 / 60);
        assert.ok(vehicle.wheelIsInContact(0));
    }
    world.free();
});
