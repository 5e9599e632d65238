// The frame of the page: the bar on top, the panels at the sides, sheets on a phone.

import type { EngineId } from "../core/engine.ts";
import { Choice, el, iconButton } from "./dom.ts";
import { ICONS } from "./icons.ts";

type EngineMode = EngineId | "both";

export interface LayoutParts {
    readonly brand: string;
    readonly gallery: HTMLElement;
    readonly side: readonly HTMLElement[];
    readonly over: readonly HTMLElement[];
    readonly help: HTMLDialogElement;
    /** The engines that are not there, and the reasons. */
    readonly missing: ReadonlyMap<EngineId, string>;
    chooseEngine(mode: EngineMode): void;
    toggleTheme(): void;
    share(): void;
    viewSource(): void;
}

const MODES = [
    { value: "own", text: "Ours", title: "This engine" },
    { value: "published", text: "@dimforge", title: "The published package with the same API" },
    { value: "both", text: "Both", title: "Both engines side by side on the same scene" },
] as const;

export class Layout {
    readonly canvas = el("canvas", { label: "Scene", tabindex: "0" });
    readonly elements: readonly HTMLElement[];
    private readonly now = el("div", { class: "now" });
    private readonly about = el("p", { class: "about" });
    private readonly choice: Choice<EngineMode>;
    private readonly side: HTMLElement;

    constructor(private readonly parts: LayoutParts) {
        this.choice = new Choice("Engine", MODES, (mode) => parts.chooseEngine(mode));
        for (const button of this.choice.element.querySelectorAll("button")) this.disable(button);
        const reasons = [...parts.missing.values()].map((reason) => el("p", { class: "about missing" }, reason));
        this.side = el("aside", { class: "right", label: "Settings" }, this.about, this.links(), ...reasons, ...parts.side);
        const stage = el("main", { class: "stage" }, this.canvas, ...parts.over);
        stage.addEventListener("pointerdown", (event) => {
            if (event.target === this.canvas) this.closeSheets();
        });
        this.elements = [this.bar(), parts.gallery, stage, this.side, parts.help];
    }

    /** An engine that is not there cannot be chosen. */
    private disable(button: HTMLButtonElement): void {
        const mode = button.dataset["value"];
        const { missing } = this.parts;
        const reason = mode === "both" ? [...missing.values()][0] : missing.get(mode as EngineId);
        button.disabled = reason !== undefined;
        if (reason !== undefined) button.title = reason;
    }

    private bar(): HTMLElement {
        const { parts } = this;
        return el(
            "header",
            { class: "top" },
            iconButton(ICONS.scenes, "Scenes", () => this.toggle(parts.gallery), "only-phone scenes"),
            el("div", { class: "brand" }, "Rapier ", el("span", {}, parts.brand)),
            this.now,
            this.choice.element,
            iconButton(ICONS.theme, "Dark or light (L)", () => parts.toggleTheme(), "only-desktop"),
            iconButton(ICONS.help, "Keys and gestures (?)", () => parts.help.showModal(), "only-desktop"),
            iconButton(ICONS.settings, "Settings", () => this.toggle(this.side), "only-phone settings"),
        );
    }

    set engine(mode: EngineMode) {
        this.choice.value = mode;
    }

    private links(): HTMLElement {
        const share = el("button", { type: "button" }, "Share");
        share.addEventListener("click", () => this.parts.share());
        const source = el("button", { type: "button" }, "View source");
        source.addEventListener("click", () => this.parts.viewSource());
        return el("div", { class: "links" }, share, source);
    }

    describe(title: string, description: string): void {
        document.title = `${title} – Rapier ${this.parts.brand}`;
        this.now.replaceChildren(title);
        this.about.replaceChildren(description);
    }

    private toggle(sheet: HTMLElement): void {
        const open = !sheet.classList.contains("open");
        this.closeSheets();
        sheet.classList.toggle("open", open);
    }

    openGallery(search: HTMLInputElement): void {
        this.closeSheets();
        this.parts.gallery.classList.add("open");
        search.focus();
    }

    closeSheets(): void {
        this.parts.gallery.classList.remove("open");
        this.side.classList.remove("open");
    }
}
