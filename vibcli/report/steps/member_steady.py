"""What a load that swings keeps up of members, by their dynamic stiffness (V. Koloušek, Dynamics in
Engineering Structures, 1973):

    D U = F,   D = K − Ω²M + iΩC + Σ Sᵀ d(β) S,   β² = (μΩ² − k)/N of bars, shafts, strings,   β⁴ = (μΩ² − k)/(EI).
"""

from collections.abc import Mapping
from math import isclose
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.steady_state import waves_of_all
from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.complex_numbers import SMALL, cleared, complex_told
from vibcli.report.steps.coupled_members import tell_coupled_steady
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF, fraction_of
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy import ndarray

    from vibcli.numerics.pieces.piece import Piece
    from vibcli.results.modal_response import ModalResponse
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

ASKED = {"amplitude", "phase", "steady"}
WRITTEN = 6         # motions whose D is written out
CLOSE = 1e-8        # relative: of an amplitude by the lines and the engine's
ENTRIES = (("d₁₁ = d₃₃", "EI·β³·(cos βl·sinh βl + sin βl·cosh βl)/N"), ("d₁₂ = −d₃₄", "EI·β²·sin βl·sinh βl/N"),
           ("d₂₂ = d₄₄", "EI·β·(sin βl·cosh βl − cos βl·sinh βl)/N"),
           ("d₁₃", "−EI·β³·(sin βl + sinh βl)/N"), ("d₁₄ = −d₂₃", "EI·β²·(cosh βl − cos βl)/N"),
           ("d₂₄", "EI·β·(sinh βl − sin βl)/N"))


class SwingingLoads(NamedTuple):
    """Ωt + φ of loads of one frequency, its Ω in numbers, the wave they are counted from, and F of each motion."""

    argument: Any
    Omega: float
    wave: str
    forces: "ndarray"


def tell_steady_members(problem: "Problem", sheet: WorkedSolution) -> None:
    """Write down D U = F and its solution where amplitudes are asked; nothing of several frequencies, of supports that
    are driven, and where `damping` acts on modes and no damper beside it."""
    heads = {tree.head for answer in problem.spec.answers for tree in answer.asked.parts.quantities}
    if not heads & ASKED or not problem.scene.timed or problem.numeric.has_free_symbols:
        return
    from vibcli.results.modal_response import ModalResponse

    response = ModalResponse(problem)
    try:
        loads = _loads(problem, response)
        if loads is not None and problem.scene.coordinates and problem.spec.get("damping") is not None:
            tell_coupled_steady(problem, sheet, loads.Omega, loads.forces)
        elif loads is not None and problem.scene.coordinates:
            _SteadyMembers(problem, sheet, response, loads).write()
    except (PhysicsError, NotInLetters):
        return


def _loads(problem: "Problem", response: "ModalResponse") -> SwingingLoads | None:
    """None of supports that move, and of more than one frequency."""
    import numpy as np

    from vibcli.analyses.continuous.mode_basis import in_floats

    if any(node is not None for _, node in response.ends_of_pieces):
        return None
    spread = {("along", k): force.weight for k, force in enumerate(response.spread_forces)}
    nodes: dict[Any, Any] = response.loads | spread
    found = waves_of_all(problem.scene, nodes)
    arguments = list(dict.fromkeys(argument for parts in found.values() for argument, _ in parts))
    if len(arguments) != 1:
        return None
    kinds = sorted({wave for parts in found.values() for _, wave in parts})
    wave, floats, argument = kinds[0] if len(kinds) == 1 else "sin", problem.numeric.floats, arguments[0]
    Omega, = evaluate([gradient(argument)[problem.scene.time]], Floats, floats)
    sizes = {key: _complex(parts, argument, wave, floats) for key, parts in found.items()}
    forces = np.zeros(len(problem.scene.coordinates), complex)
    for key, size in sizes.items():
        if isinstance(key, tuple):
            for one in in_floats(problem.configuration.linear_system.pieces):
                put = response.spread_drives[key[1]].end_loads(one, np.array([1j * Omega]))
                for a, row in enumerate(one.rows if put is not None else ()):
                    for i, v in row.items():
                        forces[i] += v * size * put[0, a]
        else:
            forces[key] += size
    return SwingingLoads(argument, Omega, wave, forces)


def _complex(parts: "Mapping[tuple[Node, str], Node]", argument: "Node", wave: str,
             floats: dict[str, float]) -> complex:
    A, B = (evaluate([parts[argument, kind]], Floats, floats)[0] if (argument, kind) in parts else 0.0
            for kind in ("sin", "cos"))
    return complex(A, B) if wave == "sin" else complex(B, -A)


class _SteadyMembers:
    """The lines of one frequency."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution, response: Any, loads: SwingingLoads) -> None:
        import numpy as np

        from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
        from vibcli.analyses.continuous.mode_basis import in_floats

        self.problem, self.sheet, self.loads = problem, sheet, loads
        self.pieces = in_floats(problem.configuration.linear_system.pieces)
        self.names, self.table = problem.scene.coordinates, problem.scene.table
        self.units = ["m" if problem.system.dimension(name) else "rad" for name in self.names]
        M, C, K = response.matrices
        self.undamped = not C.any() and not any(one.piece.drag or one.retardation for one in self.pieces) and (
            not loads.forces.imag.any())
        D = DynamicMatrix(np.array([K, C, M]), self.pieces).at(np.array([1j * loads.Omega])).D[:, :, 0]
        self.D = np.array([[cleared(complex(x)) for x in row] for row in D])
        U = np.linalg.solve(self.D, loads.forces)
        most = {unit: max(abs(x) for x, own in zip(U, self.units, strict=True) if own == unit) for unit in self.units}
        self.U = [cleared(complex(x)) if abs(x) > SMALL * most[unit] else 0j
                  for x, unit in zip(U, self.units, strict=True)]

    def write(self) -> None:
        """Write down all of them; nothing where the engine finds other amplitudes."""
        if not self._agrees():
            return
        sheet, wave = self.sheet, self.loads.wave
        U, D, F = (Name(sheet.letter(letter)) for letter in "UDF")
        part = Words(f"the {'imaginary' if wave == 'sin' else 'real'} part of  ")
        turned = ["(", self.loads.argument, ")"] if self.loads.argument.op == "sum" else [self.loads.argument]
        form = [U, f"·{wave}(", self.loads.argument, ")"] if self.undamped else [
            part, U, "·exp(i·", *turned, ")"]
        words = ",  of what is lumped and of the dynamic stiffness of each stretch"
        line = sheet.write(Words("steady state: each motion is  "), *form, Words("  with  "), D, "·", U, " = ", F,
                           Words(words), settles="steady state", uses=[sheet.last])
        lines = [line, *self._stretches(line)]
        if len(self.names) <= WRITTEN:
            lines.append(self._entries(lines))
        self._motions(lines)

    def _agrees(self) -> bool:
        turn = -1j if self.loads.wave == "sin" else 1
        for name, U in zip(self.names, self.U, strict=True):
            signal = self.problem.response.kept_up.signal(NameRef(0, len(name), name, 0))
            known = [value for at, value in signal.phasors if isclose(at, self.loads.Omega, rel_tol=CLOSE)]
            if abs((known[0] if known else 0.0) - turn * U) > CLOSE * max(map(abs, self.U)):
                return False
        return True

    def _stretches(self, line: int) -> "Iterator[int]":
        """β of each kind of stretch, and what its ends need."""
        kinds: dict[tuple[Any, ...], list[Any]] = {}
        for one, of in zip(self.pieces, self.problem.symbolic.linearisation.pieces, strict=True):
            kinds.setdefault((one.piece.order, _beta(one.piece, self.loads.Omega)), []).append((one, of.piece))
        Omega = gradient(self.loads.argument)[self.problem.scene.time]
        plain = [(order, beta) for order, beta in kinds if beta is not None]
        for order, beta in plain:
            lengths = list(dict.fromkeys(told(one.piece.length) for one, _ in kinds[order, beta]))
            owners = ", ".join(dict.fromkeys(one.owner for one, _ in kinds[order, beta]))
            piece = kinds[order, beta][0][1]
            square = textbook((piece.inertia * Omega ** 2 - piece.foundation) / (piece.bending if order == 4 else
                                                                                 piece.tension))
            yield self.sheet.write(Words(f"{owners}:  "), "β = ", square ** (HALF if order == 2 else HALF / 2),
                                   *number(beta, "1/m"), Words(",  of length  "), f"l = {' m, '.join(lengths)}",
                                   Words(" m"), settles=f"beta {owners} {beta}", value=beta, unit="1/m", uses=[line])
        for order in sorted({order for order, _ in plain}):
            yield tell_end_forces(self.sheet, order, line)

    def _entries(self, uses: list[int]) -> int:
        """The line of D and F in numbers."""
        n, parts, letter = len(self.names), [], self.sheet.letter
        names = [part for name in self.names for part in (Words(", "), Name(name))][1:]
        for i in range(n):
            for j in range(i, n):
                if self.D[i, j]:
                    parts += [Words(",  "), Name(letter(f"D{i + 1}{j + 1}")), f" = {complex_told(self.D[i, j])}"]
        for i, value in enumerate(self.loads.forces):
            if value:
                parts += [Words(",  "), Name(letter(f"F{i + 1}")), f" = {complex_told(cleared(complex(value)))}"]
        return self.sheet.write(Words("of  "), *names, Words(":  "), *parts[1:], settles="dynamic stiffness", uses=uses)

    def _motions(self, uses: list[int]) -> None:
        """The lines of U of each motion."""
        for i, name in enumerate(self.names):
            letter = self.table.parameter(self.sheet.letter(f"U{i + 1}"))
            unit = self.units[i]
            value, row = (self.U[i].real, self._row(i)) if self.undamped else (abs(self.U[i]), None)
            told = [Words("so  ")] * (not i) + [letter, *([] if self.undamped else [
                f" = {complex_told(self.U[i])}", Words(f" {unit},  "), "|", letter, "|"]), *number(value, unit)]
            self.sheet.write(*told, settles=f"steady {name}", value=value, unit=unit, uses=uses, joined=i > 0,
                             letter=letter.name if self.undamped else "", vanishes=row)

    def _row(self, i: int) -> "Node":
        """What vanishes of a row of D U = F."""
        return self.table.total([self._exact(d.real) * self.table.parameter(self.sheet.letter(f"U{j + 1}"))
                                 for j, d in enumerate(self.D[i])]) - self._exact(self.loads.forces[i].real)

    def _exact(self, value: Any) -> "Node":
        return self.table.number(fraction_of(float(value)))


def tell_end_forces(sheet: WorkedSolution, order: int, line: int, stiff: str = "EI") -> int:
    """The line of what the ends of a uniform stretch need to move; `stiff`: its letter where it bends."""
    if order == 2:
        return sheet.write(Words("an end that moves by 1 while the other one is held needs  "), "S·β·cot βl",
                           Words(",  the other one  "), "−S·β/sin βl", Words(",  "), "S", Words(" the factor of  "),
                           "∂²u/∂x²", settles="stiffness 2", uses=[line])
    parts = [part for head, text in ENTRIES for part in (
        Words(",  "), f"{head} = {text.replace('EI', stiff)}")][1:]
    return sheet.write(Words("ends that move by  "), "u₀, θ₀, u₁, θ₁", Words(",  "), "θ = ∂u/∂x", Words(
        ",  need  "), "d", Words("  times these,  "), "N = 1 − cos βl·cosh βl", Words(",  "), stiff,
        Words(" the factor of  "), "∂⁴u/∂x⁴", Words(":  "), *parts, settles="stiffness 4", uses=[line])


def _beta(piece: "Piece", Omega: float) -> float | None:
    """β of a uniform stretch that waves travel along; None of others, under tension or damped."""
    kappa, stiff = piece.inertia * Omega**2 - piece.foundation, piece.bending or piece.tension
    if kappa <= 0 or piece.gradient or piece.drag or (piece.bending and piece.tension):
        return None
    return float((kappa / stiff) ** (1 / piece.order))
