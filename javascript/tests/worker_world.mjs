// A world in a worker: boxes that fall, and one that turns. Without a rate, it steps on request.

import { parentPort, workerData } from "node:worker_threads";
import { DIM, RAPIER, box, insert, makeGround, v } from "./setup.mjs";

const { rate, shared, count } = workerData;
const { world } = makeGround();
const { body: spinner } = insert(world, 0, 50, box(1, 1));
spinner.setGravityScale(0, true);
spinner.setAngvel(DIM === 2 ? 3 : v(0, 0, 3), true);
const fall = (number = 0) => insert(world, 5 + 2 * number, 20, box(0.5, 0.5));
fall();

const publisher = new RAPIER.WorldPublisher(world, parentPort, { rate: rate ?? 60, shared });
parentPort.on("message", ({ ask }) => {
    if (ask === "step") {
        publisher.step();
    } else if (ask === "more") {
        for (let number = 0; number < count; number += 1) fall(number);
    } else if (ask === "stop") {
        publisher.free();
        world.free();
        parentPort.close();
        return;
    }
    if (ask) parentPort.postMessage({ done: ask, spinner: spinner.handle, y: spinner.rotation() });
});
if (rate) publisher.start();
parentPort.postMessage({ done: "begin", spinner: spinner.handle });
