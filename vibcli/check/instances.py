"""Instances of a scene with values for its free symbols and for what it chooses: the same at every run."""

from fractions import Fraction

from vibcli.base.errors import PhysicsError, SpecError

DRAWS, CANDIDATES = 3, 40
FAILURES = 8        # draws without a solution after which the search for what is chosen is given up


class Draws:
    """Numeric Problems of a scene: itself, or with random values for its symbols for which the drawing fits together;
    with values for what it chooses.

    Made when they are asked for and kept; `wanted` is how many of them a comparison takes.
    """

    def __init__(self, problem):
        symbolic = bool(problem.symbolic.letters)
        self.wanted = DRAWS if symbolic else 1
        self._known = [] if symbolic else [_settled(problem)]
        self._candidates = _candidates(problem) if symbolic else iter(())

    def __iter__(self):
        yield from self._known
        for problem in self._candidates:
            self._known.append(problem)
            yield problem


def drawn(problem):
    """The problem with random values for its letters, whenever the drawing fits together."""
    from vibcli.language.parameter_samples import sample_values

    for attempt in range(CANDIDATES):
        values = sample_values(problem.symbolic.letters, attempt)
        given = {name: Fraction(value).limit_denominator(1000) for name, value in values.items()}
        candidate = problem.with_values(given)
        try:
            candidate.draw()
        except (SpecError, PhysicsError):
            continue
        yield candidate


def _candidates(problem):
    """Those for which what the scene chooses can be found; its refusal where that is so for none."""
    found, failed, refusal = 0, 0, None
    for candidate in _for_choices(problem) or drawn(problem):
        try:
            settled = _settled(candidate)
        except (SpecError, PhysicsError) as error:
            refusal, failed = refusal or error, failed + 1
            if failed >= FAILURES and not found:
                break
            continue
        found += 1
        yield settled
    if not found and refusal is not None:
        raise refusal


def _for_choices(problem):
    """Draws at which the first solution in letters of what a scene chooses is the first one; None without such."""
    if not problem.spec.choices:
        return None
    from vibcli.inverse import settled

    try:
        return settled(problem).choice.draws
    except PhysicsError:
        return None


def _settled(problem):
    """The problem with values for what it chooses."""
    if not problem.spec.choices:
        return problem
    from vibcli.inverse import settled

    return settled(problem)
