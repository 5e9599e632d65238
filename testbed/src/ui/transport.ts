// The bar with the buttons of time: restart, run, step, speed.

import { el, iconButton } from "./dom.ts";
import { ICONS } from "./icons.ts";

export const SPEEDS = [1, 0.5, 0.25, 0.1] as const;

export interface TransportActions {
    restart(): void;
    toggle(): void;
    step(): void;
    speed(value: number): void;
    throwBall(): void;
    debug(): void;
}

export class Transport {
    readonly element: HTMLElement;
    private readonly play: HTMLButtonElement;
    private readonly speedButton: HTMLButtonElement;
    private readonly debugButton: HTMLButtonElement;
    private speed = 1;

    constructor(actions: TransportActions) {
        this.play = iconButton(ICONS.pause, "Pause (P)", actions.toggle, "primary");
        this.play.dataset["action"] = "toggle";
        this.speedButton = el("button", { class: "speed", type: "button", title: "Speed (S)", label: "Speed" }, "1×");
        this.speedButton.addEventListener("click", () => actions.speed(this.nextSpeed()));
        this.debugButton = iconButton(ICONS.debug, "Debug lines (D)", actions.debug);
        this.debugButton.dataset["action"] = "debug";
        this.element = el(
            "div",
            { class: "transport", role: "toolbar", label: "Time" },
            iconButton(ICONS.restart, "Restart (R)", actions.restart),
            this.play,
            iconButton(ICONS.step, "One step (N)", actions.step),
            this.speedButton,
            el("span", { class: "rule" }),
            iconButton(ICONS.ball, "Throw a ball (Space)", actions.throwBall),
            this.debugButton,
        );
    }

    nextSpeed(): number {
        const index = SPEEDS.findIndex((speed) => speed === this.speed);
        return SPEEDS[(index + 1) % SPEEDS.length] ?? 1;
    }

    show(running: boolean, speed: number, debug: boolean): void {
        this.speed = speed;
        this.play.innerHTML = running ? ICONS.pause : ICONS.play;
        const label = running ? "Pause (P)" : "Run (P)";
        this.play.title = label;
        this.play.setAttribute("aria-label", label);
        this.speedButton.textContent = speed === 1 ? "1×" : `1/${Math.round(1 / speed)}`;
        this.speedButton.classList.toggle("active", speed !== 1);
        this.debugButton.setAttribute("aria-pressed", String(debug));
    }
}
