"""A stage of a lazy pipeline: computed once, on first touch, and its cost kept; parts that several objects share."""

from collections.abc import Callable
from functools import cached_property
from time import perf_counter
from typing import TYPE_CHECKING, Any, TypeVar

Value = TypeVar("Value")


class Costs(dict[str, float]):
    """{stage: seconds}, each without the stages that it had to wait for; the parts of a pipeline share them."""

    inner = 0.0         # seconds of the stages within the one under way

    def measured(self, stage: str, compute: Callable[..., Value]) -> Value:
        """The result of a stage; its cost is kept."""
        before, outer = perf_counter(), self.inner
        self.inner = 0.0
        value = compute()
        spent = perf_counter() - before
        self[stage] = spent - self.inner
        self.inner = outer + spent
        return value


class Stage(cached_property[Value]):
    """A cached property that records in the `costs` of its object what it cost."""

    if not TYPE_CHECKING:       # as of any cached property, its type is that of what its function gives
        def __get__(self, part: Any, owner: type[Any] | None = None) -> Any:
            if part is None:
                return self
            if self.attrname in part.__dict__:
                return part.__dict__[self.attrname]
            return part.costs.measured(self.attrname, lambda: cached_property.__get__(self, part, owner))


class SharedPart(cached_property[Value]):
    """A cached property that follows from expressions alone: an object that is `like` another one, but for its values,
    takes over that of the other."""

    if not TYPE_CHECKING:
        def __get__(self, part: Any, owner: type[Any] | None = None) -> Any:
            if part is None or part.like is None:
                return super().__get__(part, owner)
            found = part.__dict__[self.attrname] = getattr(part.like, self.attrname)
            return found
