"""The families of `vibcli stress`: {file, which defines FAMILY: what it turns}."""

FAMILIES = {
    "buckling": "a column of two rods near its critical load: 1 − P/P_cr",
    "close_modes": "frequencies that lie close to each other: their gap",
    "critical_damping": "a free motion just below critical damping: 1 − ζ",
    "damped_chain": "a chain whose dampers are weak or strong: c/√(k m)",
    "damping_ratio": "one mass on a spring and a damper: ζ",
    "dead_point": "a linkage near its dead point: the angle of its crank",
    "detuning": "a load near resonance, without damping: 1 − Ω/ω",
    "double_eigenvalue": "two damped modes near where their shapes are one: the distance from it",
    "gyroscopic": "a mass on a turning table, up to very fast: Ω/ω",
    "long_times": "a free motion after many periods: ω t",
    "many_coordinates": "a chain of equal masses between two walls: their number",
    "mass_ratio": "a chain of six, every other mass heavy: the ratio of the masses",
    "near_node": "a force near a node of the mode that it drives: its distance from it",
    "sharp_peak": "the peak of a frequency response of little damping: ζ",
    "stiffness_ratio": "a chain of six, every other spring stiff: the ratio of the springs",
    "two_pendulums": "a double pendulum at wide angles, integrated: how long it is followed",
    "wide_swing": "a pendulum that lingers on its head, integrated: the angle that it starts from there",
}
