// Elements of the page, without a framework.

type Child = Node | string;

interface Attributes {
    class?: string;
    title?: string;
    label?: string;
    [name: string]: string | undefined;
}

/** Creates an element. `label` becomes the accessible name. */
export function el<K extends keyof HTMLElementTagNameMap>(
    tag: K,
    attributes: Attributes = {},
    ...children: Child[]
): HTMLElementTagNameMap[K] {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (value === undefined) continue;
        element.setAttribute(name === "label" ? "aria-label" : name, value);
    }
    element.append(...children);
    return element;
}

/** A button with an icon. */
export function iconButton(icon: string, label: string, onClick: () => void, classes = ""): HTMLButtonElement {
    const button = el("button", { class: `icon ${classes}`, title: label, label, type: "button" });
    button.innerHTML = icon;
    button.addEventListener("click", (event) => {
        // After a click by pointer the keys go to the scene again.
        if (event.detail > 0) button.blur();
        onClick();
    });
    return button;
}

/** A row of buttons of which one is chosen. */
export class Choice<T extends string> {
    readonly element: HTMLElement;
    private readonly buttons = new Map<T, HTMLButtonElement>();

    constructor(label: string, options: readonly { value: T; text: string; title: string }[], choose: (value: T) => void) {
        this.element = el("div", { class: "choice", role: "group", label });
        for (const { value, text, title } of options) {
            const button = el("button", { type: "button", title, "data-value": value }, text);
            button.addEventListener("click", () => choose(value));
            this.buttons.set(value, button);
            this.element.append(button);
        }
    }

    set value(chosen: T) {
        for (const [value, button] of this.buttons) button.setAttribute("aria-pressed", String(value === chosen));
    }
}
