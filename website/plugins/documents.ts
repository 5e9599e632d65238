// Renders the repository's documents without a second copy: rustdoc's hidden lines disappear, and links that leave
// `docs/` lead to the repository's file view.

import { existsSync, readFileSync } from "node:fs";
import { basename, dirname, join, relative } from "node:path";
import type { Code, InlineCode, Link, Parent, PhrasingContent, Root } from "mdast";
import { SKIP, visit } from "unist-util-visit";
import { showDimensions } from "./dimensions";
import { ROOT, fileView } from "./repository";
import { withoutHiddenLines } from "./rustdoc.mjs";
import { showScenes } from "./scenes";

interface File {
    readonly path: string;
}

/** The folder of the documents of an archived version. */
const ARCHIVED = /website\/versioned_docs\/version-([^/]+)\//;

/** Returns the path of a link's target in the repository, if the target is outside `docs/`. */
function outside(file: string, url: string): string | undefined {
    if (/^(\w+:|#|\/)/.test(url)) return undefined;
    const path = relative(ROOT, join(dirname(file), url.replace(/#.*/, "")));
    return path.startsWith("docs/") && path.includes(".") ? undefined : path;
}

function showCode(node: Code): void {
    const [language, ...attributes] = (node.lang ?? "").split(",");
    node.lang = language || "text";
    if (language === "rust") node.value = withoutHiddenLines(node.value).trim();
    if (attributes.length > 0 && node.meta === undefined) node.meta = null;
}

/** Takes pictures out of paragraphs of their own: a scene that runs in place of one is a block. */
function freePictures(tree: Root): void {
    visit(tree, "paragraph", (node, index, parent) => {
        const [only, ...others] = node.children;
        if (only?.type !== "image" || others.length > 0 || parent === undefined || index === undefined) return;
        parent.children[index] = only;
    });
}

/** Pages of the guide whose names are those of the JavaScript package. */
const JAVASCRIPT = /guide\/(javascript|testbed)\.md$/;
/** Pages of packages without a reference. */
const UNREFERENCED = /guide\/(python|bevy)\.md$/;

/** Addresses in the reference by name, if the reference was generated. */
function names(language: "rust" | "javascript"): Record<string, string> {
    const path = join(__dirname, "..", "generated", "data", `${language}-names.json`);
    return existsSync(path) ? (JSON.parse(readFileSync(path, "utf8")) as Record<string, string>) : {};
}

/** Links the first mention of each name of the API to the reference. Headings and links stay as they are. */
function linkNames(tree: Root, addresses: Record<string, string>): void {
    const done = new Set<string>();
    visit(tree, (node, index, parent) => {
        if (node.type === "heading" || node.type === "link") return SKIP;
        if (node.type !== "inlineCode" || parent === undefined || index === undefined) return undefined;
        const { value } = node as InlineCode;
        const url = Object.hasOwn(addresses, value) ? addresses[value] : undefined;
        if (url === undefined || done.has(value)) return undefined;
        done.add(value);
        (parent as Parent).children[index] = { type: "link", url, children: [node as InlineCode] };
        return SKIP;
    });
}

/** The remark plugin. */
export default function documents() {
    const addresses = { rust: names("rust"), javascript: names("javascript") };
    return (tree: Root, file: File): void => {
        const version = ARCHIVED.exec(file.path)?.[1];
        const document = file.path.replace(ARCHIVED, "docs/");
        visit(tree, "code", showCode);
        visit(tree, "link", (node: Link, index, parent) => {
            const path = outside(document, node.url);
            if (path === undefined || parent === undefined || index === undefined) return;
            const address = fileView(path, version && `v${version}`);
            const picture = node.children.some((child) => child.type === "image");
            // A picture is a button where its scene runs in the page, and no button stands in a link.
            if (address !== undefined && !picture) node.url = address;
            else (parent.children as PhrasingContent[]).splice(index, 1, ...node.children);
        });
        freePictures(tree);
        showDimensions(tree);
        if (!document.includes("docs/guide/") || UNREFERENCED.test(document)) return;
        linkNames(tree, JAVASCRIPT.test(document) ? addresses.javascript : addresses.rust);
        showScenes(tree, basename(document, ".md"));
    };
}
