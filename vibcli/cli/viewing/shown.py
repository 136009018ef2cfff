"""What the page shows, from the thread that follows the file to those that serve it."""

from threading import Condition
from typing import Any

from vibcli.base.named_tuple import NamedTuple


class State(NamedTuple):
    """`parts`: the scene and its cases as HTML; `errors`: what is wrong with the file as it is now, the parts being
    those of an earlier one; `work`: what is being done."""

    version: int
    title: str
    parts: tuple[str, ...] = ()
    errors: tuple[str, ...] = ()
    work: str = ""


class Shown:
    """The present State; a new version wakes who waits for it."""

    def __init__(self, title: str):
        self._changed, self.state = Condition(), State(0, title)

    def show(self, **changes: Any) -> None:
        """Let the state have these fields; nothing where it has them."""
        with self._changed:
            found = self.state._replace(**changes)
            if found != self.state:
                self.state = found._replace(version=self.state.version + 1)
                self._changed.notify_all()

    def after(self, version: int, seconds: float) -> State:
        """The state as soon as it is another than this version, at the latest after so many seconds."""
        with self._changed:
            self._changed.wait_for(lambda: self.state.version != version, seconds)
            return self.state
