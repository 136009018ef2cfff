"""Workers for long work: processes of this machine, or a cluster of dask.distributed."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from collections.abc import Callable
    from concurrent.futures import Executor
    from typing import TypeVar

    from click.decorators import FC
    from dask.distributed import Client

    T = TypeVar("T")

ANSWERS = 3         # seconds in which a cluster does: its machine, and a little later its scheduler


def worker_options(command: "FC") -> "FC":
    """--jobs and --cluster."""
    command = click.option("--cluster", metavar="ADDRESS", help="Workers of a scheduler of dask.distributed instead: "
                           "tcp://host:8786.")(command)
    return click.option("--jobs", "-j", type=click.IntRange(1, 256), default=1, metavar="N",
                        help="So many processes at a time; what is found and written is the same.")(command)


@contextmanager
def workers(jobs: int, cluster: str | None) -> "Iterator[Executor | None]":
    """The Executor of some options, None of one job; it ends with what is done in it, or when that is interrupted."""
    if cluster is not None:
        if jobs > 1:
            raise click.UsageError("--jobs is for this machine, and --cluster for others: choose one")
        with _cluster(cluster) as client:
            yield client.get_executor()
    elif jobs == 1:
        yield None
    else:
        from vibcli.cli.processes import Processes

        pool = Processes(jobs)
        try:
            yield pool
        except BaseException:
            pool.end()
            raise
        pool.shutdown()


def _cluster(address: str) -> "Client":
    try:
        from dask.distributed import Client
    except ImportError:
        raise click.UsageError("--cluster needs the extra cluster: pip install 'vibcli[cluster]'") from None
    try:
        _reach(address)
        return _within(ANSWERS + 2, lambda: Client(address, timeout=ANSWERS, set_as_default=False))
    except Exception as error:      # what another server says may be read as anything, as a length beyond all memory
        raise click.UsageError(f"no cluster answers at {address}: {error}") from None


def _within(seconds: float, work: "Callable[[], T]") -> "T":
    """What work gives, or raises; TimeoutError where that takes longer: it is left to itself, as what waits for a
    server that says nothing ends when it likes."""
    from concurrent.futures import Future
    from threading import Thread

    found: Future[T] = Future()

    def run() -> None:
        try:
            found.set_result(work())
        except Exception as error:
            found.set_exception(error)

    Thread(target=run, daemon=True).start()
    try:
        return found.result(seconds)
    except TimeoutError:
        raise TimeoutError("nothing is heard from there") from None


def _reach(address: str) -> None:
    """OSError or ValueError where nothing listens there: a Client that did not find its scheduler ends slowly."""
    import socket
    from urllib.parse import urlsplit

    place = urlsplit(address if "://" in address else f"tcp://{address}")
    if place.hostname is None or place.port is None:
        raise ValueError("write it as in tcp://host:8786")
    socket.create_connection((place.hostname, place.port), ANSWERS).close()
