// Measures the steps of one scene with one engine.

import { ENGINES } from "./engines.mjs";
import { SCENES } from "./scenes.mjs";

/** Milliseconds per step by this clock (ms). */
export async function measure(dimension, engine, scene, clock) {
    const { steps = 200, warm = 20, ...content } = SCENES[scene](dimension);
    const { step, height } = await ENGINES[dimension][engine](dimension, content);
    for (let count = 0; count < warm; count += 1) step();
    const start = clock();
    for (let count = 0; count < steps; count += 1) step();
    const time = (clock() - start) / steps;
    const result = height();
    if (!Number.isFinite(result)) {
        throw new Error(`the scene ended at a height of ${result}`);
    }
    return time;
}
