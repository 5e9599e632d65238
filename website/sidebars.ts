// The order of pages. The guide's order is that of its table of contents, decisions are in the order of their numbers.

import { readdirSync } from "node:fs";
import { join } from "node:path";
import type { SidebarsConfig } from "@docusaurus/plugin-content-docs";
import { numbered, tabled } from "./plugins/listed.mjs";
import { ROOT, read } from "./plugins/repository";

const inFolder = (folder: string, pages: readonly string[]): string[] => pages.map((page) => `${folder}/${page}`);

const decisions = readdirSync(join(ROOT, "docs/decisions"))
    .filter((name) => name.endsWith(".md"))
    .sort()
    .map((name) => `decisions/${name.replace(/\.md$/, "")}`);

const sidebars: SidebarsConfig = {
    guide: ["guide/README", ...inFolder("guide", numbered(read("docs/guide/README.md"))), "complaints", "compat"],
    design: [
        "architecture",
        "step",
        "data-layout",
        "glossary",
        { type: "category", label: "Decisions", items: decisions, link: { type: "generated-index", slug: "/decisions" } },
        "panics",
        "papers",
        "platforms",
        "versioning",
        "dependencies",
    ],
    fidelity: [{ type: "link", label: "Charts", href: "/fidelity" }, "fidelity/README", ...inFolder("fidelity", tabled(read("docs/fidelity/README.md")))],
    benchmarks: [
        { type: "link", label: "Charts", href: "/benchmarks" },
        "benchmarks/latest",
        { type: "doc", id: "benchmarks/native", label: "Beside its peers, native code" },
        ...["growth", "threads", "joints", "ground", "queries", "saving", "javascript"].map((name) => `benchmarks/${name}`),
        "performance",
    ],
};

export default sidebars;
