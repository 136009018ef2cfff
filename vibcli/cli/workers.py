"""Workers for long work: processes of this machine, or a cluster of dask.distributed."""

from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor
from contextlib import contextmanager
from typing import Any

import click

from vibcli.base.errors import PhysicsError

ANSWERS = 3         # seconds in which a cluster does: its machine, and a little later its scheduler


def worker_options(command: Callable) -> Callable:
    """--jobs and --cluster."""
    command = click.option("--cluster", metavar="ADDRESS", help="Workers of a scheduler of dask.distributed instead: "
                           "tcp://host:8786.")(command)
    return click.option("--jobs", "-j", type=click.IntRange(1, 256), default=1, metavar="N",
                        help="So many processes at a time; what is found and written is the same.")(command)


@contextmanager
def workers(jobs: int, cluster: str | None) -> Iterator[Executor | None]:
    """The Executor of some options, None of one job; it ends with what is done in it, or when that is interrupted."""
    if cluster is not None:
        if jobs > 1:
            raise click.UsageError("--jobs is for this machine, and --cluster for others: choose one")
        with _cluster(cluster) as client:
            yield client.get_executor()
    elif jobs == 1:
        yield None
    else:
        pool = Processes(jobs)
        try:
            yield pool
        except BaseException:
            pool.end()
            raise
        pool.shutdown()


def _cluster(address):
    try:
        from dask.distributed import Client
    except ImportError:
        raise click.UsageError("--cluster needs the extra cluster: pip install 'vibcli[cluster]'") from None
    try:
        _reach(address)
        return _within(ANSWERS + 2, lambda: Client(address, timeout=ANSWERS, set_as_default=False))
    except Exception as error:      # what another server says may be read as anything, as a length beyond all memory
        raise click.UsageError(f"no cluster answers at {address}: {error}") from None


def _within(seconds, work):
    """What work gives, or raises; TimeoutError where that takes longer: it is left to itself, as what waits for a
    server that says nothing ends when it likes."""
    from concurrent.futures import Future
    from threading import Thread

    found: Future[Any] = Future()

    def run():
        try:
            found.set_result(work())
        except Exception as error:
            found.set_exception(error)

    Thread(target=run, daemon=True).start()
    try:
        return found.result(seconds)
    except TimeoutError:
        raise TimeoutError("nothing is heard from there") from None


def _reach(address):
    """OSError or ValueError where nothing listens there: a Client that did not find its scheduler ends slowly."""
    import socket
    from urllib.parse import urlsplit

    place = urlsplit(address if "://" in address else f"tcp://{address}")
    if place.hostname is None or place.port is None:
        raise ValueError("write it as in tcp://host:8786")
    socket.create_connection((place.hostname, place.port), ANSWERS).close()


class Processes(Executor):
    """So many processes of this machine. Where one dies, which is said, what was not done is done again once."""

    def __init__(self, jobs: int):
        self._jobs = jobs
        self._pool = self._new()

    def _new(self):
        import gc
        from concurrent.futures import ProcessPoolExecutor
        from multiprocessing import get_context

        return ProcessPoolExecutor(self._jobs, get_context("spawn"), _begun, gc.get_threshold())

    def submit(self, work: Callable, /, *args: Any, **named: Any) -> Any:
        """What gives the result when it is asked for."""
        return _Pending(self, self._pool, self._pool.submit(work, *args, **named), (work, args, named))

    def again(self, broken: Executor, task: Any) -> Any:
        """A task whose pool broke, in a new one."""
        if self._pool is broken:
            click.echo("a worker ended before its work did: its part is done again", err=True)
            self._pool = self._new()
        work, args, named = task
        return self._pool.submit(work, *args, **named)

    def end(self) -> None:
        """End the processes at once."""
        from multiprocessing import active_children

        for child in active_children():
            child.terminate()
        self._pool.shutdown(cancel_futures=True)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Let the processes go."""
        self._pool.shutdown(wait, cancel_futures=cancel_futures)


def _begun(*thresholds):
    """What a process does first: it searches for garbage as seldom as the one that began it."""
    import gc

    from vibcli.cli.jobs import leave_interrupts

    gc.set_threshold(*thresholds)
    leave_interrupts()


class _Pending:
    """A result that is under way."""

    def __init__(self, executor, pool, future, task):
        self._executor, self._pool, self._future, self._task = executor, pool, future, task

    def result(self) -> Any:
        """The result; PhysicsError where workers ended twice."""
        try:
            return self._future.result()
        except BrokenExecutor:
            pass
        try:
            return self._executor.again(self._pool, self._task).result()
        except BrokenExecutor:
            raise PhysicsError("workers ended twice before their work did", "ask for fewer --jobs: memory may be short"
                               ) from None
