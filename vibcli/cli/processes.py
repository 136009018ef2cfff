"""Processes of this machine that do what they are given, each at its end of a pipe."""

import gc
import os
import signal
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager, suppress
from multiprocessing import get_context, parent_process, resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.reduction import ForkingPickler
from threading import Thread
from typing import Any, cast

import click

from vibcli.base.errors import PhysicsError

SPARE = 5       # pipes, more than who begins a process and that one itself open
ENDING = signal.SIGINT, signal.SIGTERM, signal.SIGHUP       # what asks a process for its end


class Processes(Executor):
    """So many processes of this machine, begun as there is work, and what is given to them in its order.

    Between one of them and this process there is a pipe, no thread and no lock: an interrupt, wherever it falls, leaves
    nothing that waits for another. However this process ends, they end with it, whatever they do. What is found is
    taken in while a result is waited for. Where a process dies, which is said, its task is done again once. Where no
    more files may be opened there are fewer processes, and without any a usage error. `start`: fork, spawn or
    forkserver, None for what is usual here."""

    def __init__(self, jobs: int, start: str | None = "spawn") -> None:
        self._jobs, self._context = jobs, cast(Any, get_context(start))
        self._processes: dict[Connection, Any] = {}
        self._tasks: dict[Connection, _Pending] = {}        # of those that are at work
        self._require_room()
        if self._context.get_start_method() != "fork":
            resource_tracker.ensure_running()       # where it begins it lets interrupts through
        self._waiting: deque[_Pending] = deque()

    def submit(self, work: Callable[..., Any], /, *args: Any, **named: Any) -> "_Pending":
        """What gives the result when it is asked for."""
        task = _Pending(self, (work, args, named))
        self._waiting.append(task)
        self._hand_out()
        return task

    def _hand_out(self) -> None:
        while self._waiting and len(self._tasks) < self._jobs:
            ours = next((one for one in self._processes if one not in self._tasks), None)
            if ours is None:
                if not self._require_room():
                    self._jobs = len(self._processes)
                    continue
                with interrupts_held():
                    ours = self._begun()
            task = self._waiting.popleft()
            try:
                data = ForkingPickler.dumps(task.work)
            except Exception as error:      # it cannot be pickled
                task.finish(None, error)
                continue
            with suppress(OSError):     # where it died while it had nothing to do: as if it had died of this
                ours.send_bytes(data)
            self._tasks[ours] = task

    def _require_room(self) -> bool:
        """May so many files be opened as another process takes? A usage error where there is none yet."""
        opened = []
        try:
            for _ in range(SPARE):
                opened += os.pipe()
        except OSError as error:
            if not self._processes:
                raise click.UsageError(f"no process can be begun: {error.strerror}; leave --jobs out, or let more "
                                       "files be open at a time (ulimit -n)") from None
            return False
        finally:
            for descriptor in opened:
                os.close(descriptor)
        return True

    def _begun(self) -> Connection:
        ours: Connection
        ours, theirs = self._context.Pipe()
        copied = (*self._processes, ours) if self._context.get_start_method() == "fork" else ()
        process = self._context.Process(target=_work, args=(theirs, copied, gc.get_threshold()), daemon=True)
        process.start()
        self._processes[ours] = process
        theirs.close()
        return ours

    def take_in(self) -> None:
        """Wait until something is found."""
        for ours in wait(list(self._tasks)):
            assert isinstance(ours, Connection)
            task = self._tasks.pop(ours)
            try:
                task.finish(*ours.recv())
            except (EOFError, OSError):
                self._bury(ours)
                if task.begin_again():
                    self._waiting.appendleft(task)
            except Exception as error:      # one may be pickled and yet not be read
                task.finish(None, error)
        self._hand_out()

    def _bury(self, ours: Connection) -> None:
        ours.close()
        self._processes.pop(ours).join()

    def end(self) -> None:
        """End the processes at once."""
        with interrupts_held():
            for ours in self._processes:        # none is held by a name here: they go while interrupts are held
                self._processes[ours].kill()
            self.shutdown()

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Let the processes go; what was not waited for is not begun."""
        self._waiting.clear()
        for ours in self._processes:
            ours.close()
        for process in self._processes.values() if wait else ():
            process.join()
        self._processes.clear()
        self._tasks.clear()


class _Pending:
    """A task, done or not."""

    _error: Exception | None

    def __init__(self, processes: Processes, work: tuple[Callable[..., Any], tuple[Any, ...], dict[str, Any]]) -> None:
        self._processes, self.work = processes, work
        self._done, self._repeated, self._value, self._error = False, False, None, None

    def finish(self, value: Any, error: Exception | None) -> None:
        """What it gave, or what it raised."""
        self._done, self._value, self._error = True, value, error

    def begin_again(self) -> bool:
        """Is it to be done again, as its process died? Once, and that is said."""
        if self._repeated:
            self.finish(None, PhysicsError("workers ended twice before their work did",
                                           "ask for fewer --jobs: memory may be short"))
            return False
        click.echo("a worker ended before its work did: its part is done again", err=True)
        self._repeated = True
        return True

    def result(self) -> Any:
        """The result; PhysicsError where processes ended twice."""
        while not self._done:
            self._processes.take_in()
        if self._error is not None:
            raise self._error
        return self._value


def end_with_parent() -> None:
    """Let this process end when the one that began it does, though by a signal and in the midst of a task."""
    def end() -> None:
        wait([parent_process().sentinel])
        os._exit(1)

    Thread(target=end, daemon=True).start()


def _work(theirs: Connection, copied: Sequence[Connection], threshold: tuple[int, int, int]) -> None:
    """Do task by task until the other end is closed, of which none of the `copied` may stay open here; searching for
    garbage as seldom as who began this."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)        # one from the terminal reaches all: who began this ends it
    for end in copied:
        end.close()
    end_with_parent()
    gc.set_threshold(*threshold)
    while True:
        try:
            task = theirs.recv_bytes()
        except (EOFError, OSError):
            return
        try:
            work, args, named = ForkingPickler.loads(task)
            found = work(*args, **named), None
        except Exception as error:
            found = None, error
        try:
            theirs.send(found)
        except OSError:
            return
        except Exception as error:      # it cannot be pickled
            theirs.send((None, TypeError(str(error))))


@contextmanager
def interrupts_held() -> Iterator[None]:
    """An interrupt, or what else asks for the end, waits until this is done: half a process is none that can be ended.
    A process that begins meanwhile does not hear of any: it ends with this one."""
    came: list[int] = []
    before = {number: signal.signal(number, lambda number, _: came.append(number)) for number in ENDING}
    let_through = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, let_through)
        for number, handler in before.items():
            signal.signal(number, handler)
        for number in came[:1]:
            signal.raise_signal(number)
