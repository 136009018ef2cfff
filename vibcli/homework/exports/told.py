"""What answers that are numbers are told: the band of the key, and beyond it those of mistakes, as `grade` tells them
apart."""

from collections.abc import Iterator, Mapping
from itertools import combinations, pairwise
from typing import Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.homework.marks import mistake_near, reach

RIGHT = ""              # in place of a mistake


class ToldBand(NamedTuple):
    """Answers from low to high, in the unit that is asked, are right where `mistake` is '', else show that mistake."""

    low: float
    high: float
    mistake: str

    def scaled(self, factor: float) -> "ToldBand":
        """The same in another unit, of which the asked one is so many."""
        return ToldBand(self.low * factor, self.high * factor, self.mistake)


def bands_told(key: Mapping[str, Any]) -> list[ToldBand]:
    """The ToldBands of a key of a manifest, none of which overlap: first that of the key, then mistakes that give 0 and
    have no width."""
    value, width = key["value"], reach(key["value"], key["band"])
    right = ToldBand(value - width, value + width, RIGHT)
    zero = mistake_near(0.0, 0.0, key) if any(one["value"] == 0.0 for one in key["mistakes"]) else None
    points = [ToldBand(0.0, 0.0, zero)] if zero is not None and not right.low <= 0.0 <= right.high else []
    return [right, *points, *_joined(_of_mistakes(key, right))]


def _of_mistakes(key: Mapping[str, Any], right: ToldBand) -> Iterator[ToldBand]:
    """Pieces of the line, upwards, each with the mistake that `grade` names there; none within the key's band."""
    spans = [_span(one["value"], key) for one in key["mistakes"]]
    places = {end for span in spans for end in span}
    places |= {end for end in right[:2] if any(low < end < high for low, high in spans)}
    spanned = [(one["value"], *span) for one, span in zip(key["mistakes"], spans, strict=True)]
    places |= {(one + other) / 2 for (one, low, high), (other, least, most) in combinations(spanned, 2)
               if low < most and least < high}
    for low, high in pairwise(sorted(places)):
        inner = (low + high) / 2
        if not right.low <= inner <= right.high and (name := mistake_near(inner, 0.0, key)) is not None:
            yield ToldBand(low, high, name)


def _span(value: float, key: Mapping[str, Any]) -> tuple[float, float]:
    width = reach(value, key["band"] * (abs(value / key["value"]) if key["value"] else 1.0))
    return value - width, value + width


def _joined(pieces: Iterator[ToldBand]) -> list[ToldBand]:
    found: list[ToldBand] = []
    for one in pieces:
        if found and found[-1].mistake == one.mistake and found[-1].high == one.low:
            found[-1] = found[-1]._replace(high=one.high)
        else:
            found.append(one)
    return found
