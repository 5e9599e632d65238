"""The cost of a call of a hook: a pile with and without callables.

    python python/benchmarks/hooks.py
"""

import time

from rapier import dim3

BOXES, STEPS, REPEATS = 200, 200, 5


def pile(hooks):
    """A pile of boxes on a ground. They never sleep."""
    world = dim3.World()
    world.add_collider(dim3.Shape.box([50, 0.5, 50]), position=[0, -0.5, 0])
    for number in range(BOXES):
        place = [number % 5 * 0.9, 0.5 + 0.9 * (number // 25), number // 5 % 5 * 0.9]
        world.add_body(shape=dim3.Shape.box([0.4, 0.4, 0.4]), position=place, can_sleep=False, hooks=hooks)
    world.step(100)
    return world


def measure(world, **callables):
    """Seconds of the processor for the steps, the best of some repetitions that begin alike."""
    best = float("inf")
    for _ in range(REPEATS):
        other = world.copy()
        other.set_hooks(**callables)
        begin = time.process_time()
        other.step(STEPS)
        best = min(best, time.process_time() - begin)
    return best


def main():
    calls = 0

    def count(_):
        nonlocal calls
        calls += 1
        return True

    plain, hooked = measure(pile(False)), pile(True)
    without = measure(hooked)
    print(f"{1e3 * plain / STEPS:.2f} ms a step without hooks, {1e3 * without / STEPS:.2f} ms with colliders that have hooks and no callable")
    for name in ("filter_contact", "modify_contact"):
        calls = 0
        seconds = measure(hooked, **{name: count})
        per_run = calls / REPEATS
        cost = (seconds - without) / per_run * 1e6
        print(f"{name}: {per_run / STEPS:.0f} calls a step, {1e3 * seconds / STEPS:.2f} ms a step: {cost:.2f} µs a call")


if __name__ == "__main__":
    main()
