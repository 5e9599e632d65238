// The sheet with the source of a scene.

import { el } from "./dom.ts";

export class SourceSheet {
    private readonly title = el("h2");
    private readonly code = el("code");
    readonly element: HTMLDialogElement;

    constructor() {
        const close = el("button", { type: "button", class: "close" }, "Close");
        this.element = el("dialog", { class: "help source", label: "Source" }, this.title, el("pre", { tabindex: "0" }, this.code), close);
        close.addEventListener("click", () => this.element.close());
        this.element.addEventListener("click", (event) => {
            if (event.target === this.element) this.element.close();
        });
    }

    show(file: string, source: string): void {
        this.title.textContent = file;
        this.code.textContent = source;
        this.element.showModal();
    }
}
