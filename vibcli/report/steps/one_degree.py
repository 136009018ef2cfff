"""The steps from the equation of one degree of freedom to its frequency, its damping, its free motion from a given
start, and its steady state under one harmonic."""

from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Factor, Name, WithNumbers, Words
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.small_oscillations import SmallEquations
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.normal_form import is_zero
from vibcli.symbolic.radicals import root

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


ROUNDING = 2.0**-50         # of ζ that is 1


class OneDegree:
    """The steps of m q̈ + c q̇ + k q = Q."""

    def __init__(self, problem: "Problem", about: AboutRest, sheet: WorkedSolution, found: SmallEquations):
        self.problem, self.about, self.sheet, self.found = problem, about, sheet, found
        zero = about.table.zero
        self.M, self.C, self.K = (part.get((0, 0), zero) for part in (found.M, found.C, found.K))
        self.omega, self.delta, self.zeta, self.omega_d = (
            about.letter(sheet.letter(name)) for name in ("omega", "delta", "zeta", "omega_d"))

    def write(self) -> None:
        """Write down all of them."""
        if self.M.is_zero or self.K.is_zero:
            return
        square = single(self.K / self.M)
        value = self.about.value(square)
        if value is not None and value < 0:
            self.sheet.write(self.omega ** 2, " = ", square, *number(value, "1/s²"),
                             Words(" < 0: it leaves the equilibrium"), settles="omega[1]", node=square)
            return
        if value == 0:
            self.sheet.write(self.omega ** 2, " = ", square, " = 0", Words(": to the first order nothing brings it "
                             "back"), settles="omega[1]", node=square)
            return
        of_omega = self._frequency(square)
        of_delta = None if self.C.is_zero else self._damping(of_omega)
        self._free_motion([of_omega, of_delta])
        self._steady_state()

    def _root(self, node):
        """√ of an expression, in its simplest form."""
        return root(node, self.about.samples)

    def _frequency(self, square):
        omega = self._root(square)
        line = self._settled([self.omega ** 2, " = ", square, Words(",  "), self.omega], omega, "rad/s",
                             "omega[1]", self.found.lines, letters=False)
        if (value := self.about.value(omega)) is not None:
            turn = 2 * self.about.table.pi
            self.sheet.write("f = ", self.omega / turn, " = " + told(value / tau), Words(" Hz,  "), "T = ",
                             turn / self.omega, " = " + told(tau / value), Words(" s"), uses=[line],
                             settles="frequency[1]")
        return line

    def _damping(self, of_omega):
        """δ = c/(2m), ζ = δ/ω, ω_d; the number of the last line."""
        delta = single(self.C / (2 * self.M))
        of_delta = self._settled([Words("half the factor of the speed over that of the acceleration:  "),
                                  self.delta], delta, "1/s", "delta", self.found.lines)
        zeta = self.C / (2 * self._root(self.K) * self._root(self.M))
        value = self.about.value(zeta)
        if is_zero(self.C * self.C - 4 * self.M * self.K) or (value is not None and abs(value - 1) <= ROUNDING):
            value = 1.0
        kind = () if value is None else (Words(
            ": under-damped" if value < 1 else ": critically damped" if value == 1 else ": over-damped"),)
        line = self.sheet.write(self.zeta, " = ", self.delta / self.omega, " = ", zeta,
                                *(() if value is None else number(value)), *kind, uses=[of_delta, of_omega],
                                settles="zeta[1]", node=zeta, value=value)
        if value is None or value < 1:
            return self._damped_frequency(delta, [of_omega, of_delta, line])
        return line

    def _damped_frequency(self, delta, uses):
        from vibcli.analyses.closed_form.one_degree import damped_frequency

        omega_d = damped_frequency(self.M, self.C, self.K, self.about.samples)
        parts = [self.omega_d, " = ", self.about.table.sqrt(self.omega ** 2 - self.delta ** 2)]
        return self._settled(parts, omega_d, "rad/s", "omega_d[1]", uses)

    def _settled(self, head, node, unit, settles, uses, letters=True):
        """A line `head = expression = with numbers = value`."""
        value, numbers = self.about.value(node), self.about.numbers()
        parts: list[Any] = [*head, *([" = ", node] if letters or value is None else [])]
        if value is not None:
            put_in = {name: figure(x) for name, x in numbers.items()}
            parts += [" = ", WithNumbers(node, put_in), *number(value, unit)]
        return self.sheet.write(*parts, settles=settles, node=node, value=value, unit=unit, uses=uses)

    def _free_motion(self, uses):
        """The constants of the free motion from the start that the file gives, under-damped or not damped."""
        from vibcli.mechanics.initial_state import start_in_letters

        try:
            start = start_in_letters(self.problem.symbolic)
        except PhysicsError:
            return
        if start is None or self.found.drive or self.problem.spec.in_full:
            return
        x0, v0 = start
        delta = single(self.C / (2 * self.M))
        rest = self.about.value(self.K / self.M - delta * delta)
        if rest is None or rest <= 0:
            return
        (name,), table = self.problem.scene.coordinates, self.about.table
        A, B, start, speed = (self.about.letter(letter) for letter in (
            self.sheet.letter("A"), self.sheet.letter("B"), self.sheet.letter(f"{name}_0"),
            self.sheet.letter(f"v_{name}0")))
        rate, t = self.omega if self.C.is_zero else self.omega_d, self.problem.scene.time
        wave = A * table.call("cos", rate * t) + B * table.call("sin", rate * t)
        decay = () if self.C.is_zero else (table.call("exp", -(self.delta * t)), "·")
        line = self.sheet.write(Name(name), " = ", *decay, Factor(wave) if decay else wave, settles=name, uses=uses)
        of_A, of_B = self.about.value(x0), self.about.value(v0 + delta * x0) / rest**0.5
        unit = "m" if self.problem.system.dimension(name) else "rad"
        ahead = speed if self.C.is_zero else speed + self.delta * start
        self.sheet.write(Words("from the start "), start, " = ", x0, Words(",  speed "), speed, " = ", v0,
                         Words(":  "), A, " = ", start, *number(of_A, unit), Words(",  "), B, " = ",
                         ahead / rate, *number(of_B, unit), uses=[line], settles="free motion")

    def _steady_state(self):
        """X and θ under one harmonic, from the complex equation (k − mΩ² + icΩ) X = Q."""
        if not self.found.drive or self.problem.spec.in_full:
            return
        name, = self.problem.scene.coordinates
        try:
            steady = self.problem.symbolic_steady_state(name)
        except (NotInLetters, PhysicsError):
            return
        formula, table = steady.formula, self.about.table
        X, theta = (self.about.letter(self.sheet.letter(letter)) for letter in ("X", "theta"))
        lags = not (formula.undamped or formula.ahead)
        wave = steady.wave if not formula.ahead else {"sin": "cos", "cos": "sin"}[steady.wave]
        node = X * table.call(wave, steady.argument - theta if lags else steady.argument)
        node = -node if formula.ahead and steady.wave == "cos" else node
        line = self.sheet.write(Words("steady state:  "), Name(name), " = ", node, uses=self.found.lines,
                                settles="steady state")
        unit = "m" if self.problem.system.dimension(name) else "rad"
        self._settled([X], formula.amplitude, unit, f"amplitude({name})", [line])
        if lags and formula.tangent is not None:
            self._settled([table.call("tan", theta)], formula.tangent, "", "tan theta", [line])
