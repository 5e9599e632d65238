// The interface between scenes and the testbed.

import type { EngineModule } from "./engine.ts";
import type { Random } from "./random.ts";

/** A value of a scene's own parameter. */
export type ParameterValue = number | boolean | string;

/** A parameter that the panel shows. A change restarts the scene unless `live` is set. */
export type Parameter = { label: string; live?: boolean } & (
    | { value: number; min: number; max: number; step: number }
    | { value: boolean }
    | { value: string; options: readonly string[] }
);

/**
 * A colour by name; the theme holds the tone. `glass` is translucent and casts no shadow, `hidden` is not
 * drawn.
 */
export type Paint =
    | "red"
    | "orange"
    | "yellow"
    | "green"
    | "teal"
    | "blue"
    | "purple"
    | "pink"
    | "white"
    | "grey"
    | "dark"
    | "ground"
    | "glass"
    | "hidden";

/** The state of keys and of the touch joystick. Both axes are in the range -1 to 1. */
export interface Input {
    /** Right is positive. */
    x: number;
    /** Up, or forward, is positive. */
    y: number;
    /** Whether the action button (J, or the round touch button) is down. */
    action: boolean;
    /** Whether the user has steered since the scene began; scenes steer themselves before that. */
    used: boolean;
}

/** Draws lines and points that are no colliders. */
export interface Pen {
    line(from: Point, to: Point, paint: Paint): void;
    cross(at: Point, size: number, paint: Paint): void;
}

export interface Point {
    x: number;
    y: number;
    z?: number;
}

/** A colour can be given to a collider, or to a body with all its colliders. */
export interface Paintable {
    readonly handle: number;
    numColliders?: () => number;
    collider?: (index: number) => { readonly handle: number };
}

/** The material from which a scene builds itself. `R` is the engine's module, `W` its world. */
export interface SceneContext<R, W> {
    readonly RAPIER: R;
    readonly world: W;
    readonly random: Random;
    readonly input: Readonly<Input>;
    /** The current value of a parameter of the scene. */
    parameter<T extends ParameterValue>(name: string): T;
    /** Gives a body or a collider a colour. */
    paint(target: Paintable, paint: Paint): void;
}

/** A statement about the scene after a number of steps, which the tests check. */
export interface Claim {
    readonly text: string;
    readonly after: number;
    /** Returns whether the statement holds, or the reason why it does not. */
    check(): boolean | string;
}

/** The moving parts of a scene that was built. */
export interface SceneRun<Events = unknown, Hooks = unknown> {
    /** Runs before each step. `time` is the simulated time in seconds. */
    update?(time: number, step: number): void;
    /** Runs after each step. */
    after?(time: number, step: number): void;
    /** Draws additional lines for the current state. */
    draw?(pen: Pen): void;
    /** A short line of text for the picture. */
    caption?(): string;
    /** The point that the camera follows. */
    follow?(): Point;
    readonly events?: Events;
    readonly hooks?: Hooks;
    readonly claims?: readonly Claim[];
}

export interface Camera {
    /** Position of the eye; 2D scenes have none. */
    eye?: readonly [number, number, number];
    target: readonly [number, number, number];
    /** Visible height in metres, for 2D scenes. */
    height?: number;
}

export interface SceneDefinition<R, W> {
    readonly id: string;
    readonly title: string;
    /** One sentence of plain English. */
    readonly description: string;
    readonly group: string;
    readonly camera: Camera;
    readonly parameters?: Readonly<Record<string, Parameter>>;
    readonly gravity?: number;
    /** Whether arrow keys steer something. */
    readonly steered?: boolean;
    /** What the action button of a steered scene does. Without this word the scene has no such button. */
    readonly action?: string;
    /** Steps before the thumbnail is drawn. */
    readonly poster?: number;
    setup(context: SceneContext<R, W>): SceneRun | void;
}

/** The scene types of shared code, which does not depend on a package's typings. */
export type AnyScene = SceneDefinition<EngineModule, never>;
