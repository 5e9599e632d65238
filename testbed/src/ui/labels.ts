// Text over each viewport: engine, step, time, counts, caption, and the hash on request.

import type { EngineModule, WorldLike } from "../core/engine.ts";
import type { Stage } from "../core/stage.ts";
import type { Viewport } from "../view/picture.ts";
import { el } from "./dom.ts";

/** Milliseconds between two updates of the text. */
const INTERVAL = 120;

interface Label {
    readonly box: HTMLElement;
    readonly numbers: HTMLElement;
    readonly hash: HTMLElement;
    readonly caption: HTMLElement;
}

export class Labels<R extends EngineModule, W extends WorldLike> {
    readonly element = el("div", { class: "labels" });
    private labels: Label[] = [];
    private stages: readonly Stage<R, W>[] = [];
    private written = 0;
    /** Whether the hash is shown: it visits the whole world. */
    private hashed = false;

    show(stages: readonly Stage<R, W>[]): void {
        this.stages = stages;
        this.labels = stages.map((stage) => {
            const numbers = el("span", { class: "numbers" });
            const hash = el("button", { class: "hash", type: "button", title: "The hash of the world's state" }, "hash");
            hash.hidden = stage.hash() === null;
            hash.addEventListener("click", () => {
                this.hashed = !this.hashed;
                this.written = 0;
            });
            const caption = el("span", { class: "caption" });
            const box = el("div", { class: "label" }, el("strong", {}, stage.engine.label), numbers, hash, caption);
            return { box, numbers, hash, caption };
        });
        this.element.replaceChildren(...this.labels.map(({ box }) => box));
        this.written = 0;
    }

    update(now: number, viewports: readonly Viewport[]): void {
        if (now - this.written < INTERVAL) return;
        this.written = now;
        this.labels.forEach(({ box, numbers, hash, caption }, index) => {
            const stage = this.stages[index];
            const viewport = viewports[index];
            if (!stage || !viewport) return;
            box.style.left = `${viewport.left}px`;
            box.style.top = `${viewport.top}px`;
            const { bodies, joints } = stage.counts();
            const parts = [`step ${stage.steps}`, `${stage.stepTimes.mean(30).toFixed(2)} ms`, `${bodies} bodies`];
            if (joints > 0) parts.push(`${joints} ${joints === 1 ? "joint" : "joints"}`);
            numbers.textContent = parts.join(" · ");
            hash.textContent = this.hashed ? `hash ${stage.hash()}` : "hash";
            hash.setAttribute("aria-pressed", String(this.hashed));
            caption.textContent = stage.run.caption?.() ?? "";
        });
    }
}
