// The sheet of keys and gestures.

import { el } from "./dom.ts";

const KEYS: readonly (readonly [string, string])[] = [
    ["P", "Run or pause"],
    ["N", "One step"],
    ["R", "Restart the scene"],
    ["S", "Speed: full, a half, a quarter, a tenth"],
    ["Space", "Throw a ball at the pointer"],
    ["D", "Debug lines"],
    ["C", "Reset the camera"],
    ["E", "Next engine, then both side by side"],
    ["T / B", "Take a snapshot, go back to it"],
    ["[ and ]", "Previous and next scene"],
    ["/", "Search scenes"],
    ["L", "Dark or light"],
    ["Arrows, W A X", "Steer cars and characters; J jumps or brakes"],
    ["?", "This sheet"],
];

const GESTURES: readonly (readonly [string, string])[] = [
    ["Drag a body", "Pull it with a spring"],
    ["Double click", "Throw a ball there"],
    ["Drag the ground", "Orbit (3D) or pan (2D)"],
    ["Right drag, two fingers", "Pan"],
    ["Wheel, pinch", "Zoom"],
];

function table(rows: readonly (readonly [string, string])[]): HTMLElement {
    return el("dl", {}, ...rows.flatMap(([key, text]) => [el("dt", {}, key), el("dd", {}, text)]));
}

export function helpSheet(): HTMLDialogElement {
    const close = el("button", { type: "button", class: "close" }, "Close");
    const dialog = el(
        "dialog",
        { class: "help", label: "Keys and gestures" },
        el("h2", {}, "Keys"),
        table(KEYS),
        el("h2", {}, "Pointer"),
        table(GESTURES),
        close,
    );
    close.addEventListener("click", () => dialog.close());
    dialog.addEventListener("click", (event) => {
        if (event.target === dialog) dialog.close();
    });
    return dialog;
}
