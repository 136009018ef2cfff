"""Names of signals, parsed once: what they are of, which part, at which place, and how often differentiated."""

import re
from functools import lru_cache

from vibcli.base.named_tuple import NamedTuple

LEFT_OF = "⁻"       # behind a place: the value on its left, where it jumps; of signals that the program itself asks for
SIGNAL = r"(?s)([^.'(]*)(?:\.([^'(]*))?('*)(?:\((.+)\))?('*)"


class SignalName(NamedTuple):
    """`rod.u'(L/2)`: name rod, part u, place L/2, primes 1; `x`: name x; `disc.reaction.x`: part reaction.x. The place
    of what has one is an expression of parameters, a length counted from the left end of a member."""

    name: str
    part: str = ""
    place: str = ""
    primes: int = 0

    @property
    def kind(self) -> str:
        """The first word of its part: reaction of reaction.x."""
        return self.part.partition(".")[0]

    @property
    def axis(self) -> str:
        """What follows that word: x of reaction.x, the number of a piece of a rope, the surface of a contact."""
        return self.part.partition(".")[2]

    @property
    def still(self) -> "SignalName":
        """Itself, not differentiated."""
        return self._replace(primes=0)

    @property
    def text(self) -> str:
        """As it is written in a scene."""
        return self.name + ("." + self.part if self.part else "") + "'" * self.primes + (
            f"({self.place})" if self.place else "")


@lru_cache(maxsize=4096)
def signal_name(text: str) -> SignalName:
    """The SignalName of a text; primes may stand after the place too, as in the names of velocities."""
    found = None if text.isidentifier() else re.compile(SIGNAL).fullmatch(text)
    if found is None:
        return SignalName(text)
    name, part, before, place, after = found.groups("")
    return SignalName(name, part, " ".join(place.split()), len(before) + len(after))
