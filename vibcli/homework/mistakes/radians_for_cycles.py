"""Radians for cycles: ω = 2πf."""

from math import tau

from vibcli.homework.mistakes.mistake import FREQUENCIES, CommonMistake, by_reading

MISTAKE = CommonMistake("this is the angular frequency in rad/s: f = ω/(2π)",
                  reading=by_reading(tau, FREQUENCIES))
