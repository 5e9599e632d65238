// A small generator of random numbers with a seed: a scene is the same at each start and in each engine.

export class Random {
    private state: number;

    constructor(seed = 1) {
        this.state = (seed * 0x9e3779b9) >>> 0 || 1;
    }

    /** A number of at least 0 and less than 1 (xorshift of 32 bits). */
    next(): number {
        let x = this.state;
        x ^= x << 13;
        x ^= x >>> 17;
        x ^= x << 5;
        this.state = x >>> 0;
        return this.state / 0x1_0000_0000;
    }

    between(min: number, max: number): number {
        return min + (max - min) * this.next();
    }

    /** An integer of at least 0 and less than `count`. */
    below(count: number): number {
        return Math.min(count - 1, Math.floor(this.next() * count));
    }

    pick<T>(items: readonly T[]): T {
        const item = items[this.below(items.length)];
        if (item === undefined) throw new RangeError("pick: the list is empty");
        return item;
    }
}
