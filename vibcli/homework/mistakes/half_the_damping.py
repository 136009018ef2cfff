"""Half the decay: c/(4m)."""

from vibcli.homework.mistakes.mistake import CommonMistake, by_formula

MISTAKE = CommonMistake("half of it: c/(4m) instead of c/(2m)?",
                  formula=by_formula("{}/2", ("zeta", "decay")))
