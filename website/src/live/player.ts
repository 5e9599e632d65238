// Runs one scene of the testbed in a canvas of a page, without the testbed's panels.

import { Pointer } from "@repository/testbed/src/app/pointer";
import { Clock } from "@repository/testbed/src/core/clock";
import type { Dimension } from "@repository/testbed/src/core/dimension";
import type { Engine, EngineModule, WorldLike } from "@repository/testbed/src/core/engine";
import type { Input, SceneDefinition } from "@repository/testbed/src/core/scene";
import { Stage } from "@repository/testbed/src/core/stage";
import { Picture } from "@repository/testbed/src/view/picture";
import { THEMES, type ThemeName } from "@repository/testbed/src/view/theme";

/** Seconds between two updates of the figures. */
const REPORT_INTERVAL = 0.5;
const MEAN_STEPS = 30;

export interface Figures {
    readonly bodies: number;
    readonly awake: number;
    /** Mean time of the last steps in milliseconds. */
    readonly step: number;
}

export interface PlayerOptions {
    readonly canvas: HTMLCanvasElement;
    readonly theme: ThemeName;
    readonly report: (figures: Figures) => void;
    readonly fail: (error: unknown) => void;
}

/** A player of any dimension. */
export type AnyPlayer = Pick<Player<never, never>, "clock" | "visible" | "input" | "open" | "setTheme" | "throwBall" | "dispose">;

export class Player<R extends EngineModule, W extends WorldLike> {
    readonly input: Input = { x: 0, y: 0, action: false, used: false };
    readonly clock = new Clock();
    /** Whether the canvas is in view. */
    visible = true;
    private readonly picture: Picture<R, W>;
    private readonly pointer: Pointer<R, W>;
    private stage: Stage<R, W> | null = null;
    private theme: ThemeName;
    private last = performance.now();
    private reported = 0;
    private request = 0;

    constructor(
        private readonly dimension: Dimension<R, W>,
        private readonly engine: Engine<R>,
        private readonly scenes: readonly SceneDefinition<R, W>[],
        private readonly options: PlayerOptions,
    ) {
        this.theme = options.theme;
        this.picture = new Picture(options.canvas, dimension.flat, THEMES[this.theme], "high");
        this.pointer = new Pointer(this.picture, () => (this.stage === null ? [] : [this.stage]));
        this.leaveScrollingToThePage(options.canvas);
        this.request = requestAnimationFrame((now) => this.frame(now));
    }

    /** A wheel or a vertical swipe scrolls the page, unless the swipe holds a body. Two fingers zoom and pan. */
    private leaveScrollingToThePage(canvas: HTMLCanvasElement): void {
        const { controls } = this.picture.rig;
        const allow = ({ pointerType }: PointerEvent): void => {
            controls.enableZoom = controls.enablePan = pointerType === "touch";
        };
        for (const name of ["pointerenter", "pointerdown"] as const) canvas.addEventListener(name, allow, { capture: true });
        controls.enableZoom = controls.enablePan = false;
        canvas.style.touchAction = "pan-y";
        const hold = (event: TouchEvent): void => {
            if (!controls.enabled) event.preventDefault();
        };
        canvas.addEventListener("touchstart", hold, { passive: false });
        canvas.addEventListener("touchmove", hold, { passive: false });
    }

    open(id: string): void {
        const scene = this.scenes.find((candidate) => candidate.id === id);
        if (scene === undefined) throw new RangeError(`there is no scene ${id}`);
        this.pointer.forget();
        this.stage?.dispose();
        // A scene that throws leaves no disposed stage behind.
        this.stage = null;
        this.stage = new Stage(this.dimension, this.engine, scene, { input: this.input });
        this.input.used = false;
        this.picture.frame(scene.camera);
        this.clock.reset();
        this.draw();
    }

    setTheme(theme: ThemeName): void {
        this.theme = theme;
        this.draw();
    }

    throwBall(): void {
        this.pointer.throwBall();
    }

    private draw(): void {
        this.picture.show(this.stage === null ? [] : [this.stage], THEMES[this.theme]);
    }

    private frame(now: number): void {
        const seconds = (now - this.last) / 1000;
        this.last = now;
        try {
            if (this.visible && this.stage !== null) this.advance(this.stage, seconds, now);
        } catch (error) {
            this.stage = null;
            this.options.fail(error);
        }
        this.request = requestAnimationFrame((next) => this.frame(next));
    }

    private advance(stage: Stage<R, W>, seconds: number, now: number): void {
        const { timestep } = stage.world;
        const steps = this.clock.take(seconds, timestep);
        for (let step = 0; step < steps; step += 1) {
            stage.advance();
            if (step >= steps - 2) for (const view of this.picture.views) view.capture();
        }
        this.picture.rig.follow(stage.run.follow?.() ?? null);
        this.picture.render(this.clock.fraction(timestep));
        if (now - this.reported < REPORT_INTERVAL * 1000) return;
        this.reported = now;
        this.options.report({ bodies: stage.counts().bodies, awake: stage.countAwake(), step: stage.stepTimes.mean(MEAN_STEPS) });
    }

    dispose(): void {
        cancelAnimationFrame(this.request);
        this.pointer.forget();
        this.stage?.dispose();
        this.stage = null;
        this.picture.dispose();
    }
}
