"""Cases as tasks of a cluster of Ray."""

import contextlib
import traceback


def _run(job, parameters):
    """The result of a case, or the text of an exception."""
    try:
        return job.run(parameters), None
    except Exception:
        return None, traceback.format_exc()


@contextlib.contextmanager
def _connected(ray, address):
    """A connection to a cluster. Ray that the caller has started is used, and continues after the sweep."""
    if ray.is_initialized():
        yield
        return
    options = {"include_dashboard": False} if address == "local" else {}
    ray.init(address=address, log_to_driver=False, **options)
    try:
        yield
    finally:
        ray.shutdown()


def run_cluster(job, cases, address, attempts, report):
    """Runs all cases as tasks of a cluster and calls `report(number, result, error)` for each. Ray runs the tasks of a lost worker again.

    Returns 0: Ray does not count lost workers.
    """
    import ray

    with _connected(ray, address):
        task = ray.remote(num_cpus=1, max_retries=max(attempts - 1, 0))(_run)
        shared = ray.put(job)
        numbers = {task.remote(shared, parameters): number for number, parameters in enumerate(cases)}
        waiting = list(numbers)
        while waiting:
            done, waiting = ray.wait(waiting, num_returns=1)
            for reference in done:
                try:
                    result, error = ray.get(reference)
                except ray.exceptions.RayError as failure:
                    result, error = None, str(failure)
                report(numbers[reference], result, error)
    return 0
