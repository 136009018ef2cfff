"""The modes of one block in letters."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.algebraic_extension import Extension, unless_long
from vibcli.analyses.closed_form.amplitude_ratios import OMEGA, of_omega
from vibcli.analyses.closed_form.characteristic import Characteristic
from vibcli.analyses.closed_form.characteristic_roots import Turning
from vibcli.analyses.closed_form.closed_forms import ClosedMode
from vibcli.analyses.closed_form.damping import proportions
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.characteristic_roots import Simple, Surd
    from vibcli.analyses.closed_form.decoupling import DecoupledBlock
    from vibcli.analyses.closed_form.toeplitz_chains import Cosine
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node


def block_modes(table: "Table", n: int, part: "DecoupledBlock", damping: "Mapping[tuple[int, int], Node]",
                values: Sequence[dict[str, float]]) -> "tuple[list[ClosedMode], list[list[Node]]]":
    """(modes, unsolved polynomials) of a block of a system with n coordinates; `damping`: its C, `values`: samples."""
    M, G, K = part.matrices
    chi = Characteristic(table, len(part), (M, damping, G, K), values[0])
    shares = proportions(chi.M, chi.C, chi.K) if damping else None
    modes, left = [], []
    for modulus, power in chi.factors:
        roots = chi.roots(modulus)
        if roots is None:
            left += [chi.polynomial(modulus)] * power
            continue
        vectors = chi.null_vectors(modulus) or [None] * power
        shapes = [vector and unless_long(_amplitudes, chi, modulus, part, vector, n) for vector in vectors[:power]]
        modes += [_mode(table, root, shape, shares, values) for root in roots for shape in shapes]
    return modes, left


def _mode(table: "Table", root: "Simple | Surd | Turning | Cosine", shape: list[Any] | None,
          shares: tuple[Any, Any] | None, values: Sequence[dict[str, float]]) -> ClosedMode:
    sign = -1 if evaluate([root.square], Floats, values[0])[0] < 0 else 1
    if isinstance(root, Turning):       # G leaves no null vectors, and is told beside no damping
        return ClosedMode(root.square, root.omega(values, sign), unstable=sign < 0, solves=root)
    mode = ClosedMode(root.square, root.omega(values, sign), shape and [root.value(x) for x in shape], sign < 0,
                      root.pair)
    pair = root.pair if root.pair is not None and root.pair.in_letters else None
    if shape and pair:
        mode = mode._replace(pattern=[of_omega(pair.quotients, x) for x in shape])
    if not shares or sign < 0 or root.square.is_zero:
        return mode
    zeta = root.value(shares) / (2 * mode.omega)
    return mode._replace(zeta=zeta, omega_d=mode.omega * (1 - zeta * zeta) ** HALF,
                         zeta_pattern=pair and of_omega(pair.quotients, shares) / (2 * table.parameter(OMEGA)))


def _amplitudes(chi: Characteristic, modulus: list[Any], part: "DecoupledBlock", vector: Sequence[list[Any]],
                n: int) -> list[list[Any]]:
    """x = Σ column·y with the first amplitude that is not zero 1, as elements of F[λ]/(modulus)."""
    field = Extension(chi.quotients.field, modulus)
    found = [[] for _ in range(n)]
    for column, y in zip(part.columns, vector, strict=True):
        for i, whole in column.items():
            found[i] = field.minus(found[i], [c * -whole for c in y])
    scale = field.inverse(next(x for x in found if x))
    return [field.times(scale, x) for x in found]
