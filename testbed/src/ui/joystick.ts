// The joystick and the action button for touch screens.

import type { Input } from "../core/scene.ts";
import { el } from "./dom.ts";

/** A scene, as far as the joystick is concerned. */
export interface Steered {
    readonly steered?: boolean;
    readonly action?: string;
}

const REACH = 42;

export class Joystick {
    readonly element: HTMLElement;
    private readonly action = el("button", { class: "action", type: "button" });

    constructor(input: Input) {
        const knob = el("div", { class: "knob" });
        const stick = el("div", { class: "stick", role: "group", label: "Joystick" }, knob);
        const { action } = this;
        this.element = el("div", { class: "joystick", hidden: "" }, stick, action);
        const move = (event: PointerEvent): void => {
            const box = stick.getBoundingClientRect();
            const dx = event.clientX - box.left - box.width / 2;
            const dy = event.clientY - box.top - box.height / 2;
            const scale = Math.min(1, REACH / Math.max(1, Math.hypot(dx, dy)));
            input.x = (dx * scale) / REACH;
            input.y = (-dy * scale) / REACH;
            input.used = true;
            knob.style.transform = `translate(${dx * scale}px, ${dy * scale}px)`;
        };
        stick.addEventListener("pointerdown", (event) => {
            stick.setPointerCapture(event.pointerId);
            move(event);
        });
        stick.addEventListener("pointermove", (event) => {
            if (stick.hasPointerCapture(event.pointerId)) move(event);
        });
        const release = (): void => {
            input.x = 0;
            input.y = 0;
            knob.style.transform = "";
        };
        stick.addEventListener("pointerup", release);
        stick.addEventListener("pointercancel", release);
        action.addEventListener("pointerdown", () => {
            input.action = true;
            input.used = true;
        });
        for (const name of ["pointerup", "pointercancel", "pointerleave"]) {
            action.addEventListener(name, () => {
                input.action = false;
            });
        }
    }

    /** Shows the joystick on touch screens, and the button with the word for its action. */
    show({ steered = false, action }: Steered): void {
        this.action.textContent = action ?? "";
        this.action.hidden = action === undefined;
        this.element.hidden = !(steered && matchMedia("(pointer: coarse)").matches);
    }
}
