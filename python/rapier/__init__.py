"""Rigid-body physics in 2D and 3D: fast, deterministic and robust, one world or thousands at once.

The modules ``rapier.dim3`` and ``rapier.dim2`` contain the classes in single precision, ``rapier.dim3_f64`` and ``rapier.dim2_f64`` in double precision.
"""

import sys as _sys

from . import _rapier
from ._rapier import InvalidValueError, RapierError, SnapshotError, StaleHandleError, __version__

dim2 = _rapier.dim2
dim3 = _rapier.dim3
dim2_f64 = _rapier.dim2_f64
dim3_f64 = _rapier.dim3_f64
for _name in ("dim2", "dim3", "dim2_f64", "dim3_f64"):
    _module = getattr(_rapier, _name)
    _sys.modules[f"{__name__}.{_name}"] = _module
    for _class in vars(_module).values():
        if isinstance(_class, type):
            # Pickles find a class by the name of its module.
            _class.__module__ = f"{__name__}.{_name}"

from .pictures import Animation, save_picture  # noqa: E402 - after the modules above, which they use
from .sweeps import SweepError, SweepResult, sweep  # noqa: E402

__all__ = [
    "Animation", "InvalidValueError", "RapierError", "SnapshotError", "StaleHandleError", "SweepError", "SweepResult", "__version__",
    "dim2", "dim2_f64", "dim3", "dim3_f64", "save_picture", "sweep",
]
