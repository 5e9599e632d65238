// The order of pages. The guide's order is that of its table of contents, decisions are in the order of their numbers.

import { readdirSync } from "node:fs";
import { join } from "node:path";
import type { SidebarsConfig } from "@docusaurus/plugin-content-docs";
import { ROOT, read } from "./plugins/repository";

/** The documents that the list of a page links to, in order. */
function listed(page: string, folder: string): string[] {
    return [...read(page).matchAll(/^\d+\. \[[^\]]*\]\(([\w-]+)\.md\)/gm)].map((match) => `${folder}/${match[1]}`);
}

/** The documents that the table of a folder links to, in order. */
function pages(folder: string): string[] {
    return [...read(`docs/${folder}/README.md`).matchAll(/^\| \[[^\]]*\]\(([\w-]+)\.md\)/gm)].map((match) => `${folder}/${match[1]}`);
}

const decisions = readdirSync(join(ROOT, "docs/decisions"))
    .filter((name) => name.endsWith(".md"))
    .sort()
    .map((name) => `decisions/${name.replace(/\.md$/, "")}`);

const sidebars: SidebarsConfig = {
    guide: ["guide/README", ...listed("docs/guide/README.md", "guide"), "complaints"],
    design: [
        "architecture",
        "step",
        "data-layout",
        "glossary",
        { type: "category", label: "Decisions", items: decisions, link: { type: "generated-index", slug: "/decisions" } },
        "panics",
        "papers",
        "dependencies",
    ],
    fidelity: [{ type: "link", label: "Charts", href: "/fidelity" }, "fidelity/README", ...pages("fidelity")],
    benchmarks: [
        { type: "link", label: "Charts", href: "/benchmarks" },
        "benchmarks/latest",
        { type: "doc", id: "benchmarks/native", label: "Beside its peers, native code" },
        ...["growth", "joints", "ground", "queries", "saving", "javascript"].map((name) => `benchmarks/${name}`),
        "performance",
    ],
};

export default sidebars;
