"""Scenes with variants, as small as they may be."""

BLOCK = """title: A block
question: A block {m} on a spring {k} and a damper {c}.
parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
dampers: {d: {c: c, between: [ground, block]}}
"""
BY_STRETCH = BLOCK.replace("between: [ground, block]", "stretch: x") + """answers: {"omega_d[1]": 19.90 rad/s}
"""
EIGHTEEN = BLOCK + """variants:
  parameters: {m: {from: 1.2 kg, to: 3.2 kg, step: 0.4 kg}, k: [620 N/m, 820 N/m, 1.1 kN/m]}
  ask: {"omega_d[1]": {unit: rad/s, points: 2}, "zeta[1]": }
"""
LETTERS = """title: A block in letters
question: A block {m} on a spring {k}.
parameters: {m: {}, k: {}, n: 1}
bodies: {block: {mass: n*m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
variants:
  parameters: {n: [2, 3, 5]}
  ask: {"omega[1]": , "equation[x]": }
  without: [told]
"""
