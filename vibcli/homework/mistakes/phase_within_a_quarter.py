"""The arc tangent beyond resonance, half a turn away."""

from vibcli.homework.mistakes.mistake import CommonMistake, by_formula

MISTAKE = CommonMistake("half a turn away: beyond resonance the phase is more than a right angle",
                  formula=by_formula("{0} - pi*sign({0})", ("phase",)))
