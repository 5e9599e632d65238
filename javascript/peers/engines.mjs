// One adapter for each engine: builds a scene, and returns the function that steps it and one that reads a
// height. In Node.js, node_modules contains the packages of the registry; on a page, an import map does: see
// browser.mjs.

import { load } from "#load";

/** Ours and the published packages: one API. */
function rapier(prepare) {
    return async (dimension, { bodies, joints }) => {
        const RAPIER = await prepare(dimension);
        const v = ([x, y, z]) => (dimension === 2 ? { x, y } : { x, y, z });
        const c = ([x, y, z]) => (dimension === 2 ? [x, y] : [x, y, z]);
        const turn = (angle) => (dimension === 2 ? angle : { x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) });
        const world = new RAPIER.World(v([0, -9.81, 0]));
        const shapes = {
            box: ({ half }) => RAPIER.ColliderDesc.cuboid(...c(half)),
            ball: ({ radius }) => RAPIER.ColliderDesc.ball(radius),
            capsule: ({ halfHeight, radius }) => RAPIER.ColliderDesc.capsule(halfHeight, radius),
            mesh({ vertices, indices }) {
                const [points, elements] = [new Float32Array(vertices.flatMap(c)), new Uint32Array(indices.flat())];
                return dimension === 2 ? RAPIER.ColliderDesc.polyline(points, elements) : RAPIER.ColliderDesc.trimesh(points, elements);
            },
        };
        const made = bodies.map(({ fixed, at, shape, turned = 0 }) => {
            const desc = fixed ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic();
            const body = world.createRigidBody(desc.setTranslation(...c(at)).setRotation(turn(turned)).setCanSleep(false));
            world.createCollider(shapes[shape.kind](shape), body);
            return body;
        });
        for (const { bodies: [one, other], at } of joints) {
            const anchors = [one, other].map((index) => {
                const { at: origin, turned = 0 } = bodies[index];
                const [x, y, z] = at.map((value, axis) => value - origin[axis]);
                const [cos, sin] = [Math.cos(-turned), Math.sin(-turned)];
                return v([x * cos - y * sin, x * sin + y * cos, z]);
            });
            const data = dimension === 2 ? RAPIER.JointData.revolute(...anchors) : RAPIER.JointData.spherical(...anchors);
            world.createImpulseJoint(data, made[one], made[other], true).setContactsEnabled?.(false);
        }
        return { step: () => world.step(), height: () => made[made.length - 1].translation().y, free: () => world.free() };
    };
}

const published = (name) => async (dimension) => {
    const RAPIER = await import(name.replace("%d", `${dimension}d`));
    await RAPIER.init();
    return RAPIER;
};

const ours = (simd) => async (dimension) => {
    const RAPIER = await load(dimension);
    await RAPIER.init({ simd });
    return RAPIER;
};

/** Jolt: 3D, one thread, SIMD. */
async function jolt(_dimension, { bodies, joints }) {
    const { default: make } = await import("jolt-physics/wasm-compat");
    const Jolt = await make();
    const settings = new Jolt.JoltSettings();
    settings.mMaxBodies = 8192;
    settings.mMaxBodyPairs = 40000;
    settings.mMaxContactConstraints = 20480;
    const [STATIC, MOVING] = [0, 1];
    const filter = new Jolt.ObjectLayerPairFilterTable(2);
    filter.EnableCollision(STATIC, MOVING);
    filter.EnableCollision(MOVING, MOVING);
    const [lower, upper] = [new Jolt.BroadPhaseLayer(0), new Jolt.BroadPhaseLayer(1)];
    const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
    layers.MapObjectToBroadPhaseLayer(STATIC, lower);
    layers.MapObjectToBroadPhaseLayer(MOVING, upper);
    settings.mObjectLayerPairFilter = filter;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, filter, 2);
    const world = new Jolt.JoltInterface(settings);
    const system = world.GetPhysicsSystem();
    const bodyInterface = system.GetBodyInterface();
    const shapes = {
        box: ({ half }) => new Jolt.BoxShape(new Jolt.Vec3(...half), 0.02, null),
        ball: ({ radius }) => new Jolt.SphereShape(radius, null),
        capsule: ({ halfHeight, radius }) => new Jolt.CapsuleShape(halfHeight, radius, null),
        mesh({ vertices, indices }) {
            const points = new Jolt.VertexList();
            vertices.forEach((vertex) => points.push_back(new Jolt.Float3(...vertex)));
            const triangles = new Jolt.IndexedTriangleList();
            indices.forEach((triangle) => triangles.push_back(new Jolt.IndexedTriangle(...triangle, 0)));
            return new Jolt.MeshShapeSettings(points, triangles, new Jolt.PhysicsMaterialList()).Create().Get();
        },
    };
    const made = bodies.map(({ fixed, at, shape, turned = 0 }) => {
        const rotation = new Jolt.Quat(0, 0, Math.sin(turned / 2), Math.cos(turned / 2));
        const motion = fixed ? Jolt.EMotionType_Static : Jolt.EMotionType_Dynamic;
        const description = new Jolt.BodyCreationSettings(shapes[shape.kind](shape), new Jolt.RVec3(...at), rotation, motion, fixed ? STATIC : MOVING);
        description.mAllowSleeping = false;
        description.mFriction = 0.5;
        const body = bodyInterface.CreateBody(description);
        bodyInterface.AddBody(body.GetID(), Jolt.EActivation_Activate);
        return body;
    });
    for (const { bodies: [one, other], at } of joints) {
        const description = new Jolt.PointConstraintSettings();
        description.mPoint1 = description.mPoint2 = new Jolt.RVec3(...at);
        system.AddConstraint(description.Create(made[one], made[other]));
    }
    system.OptimizeBroadPhase();
    return { step: () => world.Step(1 / 60, 1), height: () => made[made.length - 1].GetPosition().GetY() };
}

/** Box2D 3: 2D, one thread, SIMD. */
async function box2d(_dimension, { bodies, joints }) {
    const { default: make } = await import("box2d3-wasm");
    const b2 = await make();
    const worldDef = b2.b2DefaultWorldDef();
    worldDef.gravity.Set(0, -9.81);
    worldDef.enableSleep = false;
    const world = b2.b2CreateWorld(worldDef);
    const shapeDef = () => {
        const def = b2.b2DefaultShapeDef();
        def.density = 1;
        def.material.friction = 0.5;
        return def;
    };
    const point = (x, y) => new b2.b2Vec2(x, y);
    const shapes = {
        box: (body, { half }) => b2.b2CreatePolygonShape(body, shapeDef(), b2.b2MakeBox(half[0], half[1])),
        ball(body, { radius }) {
            const circle = new b2.b2Circle();
            circle.radius = radius;
            b2.b2CreateCircleShape(body, shapeDef(), circle);
        },
        capsule(body, { halfHeight, radius }) {
            const capsule = new b2.b2Capsule();
            capsule.center1 = point(0, -halfHeight);
            capsule.center2 = point(0, halfHeight);
            capsule.radius = radius;
            b2.b2CreateCapsuleShape(body, shapeDef(), capsule);
        },
        mesh(body, { vertices, indices }) {
            for (const [one, other] of indices) {
                const segment = new b2.b2Segment();
                segment.point1 = point(...vertices[one]);
                segment.point2 = point(...vertices[other]);
                b2.b2CreateSegmentShape(body, shapeDef(), segment);
            }
        },
    };
    const made = bodies.map(({ fixed, at, shape, turned = 0 }) => {
        const def = b2.b2DefaultBodyDef();
        def.type = fixed ? b2.b2BodyType.b2_staticBody : b2.b2BodyType.b2_dynamicBody;
        def.position = point(at[0], at[1]);
        def.rotation = b2.b2MakeRot(turned);
        const body = b2.b2CreateBody(world, def);
        shapes[shape.kind](body, shape);
        return body;
    });
    for (const { bodies: [one, other], at } of joints) {
        const def = b2.b2DefaultRevoluteJointDef();
        def.base.bodyIdA = made[one];
        def.base.bodyIdB = made[other];
        def.base.localFrameA.p = b2.b2Body_GetLocalPoint(made[one], point(at[0], at[1]));
        def.base.localFrameB.p = b2.b2Body_GetLocalPoint(made[other], point(at[0], at[1]));
        b2.b2CreateRevoluteJoint(world, def);
    }
    return { step: () => b2.b2World_Step(world, 1 / 60, 4), height: () => b2.b2Body_GetPosition(made[made.length - 1]).y, free: () => b2.b2DestroyWorld(world) };
}

/** The engines by dimension. */
export const ENGINES = {
    2: {
        "ours": rapier(ours(true)),
        "ours, scalar": rapier(ours(false)),
        "rapier2d-compat": rapier(published("@dimforge/rapier%d-compat")),
        "box2d3-wasm": box2d,
    },
    3: {
        "ours": rapier(ours(true)),
        "ours, scalar": rapier(ours(false)),
        "rapier3d-simd-compat": rapier(published("@dimforge/rapier%d-simd-compat")),
        "rapier3d-compat": rapier(published("@dimforge/rapier%d-compat")),
        "jolt-physics": jolt,
    },
};
