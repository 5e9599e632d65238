// Colours of the picture in both themes. The style sheet holds the colours of the page.

import { Color } from "three";
import type { Paint } from "../core/scene.ts";

export type ThemeName = "dark" | "light";

export interface Theme {
    readonly name: ThemeName;
    readonly sky: Color;
    readonly ground: Color;
    readonly grid: Color;
    /** The backdrop's colour overhead; `sky` is the one at the horizon. */
    readonly zenith: Color;
    /** Colours of the light from above and from below. */
    readonly room: { sky: Color; ground: Color; intensity: number };
    readonly sun: { color: Color; intensity: number };
    readonly shadow: number;
    /** Colour towards which sleeping bodies fade. */
    readonly asleep: Color;
    /** Factor of the engine's colours of debug lines, which are bright: a bright floor hides them. */
    readonly debug: number;
    /** Factor of fill colours at outlines (2D) and edges of boxes (3D). */
    readonly edge: number;
    readonly paints: Readonly<Record<Paint, Color>>;
    /** The tones of dynamic bodies without a colour of their own. */
    readonly cycle: readonly Color[];
}

const PAINTS_DARK: Record<Paint, string> = {
    red: "#e5616a",
    orange: "#f0954c",
    yellow: "#f2c75c",
    green: "#7cc36e",
    teal: "#45b8ac",
    blue: "#5b9bf0",
    purple: "#a184ec",
    pink: "#ea85b8",
    white: "#e8edf4",
    grey: "#8a95a5",
    dark: "#566378",
    ground: "#485568",
    glass: "#a9c4e6",
    hidden: "#000000",
};

const PAINTS_LIGHT: Record<Paint, string> = {
    ...PAINTS_DARK,
    red: "#dd4c58",
    orange: "#ee8537",
    yellow: "#edb834",
    green: "#5fb053",
    teal: "#2ba699",
    blue: "#4287ea",
    purple: "#8d6ce3",
    pink: "#e26ca8",
    white: "#fbfcfe",
    grey: "#98a3b3",
    dark: "#4a5567",
    ground: "#c9d2dd",
    glass: "#7e9cc4",
};

const CYCLE: readonly Paint[] = ["blue", "teal", "yellow", "orange", "purple", "green", "red"];

function colours(paints: Record<Paint, string>): Record<Paint, Color> {
    const entries = Object.entries(paints).map(([name, value]) => [name, new Color(value)]);
    return Object.fromEntries(entries) as Record<Paint, Color>;
}

function theme(name: ThemeName): Theme {
    const dark = name === "dark";
    const paints = colours(dark ? PAINTS_DARK : PAINTS_LIGHT);
    return {
        name,
        sky: new Color(dark ? "#171d27" : "#eaf0f6"),
        ground: paints.ground,
        grid: new Color(dark ? "#66758c" : "#a9b5c4"),
        zenith: new Color(dark ? "#0b0f16" : "#bdd3ec"),
        room: {
            sky: new Color(dark ? "#c3d4f0" : "#ffffff"),
            ground: new Color(dark ? "#59606d" : "#b9c1cc"),
            intensity: dark ? 0.55 : 0.42,
        },
        sun: { color: new Color(dark ? "#fff3e0" : "#fff7ea"), intensity: dark ? 3 : 2.6 },
        shadow: dark ? 0.9 : 0.85,
        asleep: new Color(dark ? "#5a6473" : "#c3cad4"),
        debug: dark ? 1 : 0.3,
        edge: dark ? 0.62 : 0.72,
        paints,
        cycle: CYCLE.map((paint) => paints[paint]),
    };
}

export const THEMES: Readonly<Record<ThemeName, Theme>> = { dark: theme("dark"), light: theme("light") };
