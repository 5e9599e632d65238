// Wrong handles and wrong values: a typed error that names the value, and a world that continues.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, c, fails, insert, box, makeGround, makeWorld, steps, v } from "./setup.mjs";

test("a removed body is refused by name", () => {
    const { world } = makeGround();
    const { body, collider } = insert(world, 0, 3, box(0.5, 0.5));
    world.removeRigidBody(body);
    assert.ok(!body.isValid());
    assert.ok(!collider.isValid());
    assert.throws(() => body.translation(), fails("StaleHandle", "rigid body 1", "generation 0"));
    assert.throws(() => collider.friction(), fails("StaleHandle", "collider 1"));
    assert.equal(world.getRigidBody(body.handle), null);
    steps(world, 2);
    const again = insert(world, 0, 3, box(0.5, 0.5));
    assert.notEqual(again.body.handle, body.handle);
    assert.throws(() => body.linvel(), fails("StaleHandle", "generation 0"));
    world.free();
});

test("a freed world is refused", () => {
    const { world, ground } = makeGround();
    world.free();
    world.free();
    assert.throws(() => world.step(), fails("Freed", "world"));
    assert.throws(() => ground.translation(), fails("Freed"));
    assert.ok(!ground.isValid());
});

test("objects of another world are refused", () => {
    const [one, other] = [makeGround(), makeGround()];
    assert.throws(() => one.world.removeRigidBody(other.ground), fails("StaleHandle", "another world"));
    assert.throws(() => one.world.createCollider(box(1, 1), other.ground), fails("StaleHandle"));
    const zeros = new Float32Array(DIM);
    assert.throws(() => one.world.changeBodies("translation", [other.ground], zeros), fails("StaleHandle", "another world"));
    assert.throws(() => one.world.intersectionPair(one.collider, other.collider), fails("StaleHandle", "another world"));
    const ray = new RAPIER.Ray(v(0, 5), v(0, -1));
    const cast = () => one.world.castRay(ray, 10, true, undefined, undefined, other.collider);
    assert.throws(cast, fails("StaleHandle", "another world"));
    one.world.free();
    other.world.free();
});

test("numbers that are not finite are refused by name", () => {
    const { world } = makeGround();
    const { body, collider } = insert(world, 0, 3, box(0.5, 0.5));
    const before = { ...body.translation() };
    assert.throws(() => body.setTranslation(v(NaN, 0), true), fails("InvalidValue", "translation", "NaN"));
    assert.throws(() => body.setLinvel(v(0, Infinity), true), fails("InvalidValue", "linvel", "Infinity"));
    assert.throws(() => body.setLinearDamping(-1), fails("InvalidValue", "linearDamping", "-1"));
    assert.throws(() => body.setGravityScale(NaN, true), fails("InvalidValue", "gravityScale"));
    assert.throws(() => body.setDominanceGroup(300), fails("InvalidValue", "300"));
    assert.throws(() => collider.setFriction(-0.5), fails("InvalidValue", "friction", "-0.5"));
    assert.throws(() => collider.setDensity(NaN), fails("InvalidValue", "NaN"));
    assert.throws(() => (world.timestep = -1), fails("InvalidValue", "-1"));
    assert.throws(() => (world.numSolverIterations = 0), fails("InvalidValue", "0"));
    assert.throws(() => world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...c(0, NaN))), fails("InvalidValue", "NaN"));
    assert.deepEqual({ ...body.translation() }, before);
    steps(world, 60);
    assert.ok(Number.isFinite(body.translation().y));
    world.free();
});

test("shapes that cannot be are refused by name", () => {
    const world = makeWorld();
    const make = (desc) => () => world.createCollider(desc);
    assert.throws(make(RAPIER.ColliderDesc.ball(-1)), fails("InvalidValue", "-1"));
    assert.throws(make(RAPIER.ColliderDesc.ball(NaN)), fails("InvalidValue", "NaN"));
    const vertices = new Float32Array(DIM * 3).map((_, index) => index * index);
    assert.throws(make(RAPIER.ColliderDesc.trimesh(vertices, new Uint32Array([0, 1, 7]))), fails("InvalidValue", "index 7", "3 vertices"));
    assert.throws(make(RAPIER.ColliderDesc.trimesh(vertices, new Uint32Array([0, 1]))), fails("InvalidValue", "2 numbers"));
    assert.throws(make(RAPIER.ColliderDesc.polyline(new Float32Array(DIM))), fails("InvalidValue", "vertices"));
    assert.equal(RAPIER.ColliderDesc.convexHull(new Float32Array(DIM)), null);
    assert.equal(world.colliders.len(), 0);
    world.free();
});

test("memory that cannot be had is refused", () => {
    const before = RAPIER.memoryBytes();
    assert.throws(() => RAPIER.reserveMemory(2 ** 31), fails("InvalidValue", "2147483648"));
    RAPIER.reserveMemory(1 << 20);
    assert.ok(RAPIER.memoryBytes() >= before);
});

test("4000 worlds come and go in flat memory", () => {
    const cycle = () => {
        const { world } = makeGround();
        insert(world, 0, 0.4, box(0.5, 0.5));
        insert(world, 0, 1.4, RAPIER.ColliderDesc.ball(0.5));
        steps(world, 2);
        world.free();
    };
    for (let warm = 0; warm < 200; warm += 1) cycle();
    const before = RAPIER.memoryBytes();
    for (let count = 0; count < 4000; count += 1) cycle();
    assert.equal(RAPIER.memoryBytes(), before);
});

test("errors leak no memory", () => {
    const { world, ground } = makeGround();
    const wrong = () => {
        assert.throws(() => ground.setTranslation(v(NaN, 0), true));
        assert.throws(() => world.createCollider(RAPIER.ColliderDesc.trimesh(new Float32Array(DIM * 50), new Uint32Array([0, 1, 70]))));
    };
    for (let warm = 0; warm < 100; warm += 1) wrong();
    const before = RAPIER.memoryBytes();
    for (let count = 0; count < 20000; count += 1) wrong();
    assert.equal(RAPIER.memoryBytes(), before);
    world.step();
    world.free();
});

test("unreachable worlds are freed with the garbage", { skip: !globalThis.gc }, async () => {
    for (let count = 0; count < 300; count += 1) {
        const { world } = makeGround();
        insert(world, 0, 3, box(0.5, 0.5));
        world.step();
    }
    const collect = async () => {
        globalThis.gc();
        await new Promise((resolve) => setTimeout(resolve, 20));
    };
    await collect();
    await collect();
    const before = RAPIER.memoryBytes();
    for (let round = 0; round < 10; round += 1) {
        for (let count = 0; count < 100; count += 1) {
            const { world } = makeGround();
            insert(world, 0, 3, box(0.5, 0.5));
            world.step();
        }
        await collect();
    }
    assert.ok(RAPIER.memoryBytes() <= before, `${RAPIER.memoryBytes()} bytes after ${before}`);
});

test("a world can be used with `using`", () => {
    const { world, ground } = makeGround();
    world[Symbol.dispose ?? Symbol.for("Symbol.dispose")]();
    assert.throws(() => ground.mass(), fails("Freed"));
});

test("shapes can be used any number of times", () => {
    // The numbers of shapes in the module have a slot and a generation: each use takes the next generation.
    const [ball, zero] = [new RAPIER.Ball(1), v(0, 0)];
    const none = DIM === 2 ? 0 : { x: 0, y: 0, z: 0, w: 1 };
    const { world, collider } = makeGround();
    for (let use = 0; use < 9000; use += 1) {
        assert.ok(ball.containsPoint(zero, none, v(0.5, 0)), `use ${use}`);
        if (use % 100 === 0) {
            assert.ok(collider.intersectsShape(ball, zero, none), `use ${use}`);
            assert.ok(collider.castShape(zero, ball, v(0, 5), none, v(0, -1), 0, 9, true), `use ${use}`);
            assert.ok(ball.castShape(zero, none, zero, ball, v(0, 5), none, v(0, -1), 0, 9, true), `use ${use}`);
        }
    }
    world.free();
});

test("functions over bodies and pairs may remove them", () => {
    const { world, collider: floor } = makeGround();
    const boxes = Array.from({ length: 4 }, (_, index) => insert(world, 2 * index, 0.5, box(0.5, 0.5)));
    world.step();
    const seen = [];
    world.contactPairsWith(floor, (other) => {
        seen.push(other);
        boxes.filter(({ collider }) => collider !== other).forEach(({ body }) => world.removeRigidBody(body));
    });
    assert.equal(seen.length, 1);
    assert.ok(seen[0].isValid());
    insert(world, 9, 5, box(0.5, 0.5));
    let active = 0;
    world.forEachActiveRigidBody((body) => {
        assert.ok(body.isValid());
        active += 1;
        world.bodies.getAll().forEach((other) => other !== body && world.removeRigidBody(other));
    });
    assert.ok(active <= 1);
    world.free();
});

test("a freed world makes no controllers", () => {
    const world = makeWorld();
    world.free();
    assert.throws(() => world.createCharacterController(0.1), fails("Freed", "world"));
    assert.throws(() => world.createPidController(1, 0, 0, RAPIER.PidAxesMask.All), fails("Freed", "world"));
});
