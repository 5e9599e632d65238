export function withoutHiddenLines(code: string): string;
