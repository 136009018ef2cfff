"""What functions of the time are multiplied by in loads and driven displacements."""

from typing import TYPE_CHECKING, Any

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.symbolic.node import Node


def amplitudes(opened: Any, nodes: "Sequence[Node]") -> list[Any]:
    """The nodes of a SystemWithInputs with each function of the time as 1, or as near to it as they are defined: not so
    1/(1 − cos Ωt)."""
    scene, sample, arithmetic = opened.scene, opened.sample, opened.arithmetic
    calls = [part for part in reachable(nodes) if part.op == "call" and part.mask & scene.time.mask]
    waves = {part: scene.table.parameter(f"wave {i}", positive=False) for i, part in enumerate((*calls, scene.time))}
    nodes = substitute(nodes, waves)
    found = (evaluate(nodes, arithmetic, sample | {wave.name: size for wave in waves.values()})
             for size in (1.0, 0.9, 0.7))
    return next((values for values in found if all(map(arithmetic.isfinite, values))), [0.0] * len(nodes))
