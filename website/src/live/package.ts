// The npm package as an engine of the testbed. It is loaded when it is needed.

import { loadEngine, type Engine } from "@repository/testbed/src/core/engine";
import type { Rapier } from "@repository/testbed3d/src/rapier";

/** Loads the engine. Returns null where the page was built without the package. */
export async function loadPackage(): Promise<Engine<Rapier> | null> {
    const module: object = await import("rapier3d");
    return "World" in module ? loadEngine("own", module as Rapier) : null;
}
