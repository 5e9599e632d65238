"""A pool of processes on this machine that survives the loss of workers."""

import multiprocessing
import os
import pickle
import signal
import traceback
from multiprocessing.connection import wait


def _work(connection, pickled):
    """Runs cases until the pipe closes. Each answer is the number of the case with its result, or with the text of an exception."""
    job = None
    while True:
        try:
            number, parameters = connection.recv()
        except EOFError:
            return
        try:
            job = job or pickle.loads(pickled)
            answer = pickle.dumps((number, job.run(parameters), None))
        except Exception:
            answer = pickle.dumps((number, None, traceback.format_exc()))
        connection.send_bytes(answer)


class _Worker:
    """A process with a pipe, and the case that it runs."""

    def __init__(self, context, pickled):
        self.connection, other = context.Pipe()
        self.process = context.Process(target=_work, args=(other, pickled), daemon=True)
        self.process.start()
        # The pipe closes with the process, so its end is noticed.
        other.close()
        self.case = None

    def give(self, number, parameters):
        """Sends a case. Without the process, `answer` raises `EOFError`."""
        self.case = number
        try:
            self.connection.send((number, parameters))
        except OSError:
            pass

    def answer(self):
        """The number of the case, its result and the text of an exception."""
        data = self.connection.recv_bytes()
        try:
            return pickle.loads(data)
        except Exception:
            return self.case, None, traceback.format_exc()

    def end(self):
        """The text of the exit code of a process that ended."""
        self.process.join(5)
        code = self.process.exitcode
        if code is None or code >= 0:
            return f"the exit code {code}"
        return f"the signal {signal.Signals(-code).name}"

    def stop(self):
        self.connection.close()
        self.process.join(5)
        if self.process.is_alive():
            self.process.terminate()
            self.process.join()


class _Pool:
    """Processes, the cases that wait for them, and the number of lost processes."""

    def __init__(self, pickled, cases, attempts):
        self.context = multiprocessing.get_context("spawn")
        self.pickled, self.cases, self.attempts = pickled, cases, attempts
        self.waiting = list(range(len(cases)))[::-1]
        self.tries, self.lost, self.workers = [0] * len(cases), 0, []

    def fill(self, count):
        """Starts processes up to a count, as far as cases wait."""
        idle = sum(worker.case is None for worker in self.workers)
        for _ in range(min(count - len(self.workers), len(self.waiting) - idle)):
            self.workers.append(_Worker(self.context, self.pickled))

    def next_case(self, worker):
        """Gives a waiting case to a process. Returns the answer of a case that cannot be sent, or None."""
        number = self.waiting.pop()
        self.tries[number] += 1
        try:
            worker.give(number, self.cases[number])
        except Exception:
            worker.case = None
            return number, None, traceback.format_exc()
        return None

    def answer(self, worker):
        """The answer of a process, or None if it ended and its case waits again."""
        try:
            return worker.answer()
        except (EOFError, OSError):
            end, number = worker.end(), worker.case
            worker.stop()
            self.workers.remove(worker)
            self.lost += 1
        if self.tries[number] < self.attempts:
            self.waiting.append(number)
            return None
        return number, None, f"{self.attempts} workers ended in this case, the last one with {end}"

    def answers(self):
        """The answers of the processes that have one."""
        idle = [worker for worker in self.workers if worker.case is None]
        for worker in idle[: len(self.waiting)]:
            failure = self.next_case(worker)
            if failure is not None:
                yield failure
        by_connection = {worker.connection: worker for worker in self.workers if worker.case is not None}
        for connection in wait(list(by_connection)) if by_connection else []:
            worker = by_connection[connection]
            answer = self.answer(worker)
            worker.case = None
            if answer is not None:
                yield answer


def run_local(job, cases, workers, attempts, report):
    """Runs all cases and calls `report(number, result, error)` for each. A case whose worker ends runs again, up to `attempts` times.

    Returns the number of workers that were lost.
    """
    pool = _Pool(pickle.dumps(job), cases, attempts)
    count, open_cases = max(1, workers or os.cpu_count() or 1), len(cases)
    try:
        while open_cases:
            pool.fill(count)
            for number, result, error in pool.answers():
                open_cases -= 1
                report(number, result, error)
    finally:
        for worker in pool.workers:
            worker.stop()
    return pool.lost
