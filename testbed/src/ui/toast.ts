// A short message that disappears.

import { el } from "./dom.ts";

const DURATION = 3500;

export class Toast {
    readonly element = el("div", { class: "toast", role: "status", hidden: "" });
    private timer = 0;

    show(text: string): void {
        this.element.textContent = text;
        this.element.hidden = false;
        window.clearTimeout(this.timer);
        this.timer = window.setTimeout(() => {
            this.element.hidden = true;
        }, DURATION);
    }
}
