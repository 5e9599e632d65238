// Colours of programs. Each has a contrast of at least 4.5 to its background, marked lines included.

import type { PrismTheme } from "prism-react-renderer";

interface Palette {
    readonly plain: string;
    readonly background: string;
    readonly comment: string;
    readonly keyword: string;
    readonly name: string;
    readonly type: string;
    readonly value: string;
    readonly text: string;
}

function theme({ plain, background, comment, keyword, name, type, value, text }: Palette): PrismTheme {
    return {
        plain: { color: plain, backgroundColor: background },
        styles: [
            { types: ["comment", "prolog", "doctype", "cdata"], style: { color: comment, fontStyle: "italic" } },
            { types: ["keyword", "tag", "atrule", "attr-name", "important"], style: { color: keyword } },
            { types: ["function", "function-definition", "macro", "property", "key"], style: { color: name } },
            { types: ["class-name", "type-definition", "table"], style: { color: type } },
            { types: ["number", "boolean", "constant", "symbol", "lifetime-annotation"], style: { color: value } },
            { types: ["string", "char", "attr-value", "regex"], style: { color: text } },
        ],
    };
}

export const LIGHT = theme({
    plain: "#1f2733",
    background: "#f4f7fb",
    comment: "#566275",
    keyword: "#a8203a",
    name: "#5b3bb0",
    type: "#8a4300",
    value: "#0b55a8",
    text: "#14663c",
});

export const DARK = theme({
    plain: "#e3e9f2",
    background: "#1a212c",
    comment: "#97a5ba",
    keyword: "#ff8f9c",
    name: "#c9b1ff",
    type: "#f5b878",
    value: "#8cc4ff",
    text: "#8fdcae",
});
