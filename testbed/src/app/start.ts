// Loads the engines and starts the page.

import "uplot/dist/uPlot.min.css";
import "../ui/style.css";
import "../ui/joystick.css";
import type { Dimension } from "../core/dimension.ts";
import { loadEngine, type Engine, type EngineId, type EngineModule, type WorldLike } from "../core/engine.ts";
import type { SceneDefinition } from "../core/scene.ts";
import { el } from "../ui/dom.ts";
import { App } from "./app.ts";
import { readLink } from "./link.ts";

export interface StartOptions<R extends EngineModule, W extends WorldLike> {
    readonly dimension: Dimension<R, W>;
    readonly scenes: readonly SceneDefinition<R, W>[];
    /** The modules by engine; null for an engine that is not there. */
    readonly modules: Record<EngineId, (() => Promise<R | null>)>;
}

const NAMES: Record<EngineId, string> = { own: "The package of this repository", published: "The published package" };

/** Loads the engines. Of others, the page shows the reason. */
async function loadAll<R extends EngineModule>(modules: StartOptions<R, WorldLike>["modules"]): Promise<[Map<EngineId, Engine<R>>, Map<EngineId, string>]> {
    const engines = new Map<EngineId, Engine<R>>();
    const missing = new Map<EngineId, string>();
    for (const id of ["own", "published"] as const) {
        try {
            const module = await modules[id]();
            if (module) engines.set(id, await loadEngine(id, module));
            else missing.set(id, `${NAMES[id]} was not built. Build it with ./build_all.sh, then restart the server.`);
        } catch (error) {
            console.warn(`the engine "${id}" did not load`, error);
            missing.set(id, `${NAMES[id]} did not load. ${String(error)}`);
        }
    }
    return [engines, missing];
}

declare global {
    interface Window {
        /** The running page, for tests and for the console. */
        testbed?: unknown;
    }
}

export async function start<R extends EngineModule, W extends WorldLike>(options: StartOptions<R, W>): Promise<void> {
    const root = document.getElementById("app");
    if (!root) throw new Error("the page has no element #app");
    const [engines, missing] = await loadAll<R>(options.modules);
    if (engines.size === 0) {
        root.append(...[...missing.values()].map((reason) => el("p", { class: "about missing" }, reason)));
        return;
    }
    const { dimension, scenes } = options;
    const app = new App({ dimension, scenes, engines, missing, link: readLink(location.search), root });
    window.testbed = app;
    app.start();
}
