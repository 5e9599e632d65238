// Keyboard shortcuts, and the keys that steer.

import type { Input } from "../core/scene.ts";

const STEERING: Readonly<Record<string, { axis: "x" | "y"; sign: 1 | -1 }>> = {
    ArrowLeft: { axis: "x", sign: -1 },
    ArrowRight: { axis: "x", sign: 1 },
    ArrowUp: { axis: "y", sign: 1 },
    ArrowDown: { axis: "y", sign: -1 },
    KeyA: { axis: "x", sign: -1 },
    KeyW: { axis: "y", sign: 1 },
    KeyX: { axis: "y", sign: -1 },
};
const ACTION = "KeyJ";

/** Listens to keys of the page, or of an element in focus. `shortcuts` maps the key's character or code to an action. */
export function listenToKeys(input: Input, shortcuts: ReadonlyMap<string, () => void>, target: GlobalEventHandlers = window): void {
    const down = new Set<string>();
    const steer = (): void => {
        input.x = 0;
        input.y = 0;
        for (const code of down) {
            const way = STEERING[code];
            if (way) input[way.axis] = Math.max(-1, Math.min(1, input[way.axis] + way.sign));
        }
        input.action = down.has(ACTION);
    };
    target.addEventListener("keydown", (event) => {
        const typing =
            event.target instanceof HTMLInputElement ||
            event.target instanceof HTMLSelectElement ||
            // The space bar presses a focused button.
            (event.target instanceof HTMLButtonElement && event.key === " ");
        if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.code in STEERING || event.code === ACTION) {
            down.add(event.code);
            input.used = true;
            steer();
            event.preventDefault();
            return;
        }
        const action = shortcuts.get(event.key.toLowerCase()) ?? shortcuts.get(event.code);
        if (!action) return;
        event.preventDefault();
        if (!event.repeat || event.key.toLowerCase() === "n") action();
    });
    target.addEventListener("keyup", (event) => {
        if (down.delete(event.code)) steer();
    });
    window.addEventListener("blur", () => {
        down.clear();
        steer();
    });
}
