export const FLAGS: string[];
export const RENDERING: string[];
export function findChromium(): string | undefined;
export function requireChromium(): string;
