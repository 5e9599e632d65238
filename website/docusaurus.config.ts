import type { Config } from "@docusaurus/types";
import type { Options, ThemeConfig } from "@docusaurus/preset-classic";
import { themes } from "prism-react-renderer";
import documents from "./plugins/documents";
import engine from "./plugins/engine";
import { REPOSITORY, VERSION, fileView } from "./plugins/repository";

const presets: Options = {
    docs: {
        path: "../docs",
        sidebarPath: "./sidebars.ts",
        numberPrefixParser: false,
        beforeDefaultRemarkPlugins: [documents],
        editUrl: REPOSITORY === undefined ? undefined : ({ docPath }) => fileView(`docs/${docPath}`),
    },
    blog: false,
    theme: { customCss: "./src/css/site.css" },
};

const search = {
    hashed: "filename",
    indexBlog: false,
    docsRouteBasePath: ["docs"],
    docsDir: ["../docs"],
    highlightSearchTermsOnTargetPage: true,
    explicitSearchResultPath: true,
};

const themeConfig: ThemeConfig = {
    colorMode: { respectPrefersColorScheme: true },
    navbar: {
        title: "Rapier",
        logo: { alt: "", src: "img/logo.svg" },
        items: [
            { type: "docSidebar", sidebarId: "guide", label: "Guide" },
            { type: "docSidebar", sidebarId: "design", label: "How it works" },
            { to: "/benchmarks", label: "Benchmarks" },
            { to: "/gallery", label: "Gallery" },
            { type: "html", position: "right", value: `<span class="version">${VERSION}</span>` },
            ...(REPOSITORY === undefined ? [] : [{ href: REPOSITORY, label: "Source", position: "right" as const }]),
        ],
    },
    docs: { sidebar: { hideable: true } },
    prism: { theme: themes.github, darkTheme: themes.vsDark, additionalLanguages: ["rust", "toml", "bash"] },
};

const config: Config = {
    title: "Rapier",
    tagline: "Rigid-body physics for games, tools and robots",
    favicon: "img/logo.svg",
    url: process.env.SITE_URL ?? "http://localhost:3000",
    baseUrl: process.env.BASE_URL ?? "/",
    staticDirectories: ["static", "../testbed3d/public"],
    onBrokenLinks: "throw",
    onBrokenAnchors: "throw",
    onDuplicateRoutes: "throw",
    markdown: {
        format: "detect",
        hooks: { onBrokenMarkdownLinks: "throw", onBrokenMarkdownImages: "throw" },
    },
    presets: [["classic", presets]],
    plugins: [engine],
    themes: [["@easyops-cn/docusaurus-search-local", search]],
    themeConfig,
};

export default config;
