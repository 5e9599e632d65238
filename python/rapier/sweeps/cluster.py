"""Cases as tasks of a cluster of Ray."""

import traceback


def _run(job, parameters):
    """The result of a case, or the text of an exception."""
    try:
        return job.run(parameters), None
    except Exception:
        return None, traceback.format_exc()


def run_cluster(job, cases, address, attempts, report):
    """Runs all cases as tasks of a cluster and calls `report(number, result, error)` for each. Ray runs the tasks of a lost worker again.

    Returns 0: Ray does not count lost workers.
    """
    import ray

    if not ray.is_initialized():
        ray.init(address=address, log_to_driver=False)
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
