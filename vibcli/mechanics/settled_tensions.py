"""Tensions that statics alone leaves open: those under which the members rest are those in their stiffness.

The tension N of each piece enters its stiffness, the scene rests under it, and there the force along the piece is
found: g(N). What is sought is N = g(N). Where statics alone tells all, that is so at once.
"""

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.configuration import Configuration
from vibcli.mechanics.member_tensions import tensions_at_rest
from vibcli.mechanics.numeric_system import NumericSystem
from vibcli.scene.member_tensions import require_preloads, statics_tells

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.member_tensions import TensionAtRest
    from vibcli.mechanics.system import MechanicalSystem

ROUNDING = 1e-11        # of the largest force in the scene: tensions that differ by less are one


class Settled(NamedTuple):
    """A Configuration whose members rest under the tensions in their stiffness, with the `names` of those that statics
    alone leaves open; or, as far as it is drawn, what is in the way."""

    configuration: Configuration
    names: tuple[str, ...] = ()
    refusal: PhysicsError | None = None

    @property
    def told_by_statics(self) -> bool:
        """Does statics alone tell all tensions of the scene?"""
        return statics_tells(self.configuration.scene)


def settled(system: "MechanicalSystem") -> Settled:
    """That of a scene with beams or strings in the plane."""
    found = _settled(system)
    if found.refusal is None:
        require_preloads(found.configuration.scene)
    return found


def _settled(system: "MechanicalSystem") -> Settled:
    first = _under(system, {})
    if first.numeric.has_free_symbols or statics_tells(first.scene):
        return Settled(first)
    try:
        found = tensions_at_rest(first)
    except PhysicsError:        # nowhere to rest: whoever asks where is told
        return Settled(first)
    open_ones = {one.member.name: one for one in found if _differs(one)}
    if not open_ones:
        return Settled(first)
    with system.work.task("the search for the tension of members"):
        return _search(system, first, open_ones)


def _differs(one: "TensionAtRest") -> bool:
    return any(abs(a - b) > ROUNDING * (one.size + abs(b)) for a, b in zip(one.found, one.drawn, strict=True))


def _under(system: "MechanicalSystem", tensions: Mapping[str, list[float]]) -> Configuration:
    """The Configuration under {member: [N of each piece]}."""
    exact = {name: [Fraction(x) for x in pieces] for name, pieces in tensions.items()}
    return Configuration(NumericSystem(system.under(exact)))


def _search(system: "MechanicalSystem", first: Configuration, open_ones: "Mapping[str, TensionAtRest]") -> Settled:
    """The Settled one; a member whose tension turns out to be open on the way is sought with the others."""
    import numpy as np

    from vibcli.numerics.mixing import fixed_by_mixing

    start = {name: one.found for name, one in open_ones.items()}
    _under(system, start).scene  # noqa: B018 - SpecError of a string that is pressed
    while True:
        search = _Search(system, start)
        size = max(one.size for one in open_ones.values())
        try:
            found = fixed_by_mixing(search.next, np.concatenate(list(start.values())), size)
        except (PhysicsError, SpecError) as error:
            return Settled(first, refusal=_refusal(search, error))
        if found is None:
            return Settled(first, refusal=_refusal(search, None))
        configuration = search.configuration(found)
        at_rest = {one.member.name: one for one in tensions_at_rest(configuration)}
        more = [one for one in at_rest.values() if one.member.name not in start and _differs(one)]
        if not more:
            return Settled(configuration, tuple(start))
        start = search.split(found) | {one.member.name: one.found for one in more}


class _Search:
    """g(N): N as one array of the pieces of the members in `start`, one after the other."""

    __slots__ = ("last", "sizes", "system")

    def __init__(self, system: "MechanicalSystem", start: Mapping[str, list[float]]) -> None:
        self.system, self.sizes = system, {name: len(pieces) for name, pieces in start.items()}
        self.last: tuple[np.ndarray, Configuration] | None = None

    def split(self, N: "np.ndarray") -> "dict[str, list[float]]":
        """{member: [N of each piece]}."""
        numbers = iter(N.tolist())
        return {name: [next(numbers) for _ in range(size)] for name, size in self.sizes.items()}

    def configuration(self, N: "np.ndarray") -> Configuration:
        """The Configuration under N."""
        if self.last is None or self.last[0] is not N:
            self.last = N, _under(self.system, self.split(N))
        return self.last[1]

    def next(self, N: "np.ndarray") -> "np.ndarray":
        """g(N)."""
        import numpy as np

        found = {one.member.name: one.found for one in tensions_at_rest(self.configuration(N))}
        return np.concatenate([found[name] for name in self.sizes])


def _refusal(search: _Search, cause: Exception | None) -> PhysicsError:
    """That no tension is found, and the last one tried."""
    spec = search.system.spec
    name, pieces = next(iter(search.split(search.last[0]).items()))
    record = (spec.get("beams") or {}).get(name) or (spec.get("strings") or {}).get(name)
    why = "" if cause is None else f" ({cause})"
    return PhysicsError(f"the tension of '{name}', which statics alone leaves open, is not found in equilibrium: "
                        f"{pieces[0]:.6g} N is the last one tried{why}", "take loads off: near a buckling load nothing "
                        "rests", record.where)
