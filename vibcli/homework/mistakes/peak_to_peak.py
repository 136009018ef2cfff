"""The whole range for the amplitude."""

from vibcli.homework.mistakes.mistake import AMPLITUDES, CommonMistake, by_formula

MISTAKE = CommonMistake("twice of it: the amplitude is half the range from peak to peak",
                  formula=by_formula("2*{}", AMPLITUDES))
