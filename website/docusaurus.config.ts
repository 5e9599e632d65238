import type { Config } from "@docusaurus/types";
import type { Options, ThemeConfig } from "@docusaurus/preset-classic";
import { DARK, LIGHT } from "./plugins/code-themes";
import documents from "./plugins/documents";
import bundler from "./plugins/bundler";
import gallery from "./plugins/gallery";
import { REPOSITORY, VERSION, fileView } from "./plugins/repository";

const presets: Options = {
    docs: {
        path: "../docs",
        sidebarPath: "./sidebars.ts",
        numberPrefixParser: false,
        versions: { current: { label: VERSION } },
        beforeDefaultRemarkPlugins: [documents],
        editUrl: REPOSITORY === undefined ? undefined : ({ docPath }) => fileView(`docs/${docPath}`),
    },
    blog: false,
    theme: { customCss: "./src/css/site.css" },
};

/** The reference, which `scripts/prepare.mjs` generates. */
const reference = {
    id: "api",
    path: "generated/api",
    routeBasePath: "api",
    sidebarPath: "./sidebars-api.ts",
    numberPrefixParser: false,
};

/** Documents of the repository's root, which `scripts/prepare.mjs` copies. */
const root = { id: "root", path: "generated/pages", routeBasePath: "/" };

/** Addresses that visitors try. */
const redirects = {
    redirects: [
        { from: "/docs", to: "/docs/guide" },
        { from: "/api", to: "/api/rust" },
        { from: "/docs/benchmarks", to: "/benchmarks" },
    ],
};

const search = {
    hashed: "filename",
    indexBlog: false,
    docsRouteBasePath: ["docs", "api"],
    docsDir: ["../docs", "generated/api"],
    highlightSearchTermsOnTargetPage: true,
    explicitSearchResultPath: true,
    // Declarations double the index, and repeat the names of their headings.
    ignoreCssSelectors: ["html.plugin-id-api .theme-code-block"],
    // Figures are no terms of a search, and the reference of 2D has the names of 3D.
    ignoreFiles: [/docs\/(benchmarks\/(latest|native|growth)|fidelity\/)/, /api\/rust-2d/],
};

const footer: ThemeConfig["footer"] = {
    style: "light",
    links: [
        {
            title: "Learn",
            items: [
                { label: "Guide", to: "/docs/guide" },
                { label: "Rust reference", to: "/api/rust" },
                { label: "JavaScript reference", to: "/api/javascript" },
            ],
        },
        {
            title: "Compare",
            items: [
                { label: "Benchmarks", to: "/benchmarks" },
                { label: "Fidelity", to: "/fidelity" },
                { label: "Coming from another engine", to: "/docs/guide/coming-from" },
            ],
        },
        {
            title: "Project",
            items: [
                ...(REPOSITORY === undefined ? [] : [{ label: "Source", href: REPOSITORY }]),
                { label: "Changelog", to: "/changelog" },
                { label: "Licence: MIT", href: "pathname:///LICENSE-MIT.txt" },
                { label: "or Apache 2.0", href: "pathname:///LICENSE-APACHE.txt" },
            ],
        },
    ],
};

const themeConfig: ThemeConfig = {
    image: "img/social.jpg",
    colorMode: { respectPrefersColorScheme: true },
    navbar: {
        title: "Rapier",
        logo: { alt: "", src: "img/logo.svg" },
        items: [
            { type: "docSidebar", sidebarId: "guide", label: "Guide" },
            { type: "docSidebar", sidebarId: "design", label: "How it works" },
            {
                type: "dropdown",
                label: "Reference",
                position: "left",
                items: [
                    { to: "/api/rust", label: "Rust, 3D" },
                    { to: "/api/rust-2d", label: "Rust, 2D" },
                    { to: "/api/javascript", label: "JavaScript" },
                ],
            },
            { to: "/benchmarks", label: "Benchmarks" },
            { to: "/fidelity", label: "Fidelity" },
            { to: "/determinism", label: "Determinism" },
            { to: "/gallery", label: "Gallery" },
            { type: "docsVersionDropdown", position: "right" },
            ...(REPOSITORY === undefined ? [] : [{ href: REPOSITORY, label: "Source", position: "right" as const }]),
        ],
    },
    docs: { sidebar: { hideable: true } },
    footer,
    prism: { theme: LIGHT, darkTheme: DARK, additionalLanguages: ["rust", "toml", "bash"] },
};

const config: Config = {
    title: "Rapier",
    tagline: "Rigid-body physics for games, tools and robots",
    favicon: "img/logo.svg",
    url: process.env.SITE_URL ?? "http://localhost:3000",
    baseUrl: process.env.BASE_URL ?? "/",
    staticDirectories: ["static", "generated/static"],
    onBrokenLinks: "throw",
    onBrokenAnchors: "throw",
    onDuplicateRoutes: "throw",
    markdown: {
        format: "detect",
        hooks: { onBrokenMarkdownLinks: "throw", onBrokenMarkdownImages: "throw" },
    },
    presets: [["classic", presets]],
    plugins: [
        bundler,
        gallery,
        ["@docusaurus/plugin-content-docs", reference],
        ["@docusaurus/plugin-content-pages", root],
        ["@docusaurus/plugin-client-redirects", redirects],
    ],
    themes: [["@easyops-cn/docusaurus-search-local", search]],
    themeConfig,
};

export default config;
