// Every argument of every method that is a number, a vector or a rotation: a value of another kind is a RapierError
// that names the value. The definitions list the methods, so that a new one is tested, too.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { join } from "node:path";
import test from "node:test";
import { DIM, PKG, RAPIER, box, c, insert, makeGround, v } from "./setup.mjs";

const ts = createRequire(join(PKG, "..", "package.json"))("typescript");
const file = join(PKG, `types/rapier${DIM}.d.ts`);
const program = ts.createProgram([file], { target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.ESNext, moduleResolution: ts.ModuleResolutionKind.Bundler, types: [], strict: true });
const checker = program.getTypeChecker();

RAPIER.setWarningHandler(() => {});

/** Arguments for which each number is a handle that finds nothing, or a number that only JavaScript computes with. */
const LENIENT = [
    /^World\.get\w+\(handle\)/, /Set\.(get|contains|remove|unmap|forEachJointHandleAttachedToRigidBody)\(handle\)/, /^NarrowPhase\.\w+\(collider[12]\)/,
    /^Ray\.pointAt/, /^bodyIndex/, /Ops\./, /\(_/,
];

const rotation = () => (DIM === 2 ? 0.5 : { x: 0, y: 0, z: 0.6, w: 0.8 });
const gear = () => (DIM === 2 ? RAPIER.JointData.gear(2) : RAPIER.JointData.gear(v(1, 0), v(1, 0), 2));
const rack = () => (DIM === 2 ? RAPIER.JointData.rack(v(1, 0), 2) : RAPIER.JointData.rack(v(1, 0), v(1, 0), 2));
const pulley = () => RAPIER.JointData.pulley(v(0, 0), v(0, 0), v(0, 9), v(3, 9), 20, 1);
const hinge = () => (DIM === 2 ? RAPIER.JointData.revolute(v(0, 0), v(0, 1)) : RAPIER.JointData.revolute(v(0, 0), v(0, 1), v(1, 0)));

/** A world, and objects of each class by the names of the classes. */
function scene() {
    const { world, collider: floor } = makeGround();
    const [one, other, third, fourth] = [0, 3, 6, 9].map((x) => insert(world, x, 5, box(0.5, 0.5)));
    const voxels = world.createCollider(RAPIER.ColliderDesc.voxels(new Int32Array(c(0, 0)), v(1, 1, 1)));
    const round = world.createCollider(DIM === 2 ? RAPIER.ColliderDesc.roundCuboid(1, 1, 0.1) : RAPIER.ColliderDesc.roundCylinder(1, 1, 0.1));
    const capsule = world.createCollider(RAPIER.ColliderDesc.capsule(1, 1));
    const objects = {
        World: [world], RigidBody: [one.body], Collider: [one.collider, voxels, round, capsule], RigidBodyDesc: [RAPIER.RigidBodyDesc.dynamic()], ColliderDesc: [box(1, 1)],
        RevoluteImpulseJoint: [world.createImpulseJoint(hinge(), one.body, other.body, true)],
        GearImpulseJoint: [world.createImpulseJoint(gear(), one.body, other.body, true)], RackImpulseJoint: [world.createImpulseJoint(rack(), one.body, other.body, true)],
        PulleyImpulseJoint: [world.createImpulseJoint(pulley(), one.body, other.body, true)],
        RevoluteMultibodyJoint: [world.createMultibodyJoint(hinge(), third.body, fourth.body, true)],
        KinematicCharacterController: [world.createCharacterController(0.1)], PidController: [world.createPidController(1, 1, 1, RAPIER.PidAxesMask.All)],
        BroadPhase: [world.broadPhase], IntegrationParameters: [world.integrationParameters], Ball: [new RAPIER.Ball(1)],
    };
    if (DIM === 3) {
        const vehicle = world.createVehicleController(one.body);
        vehicle.addWheel(v(0, 0), v(0, -1), v(1, 0), 0.5, 0.25);
        objects.DynamicRayCastVehicleController = [vehicle];
        objects.SphericalImpulseJoint = [world.createImpulseJoint(RAPIER.JointData.spherical(v(0, 0), v(0, 1)), third.body, one.body, true)];
    }
    return { world, floor, body: other.body, collider: other.collider, voxels, objects };
}

/** A value that a parameter accepts. */
function accepted({ name, type, owner }, { world, body, collider, voxels }) {
    const indices = new Uint32Array(DIM === 2 || owner === "Polyline" ? [0, 1] : [0, 1, 2]);
    const values = {
        boolean: true, "Vector[]": [v(0, 0)], "Rotation[]": [rotation()], "Shape[]": [new RAPIER.Ball(1)], Shape: new RAPIER.Ball(1), Vector: v(0, 1), Rotation: rotation(), Ray: new RAPIER.Ray(v(0, 9), v(0, -1)),
        AngVector: DIM === 2 ? 1 : v(1, 0), RigidBodyDesc: RAPIER.RigidBodyDesc.dynamic(), ColliderDesc: box(1, 1), JointData: hinge(), Collider: name === "voxels2" ? voxels : collider, World: world,
    };
    if (type in values) return values[type];
    if (/^RigidBody\b/.test(type)) return body;
    if (/^Collider\b/.test(type)) return collider;
    if (type.includes("=>")) return () => true;
    if (name === "indices") return indices;
    if (/Array/.test(type)) return name === "heights" ? new Float32Array(DIM === 2 ? 3 : 4) : new Float32Array(DIM === 2 ? [0, 0, 1, 0, 0, 1] : [0, 0, 0, 1, 0, 0, 0, 0, 1]);
    return name === "i" ? 0 : 1;
}

/** The parameters of a signature. Lists of named parameters are spread. */
function parametersOf(signature, owner) {
    return signature.parameters.flatMap((symbol) => {
        const declaration = symbol.valueDeclaration;
        const type = checker.getTypeOfSymbolAtLocation(symbol, declaration);
        const describe = (own, name, optional) => {
            const text = checker.typeToString(own);
            const isNumber = (own.flags & ts.TypeFlags.NumberLike) !== 0 || (own.flags & ts.TypeFlags.EnumLike) !== 0;
            return { name, owner, optional, type: text, kind: isNumber ? "number" : /^(Vector|Rotation|AngVector)$/.test(text) ? "vector" : undefined };
        };
        if (declaration.dotDotDotToken && checker.isTupleType(type)) {
            const names = type.target.labeledElementDeclarations;
            return checker.getTypeArguments(type).map((own, at) => describe(own, names?.[at]?.name?.getText() ?? `${symbol.name}${at}`, !!names?.[at]?.questionToken));
        }
        return [describe(type, symbol.name, !!declaration.questionToken)];
    });
}

/** The calls with one wrong argument: labels, parameters, and functions of a scene and the arguments. */
function* callsOf(name, symbol) {
    const statics = checker.getTypeOfSymbol(symbol);
    const use = { ColliderDesc: ({ world }, desc) => world.createCollider(desc), RigidBodyDesc: ({ world }, desc) => world.createRigidBody(desc), JointData: ({ world, floor, body }, data) => world.createImpulseJoint(data, body, floor.parent(), true) };
    const using = (parts, made) => (made === null ? undefined : (use[name]?.(parts, made), undefined));
    for (const member of checker.getPropertiesOfType(statics)) {
        const signature = checker.getTypeOfSymbol(member).getCallSignatures()[0];
        if (signature && RAPIER[name][member.name]) {
            yield [`${name}.${member.name}`, parametersOf(signature, name), (parts) => [(args) => using(parts, RAPIER[name][member.name](...args))]];
        }
    }
    if (RAPIER[name].prototype instanceof RAPIER.Shape) {
        yield [`new ${name}`, parametersOf(statics.getConstructSignatures()[0], name), ({ world }) => [(args) => world.createCollider(new RAPIER.ColliderDesc(new RAPIER[name](...args)))]];
    }
    for (const member of checker.getPropertiesOfType(checker.getDeclaredTypeOfSymbol(symbol))) {
        const signature = checker.getTypeOfSymbol(member).getCallSignatures()[0];
        if (signature && !member.declarations.some((part) => ts.getCombinedModifierFlags(part) & (ts.ModifierFlags.Private | ts.ModifierFlags.Protected))) {
            yield [`${name}.${member.name}`, parametersOf(signature, name), ({ objects, ...parts }) => (objects[name] ?? []).map((object) => (args) => {
                object[member.name](...args);
                using(parts, object);
            })];
        }
    }
}

const WRONG = { number: [undefined, null, "5", true, {}, [], NaN, 5n], vector: [undefined, null, "5", {}, [], NaN, v(NaN, 0), v("1", 0)] };

/** Calls with each wrong value. Returns the number of calls that refused a value; others are failures. */
function refusals(label, parameters, prepare) {
    let count = 0;
    parameters.forEach((parameter, at) => {
        const { kind, name, optional } = parameter;
        if (kind === undefined || LENIENT.some((pattern) => pattern.test(`${label}(${name})`))) return;
        for (const wrong of WRONG[kind]) {
            // The rule of a number decides about NaN: limits, for one, may be absent.
            if ((optional && (wrong === undefined || wrong === null)) || (kind === "number" && Number.isNaN(wrong))) continue;
            const parts = scene();
            const errors = prepare(parts).map((call) => {
                const args = parameters.map((other) => accepted(other, parts));
                args[at] = wrong;
                try {
                    call(args);
                } catch (error) {
                    return error;
                }
                return undefined;
            });
            const shown = `${label}(${name} = ${JSON.stringify(wrong, (_, value) => (typeof value === "bigint" ? `${value}n` : value))})`;
            for (const error of errors) {
                assert.ok(error instanceof RAPIER.RapierError && error.code !== "Internal", `${shown}: ${error}`);
            }
            if (errors.length > 0) {
                assert.ok(errors.some(({ code }) => code === "InvalidValue"), `${shown}: ${errors[0]}`);
                count += 1;
            }
            parts.world.step();
            parts.world.free();
        }
    });
    return count;
}

const symbols = checker.getExportsOfModule(checker.getSymbolAtLocation(program.getSourceFile(file)));
let total = 0;
for (const exported of symbols.filter(({ name }) => name !== "default")) {
    const symbol = exported.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(exported) : exported;
    if (symbol.flags & ts.SymbolFlags.Class) {
        test(`${exported.name} refuses values of another kind`, () => {
            for (const [label, parameters, prepare] of callsOf(exported.name, symbol)) {
                total += refusals(label, parameters, prepare);
            }
        });
    }
}
test("the definitions list arguments", () => assert.ok(total > 1000, `${total}`));

test("a result of a query cannot be written into a number", () => {
    const { world, collider, objects } = scene();
    const ray = new RAPIER.Ray(v(0, 9), v(0, -1));
    for (const target of [5, "5", true]) {
        assert.throws(() => collider.projectPoint(v(0, 0), true, target), { name: "RapierError", message: /^target is/ });
        assert.throws(() => collider.castRayAndGetNormal(new RAPIER.Ray(v(3, 9), v(0, -1)), 99, true, target), { name: "RapierError", message: /^target is/ });
        assert.throws(() => world.broadPhase.castRayAndGetNormal(0, 0, 0, ray, 99, true, 0, undefined, undefined, undefined, undefined, target), { name: "RapierError", message: /^target is/ });
    }
    const empty = {};
    assert.equal(objects.Collider[0].projectPoint(v(0, 20), true, empty), empty);
    assert.ok(empty.point.y > 5 && empty.isInside === false, "missing fields of a target are made");
    world.free();
});

test("functions are required where one is called", () => {
    const { world, body } = scene();
    for (const wrong of [undefined, null, 5, "f", {}]) {
        for (const each of [
            () => world.forEachRigidBody(wrong), () => world.forEachCollider(wrong), () => world.forEachActiveRigidBody(wrong), () => world.bodies.forEach(wrong), () => world.colliders.forEach(wrong),
            () => world.impulseJoints.forEach(wrong), () => world.multibodyJoints.forEach(wrong), () => world.islands.forEachActiveRigidBodyHandle(wrong),
            () => world.impulseJoints.forEachJointHandleAttachedToRigidBody(body.handle, wrong), () => world.broadPhase.intersectionsWithPoint(0, 0, 0, v(0, 0), wrong),
        ]) {
            assert.throws(each, { name: "RapierError", code: "InvalidValue", message: /^(f|callback) is/ });
        }
    }
    for (const wrong of [5, "f", {}]) {
        assert.throws(() => world.debugRender(undefined, wrong), { name: "RapierError", message: /^filterPredicate is/ });
    }
    world.free();
});
