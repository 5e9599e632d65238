// The live plot of step times, stages and counts.

import uPlot from "uplot";
import type { EngineModule, WorldLike } from "../core/engine.ts";
import { HISTORY, TIMINGS, type Stage } from "../core/stage.ts";
import type { Series } from "../core/series.ts";
import { Choice, el } from "./dom.ts";

type Mode = "time" | "stages" | "awake";

const MODES = [
    { value: "time", text: "Step", title: "Time of a step in milliseconds" },
    { value: "stages", text: "Stages", title: "Time of each stage of a step in milliseconds" },
    { value: "awake", text: "Awake", title: "Number of bodies that are awake" },
] as const;

const COLOURS = ["#5b9bf0", "#f0954c", "#7cc36e", "#a184ec", "#e5616a"] as const;
/** Milliseconds between two drawings of the plot. */
const INTERVAL = 150;
const HEIGHT = 150;
/** The plot shows this fraction of the values of a line. The first step of a scene, which is long, lies above it. */
const SHOWN = 0.95;

export class Plot<R extends EngineModule, W extends WorldLike> {
    readonly element: HTMLElement;
    private readonly place = el("div", { class: "plot" });
    private readonly legend = el("div", { class: "legend" });
    private readonly choice: Choice<Mode>;
    private mode: Mode = "time";
    private chart: uPlot | null = null;
    private stages: readonly Stage<R, W>[] = [];
    private drawn = 0;
    private readonly steps = Array.from({ length: HISTORY }, (_, index) => index - HISTORY);

    constructor() {
        this.choice = new Choice("Plot", MODES, (mode) => {
            this.mode = mode;
            this.rebuild();
        });
        this.element = el("section", { class: "plots", label: "Plot" }, this.choice.element, this.place, this.legend);
        new ResizeObserver(() => this.fit()).observe(this.place);
    }

    show(stages: readonly Stage<R, W>[]): void {
        this.stages = stages;
        this.rebuild();
    }

    /** The series of the lines. */
    private rows(): Series[] {
        const first = this.stages[0];
        if (this.mode === "stages" && first) return TIMINGS.map((name) => first.timings[name]);
        return this.stages.map((stage) => (this.mode === "time" ? stage.stepTimes : stage.awake));
    }

    private top(): number {
        return Math.max(0.1, ...this.rows().map((row) => row.percentile(this.mode === "awake" ? 1 : SHOWN)));
    }

    private names(): string[] {
        if (this.mode === "stages") return [...TIMINGS];
        return this.stages.map((stage) => stage.engine.label);
    }

    private rebuild(): void {
        this.choice.value = this.mode;
        for (const stage of this.stages) stage.world.profilerEnabled = this.mode === "stages";
        this.chart?.destroy();
        const names = this.names();
        const ink = getComputedStyle(document.documentElement).getPropertyValue("--muted").trim();
        const lines = getComputedStyle(document.documentElement).getPropertyValue("--line").trim();
        const unit = this.mode === "awake" ? "" : " ms";
        const axis = { stroke: ink, grid: { stroke: lines, width: 1 }, ticks: { show: false }, font: "11px system-ui" };
        this.chart = new uPlot(
            {
                width: Math.max(120, this.place.clientWidth),
                height: HEIGHT,
                legend: { show: false },
                cursor: { show: false },
                scales: { x: { time: false }, y: { range: () => [0, 1.2 * this.top()] } },
                axes: [
                    { ...axis, show: false },
                    { ...axis, size: 58, values: (_chart, ticks) => ticks.map((tick) => `${tick}${unit}`) },
                ],
                series: [
                    {},
                    ...names.map((label, index) => ({
                        label,
                        stroke: COLOURS[index % COLOURS.length] ?? COLOURS[0],
                        width: 1.5,
                        points: { show: false },
                    })),
                ],
            },
            this.data(),
            this.place,
        );
        this.writeLegend();
    }

    private fit(): void {
        this.chart?.setSize({ width: Math.max(120, this.place.clientWidth), height: HEIGHT });
    }

    private data(): uPlot.AlignedData {
        return [this.steps, ...this.rows().map((row) => row.padded())] as uPlot.AlignedData;
    }

    private values(): string[] {
        if (this.mode === "awake") return this.rows().map((row) => `${Math.round(row.mean(1))} bodies`);
        return this.rows().map((row) => `median ${row.percentile(0.5).toFixed(2)} ms, 99 % below ${row.percentile(0.99).toFixed(2)} ms`);
    }

    private writeLegend(): void {
        const values = this.values();
        this.legend.replaceChildren(
            ...this.names().map((name, index) => {
                const dot = el("i");
                dot.style.background = COLOURS[index % COLOURS.length] ?? COLOURS[0];
                return el("span", {}, dot, `${name} `, el("b", {}, values[index] ?? ""));
            }),
        );
    }

    /** Draws the plot anew, a few times a second. */
    update(now: number): void {
        if (now - this.drawn < INTERVAL || this.place.clientWidth === 0) return;
        this.drawn = now;
        this.chart?.setData(this.data());
        this.writeLegend();
    }
}
