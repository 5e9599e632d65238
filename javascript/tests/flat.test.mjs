// Shapes without volume: plates, lines and points are colliders, as in the engine.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, box, c, fails, insert, makeWorld, near, steps, v } from "./setup.mjs";

const { ColliderDesc } = RAPIER;
const flat = (list) => new Float32Array(list.flatMap(([x, y, z]) => (DIM === 2 ? [x, y] : [x, y, z])));

/** Descriptions of shapes without volume, by names. */
const SHAPES = {
    "a box without height": () => ColliderDesc.cuboid(...c(1, 0, 1)),
    "a box without width": () => ColliderDesc.cuboid(...c(0, 1, 1)),
    "a box without size": () => ColliderDesc.cuboid(...c(0, 0, 0)),
    "a round box without height": () => ColliderDesc.roundCuboid(...c(1, 0, 1), 0.1),
    "a ball without radius": () => ColliderDesc.ball(0),
    "a capsule without height": () => ColliderDesc.capsule(0, 0.5),
    "a capsule without radius": () => ColliderDesc.capsule(0.5, 0),
    "a hull of points in a plane": () => ColliderDesc.convexHull(flat(DIM === 2 ? [[-1, 0], [0, 0], [1, 0]] : [[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1], [0, 0, 0]])),
    "a tilted hull": () => ColliderDesc.convexHull(flat(DIM === 2 ? [[-1, -0.5], [1, 0.5], [0, 0]] : [[-1, -0.3, 0], [1, 0.3, 0], [0, 0.2, 1], [0, -0.2, -1]])),
    "a round hull of points in a plane": () => ColliderDesc.roundConvexHull(flat(DIM === 2 ? [[-1, 0], [0, 0], [1, 0]] : [[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]]), 0.1),
    ...(DIM === 3 && {
        "a cylinder without height": () => ColliderDesc.cylinder(0, 1),
        "a cylinder without radius": () => ColliderDesc.cylinder(1, 0),
        "a cone without height": () => ColliderDesc.cone(0, 1),
        "a hull of three points": () => ColliderDesc.convexHull(new Float32Array([0, 0, 0, 1, 0, 0, 0, 0, 1])),
    }),
};

for (const [name, make] of Object.entries(SHAPES)) {
    test(`${name} is a collider, and its description makes it again`, () => {
        const world = makeWorld();
        const desc = make();
        assert.ok(desc, "it is described");
        const collider = world.createCollider(desc);
        const { shape } = collider;
        const again = world.createCollider(new ColliderDesc(shape).setTranslation(...c(9, 0)));
        assert.equal(again.shapeType(), collider.shapeType());
        collider.setShape(shape);
        assert.equal(collider.shapeType(), again.shapeType());
        assert.equal(typeof world.intersectionWithShape(v(0, 50), DIM === 2 ? 0 : { x: 0, y: 0, z: 0, w: 1 }, shape), "object");
        const { body } = insert(world, 0, 20, make().setMass(1));
        steps(world, 30);
        assert.ok(body.translation().y < 19.5 && Number.isFinite(body.translation().y));
        const restored = RAPIER.World.restoreSnapshot(world.takeSnapshot());
        assert.equal(restored.hash(), world.hash());
        restored.free();
        world.free();
    });
}

test("a box lies on a floor that is a plane", () => {
    const world = makeWorld();
    world.createCollider(ColliderDesc.cuboid(...c(5, 0, 5)));
    const { body } = insert(world, 0, 2, box(0.5, 0.5));
    steps(world, 180);
    near(body.translation().y, 0.5, 3e-3);
    const hit = world.castRay(new RAPIER.Ray(v(3, 1), v(0, -1)), 5, true);
    near(hit.timeOfImpact, 1, 1e-4);
    const floor = hit.collider;
    assert.equal(floor.halfExtents().y, 0);
    floor.setHalfExtents(v(6, 0, 6));
    near(world.castRay(new RAPIER.Ray(v(5.5, 1), v(0, -1)), 5, true).timeOfImpact, 1, 1e-4);
    world.free();
});

test("sizes that are negative or not finite are refused by name", () => {
    const world = makeWorld();
    for (const bad of [-1, NaN, Infinity]) {
        assert.throws(() => world.createCollider(ColliderDesc.cuboid(...c(1, bad, 1))), fails("InvalidValue"));
        assert.throws(() => world.createCollider(ColliderDesc.ball(bad)), fails("InvalidValue", "radius"));
        assert.throws(() => world.createCollider(ColliderDesc.capsule(bad, 1)), fails("InvalidValue", "half"));
    }
    assert.equal(ColliderDesc.convexHull(flat([[1, 1, 1], [1, 1, 1], [1, 1, 1], [1, 1, 1]])), null);
    world.free();
});
