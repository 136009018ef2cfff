"""Does a displacement that depends on the time alone stay bounded? Then it counts as a small one.

Sines and cosines, pulses, waves, records and what decays are bounded; v·t and Ω·t are not: they are told apart by their
growth from some 10⁴ s to some 10⁹ s.
"""

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

EARLY, LATE = 1e4, 1e9
INSTANTS = (1.0, 1.137, 1.319, 1.523, 1.689, 1.733, 1.871, 1.957)
GROWTH = 30.0       # far more than what waves differ by, far less than LATE/EARLY


def stays_bounded(node, time, values):
    """`values`: {name: float} of all symbols but the time. An impulse is not bounded."""
    if any(part.name == "impulse" for part in reachable([node])):
        return False
    calls = [part for part in reachable([node]) if part.name in ("sin", "cos")]
    waves = {part: node.table.parameter(f"wave {i}", positive=False) for i, part in enumerate(calls)}   # not 1: 1 − 1
    if not substitute([node], waves)[0].mask & time.mask:
        return True
    early, late = (max(abs(evaluate([node], Floats, {**values, time.name: start * x})[0]) for x in INSTANTS)
                   for start in (EARLY, LATE))
    return late <= GROWTH * early
