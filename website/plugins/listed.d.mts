export function tabled(markdown: string): string[];
export function numbered(markdown: string): string[];
