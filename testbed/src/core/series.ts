// A ring of the last values of a quantity, for plots and averages.

export class Series {
    private readonly values: Float64Array;
    private next = 0;
    private filled = 0;

    constructor(readonly capacity: number) {
        this.values = new Float64Array(capacity);
    }

    get length(): number {
        return this.filled;
    }

    push(value: number): void {
        this.values[this.next] = value;
        this.next = (this.next + 1) % this.capacity;
        this.filled = Math.min(this.filled + 1, this.capacity);
    }

    clear(): void {
        this.next = 0;
        this.filled = 0;
    }

    /** Mean of the last `count` values, or 0 without values. */
    mean(count: number): number {
        const used = Math.min(count, this.filled);
        let sum = 0;
        for (let back = 1; back <= used; back++) sum += this.at(this.filled - back);
        return used > 0 ? sum / used : 0;
    }

    /** The value that a fraction of all values does not exceed, or 0 without values. */
    percentile(fraction: number): number {
        const sorted = Array.from({ length: this.filled }, (_, index) => this.at(index)).sort((a, b) => a - b);
        return sorted[Math.floor(fraction * (this.filled - 1))] ?? 0;
    }

    /** The value at an index; 0 is the oldest. */
    at(index: number): number {
        const first = this.filled < this.capacity ? 0 : this.next;
        return this.values[(first + index) % this.capacity] ?? 0;
    }

    /** The values, oldest first, padded with null at the front. */
    padded(): (number | null)[] {
        const missing = this.capacity - this.filled;
        return Array.from({ length: this.capacity }, (_, index) =>
            index < missing ? null : this.at(index - missing),
        );
    }
}
