// The list of scenes, with search and groups.

import type { EngineModule } from "../core/engine.ts";
import type { SceneDefinition } from "../core/scene.ts";
import { el } from "./dom.ts";

interface Card {
    readonly element: HTMLButtonElement;
    readonly group: HTMLElement;
    readonly words: string;
}

/** Shows a strip of pictures, one after the other, while the pointer is on a card. */
function moveOnHover(picture: HTMLElement, strip: string): void {
    const moving = el("span", { class: "moving" });
    picture.addEventListener("pointerenter", () => {
        moving.style.backgroundImage = `url("${strip}")`;
        picture.append(moving);
    });
    picture.addEventListener("pointerleave", () => moving.remove());
}

export class Gallery<R extends EngineModule, W> {
    readonly element: HTMLElement;
    readonly search: HTMLInputElement;
    private readonly cards = new Map<string, Card>();
    private readonly groups: HTMLElement[] = [];
    private readonly empty: HTMLElement;

    constructor(
        private readonly scenes: readonly SceneDefinition<R, W>[],
        thumbnails: string,
        private readonly open: (id: string) => void,
    ) {
        this.search = el("input", { type: "search", placeholder: `Search ${scenes.length} scenes`, label: "Search scenes" });
        this.search.addEventListener("input", () => this.filter());
        this.search.addEventListener("keydown", (event) => {
            if (event.key === "Enter") this.openFirst();
        });
        this.empty = el("p", { class: "empty", hidden: "" }, "No scene has all of these words.");
        const list = el("div", { class: "list" }, this.empty);
        for (const group of new Set(scenes.map((scene) => scene.group))) list.append(this.section(group, thumbnails));
        this.element = el("nav", { class: "gallery", label: "Scenes" }, el("div", { class: "search" }, this.search), list);
    }

    private section(group: string, thumbnails: string): HTMLElement {
        const section = el("section", {}, el("h2", {}, group));
        this.groups.push(section);
        for (const scene of this.scenes.filter((one) => one.group === group)) {
            section.append(this.card(scene, section, thumbnails));
        }
        return section;
    }

    private card(scene: SceneDefinition<R, W>, group: HTMLElement, thumbnails: string): HTMLElement {
        const image = el("img", { src: `${thumbnails}/${scene.id}.webp`, alt: "", loading: "lazy", width: "96", height: "60" });
        image.addEventListener("error", () => image.classList.add("missing"));
        const picture = el("span", { class: "picture" }, image);
        moveOnHover(picture, `${thumbnails}/moving/${scene.id}.webp`);
        const text = el("span", { class: "text" }, el("strong", {}, scene.title), el("small", {}, scene.description));
        const element = el("button", { class: "card", type: "button", "data-scene": scene.id }, picture, text);
        element.addEventListener("click", () => this.open(scene.id));
        const words = `${scene.title} ${scene.description} ${scene.group} ${scene.id}`.toLowerCase();
        this.cards.set(scene.id, { element, group, words });
        return element;
    }

    private filter(): void {
        const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
        let found = 0;
        for (const card of this.cards.values()) {
            const shown = words.every((word) => card.words.includes(word));
            card.element.hidden = !shown;
            if (shown) found += 1;
        }
        for (const group of this.groups) {
            group.hidden = [...this.cards.values()].every((card) => card.group !== group || card.element.hidden);
        }
        this.empty.hidden = found > 0;
    }

    private openFirst(): void {
        for (const [id, card] of this.cards) {
            if (card.element.hidden) continue;
            this.open(id);
            return;
        }
    }

    /** Marks the scene that runs. */
    select(id: string): void {
        for (const [other, { element }] of this.cards) {
            const current = other === id;
            element.toggleAttribute("aria-current", current);
            if (current) element.scrollIntoView({ block: "nearest" });
        }
    }
}
