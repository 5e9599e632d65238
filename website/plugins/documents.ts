// Renders the repository's documents without a second copy: rustdoc's hidden lines disappear, and links that leave
// `docs/` lead to the repository's file view.

import { dirname, join, relative } from "node:path";
import type { Code, Link, PhrasingContent, Root } from "mdast";
import { visit } from "unist-util-visit";
import { ROOT, fileView } from "./repository";

interface File {
    readonly path: string;
}

/** Removes the lines that rustdoc compiles and does not show. */
export function withoutHiddenLines(code: string): string {
    return code
        .split("\n")
        .filter((line) => !/^\s*#(\s|$)/.test(line))
        .map((line) => line.replace(/^(\s*)##/, "$1#"))
        .join("\n")
        .trim();
}

/** Returns the path of a link's target in the repository, if the target is outside `docs/`. */
function outside(file: string, url: string): string | undefined {
    if (/^(\w+:|#|\/)/.test(url)) return undefined;
    const path = relative(ROOT, join(dirname(file), url.replace(/#.*/, "")));
    return path.startsWith("docs/") && path.includes(".") ? undefined : path;
}

function showCode(node: Code): void {
    const [language, ...attributes] = (node.lang ?? "").split(",");
    node.lang = language || "text";
    if (language === "rust") node.value = withoutHiddenLines(node.value);
    if (attributes.length > 0 && node.meta === undefined) node.meta = null;
}

/** The remark plugin. */
export default function documents() {
    return (tree: Root, file: File): void => {
        visit(tree, "code", showCode);
        visit(tree, "link", (node: Link, index, parent) => {
            const path = outside(file.path, node.url);
            if (path === undefined || parent === undefined || index === undefined) return;
            const address = fileView(path);
            if (address !== undefined) node.url = address;
            else (parent.children as PhrasingContent[]).splice(index, 1, ...node.children);
        });
    };
}
