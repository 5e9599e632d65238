// The search of the bar, in place of the plugin's: types of that name, then the guide, then the reference with one entry for each name.
// `plugins/bundler.ts` puts this module into the plugin's search bar.

import { searchByWorker as search } from "@easyops-cn/docusaurus-search-local/dist/client/client/theme/searchByWorker";

export { fetchIndexesByWorker } from "@easyops-cn/docusaurus-search-local/dist/client/client/theme/searchByWorker";

/** Results from which the shown ones are chosen: methods of one name must not displace the guide. */
const CANDIDATES = 60;

function rank({ document }, input) {
    if (/^[A-Z]/.test(input) && document.t.toLowerCase() === input.toLowerCase()) return 0;
    return document.u.includes("/api/") ? 2 : 1;
}

/** The results in their new order. The reference has an entry for each dimension and type: the first stands for all. */
export function ranked(results, input) {
    const seen = new Set();
    const kept = results.filter(({ document }) => {
        if (!document.u.includes("/api/")) return true;
        const known = seen.has(document.t);
        seen.add(document.t);
        return !known;
    });
    return kept
        .map((result) => ({ ...result, isInterOfTree: undefined, isLastOfTree: undefined }))
        .sort((a, b) => rank(a, input) - rank(b, input));
}

export async function searchByWorker(baseUrl, context, input, limit) {
    const results = await search(baseUrl, context, input, Math.max(limit, CANDIDATES));
    return ranked(results, input.trim()).slice(0, limit);
}
