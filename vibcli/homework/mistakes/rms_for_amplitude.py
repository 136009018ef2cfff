"""The root mean square of a harmonic for its amplitude."""

from vibcli.homework.mistakes.mistake import AMPLITUDES, CommonMistake, by_formula

MISTAKE = CommonMistake("this is the root mean square: the amplitude is √2 times that",
                  formula=by_formula("{}/sqrt(2)", AMPLITUDES))
