// Loads the engines and starts the page.

import "uplot/dist/uPlot.min.css";
import "../ui/style.css";
import "../ui/joystick.css";
import "../ui/moving.css";
import type { Dimension } from "../core/dimension.ts";
import { loadEngine, type Engine, type EngineId, type EngineModule, type WorldLike } from "../core/engine.ts";
import type { SceneDefinition } from "../core/scene.ts";
import { el } from "../ui/dom.ts";
import { App } from "./app.ts";
import { scenesOf } from "../../tools/sources.mjs";
import { readLink } from "./link.ts";

export interface StartOptions<R extends EngineModule, W extends WorldLike> {
    readonly dimension: Dimension<R, W>;
    readonly scenes: readonly SceneDefinition<R, W>[];
    /** The modules by engine; null for an engine that is not there. */
    readonly modules: Record<EngineId, (() => Promise<R | null>)>;
    /** Loads the text of files of scenes, by path. */
    readonly sources: Readonly<Record<string, () => Promise<string>>>;
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

/** The page without this repository's package: the reasons, and a way to the other engine. */
function refusal(reasons: readonly string[], published: boolean): HTMLElement {
    const address = new URL(location.href);
    address.searchParams.set("engine", "published");
    const other = el("a", { href: address.href }, "Show the scenes with the published package instead");
    const lines = reasons.map((reason) => el("p", { class: "about missing" }, reason));
    return el("main", { class: "refusal" }, el("h1", {}, "The engine did not load"), ...lines, ...(published ? [other] : []));
}

/** Finds a scene in the files of scenes. */
async function find(sources: Readonly<Record<string, () => Promise<string>>>, id: string): Promise<{ file: string; source: string }> {
    for (const [file, load] of Object.entries(sources)) {
        const found = scenesOf(await load()).find((scene) => scene.id === id);
        if (found !== undefined) return { file: file.replace(/^\.\//, "src/"), source: found.source };
    }
    throw new Error(`no file has the scene ${id}`);
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
    const link = readLink(location.search);
    if (!engines.has("own") && !(link.engine === "published" && engines.has("published"))) {
        root.append(refusal([...missing.values()], engines.has("published")));
        return;
    }
    const { dimension, scenes, sources } = options;
    const findSource = (id: string) => find(sources, id);
    const app = new App({ dimension, scenes, engines, missing, link, root, findSource });
    window.testbed = app;
    app.start();
}
