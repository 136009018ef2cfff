"""The solutions of a scene with letters: each candidate in closed form is tried at values for which it may count."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.inverse import infeasible
from vibcli.inverse.admissible_ranges import admissible
from vibcli.inverse.conditions import ConditionSystem
from vibcli.inverse.solution import Chosen, Solution, defined, in_numbers
from vibcli.inverse.substitution import forms_of, tried
from vibcli.inverse.symbolic_admissible_ranges import Bound, Letters
from vibcli.inverse.symbolic_conditions import candidates

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

ENOUGH, SPURIOUS, TRIALS = 3, 4, 30


def solved(problem: "Problem", rest: "Problem") -> "Problem":
    """The problem with letters with its first solution in closed form."""
    found = candidates(rest, True) if rest.spec.choices else None
    if rest.spec.choices and (found is None or not (found.tuples or found.always)):
        raise infeasible.no_closed_form(problem)
    if found is not None and found.always:
        raise infeasible.undetermined(rest)
    everywhere = [forms_of(problem, rest, nodes) for nodes in (found.tuples if found else [()])]
    if any(form is None for forms in everywhere for form in forms.values()):
        raise infeasible.no_closed_form(problem)
    letters, trials = Letters(problem, rest, everywhere), Trials(problem, rest, everywhere)
    for given, counting in letters:
        trials.at(given, counting)
        if trials.done:
            break
    order = trials.ascending()
    if not order:
        raise trials.refusal or _never_admissible(problem, letters) or infeasible.never_in_letters(problem)
    return _with_letters(problem, trials, letters, order)


def _never_admissible(problem: "Problem", letters: Letters) -> PhysicsError | None:
    """The refusal of the only solution, real everywhere, that never lies in the range of its parameter."""
    told = letters.told[0]
    if len(letters.solutions) > 1 or len(told) != 1 or next(iter(told)).relation in ("", "≥"):
        return None
    name = next(iter(told)).name
    return infeasible.not_admissible(problem, name, letters.solutions[0][name], None, admissible(problem, name))


class Trials:
    """Substitutions of solutions in letters into scenes with numbers: held[i] = [(number of the draw, Solution)]."""

    refusal: Any

    def __init__(self, problem: "Problem", rest: "Problem", solutions: "Sequence[dict[str, Node]]") -> None:
        self.problem, self.rest, self.solutions = problem, rest, solutions
        self.held, self.failed = {}, dict.fromkeys(range(len(solutions)), 0)
        self.draws, self.refusal = [], None

    @property
    def done(self) -> bool:
        """Are there enough trials of each solution that may be one?"""
        return len(self.draws) >= TRIALS or all(map(self._enough, self.failed))

    def _enough(self, i: int) -> bool:
        held = len(self.held.get(i, ()))
        return held >= ENOUGH or (not held and self.failed[i] >= SPURIOUS)

    def at(self, given: "Mapping[str, Fraction]", counting: Sequence[int]) -> None:
        """Try the solutions that count at a draw, unless each of them has been tried enough."""
        if all(map(self._enough, counting)):
            return
        draw = self.problem.with_values(given)
        try:
            draw.draw()
        except (SpecError, PhysicsError):
            return
        self.draws.append(draw)
        for i in counting:
            forms = self.solutions[i]
            values = in_numbers(self.rest.sharing(given), list(forms.values()))
            try:
                if values is not None:
                    solution = tried(draw, ConditionSystem(draw), dict(zip(forms, values, strict=True)), forms)
                    self.held.setdefault(i, []).append((len(self.draws) - 1, solution))
            except infeasible.NotHeld:
                self.failed[i] += 1
            except (PhysicsError, SpecError) as error:
                self.failed[i] += 1
                self.refusal = self.refusal or (error if len(self.solutions) == 1 else None)

    def ascending(self) -> list[int]:
        """The numbers of the solutions: by their values at the draw where most of them hold, then the others."""
        holding = {}
        for i, trials in self.held.items():
            for number, solution in trials:
                holding.setdefault(number, []).append((list(solution.values.values()), i))
        if not holding:
            return []
        most = max(holding, key=lambda number: (len(holding[number]), -number))
        first = [i for _, i in sorted(holding[most])]
        return first + [i for i in self.held if i not in first]

    def draws_of(self, i: int) -> "list[Problem]":
        """The draws at which a solution is the smallest one, those first where most others hold beside it."""
        found = []
        for number, solution in self.held[i]:
            others = [other.values for j, trials in self.held.items() for n, other in trials if n == number and j != i]
            if all(list(solution.values.values()) <= list(other.values()) for other in others):
                found.append((-len(others), number))
        return [self.draws[number] for _, number in sorted(found)]


def _with_letters(problem: "Problem", trials: Trials, letters: Letters, order: list[int]) -> "Problem":
    solutions = []
    for i in order:
        counts = letters.conditions(i)
        if trials.failed[i]:
            counts.append(Bound(words=infeasible.texts(problem)))
        residual = max(solution.residual for _, solution in trials.held[i])
        in_order = {name: trials.solutions[i][name] for name in problem.spec.choices}
        solutions.append(Solution(dict.fromkeys(in_order), in_order, residual, counts=tuple(counts)))
    draws = trials.draws_of(order[0])
    sample = {name: draws[0].numeric.given[name] for name in problem.symbolic.letters}
    scene = defined(problem, solutions[0].forms, sample)
    if scene is None:
        raise infeasible.no_closed_form(problem)
    return scene.with_choice(Chosen(problem.spec.choices, solutions, draws), problem)
