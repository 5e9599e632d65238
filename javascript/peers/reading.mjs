// Times how long a program reads the poses of 2000 bodies once: node --expose-gc reading.mjs [DIMENSION].
// Microseconds and bytes of garbage per frame.

import { join } from "node:path";
import { pathToFileURL } from "node:url";

const COUNT = 2000;
const FRAMES = 500;
const dimension = Number(process.argv[2] ?? 3);
const c = (x, y) => (dimension === 2 ? [x, y] : [x, y, 0]);
const v = (x, y) => (dimension === 2 ? { x, y } : { x, y, z: 0 });

const ours = await import(pathToFileURL(join(import.meta.dirname, `../../rapier${dimension}d/pkg/rapier.node.mjs`)));
const published = await import(`@dimforge/rapier${dimension}d-compat`);

function scene(RAPIER) {
    const world = new RAPIER.World(v(0, -1));
    const bodies = Array.from({ length: COUNT }, (_, index) => {
        const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...c(index * 3, 0)));
        world.createCollider(RAPIER.ColliderDesc.ball(0.5), body);
        return body;
    });
    world.step();
    return { world, bodies };
}

function measure(name, frame) {
    for (let warm = 0; warm < FRAMES; warm += 1) frame();
    globalThis.gc?.();
    const before = process.memoryUsage().heapUsed;
    const start = process.cpuUsage();
    let sum = 0;
    for (let count = 0; count < FRAMES; count += 1) sum += frame();
    const { user, system } = process.cpuUsage(start);
    const garbage = Math.max(0, process.memoryUsage().heapUsed - before) / FRAMES;
    console.log(`| ${name} | ${((user + system) / FRAMES).toFixed(0)} | ${globalThis.gc ? garbage.toFixed(0) : "?"} | ${Number.isFinite(sum)} |`);
}

const getters = ({ bodies }) => () => bodies.reduce((sum, body) => sum + body.translation().y + (dimension === 2 ? body.rotation() : body.rotation().w), 0);
const targets = ({ bodies }) => {
    const [position, rotation] = [v(0, 0), dimension === 2 ? 0 : { x: 0, y: 0, z: 0, w: 1 }];
    return () => {
        let sum = 0;
        for (const body of bodies) {
            sum += body.translation(position).y;
            const turned = body.rotation(rotation);
            sum += dimension === 2 ? turned : turned.w;
        }
        return sum;
    };
};

console.log(`| ${dimension}D, ${COUNT} poses | µs per frame | bytes of garbage | finite |\n|---|--:|--:|---|`);
await ours.init();
await published.init();
const [mine, theirs] = [scene(ours), scene(published)];
measure("ours, getters", getters(mine));
measure("ours, getters with targets", targets(mine));
const { views } = mine.world;
measure("ours, views", () => {
    const { poses, poseStride, length } = views;
    let sum = 0;
    for (let slot = 0; slot < length; slot += 1) {
        sum += poses[slot * poseStride + 1] + poses[slot * poseStride + poseStride - 1];
    }
    return sum;
});
measure("published, getters", getters(theirs));
measure("published, getters with targets", targets(theirs));
