// Colliders: settings, and shapes that come back as they went in.

import assert from "node:assert/strict";
import test from "node:test";
import { DIM, RAPIER, c, fails, insert, box, makeGround, makeWorld, near, r, steps, v } from "./setup.mjs";

const { ColliderDesc, ShapeType } = RAPIER;
const square = new Float32Array(DIM === 2 ? [0, 0, 2, 0, 2, 2, 0, 2] : [0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2]);

/** A description of each kind of shape. */
function shapes() {
    const common = {
        Ball: ColliderDesc.ball(0.5),
        Cuboid: box(0.5, 0.25),
        Capsule: ColliderDesc.capsule(0.5, 0.25),
        Segment: ColliderDesc.segment(v(0, 0), v(1, 2)),
        Polyline: ColliderDesc.polyline(square),
        Triangle: ColliderDesc.triangle(v(0, 0), v(1, 0), v(0, 1)),
        TriMesh: ColliderDesc.trimesh(square, new Uint32Array([0, 1, 2, 0, 2, 3])),
        Compound: ColliderDesc.compound([new RAPIER.Ball(0.5), new RAPIER.Ball(0.25)], [v(0, 0), v(1, 0)], [r(0), r(0.5)]),
        RoundCuboid: ColliderDesc.roundCuboid(...c(0.5, 0.25, 0.5), 0.125),
        RoundTriangle: ColliderDesc.roundTriangle(v(0, 0), v(1, 0), v(0, 1), 0.125),
        HalfSpace: ColliderDesc.halfspace(v(0, 1)),
        Voxels: ColliderDesc.voxels(new Int32Array([...c(0, 0), ...c(1, 0), ...c(1, 1)]), v(0.5, 0.5, 0.5)),
    };
    if (DIM === 2) {
        return {
            ...common,
            HeightField: ColliderDesc.heightfield(new Float32Array([0, 1, 0.5]), v(4, 1)),
            ConvexPolygon: ColliderDesc.convexPolyline(square),
            RoundConvexPolygon: ColliderDesc.roundConvexHull(square, 0.125),
        };
    }
    return {
        ...common,
        HeightField: ColliderDesc.heightfield(1, 2, new Float32Array([0, 1, 2, 3, 4, 5]), v(4, 1, 2)),
        ConvexPolyhedron: ColliderDesc.convexHull(square),
        RoundConvexPolyhedron: ColliderDesc.roundConvexHull(square, 0.125),
        Cylinder: ColliderDesc.cylinder(0.5, 0.25),
        RoundCylinder: ColliderDesc.roundCylinder(0.5, 0.25, 0.125),
        Cone: ColliderDesc.cone(0.5, 0.25),
        RoundCone: ColliderDesc.roundCone(0.5, 0.25, 0.125),
    };
}

for (const [name, desc] of Object.entries(shapes())) {
    test(`a ${name} comes back as it went in`, () => {
        const world = makeWorld();
        const collider = world.createCollider(desc);
        assert.equal(collider.shapeType(), ShapeType[name]);
        assert.equal(collider.shape.type, ShapeType[name]);
        const copy = world.createCollider(new ColliderDesc(collider.shape));
        near(copy.volume(), collider.volume(), 1e-6);
        copy.setShape(new RAPIER.Ball(1));
        copy.setShape(collider.shape);
        assert.equal(copy.shapeType(), ShapeType[name]);
        world.free();
    });
}

test("the list of shapes is that of the enumeration", () => {
    const names = Object.keys(ShapeType).filter((name) => Number.isNaN(Number(name)));
    assert.deepEqual(Object.keys(shapes()).sort(), names.sort());
});

test("settings come back as they went in", () => {
    const world = makeWorld();
    const desc = box(1, 1)
        .setFriction(0.25)
        .setRestitution(0.75)
        .setFrictionCombineRule(RAPIER.CoefficientCombineRule.Max)
        .setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Multiply)
        .setCollisionGroups(0x00030005)
        .setSolverGroups(0xffff0001)
        .setActiveEvents(RAPIER.ActiveEvents.COLLISION_EVENTS)
        .setActiveHooks(RAPIER.ActiveHooks.FILTER_CONTACT_PAIRS)
        .setActiveCollisionTypes(RAPIER.ActiveCollisionTypes.ALL)
        .setContactForceEventThreshold(5)
        .setContactSkin(0.125)
        .setMass(4)
        .setSensor(true)
        .setTranslation(...c(1, 2, 3))
        .setRotation(r(0.5));
    const collider = world.createCollider(desc);
    near(collider.friction(), 0.25, 0);
    near(collider.restitution(), 0.75, 0);
    assert.equal(collider.frictionCombineRule(), RAPIER.CoefficientCombineRule.Max);
    assert.equal(collider.restitutionCombineRule(), RAPIER.CoefficientCombineRule.Multiply);
    assert.equal(collider.collisionGroups(), 0x00030005);
    assert.equal(collider.solverGroups(), 0xffff0001);
    assert.equal(collider.activeEvents(), RAPIER.ActiveEvents.COLLISION_EVENTS);
    assert.equal(collider.activeHooks(), RAPIER.ActiveHooks.FILTER_CONTACT_PAIRS);
    assert.equal(collider.activeCollisionTypes(), RAPIER.ActiveCollisionTypes.ALL);
    assert.equal(collider.contactForceEventThreshold(), 5);
    assert.equal(collider.contactSkin(), 0.125);
    near(collider.mass(), 4, 1e-5);
    assert.ok(collider.isSensor());
    assert.deepEqual({ ...collider.translation() }, v(1, 2, 3));
    assert.equal(collider.translationWrtParent(), null);
    collider.setSensor(false);
    assert.ok(!collider.isSensor());
    collider.setEnabled(false);
    assert.ok(!collider.isEnabled());
    world.free();
});

test("flags of a compound come back as they went in", () => {
    const world = makeWorld();
    const parts = [[new RAPIER.Cuboid(...c(0.5, 0.5, 0.5)), v(0, 0)], [new RAPIER.Cuboid(...c(0.5, 0.5, 0.5)), v(1, 0)]];
    for (const flags of [0, RAPIER.CompoundFlags.FIX_INTERNAL_EDGES]) {
        const desc = ColliderDesc.compound(parts.map(([shape]) => shape), parts.map(([, at]) => at), parts.map(() => r(0)), flags);
        const collider = world.createCollider(desc);
        const restored = RAPIER.World.restoreSnapshot(world.takeSnapshot());
        assert.equal(restored.getCollider(collider.handle).shape.flags, flags);
        restored.free();
    }
    world.free();
});

test("sizes of shapes can be changed", () => {
    const world = makeWorld();
    const capsule = world.createCollider(ColliderDesc.capsule(0.5, 0.25));
    capsule.setRadius(0.75);
    capsule.setHalfHeight(1.5);
    assert.deepEqual([capsule.radius(), capsule.halfHeight()], [0.75, 1.5]);
    const cuboid = world.createCollider(ColliderDesc.roundCuboid(...c(0.5, 0.5, 0.5), 0.125));
    cuboid.setHalfExtents(v(1, 2, 3));
    cuboid.setRoundRadius(0.25);
    assert.deepEqual({ ...cuboid.halfExtents() }, v(1, 2, 3));
    assert.equal(cuboid.roundRadius(), 0.25);
    assert.throws(() => cuboid.radius(), fails("WrongShape", "RoundCuboid", "radius"));
    assert.throws(() => capsule.setRadius(-1), fails("InvalidValue", "-1"));
    assert.equal(capsule.radius(), 0.75);
    world.free();
});

test("voxels can be edited", () => {
    const world = makeWorld();
    const voxels = world.createCollider(ColliderDesc.voxels(new Int32Array(c(0, 0)), v(1, 1, 1)));
    near(voxels.volume(), 1, 1e-5);
    voxels.setVoxel(...c(1, 0), true);
    near(voxels.volume(), 2, 1e-5);
    assert.equal(voxels.shape.data.length, 2 * DIM);
    const ball = world.createCollider(ColliderDesc.ball(1));
    assert.throws(() => ball.setVoxel(...c(1, 0), true), fails("WrongShape", "Voxels"));
    world.free();
});

test("a collider follows its body with its offset", () => {
    const { world } = makeGround();
    const { body, collider } = insert(world, 0, 5, ColliderDesc.ball(0.5).setTranslation(...c(1, 0)));
    assert.deepEqual({ ...collider.translationWrtParent() }, v(1, 0));
    body.setTranslation(v(3, 5), true);
    world.propagateModifiedBodyPositionsToColliders();
    assert.deepEqual({ ...collider.translation() }, v(4, 5));
    assert.equal(collider.parent(), body);
    assert.equal(body.numColliders(), 1);
    assert.equal(body.collider(0), collider);
    steps(world, 1);
    world.free();
});

test("a description copies mass properties", () => {
    const world = makeWorld();
    const center = v(0.25, 0.5);
    const inertia = DIM === 2 ? [2] : [{ x: 1, y: 2, z: 3 }, { x: 0, y: 0, z: 0.6, w: 0.8 }];
    const desc = box(1, 1).setMassProperties(4, center, ...inertia);
    for (const object of [center, ...inertia]) {
        if (typeof object === "object") Object.assign(object, { x: 9, y: 9, z: 9, w: 9 });
    }
    assert.deepEqual([desc.centerOfMass.x, desc.centerOfMass.y], [0.25, 0.5]);
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic());
    world.createCollider(desc, body);
    world.step();
    near(body.localCom().x, 0.25, 1e-6);
    near(body.localCom().y, 0.5, 1e-6);
    if (DIM === 3) {
        near(body.principalInertia().y, 2, 1e-5);
        near(body.principalInertiaLocalFrame().z, 0.6, 1e-6);
    }
    world.free();
});
