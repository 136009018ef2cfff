"""What keys, and mistakes, are at the places of a grid: by arrays where these tell, else by the scene of a place."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.homework.keys import AnswerKey
from vibcli.homework.regime import Regime, regime
from vibcli.quantities.at_once import AnswersAtOnce
from vibcli.quantities.expression import value_of

if TYPE_CHECKING:
    from vibcli.homework.mistakes.known import KnownMistake
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.results.variants import Place, Variants


class GridAnswers:
    """Of scenes that are drawn by `scene_at(place)`, a Problem or why there is none; at_once: what arrays tell of them,
    where they do."""

    def __init__(self, scene_at: "Callable[[Place], Problem | SpecError | PhysicsError]",
                 at_once: AnswersAtOnce | None = None):
        self._scene_at, self._at_once = scene_at, at_once
        self._last: tuple[Place | None, Problem | SpecError | PhysicsError | None] = None, None
        self._oscillates = None if at_once is None else at_once.oscillates()

    @classmethod
    def of(cls, variants: "Variants") -> "GridAnswers":
        return cls(variants.scene, AnswersAtOnce(variants))

    def scene(self, place: "Place") -> "Problem":
        """That of a place; SpecError, PhysicsError where there is none."""
        if self._last[0] != place:
            self._last = place, self._scene_at(place)
        found = self._last[1]
        if isinstance(found, Exception):
            raise found.with_traceback(None)
        return found

    def value_of(self, place: "Place", expression: "Expression") -> tuple[float, float]:
        """(value, relative error bound); SpecError, PhysicsError where it has none."""
        found = None if self._at_once is None else self._at_once.value_of(expression, place)
        return value_of(self.scene(place), expression) if found is None else found

    def found(self, place: "Place", key: AnswerKey) -> Any:
        """What a key is."""
        if type(key) is AnswerKey:
            return key.in_unit(*self.value_of(place, key.asked))
        return key.found(self.scene(place))

    def mistaken(self, place: "Place", keys: Sequence[AnswerKey], mistake: "KnownMistake", concerns: Sequence[bool],
                 right: Sequence[Any]) -> tuple[Any, ...]:
        """What a mistake gives for each key, None where it does not concern it or has no solution; right: the right
        answers."""
        return tuple([self._mistaken(place, key, mistake, found) if concerned else None
                      for key, found, concerned in zip(keys, right, concerns, strict=True)])

    def _mistaken(self, place: "Place", key: AnswerKey, mistake: "KnownMistake", right: Any) -> Any:
        if type(key) is AnswerKey:
            return key.mistaken_by(mistake, partial(self.value_of, place), right)
        try:
            return key.mistaken(mistake, self.scene(place), right)
        except (SpecError, PhysicsError):
            return None

    def regime(self, place: "Place", rests: bool) -> Regime:
        """The Regime of the scene of a place."""
        kinds = None if rests or self._oscillates is None else self._oscillates.get(place)
        return regime(self.scene(place), rests) if kinds is None else Regime(*kinds, None)
