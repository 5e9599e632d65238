// The panel of parameters: the engine's settings, the scene's own, snapshots.

import GUI from "lil-gui";
import type { Parameter, ParameterValue } from "../core/scene.ts";
import { RANGES, type Settings } from "../core/settings.ts";
import { el } from "./dom.ts";

export interface PanelActions {
    /** A parameter of the scene changed. */
    changed(live: boolean): void;
    takeSnapshot(): void;
    restoreSnapshot(): void;
    /** Back to the scene's own values. */
    reset(): void;
}

export class Panel {
    readonly element = el("div", { class: "panel-gui" });
    private gui: GUI | null = null;

    constructor(private readonly actions: PanelActions) {}

    /** Builds the panel for a scene. */
    show(settings: Settings, definitions: Readonly<Record<string, Parameter>>, values: Record<string, ParameterValue>): void {
        this.gui?.destroy();
        this.gui = new GUI({ container: this.element, title: "Parameters", width: 10 });
        this.gui.domElement.style.width = "100%";
        if (Object.keys(definitions).length > 0) this.addScene(this.gui, definitions, values);
        const engine = this.gui.addFolder("Engine");
        engine.add(settings, "gravity", ...RANGES.gravity, 0.01).name("Gravity (m/s²)");
        engine.add(settings, "iterations", ...RANGES.iterations, 1).name("Solver iterations");
        engine.add(settings, "rate", ...RANGES.rate, 10).name("Steps per second");
        engine.onFinishChange(() => this.actions.changed(true));
        const snapshots = this.gui.addFolder("Snapshot");
        snapshots.add({ take: () => this.actions.takeSnapshot() }, "take").name("Take");
        snapshots.add({ restore: () => this.actions.restoreSnapshot() }, "restore").name("Restore");
        this.gui.add({ reset: () => this.actions.reset() }, "reset").name("Reset parameters");
    }

    private addScene(gui: GUI, definitions: Readonly<Record<string, Parameter>>, values: Record<string, ParameterValue>): void {
        const folder = gui.addFolder("Scene");
        for (const [name, parameter] of Object.entries(definitions)) {
            const controller =
                "options" in parameter
                    ? folder.add(values, name, [...parameter.options])
                    : "min" in parameter
                      ? folder.add(values, name, parameter.min, parameter.max, parameter.step)
                      : folder.add(values, name);
            controller.name(parameter.label);
            const live = parameter.live === true;
            if (live) controller.onChange(() => this.actions.changed(true));
            else controller.onFinishChange(() => this.actions.changed(false));
        }
    }
}
