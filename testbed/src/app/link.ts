// The page's address: `?scene=tower&engine=both&set.count=20&gravity=3&theme=light&debug=1&paused=1&steps=120`.

import type { EngineId } from "../core/engine.ts";
import type { Parameter, ParameterValue } from "../core/scene.ts";
import { RANGES, type Settings } from "../core/settings.ts";
import type { ThemeName } from "../view/theme.ts";

/** The choice of engines: one of them, or both side by side. */
export type EngineMode = EngineId | "both";

export interface Link {
    scene: string | null;
    engine: EngineMode | null;
    theme: ThemeName | null;
    debug: boolean;
    paused: boolean;
    /** Steps that run before the first picture. */
    steps: number;
    /** Low detail for slow machines. */
    detail: "high" | "low";
    /** Values of the scene's parameters, and of the engine's settings. */
    parameters: Record<string, string>;
    settings: Partial<Settings>;
}

const STEPS_MAX = 10_000;
/** Begins the names of a scene's parameters. */
const PARAMETER = "set.";
const SETTINGS = ["gravity", "iterations", "rate"] as const;

function oneOf<T extends string>(value: string | null, options: readonly T[]): T | null {
    return options.find((option) => option === value) ?? null;
}

export function readLink(search: string): Link {
    const query = new URLSearchParams(search);
    const steps = Number(query.get("steps") ?? 0);
    return {
        scene: query.get("scene"),
        engine: oneOf(query.get("engine"), ["own", "published", "both"]),
        theme: oneOf(query.get("theme"), ["dark", "light"]),
        debug: query.get("debug") === "1",
        paused: query.get("paused") === "1",
        steps: Number.isFinite(steps) ? Math.min(STEPS_MAX, Math.max(0, Math.floor(steps))) : 0,
        detail: query.get("detail") === "low" ? "low" : "high",
        parameters: Object.fromEntries(
            [...query].flatMap(([name, value]) => (name.startsWith(PARAMETER) ? [[name.slice(PARAMETER.length), value]] : [])),
        ),
        settings: readSettings(query),
    };
}

function readSettings(query: URLSearchParams): Partial<Settings> {
    const found: Partial<Settings> = {};
    for (const name of SETTINGS) {
        const text = query.get(name);
        const [min, max] = RANGES[name];
        if (text !== null && Number(text) >= min && Number(text) <= max) found[name] = Number(text);
    }
    return found;
}

/** The value of a parameter in an address, or undefined if the parameter has no such value. */
function parse(definition: Parameter, text: string): ParameterValue | undefined {
    if ("options" in definition) return definition.options.find((option) => option === text);
    if (!("min" in definition)) return text === "true" || text === "false" ? text === "true" : undefined;
    const number = Number(text);
    return number >= definition.min && number <= definition.max ? number : undefined;
}

/** Writes the values of an address into a scene's parameters. Others keep their defaults. */
export function applyParameters(
    texts: Readonly<Record<string, string>>,
    definitions: Readonly<Record<string, Parameter>>,
    values: Record<string, ParameterValue>,
): void {
    for (const [name, definition] of Object.entries(definitions)) {
        const text = texts[name];
        const value = text === undefined ? undefined : parse(definition, text);
        if (value !== undefined) values[name] = value;
    }
}

/** Writes scene, engine and changed values into the address, so that it can be shared. */
export function writeLink(scene: string, engine: EngineMode, changed: Readonly<Record<string, ParameterValue>>): void {
    const address = new URL(location.href);
    const query = address.searchParams;
    for (const name of [...query.keys()]) {
        if (name === "steps" || name.startsWith(PARAMETER) || SETTINGS.some((setting) => setting === name)) query.delete(name);
    }
    query.set("scene", scene);
    query.set("engine", engine);
    for (const [name, value] of Object.entries(changed)) query.set(name, String(value));
    history.replaceState(null, "", address);
}

/** The values that differ from their defaults, by name in the address. */
export function changedValues(
    settings: Settings,
    usual: Settings,
    parameters: Readonly<Record<string, ParameterValue>>,
    defaults: Readonly<Record<string, ParameterValue>>,
): Record<string, ParameterValue> {
    const changed: Record<string, ParameterValue> = {};
    for (const [name, value] of Object.entries(parameters)) if (value !== defaults[name]) changed[PARAMETER + name] = value;
    for (const name of SETTINGS) if (settings[name] !== usual[name]) changed[name] = settings[name];
    return changed;
}
