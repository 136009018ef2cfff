"""Parts in series of which one may give way, or is level over a stretch: their inner equilibria on the branch from
rest, in floats.

With the deflection dⱼ of that weak part as the parameter, the others have dᵢ = Fᵢ⁻¹(Fⱼ(dⱼ)) where their laws rise, and

    D = dⱼ + Σ dᵢ        dD/ddⱼ = 1 + Fⱼ′ Σ 1/Fᵢ′

The branch ends where dD/ddⱼ vanishes: there the parts snap to another inner equilibrium, if there is one.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.rising_laws import HALVINGS, PLACES, RisingLaws

if TYPE_CHECKING:
    from vibcli.symbolic.rising_laws import Laws

ROUNDS, UNIT = 12, 2.0**-52
FAR = 2.0**60               # metres, radians: an end beyond is none
SETTLED = 2.0**-40          # of a deflection: Newton's next step would be its square
CELLS, CUTS = 64, 10                        # cells of a range, each in turn
FINE = 2.0 ** np.arange(-3, 4, 1 / 64)      # places about the top of a law, over it


class Side(NamedTuple):
    """The branch to one side, without signs: |D|, ascending, and the deflections of the parts; the number of the weak
    part; the |D| at which it ends (inf: nowhere), whether parts snap there, and the least |D| at which they rest again
    beyond (inf: none)."""

    totals: np.ndarray
    deflections: np.ndarray
    weak: int
    end: float = np.inf
    snaps: bool = False
    again: float = np.inf


class BranchInSeries:
    """laws(d): (forces, slopes) at an array d of the shape (count, places)."""

    def __init__(self, laws: "Laws", count: int) -> None:
        self.laws, self.count = laws, count
        rising = {sense: RisingLaws(laws, count, sense) for sense in (1, -1)}
        self.sides = {sense: _side(rising[sense], rising[-sense]) for sense in (1, -1)}

    def deflections(self, total: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(dᵢ of the shape (count, places), their force) at deflections of the whole; NaN beyond the branch."""
        found = np.full((self.count, *total.shape), np.nan)
        with np.errstate(all="ignore"):
            for sense, side in self.sides.items():
                here = (sense * total >= 0) & (sense * total <= side.end)
                if np.any(here):
                    found[:, here] = sense * self._on(side, sense, np.abs(total[here]))
            forces, slopes = self.laws(found)
            return found, _of(forces, _softest(slopes))

    def ending(self, unit: str) -> str | None:
        """Where the parts snap, or are not known, as a predicate; None where they go on."""
        told = {sense: _told(side, sense, unit) for sense, side in self.sides.items() if side.end < FAR}
        if len(told) == 2 and _told(self.sides[-1], 1, unit) == told[1]:
            told = {0: told[1].replace("deflection of ", "deflection of ±").replace("and ", "and ±")}
        return " and ".join(told.values()) or None

    def _on(self, side: Side, sense: int, total: np.ndarray) -> np.ndarray:
        k = np.clip(np.searchsorted(side.totals, total, side="right") - 1, 0, len(side.totals) - 2)
        low, high = side.deflections[:, k], side.deflections[:, k + 1]
        share = (total - side.totals[k]) / (side.totals[k + 1] - side.totals[k])
        d, settled = self._by_newton(low + share * (high - low), total, sense)
        slack = 4 * UNIT * total
        inside = np.all((d >= np.minimum(low, high) - slack) & (d <= np.maximum(low, high) + slack), axis=0)
        lost = ~(settled & inside)
        if np.any(lost):
            d[:, lost] = self._by_halving(low[:, lost], high[:, lost], total[lost], sense, side.weak)
        return d

    def _by_newton(self, d: np.ndarray, total: np.ndarray, sense: int) -> tuple[np.ndarray, np.ndarray]:
        """(dᵢ, have they settled)."""
        for _ in range(ROUNDS):
            forces, slopes = self.laws(sense * d)
            step = newton_step(d, total, sense * forces, slopes)
            d = d + step
            settled = np.all(np.abs(step) <= np.maximum(SETTLED * np.abs(d), 4 * UNIT * total), axis=0)
            if np.all(settled):
                break
        return d, settled

    def _by_halving(self, low: np.ndarray, high: np.ndarray, total: np.ndarray, sense: int, weak: int) -> np.ndarray:
        """Within cells of the branch, in which every dᵢ goes one way."""
        at_low, at_high = low[weak], high[weak]
        for _ in range(HALVINGS):
            middle = 0.5 * (at_low + at_high)
            d = self._with(middle, low, high, sense, weak)
            short = d.sum(axis=0) < total
            at_low, at_high = np.where(short, middle, at_low), np.where(short, at_high, middle)
        return self._with(at_high, low, high, sense, weak)

    def _with(self, of_weak: np.ndarray, low: np.ndarray, high: np.ndarray, sense: int, weak: int) -> np.ndarray:
        """The deflections where the weak part has its own."""
        force = sense * self.laws(sense * np.array([of_weak] * self.count))[0][weak]
        least, most = np.minimum(low, high), np.maximum(low, high)
        for _ in range(HALVINGS):
            middle = 0.5 * (least + most)
            below = sense * self.laws(sense * middle)[0] < force
            least, most = np.where(below, middle, least), np.where(below, most, middle)
        found: np.ndarray = most
        found[weak] = of_weak
        return found


def _told(side: Side, sense: int, unit: str) -> str:
    end, again = (f"{sense * x:.6g} {unit}" for x in (side.end, side.again))
    if not side.snaps:
        return f"are not known beyond a deflection of {end}"
    if not np.isfinite(side.again):
        return f"snap at a deflection of {end}, beyond which no inner equilibrium is near"
    return f"snap at a deflection of {end}: they have several inner equilibria between {again} and that"


def newton_step(d: np.ndarray, total: np.ndarray, forces: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    """Towards Fᵢ = f, Σ dᵢ = D. With the softest part s, δₛ (1 + Σ Fₛ′/Fᵢ′) = D − Σ dᵢ − Σ (Fₛ − Fᵢ)/Fᵢ′ and
    δᵢ = (Fₛ − Fᵢ + Fₛ′ δₛ)/Fᵢ′."""
    softest = _softest(slopes)
    others = np.arange(len(d)).reshape(-1, *[1] * (d.ndim - 1)) != softest
    slopes_of_others = np.where(others, slopes, 1)
    gap = np.where(others, _of(forces, softest) - forces, 0) / slopes_of_others
    follows = np.where(others, _of(slopes, softest) / slopes_of_others, 1)
    step = (total - d.sum(axis=0) - gap.sum(axis=0)) / follows.sum(axis=0)
    found: np.ndarray = gap + follows * step
    return found


def _softest(slopes: np.ndarray) -> np.ndarray:
    found: np.ndarray = np.argmin(abs(slopes), axis=0)
    return found


def _of(rows: np.ndarray, number: np.ndarray) -> np.ndarray:
    found: np.ndarray = np.take_along_axis(rows, number[None], axis=0)[0]
    return found


def _side(rising: RisingLaws, other: RisingLaws) -> Side:
    """To the side of `rising`, `other` being the laws to the other one."""
    weak = rising.weak()
    top = rising.tops[weak]
    places = np.unique(np.append(PLACES, FINE * top)) if np.isfinite(top) else PLACES
    d, slope = _along(rising, other, weak, places)
    totals = d.sum(axis=0)
    grows = np.isfinite(totals) & (slope > 0)
    stops = np.flatnonzero(~(grows[1:] & (np.diff(totals) > 0)))
    if not stops.size:
        return Side(totals, d, weak)
    k = int(stops[0])
    snaps = bool(np.isfinite(slope[k + 1]) and slope[k + 1] <= 0)
    last = _last(rising, other, weak, places[k], places[k + 1])
    later = np.flatnonzero(grows[k + 1:])
    again = float(np.nanmin(totals[k + 1:k + 2 + later[0]])) if snaps and later.size else np.inf
    return Side(np.append(totals[:k + 1], last.sum()), np.column_stack((d[:, :k + 1], last)), weak, float(last.sum()),
                snaps, max(again, 0.0))


@np.errstate(all="ignore")
def _along(rising: RisingLaws, other: RisingLaws, weak: int, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(deflections, dD/ddⱼ) where the weak part has its deflections at places; NaN where others do not reach its
    force."""
    f = rising.at(np.array([places] * rising.count))[0][weak]
    d = np.array([places if i == weak else np.where(f < 0, -other.inverse(i, -f), rising.inverse(i, f))
                  for i in range(rising.count)])
    slopes = rising.at(d)[1]
    give = (1 / np.delete(slopes, weak, axis=0)).sum(axis=0)
    return d, 1 + np.where(slopes[weak] == 0, 0.0, slopes[weak] * give)


def _last(rising: RisingLaws, other: RisingLaws, weak: int, low: float, high: float) -> np.ndarray:
    """The deflections at the end of the branch between two places of the weak part."""
    for _ in range(CUTS):
        places = np.linspace(low, high, CELLS + 1)
        d, slope = _along(rising, other, weak, places)
        k = int(np.argmin(np.append(np.isfinite(d.sum(axis=0)) & (slope > 0), False)[1:]))
        low, high = places[k], places[min(k + 1, CELLS)]
    return d[:, k]
