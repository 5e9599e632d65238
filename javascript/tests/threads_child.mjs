// Steps a heap of boxes, and prints its hash: node threads_child.mjs DIMENSION THREADS [hooks]

import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [dimension, threads, hooked] = process.argv.slice(2);
const DIM = Number(dimension);
const pkg = process.env.RAPIER_PKG ?? join(import.meta.dirname, `../../rapier${DIM}d/pkg`);
const RAPIER = await import(pathToFileURL(join(pkg, "rapier.node.mjs")));
await RAPIER.init({ threads: Number(threads) });

const at = (x, y, z) => (DIM === 2 ? [x, y] : [x, y, z]);
const world = new RAPIER.PhysicsWorld();
world.insert(RAPIER.RigidBodyDesc.fixed().setTranslation(...at(0, -1, 0)), RAPIER.ColliderDesc.cuboid(...at(50, 1, 50)));
const side = DIM === 2 ? 32 : 10;
const depth = DIM === 2 ? 1 : side;
for (let number = 0; number < 1000; number += 1) {
    const [column, row, layer] = [number % side, Math.floor(number / side) % depth, Math.floor(number / (side * depth))];
    const desc = RAPIER.ColliderDesc.cuboid(...at(0.5, 0.5, 0.5));
    if (hooked && number % 10 === 0) desc.setActiveHooks(RAPIER.ActiveHooks.FILTER_CONTACT_PAIRS);
    world.insert(RAPIER.RigidBodyDesc.dynamic().setTranslation(...at(column * 1.0625 + layer * 0.125, layer + 1, row * 1.0625)), desc);
}
let calls = 0;
const hooks = {
    filterContactPair() {
        calls += 1;
        return RAPIER.SolverFlags.COMPUTE_IMPULSE;
    },
    filterIntersectionPair: () => true,
};
for (let step = 0; step < 100; step += 1) {
    if (hooked) world.step(undefined, hooks);
    else world.step();
}
console.log(JSON.stringify({ hash: world.hash().toString(16), calls, threads: RAPIER.threads() }));
