"""A pool of processes on this machine that survives the loss of workers."""

import multiprocessing
import os
import pickle
import traceback
from multiprocessing.connection import wait


def _work(connection, job):
    """Runs cases until the pipe closes. Each answer is the number of the case with its result, or with the text of an exception."""
    job = pickle.loads(job)
    while True:
        try:
            number, parameters = connection.recv()
        except EOFError:
            return
        try:
            answer = (number, job.run(parameters), None)
        except Exception:
            answer = (number, None, traceback.format_exc())
        connection.send(answer)


class _Worker:
    """A process with a pipe, and the case that it runs."""

    def __init__(self, context, job):
        self.connection, other = context.Pipe()
        self.process = context.Process(target=_work, args=(other, job), daemon=True)
        self.process.start()
        # The pipe closes with the process, so its end is noticed.
        other.close()
        self.case = None

    def give(self, number, parameters):
        self.case = number
        self.connection.send((number, parameters))

    def stop(self):
        self.connection.close()
        self.process.join(5)
        if self.process.is_alive():
            self.process.terminate()
            self.process.join()


def run_local(job, cases, workers, attempts, report):
    """Runs all cases and calls `report(number, result, error)` for each. A case whose worker ends runs again, up to `attempts` times.

    Returns the number of workers that were lost.
    """
    context = multiprocessing.get_context("spawn")
    pickled = pickle.dumps(job)
    count = max(1, min(workers or os.cpu_count() or 1, len(cases)))
    waiting, tries, lost = list(range(len(cases)))[::-1], [0] * len(cases), 0
    open_cases = len(cases)
    pool = [_Worker(context, pickled) for _ in range(count)] if cases else []
    try:
        while open_cases:
            for worker in pool:
                if worker.case is None and waiting:
                    number = waiting.pop()
                    tries[number] += 1
                    try:
                        worker.give(number, cases[number])
                    except OSError:
                        pass  # The worker ended: the wait below returns its pipe.
            for connection in wait([worker.connection for worker in pool]):
                place = next(place for place, worker in enumerate(pool) if worker.connection is connection)
                try:
                    number, result, error = connection.recv()
                except (EOFError, OSError):
                    lost += 1
                    number = pool[place].case
                    code = pool[place].process.exitcode
                    pool[place].stop()
                    pool[place] = _Worker(context, pickled)
                    if number is None:
                        continue
                    if tries[number] < attempts:
                        waiting.append(number)
                        continue
                    result, error = None, f"{attempts} workers ended in this case, the last one with the exit code {code}"
                pool[place].case = None
                open_cases -= 1
                report(number, result, error)
    finally:
        for worker in pool:
            worker.stop()
    return lost
