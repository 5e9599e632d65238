// The page's address: `?scene=tower&engine=both&theme=light&debug=1&paused=1&steps=120`.

import type { EngineId } from "../core/engine.ts";
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
}

const STEPS_MAX = 10_000;

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
    };
}

/** Writes scene and engine into the address, so that it can be shared. */
export function writeLink(scene: string, engine: EngineMode): void {
    const address = new URL(location.href);
    address.searchParams.set("scene", scene);
    address.searchParams.set("engine", engine);
    address.searchParams.delete("steps");
    history.replaceState(null, "", address);
}
