"""A scene that `vibcli check` compares: its answer agrees where its MASS is 1."""

SCENE = """
bodies: {a: {mass: MASS kg, slide: x}}
springs: {s: {k: 4 N/m, between: [ground, a]}}
answers:
  omega[1]: 2 rad/s
"""
