"""What may stand in the square brackets of a quantity, by its kind: a mode, a coordinate, a body …"""

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.language.spec import MEMBERS

if TYPE_CHECKING:
    from vibcli.language.spec import Spec

MOST_COUNTED, MOST_NODES = 1000, 100_000      # nodes: as many as modes


class IndexKind(NamedTuple):
    """`names(spec, index)`: those of the scene, or like the index; `fits(spec, index)`: is it one of the kind? `sample`
    stands for any, and so do `letters` in the manual; `wants`: what is expected where it is no name of the scene."""

    names: "Callable[[Spec, str], Collection[str]]"
    fits: "Callable[[Spec, str], bool]"
    sample: str
    letters: tuple[str, ...] = ()
    noun: str = ""
    wants: str = ""

    @property
    def of_signals(self) -> bool:
        """Are they signals?"""
        return self.names is _near_signals


def _whole(index: str) -> bool:
    return index.isdecimal() and index.isascii() and int(index) > 0


def _fraction(index: str) -> bool:
    try:
        return 0 < float(index) < 1
    except ValueError:
        return False


def _free(wants: str, fits: Callable[..., bool] | type[bool], sample: str) -> IndexKind:
    """The kind of numbers that no scene limits."""
    return IndexKind(lambda spec, index: (), lambda spec, index: fits(index), sample, wants=wants)


def _counted(most: int) -> IndexKind:
    """The kind of what is counted so far."""
    return _free(f"a whole number from 1 to {most}", lambda index: _whole(index) and int(index) <= most, "1")._replace(
        letters=("k",))


def _named(noun: str, letters: tuple[str, ...], *sections: str) -> IndexKind:
    """The kind of the names in some sections."""
    def names(spec: "Spec", index: str) -> "list[str]":
        return [name for section in sections for name in spec.get(section) or ()]

    return IndexKind(names, lambda spec, index: index in names(spec, index), noun, letters, noun)


def _modes(spec: "Spec", index: str) -> list[str]:
    return ["1", "2", "3", "…"] if spec.members else [str(i + 1) for i in range(len(spec.coordinates))]


def _is_mode(spec: "Spec", index: str) -> bool:
    return _whole(index) and (bool(spec.members) or int(index) <= 2 * len(spec.coordinates))


def _near_signals(spec: "Spec", index: str) -> Collection[str]:
    from vibcli.language.signals import near_signals

    return near_signals(spec, index)


def _is_signal(spec: "Spec", index: str) -> bool:
    from vibcli.language.signals import signal_dimension

    return spec.coordinate_name(index) is not None or signal_dimension(spec, index) is not None


def _is_output(spec: "Spec", index: str) -> bool:
    from vibcli.quantities.signal_dimensions import output_dimension

    return output_dimension(spec, index) is not None


def _inputs(spec: "Spec", index: str) -> Collection[str]:
    from vibcli.quantities.signal_dimensions import inputs

    return inputs(spec)


def _is_input(spec: "Spec", index: str) -> bool:
    from vibcli.quantities.signal_dimensions import input_dimension

    return input_dimension(spec, index) is not None


HIGHEST = 8         # order of a product
HIGHEST_POWER = 12  # of a deflection
_PRODUCT = f"a product of order 1 to {HIGHEST} of coordinates"
def _is_product(spec: "Spec", index: str, rates: bool) -> bool:
    from vibcli.quantities.products import is_product

    return is_product(spec, index, HIGHEST, rates)


def _is_square(spec: "Spec", index: str) -> bool:
    from vibcli.quantities.products import powers_in

    return [*(powers_in(spec, index, 2) or {}).items()][-1:] == [((index.partition("^")[0].strip(), 0), 2)]


def power_of_deflection(index: str) -> tuple[str, int] | None:
    """(d or v, n) of d, d^3, v^2 …; None of anything else."""
    letter, hat, n = (part.strip() for part in index.partition("^"))
    if letter not in ("d", "v") or (hat and not _whole(n)):
        return None
    return (letter, int(n or 1)) if int(n or 1) <= HIGHEST_POWER else None


INDICES = {
    "mode": IndexKind(_modes, _is_mode, "1", ("i",), "mode"),
    "equilibrium": IndexKind(lambda spec, index: ["1", "2", "3"], lambda spec, index: _whole(index), "1", (),
                             "equilibrium"),
    "coordinate": IndexKind(lambda spec, index: list(spec.coordinates),
                            lambda spec, index: spec.coordinate_name(index) is not None, "coordinate", ("q", "r"),
                            "coordinate"),
    "signal": IndexKind(_near_signals, _is_signal, "signal", ("q",), "coordinate or signal"),
    "output": IndexKind(_near_signals, _is_output, "x", (), "output"),
    "input": IndexKind(_inputs, _is_input, "F", (), "input"),
    "number": _counted(MOST_COUNTED), "node": _counted(MOST_NODES),
    "root": _free("1 or 2, of two real eigenvalues by ascending |λ|", lambda index: index in ("1", "2"), "1")._replace(
        letters=("j",)),
    "fraction": _free("a fraction between 0 and 1", _fraction, "0.1"),
    "parameter": IndexKind(lambda spec, index: spec.independent_parameters,
                           lambda spec, index: index in spec.independent_parameters, "parameter", ("p",), "parameter"),
    "damper": _named("damper", (), "dampers")._replace(sample="d"),
    "body": _named("body", ("body",), "bodies"),
    "member": _named("member", ("member",), *MEMBERS),
    "shape": _free("a function of the place x", bool, "x^2")._replace(letters=("x^2",)),
    "product": IndexKind(lambda spec, index: (), lambda spec, index: _is_product(spec, index, False), "x^2",
                         ("x^2*y^2",), wants=_PRODUCT),
    "product with rates": IndexKind(lambda spec, index: (), lambda spec, index: _is_product(spec, index, True),
                                    "x^2*x'^2", ("x^2*x'^2",), wants=_PRODUCT + " and their rates"),
    "square": IndexKind(lambda spec, index: [f"{name}^2" for name in spec.coordinates], _is_square, "x^2", ("x^2",),
                        "square of a coordinate", "the square of a coordinate"),
    "spring": _named("spring", ("s",), "springs")._replace(sample="s"),
    "spring or damper": _named("spring or damper", ("s",), "springs", "dampers")._replace(sample="s"),
    "power": _free(f"a power of the deflection, d to d^{HIGHEST_POWER}, of a damper v to v^{HIGHEST_POWER},",
                   lambda index: power_of_deflection(index) is not None, "d^3")._replace(letters=("d^3",)),
    "place": _named("place", ("O",), "bodies", "points"),
}
