// The npm packages as engines of the testbeds. Each is loaded when it is needed.

import { loadEngine, type Engine } from "@repository/testbed/src/core/engine";
import type { Rapier as Rapier2 } from "@repository/testbed2d/src/rapier";
import type { Rapier as Rapier3 } from "@repository/testbed3d/src/rapier";
import type { AnyPlayer, PlayerOptions } from "./player";

export type DimensionName = "3d" | "2d";

/** Loads the 3D engine. Returns null where the page was built without the package. */
export async function loadPackage(): Promise<Engine<Rapier3> | null> {
    const module: object = await import("rapier3d");
    return "World" in module ? loadEngine("own", module as Rapier3) : null;
}

async function loadFlatPackage(): Promise<Engine<Rapier2> | null> {
    const module: object = await import("rapier2d");
    return "World" in module ? loadEngine("own", module as Rapier2) : null;
}

/** Loads an engine and its scenes, and starts a player. Returns null where the page was built without the package. */
export async function startPlayer(dimension: DimensionName, options: PlayerOptions): Promise<AnyPlayer | null> {
    if (dimension === "2d") {
        const [engine, { Player }, { DIMENSION_2 }, { SCENES }] = await Promise.all([
            loadFlatPackage(),
            import("./player"),
            import("@repository/testbed2d/src/dimension"),
            import("@repository/testbed2d/src/scenes/index"),
        ]);
        return engine === null ? null : new Player(DIMENSION_2, engine, SCENES, options);
    }
    const [engine, { Player }, { DIMENSION_3 }, { SCENES }] = await Promise.all([
        loadPackage(),
        import("./player"),
        import("@repository/testbed3d/src/dimension"),
        import("@repository/testbed3d/src/scenes/index"),
    ]);
    return engine === null ? null : new Player(DIMENSION_3, engine, SCENES, options);
}
