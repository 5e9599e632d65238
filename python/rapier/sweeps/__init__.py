"""Sweeps: one scene with many parameters, on a local pool of processes or on a cluster of Ray."""

from .table import SweepResult, SweepError
from .sweep import sweep

__all__ = ["SweepError", "SweepResult", "sweep"]
