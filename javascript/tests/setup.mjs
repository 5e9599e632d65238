// Common parts of all tests: the package of the environment's dimension, and constructors of both dimensions.

import { execFile } from "node:child_process";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { promisify } from "node:util";

export const DIM = Number(process.env.DIMENSION ?? 3);
/** The package. Another build of it can be tested by `RAPIER_PKG`. */
export const PKG = process.env.RAPIER_PKG ?? join(import.meta.dirname, `../../rapier${DIM}d/pkg`);
export const RAPIER = (await import(pathToFileURL(join(PKG, "rapier.node.mjs")))).default;
await RAPIER.init();

/** A vector. 2D omits z. */
export const v = (x, y, z = 0) => (DIM === 2 ? { x, y } : { x, y, z });
/** The components of a vector as arguments. */
export const c = (x, y, z = 0) => (DIM === 2 ? [x, y] : [x, y, z]);
/** A rotation about z. */
export const r = (angle) => (DIM === 2 ? angle : { x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) });
/** A box. */
export const box = (hx, hy, hz = hx) => RAPIER.ColliderDesc.cuboid(...c(hx, hy, hz));

/** A world with gravity along -y. */
export function makeWorld(gravity = -9.81) {
    return new RAPIER.World(v(0, gravity));
}

/** A world with a wide ground whose surface is at y = 0. */
export function makeGround(gravity = -9.81) {
    const world = makeWorld(gravity);
    const ground = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(...c(0, -1)));
    const collider = world.createCollider(box(50, 1), ground);
    return { world, ground, collider };
}

/** A dynamic body with a collider. */
export function insert(world, x, y, desc, z = 0) {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...c(x, y, z)));
    return { body, collider: world.createCollider(desc, body) };
}

/** Runs steps. */
export function steps(world, count, ...rest) {
    for (let step = 0; step < count; step += 1) {
        world.step(...rest);
    }
}

/** A condition of errors of the engine: a code, and parts of the message. */
export function fails(code, ...parts) {
    return (error) => {
        if (!(error instanceof RAPIER.RapierError) || error.code !== code) {
            throw new Error(`expected a RapierError of code ${code}`, { cause: error });
        }
        const missing = parts.filter((part) => !error.message.includes(part));
        if (missing.length > 0) {
            throw new Error(`the message lacks ${missing}: ${error.message}`);
        }
        return true;
    };
}

/** Returns whether two numbers are close. */
export function near(actual, expected, tolerance) {
    if (!(Math.abs(actual - expected) <= tolerance)) {
        throw new Error(`${actual} is not within ${tolerance} of ${expected}`);
    }
}

/** The address of a file of the package, as a literal of JavaScript. */
export const entry = (file) => JSON.stringify(pathToFileURL(join(PKG, file)).href);

/** The output of a process of Node.js. */
export async function output(...options) {
    const { stdout } = await promisify(execFile)(process.execPath, options, { timeout: 120_000 });
    return stdout.trim();
}
