// Views of the engine's memory, changes of many bodies at once, debug lines.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, c, fails, insert, makeGround, near, steps, v } from "./setup.mjs";

const { ColliderDesc, bodyIndex } = RAPIER;

/** Some balls above the ground. */
function rain(count) {
    const { world, ground } = makeGround();
    const bodies = Array.from({ length: count }, (_, index) => insert(world, (index % 20) * 1.5, 1 + index * 0.25, ColliderDesc.ball(0.5)).body);
    return { world, ground, bodies };
}

function assertSame(world, bodies) {
    const { poses, velocities, sleeping, handles, poseStride, velocityStride } = world.views;
    for (const body of bodies) {
        const slot = bodyIndex(body.handle);
        const { x, y } = body.translation();
        assert.deepEqual([poses[slot * poseStride], poses[slot * poseStride + 1]], [x, y]);
        const rotation = body.rotation();
        assert.equal(poses[slot * poseStride + DIM], DIM === 2 ? rotation : rotation.x);
        assert.equal(velocities[slot * velocityStride + 1], body.linvel().y);
        assert.equal(sleeping[slot] !== 0, body.isSleeping() || body.isFixed());
        assert.equal(handles[slot], body.handle);
    }
}

test("views follow steps, edits and removals", () => {
    const { world, ground, bodies } = rain(100);
    assertSame(world, [ground, ...bodies]);
    for (let step = 0; step < 60; step += 1) {
        world.step();
        if (step % 10 === 0) assertSame(world, [ground, ...bodies]);
    }
    steps(world, 600);
    assert.ok(bodies.some((body) => body.isSleeping()));
    assertSame(world, [ground, ...bodies]);
    bodies[0].setTranslation(v(0, 50), true);
    world.views.refresh();
    assertSame(world, bodies);
    world.removeRigidBody(bodies[1]);
    world.step();
    assert.ok(Number.isNaN(world.views.handles[bodyIndex(bodies[1].handle)]));
    const more = Array.from({ length: 200 }, (_, index) => insert(world, index * 2, 200, ColliderDesc.ball(0.5)).body);
    world.step();
    assertSame(world, more);
    world.free();
    assert.throws(() => world.views.poses, fails("Freed"));
});

test("views are the same object as long as the memory stays", () => {
    const { world } = rain(10);
    world.step();
    const { poses } = world.views;
    world.step();
    assert.equal(world.views.poses, poses);
    world.free();
});

test("many bodies are changed at once, or none", () => {
    const { world, bodies } = rain(10);
    const values = new Float32Array(bodies.flatMap((_, index) => c(index, 100, 0)));
    world.changeBodies("translation", bodies, values);
    bodies.forEach((body, index) => assert.equal(body.translation().x, index));
    world.changeBodies("linvel", Float64Array.from(bodies, (body) => body.handle), values);
    bodies.forEach((body, index) => assert.equal(body.linvel().x, index));
    values[3 * DIM] = NaN;
    values[0] = 77;
    assert.throws(() => world.changeBodies("translation", bodies, values), fails("InvalidValue", "NaN"));
    assert.equal(bodies[0].translation().x, 0);
    assert.throws(() => world.changeBodies("translation", bodies.slice(1), values), fails("InvalidValue", "9 bodies"));
    world.removeRigidBody(bodies[4]);
    values.fill(1);
    assert.throws(() => world.changeBodies("translation", bodies, values), fails("StaleHandle"));
    world.free();
});

test("debug lines draw a ball and a ground", () => {
    const { world } = rain(1);
    world.step();
    const { vertices, colors } = world.debugRender();
    assert.ok(vertices.length > 20 * DIM);
    assert.equal(vertices.length / DIM, colors.length / 4);
    assert.ok(colors.every((component) => component >= 0 && component <= 1));
    const fewer = world.debugRender(undefined, (collider) => collider.shapeType() !== RAPIER.ShapeType.Ball);
    assert.ok(fewer.vertices.length < vertices.length);
    world.free();
});

/** Bytes that `run` leaves on the heap: the least of many tries, because the compiler allocates there too. */
function garbage(run) {
    let least = Infinity;
    for (let attempt = 0; attempt < 40; attempt += 1) {
        globalThis.gc();
        const before = process.memoryUsage().heapUsed;
        run();
        least = Math.min(least, process.memoryUsage().heapUsed - before);
    }
    return least;
}

test("getters with a target create no garbage", { skip: !globalThis.gc }, () => {
    const { world, bodies } = rain(50);
    const [target, rotation] = [v(0, 0), DIM === 2 ? 0 : { x: 0, y: 0, z: 0, w: 1 }];
    // Each run reads 2,000 vectors: an object each would be 48 kB and more, which no collection interrupts.
    const repeat = (read) => () => {
        for (let round = 0; round < 20; round += 1) bodies.forEach(read);
    };
    const reuse = repeat((body) => {
        body.translation(target);
        body.rotation(rotation);
        body.linvel(target);
    });
    const create = repeat((body) => [body.translation(), body.rotation(), body.linvel()]);
    for (let warm = 0; warm < 200; warm += 1) reuse();
    const [reused, created] = [garbage(reuse), garbage(create)];
    assert.ok(reused < 20_000, `${reused} bytes`);
    assert.ok(created > 48_000, `the measure sees objects: ${created} bytes`);
    world.free();
});

test("a batch with one rotation that is none changes no body", { skip: DIM === 2 }, () => {
    const { world, bodies } = rain(2);
    const before = bodies[0].rotation();
    const values = [0.6, 0, 0, 0.8, 0, 0, 0, 0];
    assert.throws(() => world.changeBodies("rotation", bodies, values), fails("InvalidValue", "rotation"));
    assert.deepEqual(bodies[0].rotation(), before);
    world.free();
});

test("a batch may take its values from the engine's memory", () => {
    const { world, bodies } = rain(3000);
    const values = world.views.poses.subarray(0, DIM * bodies.length);
    const expected = values.slice();
    world.changeBodies("linvel", bodies, values);
    bodies.forEach((body, index) => {
        const { x, y } = body.linvel();
        assert.deepEqual([x, y], [...expected.subarray(DIM * index, DIM * index + 2)]);
    });
    world.free();
});
