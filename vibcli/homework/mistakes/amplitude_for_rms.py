"""The amplitude of a harmonic for its root mean square."""

from vibcli.homework.mistakes.mistake import CommonMistake, by_formula

MISTAKE = CommonMistake("√2 times too much: is this the amplitude?",
                  formula=by_formula("sqrt(2)*{}", ("rms",)))
