"""Texts that break scenes: put in place of a value, or around it where `_` stands; and what is asked of all diagnostics
that come of them."""

from vibcli.base.diagnostics import render

EXTREMES = ("0", "-1", "1e300", "-1e50 m", "1e-50 kg", "1e59 N/m", "1e-59 N/m", "0 kg", "0 N/m", "-3 kg",
            "-800 N/m", "nan", "inf", "", "x", "x^2", "sin(x)", "1/x", "1/(x - x)", "sqrt(-1)", "sqrt(x)",
            "log(0)", "exp(1000)", "[]", "9**9**9**9", "static", "ground", "1 m", "3 Hz", "5 rad", "true",
            "inside", "t", "pi", "1e30", "x'", "[0, 0]")
SAME = ("-(_)", "0*(_)", "1e55*(_)", "1e-55*(_)", "1e12*(_)", "1e-12*(_)", "_ - (_)", "(_)*(1 + 1e-15)",
        "abs(_)", "-2*(_)", "sqrt((_)^2)", "max(_, 0)", "min(0, _)", "(_)*sin(1)", "3*(_)", "(_)^2/(_)",
        "1e-9*(_)", "(_)*cos(pi/2)", "1e6*(_)")


def require_told(error):
    """Each diagnostic of a SpecError says something, in print."""
    assert error.diagnostics
    for diagnostic in error.diagnostics:
        assert diagnostic.message
        assert render(diagnostic, []).replace("\n", "").isprintable()
