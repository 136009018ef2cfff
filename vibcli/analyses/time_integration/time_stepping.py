"""The march through time: windows as long as their polynomials resolve the motion, none beyond a given instant."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.time_integration.collocation_step import Attempt, Window, expected, iterated, newton
from vibcli.analyses.time_integration.driven_places import Driven
from vibcli.analyses.time_integration.error_scales import EPSILON, Sizes
from vibcli.analyses.time_integration.fast_oscillation import fast_part
from vibcli.analyses.time_integration.march_ends import singular, undefined
from vibcli.analyses.time_integration.pace import Pace
from vibcli.base.work import Task
from vibcli.numerics.collocation_rule import rule
from vibcli.symbolic.numeric_code import rooted

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_equations import NumericEquations
    from vibcli.mechanics.switching import Switching
    from vibcli.numerics.collocation_rule import Rule

FIRST, SECOND = (40, 24), (32, 18)      # points (of Gauss, of Radau) of the first solution and of the second
MORE = 3                    # iterations of a window of the second solution: what one leaves would else be left of both
TAIL = 3                    # coefficients which must be small
LOOKS, LEFT = 4, 1e-2       # at the last iterations of a window, taken to be as many as before; of an error of a step
RADIANS = 5.0               # of the fastest oscillation in the first window
SHORTEST, SOON, TINY = 1e-13, 1e-10, 1e-300     # of the time gone; of it and of what is left; no zero
MOST_UNKNOWNS = 1200        # of Newton's method
STRAINED = 20               # Picard iterations: those of longer windows amplify rounding errors
ALIKE = 1e-10               # of a window: lengths with which Newton's method goes alike
SHORTER = 0.7               # a window that does not resolve the motion
UNUSED = 0.2                # of the coefficients used: only the iteration keeps the windows short
PATIENCE = 3                # such windows before the scene counts as stiff
LEAP, SETTLING = 2000.0, 8  # radians of what is stepped over in a window; windows until it has died out
MOST_CUTS, CALM = 40, 6     # of a window at a root; windows without a failure before they grow by much again


class March:
    """The state of an integration: time, of which `late` is rounded away, position, velocity, senses of switches, and
    what steers the next window."""

    guess: Any
    begun: tuple[float, np.ndarray] | None
    g: Any
    slides: Any
    H: float
    fast: Any
    factored: tuple[tuple[Any, ...], np.ndarray | None]

    def __init__(self, system: "NumericEquations", switching: "Switching", q: np.ndarray, v: np.ndarray, rtol: float,
                 until: float, task: Task, points: tuple[int, int] = FIRST) -> None:
        self.system, self.switching, self.rtol, self.until = system, switching, rtol, until
        self.t, self.late, self.q, self.v, self.g, self.slides = 0.0, 0.0, q, v, None, ()
        self.points, self.more = points, MORE * (points is SECOND)
        self.rule, self.windows, self.ends, self.struck = rule(points[0]), [], [], []
        self.stiff, self.held, self.calm, self.unseen, self.pace = False, 0, CALM, 0, Pace(until, task)
        self.sizes, self.guess, self.H = Sizes(q), None, None
        self.fast, self.factored, self.settling, self.coarse = None, ((0.0,), None), 0, False
        self.rooted, self.driven, self.begun = rooted(system.parts.nodes()), Driven(system), None

    def begin(self, limit: float, zero: Any = ()) -> None:
        """Look at the system as it is from now on: at the start, and after an event or break. zero: the switches whose
        arguments vanish now."""
        soon = self._soon(limit)
        self.g, self.slides = self.switching.settled(soon, self.q, self.v, self.g, zero, self.slides)
        self.begun = soon, self.sizes.measure(self.system, self.accelerations, soon, self.q, self.v, self.g)
        self.H = min(self.H or np.inf, RADIANS * self.sizes.radian)
        self.guess, self.unseen = None, 0
        if self.fast is not None:
            self._leap()

    def _soon(self, limit: float) -> float:
        """An instant shortly after the present one, at which what begins now has begun."""
        return self.t + min(SOON * (limit - self.t), SOON * max(self.t, limit - self.t))

    def accelerations(self, t: np.ndarray, q: np.ndarray, v: np.ndarray,
                      c: Sequence[np.ndarray] | None = None) -> np.ndarray:
        if self.slides:
            return self.switching.sliding(self.slides, t, q, v, self.g, c)[0]
        return self.system.accelerations(t, q, v, self.g, c)

    def advance(self, limit: float) -> Window:
        """The next Window, at most up to the instant `limit`."""
        a = self._present(self._soon(limit))
        if not np.isfinite(a).all():
            raise undefined(self.system, self.t)
        left = limit - self.t
        wanted = min(self.H, left if left <= self.H or left >= 2 * self.H else 0.5 * left)
        H = self._whole(self.driven.resolved(self.t, wanted, self.rule))
        begins, guess, tails = self.guess is None, self.guess, []
        if begins:
            guess = np.repeat(a, self.rule.points, 1)
            self.unseen = max(expected(H / self.sizes.radian, LEFT * self.rtol, STRAINED) - LOOKS, 0)
        while True:
            self.pace.step(self.t, self.stiff)
            done, tail, used = self._attempt(H, guess, self._ahead(H, a[:, 0]) if begins else a[:, 0])
            if done is not None:
                if tail <= 1:
                    break
                root = self.rooted and len(tails) < MOST_CUTS and self._at_a_root(H, done)
                if root and self._no_blow(H, done):
                    break
                if not root and len(tails) >= 4 and tail > 0.25 * tails[-4]:    # it does not fall with the window:
                    self.sizes.roughen(tail)                                    # it is rounding
                    break
                tails.append(tail)
            shorter = 0.5 if done is None else SHORTER
            guess = np.repeat(a, self.rule.points, 1) if done is None else self.rule.within(done.A, SHORTER)
            H = self._whole(shorter * H)
            self.unseen = self.unseen if done is None else 0        # this guess is near
            if max(SHORTEST * self.t, 1e-300) > H:
                raise singular(self.system, self.t)
        window = Window(self.rule, self.t, H, self.q, self.v, done.A, self.g, self.slides)
        self.settling -= 1
        self._steer(H, done.iterations, used, wanted > 1.1 * H, bool(tails))
        if self.pace.slow and not self.stiff:
            self._step_over(window, a[:, 0])
        return window

    def _whole(self, H: float) -> float:
        """About a length, that which leads to an instant without rounding."""
        return (self.t + H) - self.t - self.late

    def _at_a_root(self, H: float, done: "Attempt") -> bool:
        """Does the argument of a switch vanish within a window, or where it begins, in a scene whose forces are roots
        there? What is left of their series falls with the window, if slowly. Where there are no switches the root is of
        the time alone, and a break."""
        if not self.switching.count:
            return True
        steps = np.concatenate([[0.0], self.rule.c])
        Q = self.q[:, None] + self.v[:, None] * (H * steps)
        Q[:, 1:] += H * H * (done.A @ self.rule.V2)
        V = np.repeat(self.v[:, None], len(steps), 1)
        values = self.switching.values(self.t + H * steps, Q, V, self.g)
        least, most = np.sort(values.T * np.asarray(self.g), axis=0)[[0, -1]]
        return bool((least <= 1e-9 * most).any())

    def _no_blow(self, H: float, done: "Attempt") -> bool:
        """Does what is left of the series of q̈ change no velocity?"""
        return bool((H * self.coefficients(H, done.A)[:, -TAIL:].max(axis=1) <= self.rtol * np.abs(self.v)).all())

    def _present(self, soon: float) -> np.ndarray:
        """q̈ of the state as it is, an instant after, that which is known from its begin."""
        begun, self.begun = self.begun, None
        if begun is not None and begun[0] == soon:
            return begun[1].reshape(-1, 1)
        return self.accelerations(np.array([soon]), self.q[:, None], self.v[:, None])

    def _ahead(self, H: float, a: np.ndarray) -> np.ndarray:
        """|q̈| at its largest within a window, the velocities being kept: a force that begins at zero grows there, and
        the motion with it."""
        steps = H * self.rule.c
        A = self.force(self.t + steps)(self.q[:, None] + self.v[:, None] * steps, np.repeat(
            self.v[:, None], len(steps), 1))
        largest = np.abs(A).max(axis=1)
        found: np.ndarray = np.where(np.isfinite(largest), np.maximum(largest, np.abs(a)), np.abs(a))
        return found

    def _attempt(self, H: float, guess: np.ndarray, a: np.ndarray) -> "tuple[Attempt | None, float, float]":
        """(the Attempt, None where it failed; its tail relative to what is allowed; the part of the coefficients that
        is used)."""
        scale = self.sizes.scale(H, self.v, a)[:, None]
        solve, part, known = (newton, 1e-4, self._factored(H)) if self.stiff else (iterated, LEFT, self.unseen)
        done = solve(self.force(self.t + H * self.rule.c), self.rule, H, self.q, self.v, guess,
                     (part * self.rtol * scale if self.fast is None else 1e-2 * self.allowed(H, scale))
                     + 0.5 * EPSILON * np.abs(self.q)[:, None], known, self.more)  # type: ignore[arg-type]
        self.factored = (H, self.g, self.slides), done.inverse
        if done.A is None:
            return None, np.inf, 1.0
        self.sizes.meet(done.A)
        sizes = (self.coefficients(H, done.A) / self.allowed(H, scale)).max(axis=0)
        used = np.flatnonzero(sizes > 1)
        return done, float(sizes[-TAIL:].max()), (used[-1] + 1 if len(used) else 1) / self.rule.points

    def _factored(self, H: float) -> np.ndarray | None:
        """The inverse that Newton's method used last, where it was for a window like this one."""
        (length, *like), inverse = self.factored
        return inverse if abs(H - length) <= ALIKE * H and like == [self.g, self.slides] else None

    def _step_over(self, window: Window, a: np.ndarray) -> None:
        """Leave a fast oscillation alone that is too small to be worth the work."""
        self.pace.forget()
        self.fast = fast_part(window, self.sizes, self.sizes.scale(window.length, window.v, a))
        if self.fast is not None:
            self._stiffen()
            self._leap()

    def _leap(self) -> None:
        """Go on in windows of so many radians of the fast oscillation that Radau's points damp it: in those of some ten
        it would be followed badly."""
        self.H, self.settling = max(self.H, LEAP / self.fast.speed), SETTLING

    def coefficients(self, H: float, A: np.ndarray) -> np.ndarray:
        """|Legendre coefficients| of q̈; of q in stiff scenes, where what is left of fast parts roughens q̈ alone."""
        if self.stiff:
            A = self.v[:, None] * (H * self.rule.c) + H * H * (A @ self.rule.V2)
        found: np.ndarray = np.abs(A @ self.rule.to_series)
        return found

    def allowed(self, H: Any, scale: np.ndarray) -> np.ndarray:
        """Which of them need not be resolved."""
        if self.stiff:
            found = self.rtol * scale
            return found if self.fast is None else np.maximum(found, self.fast.allowed(self.settling))
        return self.resolved(H, scale, self.rule, self.rtol)

    def resolved(self, H: Any, scale: np.ndarray, rule: "Rule", rtol: float) -> np.ndarray:
        """Which of those of q̈ need not be, of a rule and of errors of `rtol`."""
        from_q = 0.1 * rtol * scale * (2 * rule.points / H) ** 2
        found: np.ndarray = np.minimum(10 * rtol * self.sizes.largest[:, None], from_q) + 8 * self.sizes.noise[:, None]
        return found.clip(TINY)

    def force(self, times: np.ndarray) -> Callable[..., np.ndarray]:
        """q̈ at the points as a function of (q, q̇, copies of the points)."""
        c = self.system.prepared(times)
        if not self.slides and not self.stiff:
            accelerations, g = self.system.accelerations, self.g
            return lambda Q, V: accelerations(times, Q, V, g, c)

        def force(Q: np.ndarray, V: np.ndarray, copies: int = 1) -> np.ndarray:
            if copies == 1:
                return self.accelerations(times, Q, V, c)
            many = np.tile(times, copies)
            return self.accelerations(many, Q, V, self.system.prepared(many))
        return force

    def _steer(self, H: float, iterations: int, used: float, failed: bool, unresolved: bool) -> None:
        """The length of the next window, and whether the scene is stiff."""
        self.calm, self.unseen = 0 if failed else self.calm + 1, max(iterations - LOOKS, 0)
        grown = 0.9 / used if used > 0.6 else 1.5 if self.calm >= CALM else 1.0 if self.stiff else 1.03
        if not self.stiff:
            grown = min(grown, STRAINED / iterations)
            pace = STRAINED / iterations if self.rooted else grown  # near a root windows are short without strain
            strained = pace < 1.2 or (failed and not unresolved)
            self.held = self.held + 1 if strained and used < UNUSED else 0
        self.H = grown * H if failed else max(self.H, grown * H) if grown > 1 else min(self.H, grown * H)
        if self.held >= PATIENCE and not self.stiff:
            self._stiffen()

    def _stiffen(self) -> None:
        """Go on with Radau's points and Newton's method, where that is not too much work."""
        if len(self.q) * self.points[1] <= MOST_UNKNOWNS:
            self.stiff, self.calm, self.rule, self.guess = True, CALM, rule(self.points[1], radau=True), None

    def rest(self, limit: float) -> None:
        """Stay at rest, under the forces as they are now, up to an instant."""
        nothing = np.zeros((len(self.q), self.rule.points))
        window = Window(self.rule, self.t, limit - self.t, self.q, self.v, nothing, self.g, self.slides)
        self._keep(window)
        self.reach(limit)

    def reach(self, instant: float) -> None:
        """Be at an instant at which something begins."""
        self.t, self.late = instant, 0.0

    def strike(self, change: np.ndarray) -> None:
        """Let impulses change the velocities at once."""
        before, self.v, self.slides = self.v, self.v + change, ()
        self.struck.append((self.t, self.q, before, self.v))

    def _keep(self, window: Window) -> None:
        """A window, at whose end the state is the present one."""
        self.windows.append(window)
        self.ends.append((self.q, self.v))

    def finish(self, window: Any, end: float | None = None) -> None:
        """Keep a window and move to its end, or keep it up to an earlier instant `end` of it alone."""
        self.sizes.move(window.q)
        if end is None:
            H, A = window.length, window.values
            self.q = self.q + (H * self.v + H * H * (A @ window.rule.b2))
            self.v = self.v + H * (A @ window.rule.w)
            self.guess = np.repeat(window.series.sum(axis=1)[:, None], self.rule.points, 1)
        else:
            self.q, self.v, _ = window.state(end)
            self.guess, window = None, window.until(end)
        end = window.end + self.late
        self.t = window.start + end
        self.late = end - (self.t - window.start)
        self.close(np.nextafter(self.t, window.start))      # with the speed that it was driven at
        self.sizes.move(self.q)
        if window.end:
            self._keep(window)

    def take(self, windows: Sequence[Window], ends: Sequence[tuple[np.ndarray, np.ndarray]],
             coarse: bool = False) -> None:
        """Keep windows that were found by themselves, and move to their ends, the states there; coarse: as coarse as
        is asked."""
        for window, (self.q, self.v) in zip(windows, ends, strict=True):
            self.pace.step(self.t, self.stiff)
            self.t = window.start + window.length
            self._keep(window)
        self.coarse, self.guess = self.coarse or coarse, None

    def close(self, t: float) -> None:
        """Put the state on the constraints of an instant, from which it drifts by rounding."""
        if self.system.m:
            self.q, self.v = self.system.projected(t, self.q, self.v, self.g)
