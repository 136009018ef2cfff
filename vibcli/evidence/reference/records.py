"""Records that drive a motion: of each argument u = a t + c, the straight line level + slope·u between its samples,

    level = y₀ − slope·T₀,  slope = (y₁ − y₀)/(T₁ − T₀),  from t = (T₀ − c)/a to (T₁ − c)/a,  both 0 outside,

whose numbers are those of the samples, and another one from sample to sample. A rate of a record jumps where the record
does, and its second rate strikes where its slope jumps.
"""

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

import mpmath

from vibcli.analyses.time_integration.motion_series import fixed_point
from vibcli.analyses.time_integration.smooth_pieces import SmoothPieces
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.motion_series import Coefficients, MotionSeries
    from vibcli.mechanics.equations_of_motion import Dynamics
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.sampled_functions import Samples


class DrivingRecord(NamedTuple):
    """A call of a record, or of a rate of it of some order, with the rate of its argument; level, slope: the letters
    of its line."""

    node: "Node"
    samples: "Samples"
    order: int
    rate: "Node"
    level: "Node"
    slope: "Node"

    def line(self) -> "Node":
        """What stands for it between two samples."""
        table = self.node.table
        return cast("Node", [self.level + self.slope * self.node.args[0], self.slope, table.zero][min(self.order, 2)])

    def instants(self, time: str, known: Mapping[str, Any]) -> list[Any]:
        """Those of its samples, ascending, at the working precision."""
        offset, rate = self._argument(time, known)
        found = [(mpmath.mpf(sample) - offset) / rate for sample in self.samples.times]
        return found if rate > 0 else found[::-1]

    def numbers(self, place: int, forwards: bool) -> tuple[Any, Any]:
        """(level, slope) after so many of its instants."""
        times, values = self.samples.times, self.samples.values
        i = place - 1 if forwards else len(times) - place - 1
        if not 0 <= i < len(times) - 1:
            return mpmath.mpf(0), mpmath.mpf(0)
        slope = (mpmath.mpf(values[i + 1]) - values[i]) / (mpmath.mpf(times[i + 1]) - times[i])
        return values[i] - slope * times[i], slope

    def blows(self, time: str, known: Mapping[str, Any]) -> Iterator[tuple[Any, Any]]:
        """(instant, size) of the impulses in it."""
        rate = self._argument(time, known)[1]
        sizes = _jumps(self.samples, self.order)
        yield from zip(self.instants(time, known), [size / abs(rate) for size in sizes[::1 if rate > 0 else -1]],
                       strict=True)

    def _argument(self, time: str, known: Mapping[str, float | mpmath.mpf]) -> list[mpmath.mpf]:
        """(u at t = 0, du/dt)"""
        return evaluate([self.node.args[0], self.rate], multiprecision(), {**known, time: mpmath.mpf(0)})


def _jumps(samples: "Samples", order: int) -> list[mpmath.mpf]:
    """By how much the (order − 1)-th rate jumps at each sample."""
    values, none = [mpmath.mpf(x) for x in samples.values], [mpmath.mpf(0)] * (len(samples.values) - 2)
    if order == 1:
        return [values[0], *none, -values[-1]]
    if samples.jumps:
        raise PhysicsError("no reference is found of the second rate of a record that jumps")
    slopes = [(y - x) / (mpmath.mpf(end) - start) for x, y, start, end in zip(
        values, values[1:], samples.times, samples.times[1:], strict=False)]
    return [after - before for before, after in zip([0, *slopes], [*slopes, 0], strict=True)]


def driving_records(scene: "Scene", nodes: "Sequence[Node]") -> list[DrivingRecord]:
    """Those in expressions; PhysicsError of one whose argument is no linear function of the time alone."""
    found = []
    for part in reachable(nodes):
        if part.op == "call" and part.name in part.table.records:
            rate = gradient(part.args[0]).get(scene.time)
            if rate is None or rate.mask or part.args[0].mask != scene.time.mask:
                raise PhysicsError(f"no reference is found where the record '{part.name}' is asked at other instants "
                                   "than linear functions of the time")
            letters = (part.table.parameter(f"{kind}[{len(found)}]", positive=False) for kind in ("level", "slope"))
            order = int(part.args[1].coefficient) if len(part.args) > 1 else 0
            found.append(DrivingRecord(part, part.table.records[part.name], order, rate, *letters))
    return found


def strikes(record: DrivingRecord) -> bool:
    """Does it hold impulses?"""
    return record.order > 1 or (record.order == 1 and record.samples.jumps)


class PiecesOfRecords(SmoothPieces):
    """The equations of a motion that records drive, from sample to sample; as SmoothPieces."""

    def __init__(self, records: Sequence[DrivingRecord], scene: "Scene", parts: "Dynamics", values: Any,
                 floats: Mapping[str, float], until: float, work: Any) -> None:
        lines = {record.node: record.line() for record in records}
        super().__init__(scene, parts.made_of(substitute(parts.nodes(), lines)), values,
                         {**floats, **{letter.name: 1.0 for record in records for letter in record[-2:]}}, until, work)
        self._records, self._samples = records, {}

    def series(self, t: int, bits: int) -> Any:
        """As that of SmoothPieces, up to the next sample."""
        compute, limit, longest = super().series(t, bits)
        instants = self._known(bits)[0]
        place = bisect_right(instants, t)
        ends = [end for end in (limit, *instants[place:place + 1]) if end is not None]
        return compute, min(ends, default=None), longest

    def _computed(self, piece: "MotionSeries", t: int,
                  bits: int) -> "Callable[[int, int, Sequence[int], int], Coefficients]":
        own, values = self._known(bits)[1], dict(self.values(bits))
        with mpmath.workprec(2 * bits):
            for record, (instants, forwards) in zip(self._records, own, strict=True):
                level, slope = record.numbers(bisect_right(instants, t), forwards)
                values |= {record.level.name: level, record.slope.name: slope}
        return piece.with_bits(values, bits)

    def _known(self, bits: int) -> tuple[list[int], list[tuple[list[int], bool]]]:
        """(all instants, [(those of a record, ascend they with its samples?)]) in fixed point."""
        if bits not in self._samples:
            with mpmath.workprec(2 * bits):
                values, time = self.values(bits), self.scene.time.name
                own = [([fixed_point(t, bits) for t in record.instants(time, values)],
                        evaluate([record.rate], multiprecision(), values)[0] > 0) for record in self._records]
            self._samples[bits] = sorted({t for instants, _ in own for t in instants}), own
        return cast("tuple[list[int], list[tuple[list[int], bool]]]", self._samples[bits])
