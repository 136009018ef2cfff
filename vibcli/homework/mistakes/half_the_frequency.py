"""A factor 4 missing under the root."""

from vibcli.homework.mistakes.mistake import FREQUENCIES, RATES, CommonMistake, by_formula

MISTAKE = CommonMistake("half of it: is a factor 4 missing under the root?",
                  formula=by_formula("{}/2", RATES + FREQUENCIES))
