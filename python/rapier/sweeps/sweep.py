"""The function `rapier.sweep`."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Optional, Union

from .._rapier import InvalidValueError
from .case import Job, cases_of
from .cluster import run_cluster
from .local import run_local
from .table import SweepError, SweepResult, check_columns

if TYPE_CHECKING:
    from .._engine import World


def _progress(count, wanted):
    """A progress bar of tqdm, if it is installed, or None."""
    if not wanted:
        return None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm(total=count, unit="case")


def sweep(
    scene: Union[Callable[..., Any], World], grid: Union[dict[str, Any], Iterable[dict[str, Any]]], metrics: Mapping[str, Callable[..., Any]],
    address: Optional[str] = None, *, steps: int = 600, workers: Optional[int] = None, attempts: int = 3, progress: bool = True, strict: bool = True,
) -> SweepResult:
    """Runs a scene with all parameters of a grid, and measures each world after its steps. Returns a `SweepResult`.

    scene: a function of the parameters that returns a world, or a pair (world, object for the metrics). A world instead of a function is copied for each case, and the
    parameters are properties of it, such as `gravity`. Functions must be picklable: defined at the top of a module.
    grid: a dictionary of lists, of which all combinations run, or a list of dictionaries.
    metrics: functions by name, of the world, or of the world and the object of the scene, if two arguments have no default. They return numbers or arrays.
    address: of a cluster of Ray, such as "auto"; "local" starts one on this machine for this sweep. A Ray that runs already is used instead, and continues. None runs a
    pool of processes on this machine without Ray.
    steps: time steps of each case. workers: processes of the local pool, by default one for each core.
    attempts: how often a case runs whose worker ends. progress: whether tqdm shows the progress. strict: whether a failed case raises `SweepError` at the end.

    A killed worker loses nothing: its case runs again in a new one. Equal cases have equal hashes on every machine. Raises `InvalidValueError` if a parameter and a metric
    have one name, or the name "hash", "seconds" or "worker" of another column.
    """
    cases = cases_of(grid)
    job = Job(scene, dict(metrics), steps)
    parameters = list(dict.fromkeys(name for case in cases for name in case))
    check_columns(parameters, job.metrics)
    if attempts < 1:
        raise InvalidValueError(f"attempts is {attempts}, but must be at least 1")
    rows, failures = [dict(case) for case in cases], {}
    bar = _progress(len(cases), progress)

    def report(number, result, error):
        if error is None:
            rows[number].update(result)
        else:
            failures[number] = error
        if bar is not None:
            bar.update()

    try:
        if address is None:
            lost = run_local(job, cases, workers, attempts, report)
        else:
            lost = run_cluster(job, cases, address, attempts, report)
    finally:
        if bar is not None:
            bar.close()
    result = SweepResult(parameters, metrics, rows, dict(sorted(failures.items())), lost)
    if failures and strict:
        number, text = next(iter(result.failures.items()))
        raise SweepError(f"{len(failures)} of {len(cases)} cases failed, the first one with {cases[number]}:\n{text}", result)
    return result
