// A scene that runs in one engine, without a picture. Node tests and the page use the same class.

import type { Counts, Dimension, Spring } from "./dimension.ts";
import { stepHash, type BodyLike, type Engine, type EngineModule, type EventQueueLike, type WorldLike } from "./engine.ts";
import { Random } from "./random.ts";
import type { Input, Paint, Paintable, ParameterValue, SceneContext, SceneDefinition, SceneRun } from "./scene.ts";
import { Series } from "./series.ts";
import { applySettings, defaultSettings, type Settings } from "./settings.ts";

/** Number of steps that the plot shows. */
export const HISTORY = 240;

/** The stages of a step that engines time, in the order of the plot. */
export const TIMINGS = ["broad phase", "narrow phase", "islands", "solver", "CCD"] as const;

export interface StageOptions {
    settings?: Settings;
    parameters?: Record<string, ParameterValue>;
    input?: Input;
}

/** The default values of a scene's parameters. */
export function defaultParameters<R, W>(scene: SceneDefinition<R, W>): Record<string, ParameterValue> {
    const values: Record<string, ParameterValue> = {};
    for (const [name, parameter] of Object.entries(scene.parameters ?? {})) values[name] = parameter.value;
    return values;
}

export class Stage<R extends EngineModule, W extends WorldLike> {
    world: W;
    run: SceneRun;
    spring: Spring | null = null;
    /** Colours by handle of a collider. */
    readonly paints = new Map<number, Paint>();
    /** Colliders whose colour changed since the last picture. */
    readonly repainted = new Set<number>();
    /** Changes when every picture of the old world is out of date. */
    generation = 0;
    steps = 0;
    time = 0;
    readonly stepTimes = new Series(HISTORY);
    readonly awake = new Series(HISTORY);
    readonly timings: Record<(typeof TIMINGS)[number], Series>;
    readonly settings: Settings;
    private readonly parameters: Record<string, ParameterValue>;
    private readonly input: Input;

    constructor(
        readonly dimension: Dimension<R, W>,
        readonly engine: Engine<R>,
        readonly scene: SceneDefinition<R, W>,
        options: StageOptions = {},
    ) {
        this.settings = options.settings ?? defaultSettings(scene.gravity);
        this.parameters = options.parameters ?? defaultParameters(scene);
        this.input = options.input ?? { x: 0, y: 0, action: false, used: false };
        this.timings = Object.fromEntries(TIMINGS.map((name) => [name, new Series(HISTORY)])) as typeof this.timings;
        this.world = dimension.createWorld(engine.module, this.settings.gravity);
        applySettings(this.world, this.settings);
        this.run = scene.setup(this.context()) ?? {};
    }

    private context(): SceneContext<R, W> {
        return {
            RAPIER: this.engine.module,
            world: this.world,
            random: new Random(7),
            input: this.input,
            parameter: <T extends ParameterValue>(name: string): T => this.parameter(name) as T,
            paint: (target, paint) => this.paint(target, paint),
        };
    }

    private parameter(name: string): ParameterValue {
        const value = this.parameters[name];
        if (value === undefined) throw new RangeError(`scene ${this.scene.id} has no parameter ${name}`);
        return value;
    }

    private paint(target: Paintable, paint: Paint): void {
        if (target.numColliders === undefined || target.collider === undefined) {
            this.paintCollider(target.handle, paint);
            return;
        }
        for (let index = 0; index < target.numColliders(); index++) {
            this.paintCollider(target.collider(index).handle, paint);
        }
    }

    paintCollider(handle: number, paint: Paint): void {
        if (this.paints.get(handle) === paint) return;
        this.paints.set(handle, paint);
        this.repainted.add(handle);
    }

    /** Runs one step and records its time. */
    advance(): void {
        applySettings(this.world, this.settings);
        this.run.update?.(this.time, this.steps);
        const before = performance.now();
        this.dimension.step(this.world, this.run.events, this.run.hooks);
        this.stepTimes.push(performance.now() - before);
        this.steps += 1;
        this.time += this.world.timestep;
        this.run.after?.(this.time, this.steps);
        if (this.world.profilerEnabled) this.recordTimings();
    }

    private recordTimings(): void {
        const { world, timings } = this;
        timings["broad phase"].push(world.timingBroadPhase());
        timings["narrow phase"].push(world.timingNarrowPhase());
        timings.islands.push(world.timingIslandConstruction());
        timings.solver.push(world.timingSolver());
        timings.CCD.push(world.timingCcd());
    }

    counts(): Counts {
        return this.dimension.counts(this.world);
    }

    countAwake(): number {
        let awake = 0;
        this.world.forEachRigidBody((body) => {
            if (!body.isFixed() && !body.isSleeping()) awake += 1;
        });
        return awake;
    }

    hash(): string | null {
        return stepHash(this.world);
    }

    takeSnapshot(): Uint8Array {
        this.release();
        return this.world.takeSnapshot();
    }

    /** Replaces the world. The scene's script holds objects of the old world and ends. */
    restore(snapshot: Uint8Array): void {
        const restored = this.dimension.restoreWorld(this.engine.module, snapshot);
        this.spring = null;
        (this.run.events as EventQueueLike | undefined)?.free();
        this.world.free();
        this.world = restored;
        this.run = {};
        this.generation += 1;
    }

    /** Releases the body that the pointer holds. */
    release(): void {
        this.spring?.free();
        this.spring = null;
    }

    dispose(): void {
        this.release();
        (this.run.events as EventQueueLike | undefined)?.free();
        this.world.free();
    }

    /** The first body with a value that is not finite, or null. */
    findInvalid(): BodyLike | null {
        const state = new Float64Array(13);
        let found: BodyLike | null = null;
        this.world.forEachRigidBody((body) => {
            this.dimension.readState(body, state);
            if (!state.every(Number.isFinite)) found ??= body;
        });
        return found;
    }
}
