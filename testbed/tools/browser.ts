// A browser with the testbed's page, for tests and thumbnails.

import type { Browser, BrowserType, Page } from "playwright-core";
import type { InlineConfig, ViteDevServer } from "vite";
import { FLAGS, RENDERING, requireChromium } from "./chromium.mjs";
import { findOwnEngine } from "./own-engine.ts";

/** The packages that the testbed brings: shared source has no dependencies of its own. */
export interface Tools {
    readonly chromium: BrowserType;
    createServer(config: InlineConfig): Promise<ViteDevServer>;
}

export interface Session {
    readonly browser: Browser;
    readonly server: ViteDevServer;
    readonly address: string;
    /** Whether the package of this repository was built. */
    readonly own: boolean;
    close(): Promise<void>;
}

/** Starts the development server of a testbed and a browser. `CHROMIUM` names another browser. */
export async function openSession(testbed: string, { chromium, createServer }: Tools): Promise<Session> {
    const executablePath = requireChromium();
    const server = await createServer({
        root: testbed,
        configFile: `${testbed}/vite.config.ts`,
        logLevel: "error",
        // An edit during a run must not reload the page.
        server: { hmr: false, watch: null },
    });
    await server.listen();
    const address = server.resolvedUrls?.local[0];
    if (address === undefined) throw new Error("the development server has no address");
    const browser = await chromium.launch({ executablePath, args: [...FLAGS, ...RENDERING] });
    return {
        browser,
        server,
        address,
        own: findOwnEngine(testbed, testbed.endsWith("2d") ? 2 : 3, "browser") !== null,
        close: async () => {
            await browser.close();
            await server.close();
        },
    };
}

/** Opens a page and collects its errors. */
export async function openPage(
    session: Session,
    query: string,
    size = { width: 1280, height: 800 },
    phone = false,
): Promise<{ page: Page; errors: string[] }> {
    const context = await session.browser.newContext({
        viewport: size,
        ...(phone ? { hasTouch: true, isMobile: true, deviceScaleFactor: 2 } : {}),
    });
    const page = await context.newPage();
    const errors: string[] = [];
    page.on("console", (message) => {
        if (message.type() === "error") errors.push(message.text());
    });
    page.on("pageerror", (error) => errors.push(String(error)));
    // Without this repository's package, the page starts on request only.
    const engine = session.own || query.includes("engine=") ? "" : "&engine=published";
    await page.goto(`${session.address}?${query}${engine}`);
    await page.waitForFunction("window.testbed !== undefined", undefined, { timeout: 60_000 });
    return { page, errors };
}
