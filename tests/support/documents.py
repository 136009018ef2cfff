"""A scene file with one of everything that a reader meets."""

SCENE = """\
title: "Mass: on a spring"
parameters: {m: 2 kg, k: , on: 010}
bodies:
  block: {mass: m, slide: x}
  'tip''s':
    - [0, -(L + h)]
    - omega[1]: 1e3
answers:
  omega[1]: sqrt(k/m)   # rad/s
  x': ''
question: >
  What is
  asked
"""
