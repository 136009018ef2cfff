"""The factor of the velocity for half of it: 2δ = c/m."""

from vibcli.homework.mistakes.mistake import CommonMistake, by_formula

MISTAKE = CommonMistake("twice of it: c/m instead of c/(2m)?",
                  formula=by_formula("2*{}", ("zeta", "decay")))
