"""A scene whose numbers are watched: were more digits of them taken than floats have?"""

from collections.abc import Callable, Mapping
from typing import Any

from vibcli.analyses.modal.modal_analysis import ModalAnalysis
from vibcli.base.errors import SpecError
from vibcli.language.document.mapping import document_of
from vibcli.mechanics.configuration import Configuration
from vibcli.mechanics.numeric_system import NumericSystem
from vibcli.mechanics.system import MechanicalSystem
from vibcli.reader.read import read_spec
from vibcli.results.problem import Problem


class WatchedNumbers(NumericSystem):
    """precise: was anything evaluated in numbers of mpmath?"""

    precise = False

    def values(self, arithmetic: Any) -> dict[str, Any]:
        """As of any NumericSystem."""
        found = super().values(arithmetic)
        self.precise = self.precise or any(hasattr(x, "_mpf_") for x in found.values())
        return found


def scene_problem(scene: Mapping[str, Any]) -> tuple[Problem, Callable[[], bool]]:
    """The Problem of a scene as a mapping, and what tells whether more digits were taken."""
    node, diagnostics = document_of(scene)
    spec = read_spec(node, "scene", diagnostics, {})
    if diagnostics:
        raise SpecError(diagnostics)
    numbers = WatchedNumbers(MechanicalSystem(spec))
    return Problem(spec, modal=ModalAnalysis(Configuration(numbers))), lambda: numbers.precise
