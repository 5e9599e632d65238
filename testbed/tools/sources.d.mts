export interface SceneSource {
    readonly id: string;
    readonly title: string;
    readonly description: string;
    readonly group: string;
    readonly steered: boolean;
    /** What the action button does. */
    readonly action?: string;
    readonly source: string;
}

export function scenesOf(text: string): SceneSource[];
