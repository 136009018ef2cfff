"""Families solved: their points, and how many of them were held, escalated, refused, broken or idle."""

from collections import Counter
from collections.abc import Iterable, Iterator
from importlib import import_module

from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.stress.families import FAMILIES
from vibcli.evidence.stress.family import StressFamily
from vibcli.evidence.stress.point import BROKEN, StressPoint, measured

PLAIN = "the formula as it is written, in floats"


class FamilyPoints(NamedTuple):
    """A family by its name, with its points; plain: the name of what it stands beside."""

    name: str
    family: StressFamily
    points: list[StressPoint]

    @property
    def plain(self) -> str:
        """The plain method, with its setting."""
        return PLAIN if callable(self.family.plain) else " at ".join(filter(None, self.family.plain[1:]))


def solved(names: Iterable[str]) -> Iterator[FamilyPoints]:
    """Each family that is named, when it is found."""
    for name in names:
        family = import_module(f"vibcli.evidence.stress.families.{name}").FAMILY
        yield FamilyPoints(name, family, [measured(family, knob) for knob in family.values])


def counts(found: Iterable[FamilyPoints]) -> dict[str, int]:
    """{verdict: points}, and how many are idle."""
    points = [point for one in found for point in one.points]
    return {**Counter(point.verdict for point in points), "idle": sum(point.idle for point in points)}


def is_broken(found: Iterable[FamilyPoints]) -> bool:
    """Does any error exceed its bound?"""
    return any(point.verdict == BROKEN for one in found for point in one.points)


def about(name: str) -> str:
    """What a family turns, in words."""
    return FAMILIES[name]
