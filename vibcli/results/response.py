"""What all kinds of motion in time share."""

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    import numpy as np

    from vibcli.language.reader import Record
    from vibcli.results.problem import Problem
    from vibcli.results.signal import Signal
    from vibcli.symbolic.node import Node

LONGEST = 1e12      # seconds


class Response:
    """Until when a motion is looked at, and what drives it. KIND: small, full, prescribed, waves, modes, parts or
    series."""

    WORDS: str
    estimated = False       # may errors be estimates of what modes left out add, and no bounds?
    lasting: Callable[[], float]
    signal: Callable[[Any], "Signal"]
    known: float

    def __init__(self, problem: "Problem") -> None:
        self.problem = problem

    @property
    def words(self) -> str:
        """What kind of motion it is, and how it is found."""
        return self.WORDS

    @property
    def ends(self) -> bool:
        """Is it said until when it is looked at?"""
        return self.problem.end is not None or "until" in (self._asked or ())

    @property
    def _asked(self) -> "Record | None":
        find = self.problem.spec.get("find")
        found: Record | None = find.in_time if find is not None else None
        return found

    @cached_property
    def until(self) -> float:
        """The end of the motion [s]: what the file says, else some periods or until it has died out."""
        end, where, record = self.problem.end, None, self._asked
        if end is None and record is not None and "until" in record:
            end, = evaluate([self.problem.scene.lower(record["until"])], Floats, self.problem.numeric.floats)
            where = record["until"].where
        if end is None:
            return self.lasting()
        if not 0 < end < LONGEST:
            raise PhysicsError(f"a motion cannot end at t = {end:.6g} s",
                               f"ask for an instant between its start, t = 0, and {LONGEST:.0e} s", where)
        found: float = end
        return found

    @cached_property
    def _signals(self) -> dict[Any, Any]:
        """{tree: Signal}"""
        return {}

    def kept_signal(self, tree: Any) -> "Signal":
        """The signal of a tree, the same to all who ask, which keeps what is found of it."""
        if tree not in self._signals:
            self._signals[tree] = self.signal(tree)
        found: Signal = self._signals[tree]
        return found

    def instants(self, signals: "Sequence[Signal]", points: int) -> "np.ndarray":
        """The instants at which it is sampled for pictures and files, ascending."""
        import numpy as np

        return np.linspace(0.0, self.known, points)

    @property
    def start(self) -> tuple[dict[str, float], dict[str, float]]:
        """({coordinate: value}, {coordinate: velocity}) at t = 0."""
        found: tuple[dict[str, float], dict[str, float]] = self.problem.initial.start
        return found

    @property
    def title(self) -> str:
        """That of the scene, with where the motion ends to be known."""
        title = self.problem.spec.get("title") or ""
        return title if self.known >= self.until else f"{title} (known up to t = {self.known:.4g} s)".strip()

    @cached_property
    def drive(self) -> "dict[int, Node]":
        """{i: Q(t)} of the small oscillations, in letters."""
        return self.problem.symbolic.excitation if self.problem.scene.timed else {}
