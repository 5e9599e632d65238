// Queries of worlds, colliders and shapes, and the contacts of a step.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, c, fails, insert, box, makeGround, makeWorld, near, r, steps, v } from "./setup.mjs";

const { Ball, ColliderDesc, QueryFilterFlags, Ray } = RAPIER;

/** A ball at the origin, a box above it, and a sensor beside it. */
function scene() {
    const world = makeWorld(0);
    const ball = world.createCollider(ColliderDesc.ball(1));
    const above = insert(world, 0, 5, box(1, 1));
    const sensor = world.createCollider(ColliderDesc.ball(1).setTranslation(...c(5, 0)).setSensor(true));
    world.step();
    return { world, ball, above, sensor };
}

const down = () => new Ray(v(0, 10), v(0, -1));

test("a ray finds the first collider that the filter lets pass", () => {
    const { world, ball, above } = scene();
    const hit = world.castRay(down(), 100, true);
    assert.equal(hit.collider, above.collider);
    near(hit.timeOfImpact, 4, 1e-5);
    assert.equal(world.castRay(down(), 3, true), null);
    const pass = (...filter) => world.castRay(down(), 100, true, ...filter)?.collider;
    assert.equal(pass(QueryFilterFlags.EXCLUDE_DYNAMIC), ball);
    assert.equal(pass(QueryFilterFlags.ONLY_DYNAMIC), above.collider);
    assert.equal(pass(undefined, 0), undefined);
    assert.equal(pass(undefined, undefined, above.collider), ball);
    assert.equal(pass(undefined, undefined, undefined, above.body), ball);
    assert.equal(pass(undefined, undefined, undefined, undefined, (collider) => collider !== above.collider), ball);
    above.collider.setCollisionGroups(0x00020002);
    assert.equal(pass(undefined, 0x00010001), ball);
    world.free();
});

test("a ray has the normal and the feature", () => {
    const { world, above } = scene();
    const hit = world.castRayAndGetNormal(down(), 100, true);
    assert.equal(hit.collider, above.collider);
    near(hit.normal.y, 1, 1e-5);
    near(down().pointAt(hit.timeOfImpact).y, 6, 1e-5);
    assert.equal(hit.featureType, RAPIER.FeatureType.Face);
    assert.equal(typeof hit.featureId, "number");
    const hits = [];
    world.intersectionsWithRay(down(), 100, true, (intersection) => hits.push(intersection.collider) > 0);
    assert.equal(hits.length, 2);
    hits.length = 0;
    world.intersectionsWithRay(down(), 100, true, (intersection) => hits.push(intersection.collider) > 1);
    assert.equal(hits.length, 1);
    world.free();
});

test("points find colliders", () => {
    const { world, ball, sensor } = scene();
    const projection = world.projectPoint(v(0, -3), true);
    assert.equal(projection.collider, ball);
    near(projection.point.y, -1, 1e-5);
    assert.ok(!projection.isInside);
    assert.ok(world.projectPointAndGetFeature(v(0.5, 0)).isInside);
    const found = [];
    world.intersectionsWithPoint(v(5, 0.5), (collider) => found.push(collider) > 0);
    assert.deepEqual(found, [sensor]);
    world.intersectionsWithPoint(v(5, 0.5), () => assert.fail("the sensor is left out"), QueryFilterFlags.EXCLUDE_SENSORS);
    world.free();
});

test("shapes find colliders", () => {
    const { world, ball, above } = scene();
    assert.equal(world.intersectionWithShape(v(0, 1.5), r(0), new Ball(1)), ball);
    assert.equal(world.intersectionWithShape(v(0, 20), r(0), new Ball(1)), null);
    const found = [];
    world.intersectionsWithShape(v(0, 2.5), r(0), new Ball(2), (collider) => found.push(collider) > 0);
    assert.equal(found.length, 2);
    const hit = world.castShape(v(0, 10), r(0), v(0, -2), new Ball(0.5), 0, 100, true);
    assert.equal(hit.collider, above.collider);
    near(hit.time_of_impact, 1.75, 1e-3);
    near(Math.abs(hit.normal1.y), 1, 1e-3);
    found.length = 0;
    world.collidersWithAabbIntersectingAabb(v(0, 0), v(0.1, 0.1, 0.1), (collider) => found.push(collider) > 0);
    assert.deepEqual(found, [ball]);
    world.free();
});

test("a callback may read the world, and not change it", () => {
    const { world, above } = scene();
    let caught;
    world.castRay(down(), 100, true, undefined, undefined, undefined, undefined, (collider) => {
        assert.ok(collider.translation().y >= 0);
        try {
            world.removeRigidBody(above.body);
        } catch (error) {
            caught = error;
        }
        return true;
    });
    assert.ok(fails("Busy", "query")(caught));
    assert.throws(() => world.castRay(down(), 100, true, undefined, undefined, undefined, undefined, () => {
        throw new Error("of the predicate");
    }), /of the predicate/);
    world.removeRigidBody(above.body);
    assert.throws(() => world.castRay(new Ray(v(NaN, 0), v(0, 1)), 100, true), fails("InvalidValue", "ray.origin", "NaN"));
    assert.throws(() => world.castRay(down(), NaN, true), fails("InvalidValue", "maxToi"));
    world.free();
});

test("colliders answer themselves", () => {
    const { world, ball, above } = scene();
    assert.ok(ball.containsPoint(v(0, 0.5)));
    assert.ok(ball.intersectsRay(down(), 100));
    near(ball.castRay(down(), 100, true), 9, 1e-5);
    assert.equal(ball.castRay(down(), 1, true), -1);
    near(ball.castRayAndGetNormal(down(), 100, true).normal.y, 1, 1e-5);
    near(ball.projectPoint(v(0, 3), true).point.y, 1, 1e-5);
    near(ball.contactCollider(above.collider, 10).distance, 3, 1e-4);
    assert.equal(ball.contactCollider(above.collider, 1), null);
    near(ball.castCollider(v(0, 1), above.collider, v(0, -2), 0, 100, true).time_of_impact, 1, 1e-3);
    assert.ok(ball.intersectsShape(new Ball(1), v(1.5, 0), r(0)));
    near(ball.castShape(v(0, 0), new Ball(1), v(5, 0), r(0), v(-1, 0), 0, 100, true).time_of_impact, 3, 1e-3);
    near(ball.contactShape(new Ball(1), v(3, 0), r(0), 5).distance, 1, 1e-4);
    world.free();
});

test("shapes answer themselves", () => {
    const ball = new Ball(1);
    assert.ok(ball.containsPoint(v(1, 0), r(0), v(1.5, 0)));
    near(ball.castRay(down(), v(0, 0), r(0), 100, true), 9, 1e-5);
    near(ball.projectPoint(v(0, 0), r(0), v(0, 3), true).point.y, 1, 1e-5);
    assert.ok(ball.intersectsShape(v(0, 0), r(0), ball, v(1, 0), r(0)));
    near(ball.contactShape(v(0, 0), r(0), ball, v(3, 0), r(0), 5).distance, 1, 1e-4);
    near(ball.castShape(v(0, 0), r(0), v(0, 0), ball, v(5, 0), r(0), v(-1, 0), 0, 100, true).time_of_impact, 3, 1e-3);
});

test("contacts carry the weight", () => {
    const { world, collider: ground } = makeGround();
    const { body, collider } = insert(world, 0, 0.5, box(0.5, 0.5));
    steps(world, 30);
    let [impulse, manifolds] = [0, 0];
    world.contactPair(ground, collider, (manifold, flipped) => {
        manifolds += 1;
        assert.equal(manifold.numContacts(), DIM === 2 ? 2 : 4);
        assert.equal(manifold.numSolverContacts(), manifold.numContacts());
        near(manifold.normal().y, flipped ? -1 : 1, 1e-3);
        for (let contact = 0; contact < manifold.numContacts(); contact += 1) {
            impulse += manifold.contactImpulse(contact);
            near(manifold.contactDist(contact), 0, 0.02);
            near(manifold.solverContactPoint(contact).y, 0, 0.02);
            assert.ok(manifold.localContactPoint1(contact));
        }
        assert.equal(manifold.localContactPoint1(9), null);
        near(manifold.friction(), 0.5, 1e-6);
    });
    assert.equal(manifolds, 1);
    near(impulse, (body.mass() * 9.81) / 60, 0.05 * body.mass());
    const others = [];
    world.contactPairsWith(collider, (other) => others.push(other));
    assert.deepEqual(others, [ground]);
    world.free();
});

test("sensors intersect", () => {
    const { world } = makeGround();
    const { collider } = insert(world, 0, 3, ColliderDesc.ball(0.5));
    const sensor = world.createCollider(ColliderDesc.ball(1).setTranslation(...c(0, 3)).setSensor(true));
    world.step();
    assert.ok(world.intersectionPair(sensor, collider));
    const others = [];
    world.intersectionPairsWith(sensor, (other) => others.push(other));
    assert.deepEqual(others, [collider]);
    world.free();
});

test("null groups filter nothing, and an answer that is no boolean counts as true", () => {
    const { world } = makeGround();
    const { collider } = insert(world, 0, 5, ColliderDesc.ball(0.5));
    world.step();
    const ray = new RAPIER.Ray(v(0, 10), v(0, -1));
    const cast = (...filter) => world.castRay(ray, 100, true, undefined, ...filter)?.collider;
    assert.equal(cast(null), collider);
    assert.equal(cast(undefined, null, null), collider);
    assert.equal(cast(undefined, undefined, undefined, () => {}), collider);
    assert.equal(cast(undefined, undefined, undefined, () => false), undefined);
    let met = 0;
    world.intersectionsWithRay(ray, 100, true, () => void (met += 1));
    assert.equal(met, 2);
    world.free();
});

test("a query that exhausts the stack leaves a world that lives on", () => {
    const { world, ground } = makeGround();
    world.step();
    const ray = new RAPIER.Ray(v(0, 10), v(0, -1));
    const query = () => world.castRay(ray, 100, true, undefined, undefined, undefined, undefined, () => true);
    const at = (depth, call) => (depth > 0 ? at(depth - 1, call) : call());
    // The depth hovers where the stack ends: in JavaScript, in the module or between them.
    let [found, failed, streak] = [0, 0, 0];
    for (let depth = 1000; failed < 100; ) {
        try {
            assert.ok(at(depth, query));
            [found, streak] = [found + 1, streak + 1];
            depth += streak;
        } catch (error) {
            assert.ok(error instanceof RangeError || error instanceof WebAssembly.RuntimeError, error);
            [failed, streak] = [failed + 1, 0];
            depth -= 10;
        }
        ground.setTranslation(v(0, -1), true);
        world.step();
    }
    assert.ok(found > 0);
    assert.ok(world.castRay(ray, 100, true));
    world.free();
});
