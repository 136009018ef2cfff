"""The motion of a scene in time, of its small oscillations exactly or of its full equations, and the signals of it.

A signal is an expression of coordinates, places, forces (vibcli/signals.py) and parameters. A sum of them with constant
factors is exact at any time; products and powers are evaluated instant by instant, their extremes refined.
"""

from functools import cached_property

from vibcli.algebra.calculus import gradient
from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.algebra.meaning import lower
from vibcli.analyses.forcing.output import Output, combined
from vibcli.moving_signals import ComposedSignal, LinearSignal


def parts_of(problem, tree):
    """(node of a signal's tree, {symbol: (text, primes) or the tree of steady(…)}, the table's symbols standing for
    them)."""
    table, found = problem.scene.table, {}

    def symbol(name, primes, part):
        if part[0] == "quantity":
            node = table.variable("signal " + part[3])
            found[node] = part
            return node
        if name in problem.scene.parameters.nodes and not primes:
            return problem.scene.parameters.nodes[name]
        node = table.variable("signal " + name + "'" * primes)
        found[node] = (name, primes)
        return node

    return lower(tree, table, symbol), found


class SmallMotion:
    """Small oscillations about the equilibrium, exact in time."""

    def __init__(self, problem):
        self.problem = problem
        self._outputs = {}

    @cached_property
    def matrices(self):
        """M, C + G, K as arrays."""
        import numpy as np

        n, found = len(self.problem.scene.coordinates), []
        M, C, G, K = self.problem.elements.matrices()
        for matrix in (M, _plus(C, G), K):
            array = np.zeros((n, n))
            for (i, j), value in matrix.items():
                array[i, j] = value
            found.append(array)
        return found

    @cached_property
    def deviations(self):
        """(q, v) at t = 0, counted from the equilibrium, as arrays."""
        import numpy as np

        places, speeds = self.problem.start
        rest = self.problem.equilibrium.values
        names = self.problem.scene.coordinates
        return (np.array([places[name] - rest[name] for name in names]), np.array([speeds[name] for name in names]))

    def moved(self, direct=()):
        """The LinearMotion under the excitation; `direct`: nodes of the time on further channels."""
        from vibcli.analyses.forcing.decompose import forcing_of
        from vibcli.analyses.response import linear_motion

        problem = self.problem
        M, C, K = self.matrices
        nodes = dict(problem.excitation) if problem.scene.timed else {}
        nodes |= {len(M) + number: node for number, node in enumerate(direct)}
        forcing = forcing_of(nodes, problem.scene.time, problem.floats, len(M) + len(direct))
        return linear_motion(M, C, K, forcing, *self.deviations)

    @cached_property
    def alone(self):
        return self.moved()

    def output(self, name, primes):
        """(Output of a coordinate or signal, its direct node of the time or None)."""
        from vibcli.mechanics.outputs import linear_output

        key = name, primes
        if key not in self._outputs:
            self._outputs[key] = linear_output(self.problem, name, primes)
        return self._outputs[key]

    def signal(self, tree):
        """The signal of a tree."""
        node, parts = parts_of(self.problem, tree)
        slopes = gradient(node)
        if any(isinstance(part[0], str) and part[0] == "quantity" for part in parts.values()):
            return self._composed(node, parts)
        if any(slope.mask for slope in slopes.values()):
            return self._composed(node, parts)
        zeros = {symbol.name: 0.0 for symbol in parts}
        constant, *factors = evaluate([node, *(slopes[symbol] for symbol in parts if symbol in slopes)], Floats,
                                      {**self.problem.floats, **zeros})
        outputs = [self.output(*parts[symbol]) for symbol in parts if symbol in slopes]
        return self._linear(constant, factors, outputs)

    def _linear(self, constant, factors, outputs):
        direct = [node for _, node in outputs if node is not None]
        motion = self.moved(direct) if direct else self.alone
        channel, terms = len(self.matrices[0]), []
        for factor, (output, node) in zip(factors, outputs, strict=True):
            if node is not None:
                output = output._replace(channels={channel: 1.0})
                channel += 1
            terms.append((factor, output))
        return LinearSignal(motion, combined([(1.0, Output(constant)), *terms]))

    def _composed(self, node, parts):
        signals = {}
        for symbol, part in parts.items():
            if part[0] == "quantity":
                inner = self.signal(part[7][0])
                signals[symbol.name] = getattr(inner, part[4])
            else:
                signals[symbol.name] = self._linear(0.0, [1.0], [self.output(*part)])
        if node.name in signals and len(signals) == 1:
            return signals[node.name]
        return ComposedSignal(node, signals, self.problem.floats)


def _plus(one, two):
    found = dict(one)
    for pair, value in two.items():
        found[pair] = found.get(pair, 0.0) + value
    return found
