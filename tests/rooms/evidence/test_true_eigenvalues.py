"""Eigenvalues of the reference beside closed forms; what does not settle is refused, what is wrong is seen."""

import mpmath
import pytest

from vibcli.api.source import problem_of, text_source
from vibcli.base.errors import PhysicsError
from vibcli.bench import scenes
from vibcli.evidence.reference import modal
from vibcli.evidence.reference.settled import DoesNotSettle, TrueValues, alike, relative_error, settled

ONE = "bodies: {{b: {{mass: 1 kg, slide: x}}}}\nsprings: {{s: {{k: 4 N/m, between: [ground, b]}}}}\n" \
      "dampers: {{d: {{c: {c} N*s/m, between: [ground, b]}}}}\n"


def elements(text):
    return problem_of(text_source(text)).configuration.precise_system


def near(found, exact):
    return all(abs(x - y) <= mpmath.mpf(10) ** -45 * abs(y) for x, y in zip(found, exact, strict=True))


def test_a_chain_of_equal_masses():
    found = modal.rates(elements(scenes.chain(5)))
    with mpmath.workdps(60):
        exact = [mpmath.mpc(0, 2 * mpmath.sqrt(1000) * mpmath.sin((2 * i + 1) * mpmath.pi / 22)) for i in range(5)]
        assert near(found.values, exact) and found.digits == 47


@pytest.mark.parametrize("c", ["1e-12", "1", "4", "4.0000000001", "1e8"])
def test_one_degree_however_it_is_damped(c):
    found = modal.eigenvalues(elements(ONE.format(c=c)))
    with mpmath.workdps(found.working):
        half = mpmath.mpf(c) / 2
        root = mpmath.sqrt(half * half - 4)
        exact = [x for x in (-half + root, -half - root) if mpmath.im(x) >= 0]
        assert near(found.values, modal.by_size(exact))


def test_what_has_no_inertia_has_no_eigenvalue_and_what_is_free_has_zeros():
    massless = ("bodies: {b: {mass: 1 kg, slide: x}, d: {mass: 0 kg, slide: y}}\nsprings: {s: {k: 4 N/m, between: "
                "[ground, b]}, t: {k: 3 N/m, between: [b, d]}, r: {k: 2 N/m, between: [ground, d]}}\n")
    assert modal.squares(elements(massless)).values == [pytest.approx(5.2)]
    free = ("bodies: {b: {mass: 1 kg, slide: x}, d: {mass: 2 kg, slide: y}}\n"
            "springs: {t: {k: 3 N/m, between: [b, d]}}\ndampers: {d: {c: 4 N*s/m, between: [d, b]}}\n")
    assert modal.eigenvalues(elements(free)).values[:2] == [0, 0]
    assert modal.squares(elements(free)).values == [0, pytest.approx(4.5)]


def test_damped_eigenvalues_without_dampers_are_those_of_the_symmetric_problem():
    """Two routes: of the pencil in companion form, and by Cholesky."""
    data = elements(scenes.pendulum(3))
    one, two = modal.eigenvalues(data), modal.rates(data)
    with mpmath.workdps(60):
        assert near([mpmath.im(x) for x in one.values], [mpmath.im(x) for x in two.values])
        assert all(mpmath.re(x) == 0 for x in one.values)


def test_many_coordinates_and_members_are_refused():
    with pytest.raises(PhysicsError, match="takes too long"):
        modal.eigenvalues(elements(scenes.chain(30)))


def test_what_two_precisions_do_not_find_alike_is_refused():
    with pytest.raises(DoesNotSettle, match="47 digits of it are not alike"):
        settled(lambda: ([mpmath.mpf(mpmath.mp.dps)], None))
    found = settled(lambda: ([mpmath.pi + mpmath.mpf(10) ** (-mpmath.mp.dps // 2)], "more"))
    assert found.working == 240 and found.about == "more"
    assert not alike([mpmath.mpf(0)], [mpmath.mpf("1e-300")], 40) and not alike([mpmath.mpf(1)], [], 40)


@pytest.mark.parametrize(("found", "error"), [
    ([3, 1, 0], 0.0), ([1, 3], 0.0), ([1, 3.003, 0], 1e-3), ([1, 3, 0.03], 0.01), ([1], float("inf")),
    ([1, 3, 0, 0], float("inf")), ([1, float("nan")], float("inf"))])
def test_errors_of_values_beside_their_partners(found, error):
    true = TrueValues([mpmath.mpf(0), mpmath.mpf(1), mpmath.mpf(3)], 47, 60, 30)
    assert relative_error(found, true) == pytest.approx(error, rel=1e-9)
