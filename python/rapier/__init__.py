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
    _sys.modules[f"{__name__}.{_name}"] = getattr(_rapier, _name)

__all__ = [
    "InvalidValueError", "RapierError", "SnapshotError", "StaleHandleError", "__version__",
    "dim2", "dim2_f64", "dim3", "dim3_f64",
]
