"""A stage of a lazy pipeline: computed once, on first touch, and its cost kept."""

from functools import cached_property
from time import perf_counter


class Stage(cached_property):
    """A cached property that records what it cost."""

    def __get__(self, problem, owner=None):
        if problem is None:
            return self
        known = problem.__dict__
        if self.attrname in known:
            return known[self.attrname]
        before, inner = perf_counter(), problem.inner
        problem.inner = 0.0
        value = super().__get__(problem, owner)
        spent = perf_counter() - before
        problem.costs[self.attrname] = spent - problem.inner
        problem.inner = inner + spent
        return value
