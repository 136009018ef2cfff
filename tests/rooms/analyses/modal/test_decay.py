"""The decay of a damped mode is ζω, in letters as in numbers, of over-damped modes too; that of the scenes of trials is
looked at where they are solved.
"""

from pathlib import Path

import pytest
from support.decays import damped_modes, wrong_decays
from support.scenes import kept_problem_of, problem

from vibcli.base.errors import PhysicsError
from vibcli.quantities.expression import measure
from vibcli.report.sections.spectrum_data import frequencies_data
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import lower

ROOT = Path(__file__).parents[4]
SCENES = sorted((ROOT / "problems").glob("*/*.yaml"))


@pytest.mark.sweep
def test_decay_is_zeta_omega_in_every_problem():
    seen = set()
    for path in SCENES:
        assert not wrong_decays(kept_problem_of(path)), path
        seen |= {(mode.zeta is None, mode.omega_d is None) for mode in damped_modes(kept_problem_of(path))}
    assert seen == {(False, False), (False, True), (True, True)}


TEXT = """
    parameters: {{m: {}, k: {}, c: {}}}
    bodies: {{block: {{mass: m, slide: x}}}}
    springs: {{s: {{k: k, between: [ground, block]}}}}
    dampers: {{d: {{c: c, between: [ground, block]}}}}
"""


@pytest.mark.parametrize("c", [4.0, 20.0, 60.0])
def test_letters_and_numbers_agree_where_they_say_so(c):
    """m = 2, k = 50: ζ = c/20. What --json gives in letters, put into numbers; ω_d where its condition holds."""
    mode, = frequencies_data(problem(TEXT.format("", "", "")))["damped"]
    numeric, values = problem(TEXT.format("2 kg", "50 N/m", f"{c} N*s/m")), {"m": 2.0, "k": 50.0, "c": c}
    table = numeric.scene.table

    def number(text):
        node = lower(parse(text), table, lambda name, primes, part: numeric.scene.parameters.nodes[name])
        return evaluate([node], Floats, values)[0]

    for key in ("omega", "zeta", "decay"):
        assert measure(numeric, parse(f"{key}[1]"))[0] == pytest.approx(number(mode[key]), rel=1e-14), key
    zeta, _, one = mode["omega_d_where"].partition(" < ")
    if number(zeta) < number(one):
        assert measure(numeric, parse("omega_d[1]"))[0] == pytest.approx(number(mode["omega_d"]), rel=1e-14)
    else:
        with pytest.raises(PhysicsError, match="has no damped frequency"):
            measure(numeric, parse("omega_d[1]"))
