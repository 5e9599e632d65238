"""One case of a sweep, as a worker runs it."""

import inspect
import os
import time

import numpy as np


class Job:
    """A scene with its metrics, which a worker gets once as a pickle.

    scene: a function of the parameters that returns a world, or a pair of a world and an object for the metrics; or a world, which each case copies.
    metrics: functions by name. steps: time steps of each case.
    """

    def __init__(self, scene, metrics, steps):
        self.scene, self.metrics, self.steps = scene, metrics, steps

    def world(self, parameters):
        """The world of a case, and the object that its scene returned beside it."""
        if callable(self.scene):
            built = self.scene(**parameters)
            return built if isinstance(built, tuple) else (built, None)
        world = self.scene.copy()
        for name, value in parameters.items():
            if not hasattr(world, name):
                raise AttributeError(f"the parameter {name} is no property of the world: pass a function as the scene")
            setattr(world, name, value)
        return world, None

    def run(self, parameters):
        """The metrics of a case by name, its hash and its time (s)."""
        begin = time.perf_counter()
        world, extra = self.world(parameters)
        world.step(self.steps)
        values = {name: _plain(_call(metric, world, extra)) for name, metric in self.metrics.items()}
        return {**values, "hash": world.hash, "seconds": time.perf_counter() - begin, "worker": os.getpid()}


def _call(metric, world, extra):
    """Calls a metric with the world, and with the object of the scene if two arguments have no default."""
    return metric(world, extra) if _required(metric) >= 2 else metric(world)


def _required(function):
    """The number of positional arguments without a default."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return 1
    return sum(own.default is own.empty and own.kind in (own.POSITIONAL_ONLY, own.POSITIONAL_OR_KEYWORD) for own in parameters)


def _plain(value):
    """A number of Python for a number of NumPy, a list for an array."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    return value.item() if isinstance(value, np.generic) else value


def cases_of(grid):
    """The cases of a grid: all combinations of a dictionary of lists, or the dictionaries of a list."""
    if not isinstance(grid, dict):
        return [dict(case) for case in grid]
    cases = [{}]
    for name, values in grid.items():
        cases = [{**case, name: value} for case in cases for value in values]
    return cases
