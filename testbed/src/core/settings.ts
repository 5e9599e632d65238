// The settings of the engine that the panel offers for every scene.

import type { WorldLike } from "./engine.ts";

export interface Settings {
    /** Downward acceleration in m/s². */
    gravity: number;
    /** Solver iterations of a step. */
    iterations: number;
    /** Steps per simulated second. */
    rate: number;
}

export const GRAVITY = 9.81;

/** The smallest and the largest value of each setting. */
export const RANGES: Readonly<Record<keyof Settings, readonly [number, number]>> = {
    gravity: [-GRAVITY, 3 * GRAVITY],
    iterations: [1, 32],
    rate: [20, 480],
};

export function defaultSettings(gravity = GRAVITY): Settings {
    return { gravity, iterations: 4, rate: 60 };
}

export function applySettings(world: WorldLike, settings: Settings): void {
    world.gravity.y = -settings.gravity;
    world.numSolverIterations = settings.iterations;
    world.timestep = 1 / settings.rate;
}
