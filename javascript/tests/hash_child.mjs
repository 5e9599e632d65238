// Builds the scene of crates/wasm/src/native_hash.rs, and prints its hash:
//     node hash_child.mjs DIMENSION simd|scalar STEPS

import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [dimension, lanes, count] = process.argv.slice(2);
const DIM = Number(dimension);
const pkg = process.env.RAPIER_PKG ?? join(import.meta.dirname, `../../rapier${DIM}d/pkg`);
const RAPIER = await import(pathToFileURL(join(pkg, "rapier.node.mjs")));
await RAPIER.init({ simd: lanes === "simd" });

const at = (x, y, z) => (DIM === 2 ? [x, y] : [x, y, z]);
const world = new RAPIER.PhysicsWorld();
world.insert(RAPIER.RigidBodyDesc.fixed().setTranslation(...at(0, -1, 0)), RAPIER.ColliderDesc.cuboid(...at(50, 1, 50)));
const shapes = [
    () => RAPIER.ColliderDesc.cuboid(...at(0.5, 0.25, 0.375)),
    () => RAPIER.ColliderDesc.ball(0.375),
    () => RAPIER.ColliderDesc.capsule(0.25, 0.25),
];
let number = 0;
for (let layer = 0; layer < 12; layer += 1) {
    for (let row = 0; row < 3; row += 1) {
        for (let column = 0; column < 3; column += 1) {
            const [x, y, z] = [column * 1.25, layer + 1, row * 1.25];
            world.insert(RAPIER.RigidBodyDesc.dynamic().setTranslation(...at(x + y * 0.03125, y, z)), shapes[number % 3]());
            number += 1;
        }
    }
}
for (let step = 0; step < Number(count); step += 1) {
    world.step();
}
console.log(world.hash().toString(16).padStart(16, "0"));
