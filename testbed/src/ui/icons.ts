// Icons of buttons, drawn on a grid of 24 units.

function icon(body: string, filled = false): string {
    const paint = filled ? 'fill="currentColor"' : 'fill="none" stroke="currentColor" stroke-width="2"';
    return `<svg viewBox="0 0 24 24" width="20" height="20" ${paint} stroke-linecap="round" stroke-linejoin="round" aria-hidden="true">${body}</svg>`;
}

export const ICONS = {
    play: icon('<path d="M7 4.5v15l12-7.5z"/>', true),
    pause: icon('<rect x="6" y="5" width="4" height="14" rx="1"/><rect x="14" y="5" width="4" height="14" rx="1"/>', true),
    step: icon('<path d="M5 5v14l9-7z"/><rect x="16" y="5" width="3" height="14" rx="1"/>', true),
    restart: icon('<path d="M4 12a8 8 0 1 0 2.6-5.9"/><path d="M4 4v5h5"/>'),
    debug: icon('<path d="M12 3l8 4.5v9L12 21l-8-4.5v-9z"/><path d="M4 7.5l8 4.5 8-4.5M12 12v9"/>'),
    ball: icon('<circle cx="15" cy="9" r="5"/><path d="M3 20l5-5M3 15l3-3M8 20l2-2"/>'),
    help: icon('<circle cx="12" cy="12" r="9"/><path d="M9.5 9.5a2.5 2.5 0 1 1 3.5 2.3c-.7.3-1 .8-1 1.7"/><path d="M12 17v.01"/>'),
    theme: icon('<circle cx="12" cy="12" r="4"/><path d="M12 3v2M12 19v2M3 12h2M19 12h2M5.6 5.6L7 7M17 17l1.4 1.4M5.6 18.4L7 17M17 7l1.4-1.4"/>'),
    scenes: icon('<rect x="4" y="4" width="7" height="7" rx="1.5"/><rect x="13" y="4" width="7" height="7" rx="1.5"/><rect x="4" y="13" width="7" height="7" rx="1.5"/><rect x="13" y="13" width="7" height="7" rx="1.5"/>'),
    settings: icon('<path d="M4 7h10M18 7h2M4 17h2M10 17h10"/><circle cx="16" cy="7" r="2"/><circle cx="8" cy="17" r="2"/>'),
    close: icon('<path d="M6 6l12 12M18 6L6 18"/>'),
} as const;
