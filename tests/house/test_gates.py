"""What breaks solvers, gate by gate: each has tests that measure its error, by name, and each of these is there.

Figures of run time stand in parts of `python -m vibcli.bench`, as ratios to baselines of the same run.
"""

import ast
from pathlib import Path

import pytest

from vibcli.bench import PARTS

TESTS = Path(__file__).parents[1]
ROOMS, ANALYSES = "rooms/", "rooms/analyses/"
MODAL, DAMPED = ANALYSES + "modal/test_modal.py", ANALYSES + "modal/test_damped.py"
LINEAR, FREQUENCY = ANALYSES + "transient/test_response.py", ANALYSES + "frequency_response/test_frequency.py"
UNIFORM = ANALYSES + "continuous/test_uniform_members.py"
COUNTED = ANALYSES + "continuous/test_natural_frequencies.py"
LAGRANGE, MODES = "routes/test_lagrange.py", "routes/test_laws_of_modes.py"
EQUILIBRIA = ROOMS + "mechanics/equilibrium/test_equilibria.py"
TRAJECTORY, CHAOS = (ANALYSES + f"time_integration/test_{name}.py" for name in ("trajectory", "chaos"))
LOWEST = ROOMS + "numerics/test_lowest_eigenvalues.py"
HOSTILE, FUZZ = "fuzz/test_hostile.py", "fuzz/test_fuzz.py"
BACKBONES = ROOMS + "quantities/test_backbones.py"
FOLDS = ROOMS + "quantities/test_folds.py"

GATES = {       # {gate: (what it is of, {file: tests}, parts of the benchmark)}
    "A1": ("natural frequencies at stiffness ratios up to 1e20", {
        MODAL: ["test_every_frequency_to_the_last_digit_within_its_bound", "test_thirty_coordinates_of_any_stiffness"],
        ANALYSES + "modal/test_bounds.py": ["test_no_frequency_of_irrational_geometry_is_beyond_its_bound"]}, []),
    "A2": ("rigid motions, counted, and what is elastic beside them", {
        MODAL: ["test_rigid_motions_are_counted_not_measured", "test_rank_of_rational_rows_and_of_rows_with_rounding",
                "test_every_frequency_to_the_last_digit_within_its_bound"],
        EQUILIBRIA: ["test_a_free_cart_is_neutral_along_its_way"]}, []),
    "A3": ("mode shapes and their orthogonality", {
        MODAL: ["test_shapes_are_orthonormal_and_satisfy_the_equations", "test_shapes_of_separated_modes",
                "test_repeated_frequencies_have_an_orthonormal_basis"]}, []),
    "A4": ("preloaded systems: bounds, escalation, unstable modes", {
        MODAL: ["test_rounding_of_preloads_is_bounded_and_escalated", "test_negative_springs_make_unstable_modes",
                "test_forty_preloaded_coordinates_have_as_many_unstable_modes_as_k_has_negative_eigenvalues"]}, []),
    "A5": ("damped eigenvalues of any damping, gyroscopic systems", {
        DAMPED: ["test_every_eigenvalue_to_the_last_digit_within_its_bound", "test_anything_at_all",
                 "test_conservative_gyroscopic_systems_neither_grow_nor_decay"]}, []),
    "A6": ("one degree of freedom, ζ from 0 to 1e8", {
        LINEAR: ["test_one_degree_to_a_few_roundings"],
        DAMPED: ["test_one_degree_of_freedom_of_any_damping"],
        ROOMS + "results/test_precise_motion.py": ["test_free_vibration_even_where_it_has_died_out"]}, []),
    "A7": ("several degrees, defective, at resonance, drifting", {
        LINEAR: ["test_several_degrees", "test_differences_where_nodes_meet"]}, ["responses"]),
    "A8": ("frequency responses and their peaks", {
        FREQUENCY: ["test_few_degrees_against_fifty_digits", "test_many_degrees_against_fifty_digits",
                    "test_the_grid_sees_every_peak", "test_a_pole_on_the_grid_is_said"]}, ["frequency_responses"]),
    "A9": ("a thousand frequencies of uniform members", {
        UNIFORM: ["test_a_thousand_frequencies_of_beams_to_the_last_digits",
                  "test_a_thousand_frequencies_of_bars_and_of_beams_between_sines"]}, ["members"]),
    "A10": ("their shapes at any place", {UNIFORM: ["test_shapes_at_any_place_to_the_last_digits"]}, []),
    "A11": ("spans, steps and attachments: none missed, none too many", {
        COUNTED: ["test_random_members_have_as_many_frequencies_as_their_finite_elements",
                  "test_many_digits_agree_with_mpmath", "test_modes_that_rest_at_every_joint_are_found"],
        ROOMS + "numerics/pieces/test_stiffness.py": ["test_nothing_is_lost_from_tiny_to_huge_pieces"],
        ROOMS + "results/test_fifty_digits_of_members.py": ["test_one_member", "test_a_portal_frame"],
        "routes/test_laws_of_members.py": ["test_as_many_as_are_counted_are_listed"]}, ["members_counted"]),
    "A12": ("M, C and K from the energies", {
        LAGRANGE: ["test_matrices_in_floats", "test_matrices_in_many_digits",
                   "test_floats_are_the_rounded_many_digits"]}, ["growth"]),
    "A13": ("equilibria: balanced, all of a known set, judged", {
        EQUILIBRIA: ["test_pendulums_of_two_and_three_links", "test_himmelblau",
                     "test_a_slider_crank_all_the_way_round"],
        ROOMS + "mechanics/equilibrium/test_equilibrium.py": ["test_every_scale"]}, []),
    "A14": ("families of periodic motions; folds of loads", {
        BACKBONES: ["test_duffing", "test_about_one_of_two_wells"],
        FOLDS: ["test_a_truss_that_snaps_through", "test_limit_points_next_to_each_other"]}, []),
    "A15": ("a thousand periods of a nonlinear motion", {
        TRAJECTORY: ["test_a_pendulum_of_a_thousand_periods", "test_a_short_pulse_late_in_time_is_not_stepped_over"]},
        ["trajectories"]),
    "A17": ("powers of two change no bit, another order few", {
        MODAL: ["test_units_change_no_bit", "test_order_of_coordinates_does_not_matter"],
        LINEAR: ["test_units_change_no_bit"],
        MODES: ["test_powers_of_two_change_no_bit_of_rows", "test_powers_of_two_change_no_bit_in_the_plane",
                "test_bodies_and_springs_in_another_order"]}, []),
    "A18": ("nothing but finite numbers", {
        LINEAR: ["test_nothing_but_finite_numbers", "test_growth_beyond_numbers_is_said"],
        "fuzz/test_fuzz_responses.py": ["test_responses_with_changes"]}, []),
    "A19": ("bounds of what is read off linear motions", {
        "fuzz/test_linear_bounds.py": ["test_bounds_of_linear_motions_hold"],
        ROOMS + "results/test_escalation.py": ["test_a_value_in_doubt_is_found_anew"],
        ROOMS + "results/test_precise_signals.py": ["test_twelve_printed_digits_a_million_seconds_after"]}, []),
    "A20": ("estimates of full motions, and where they end to be known", {
        "fuzz/test_full_bounds.py": ["test_no_estimate_of_a_full_motion_is_exceeded"],
        CHAOS: ["test_every_printed_digit_of_a_chaotic_motion_is_true"]}, []),
    "A21": ("lowest modes of sparse systems, none missed", {
        LOWEST: ["test_a_chain_that_is_held", "test_a_chain_that_is_free",
                 "test_forty_that_coincide_are_all_counted", "test_counts_of_a_shift_between_close_eigenvalues"],
        ANALYSES + "modal/test_lowest_modes.py": ["test_slices_agree_with_dense_matrices"]}, ["sparse"]),
    "S1": ("hostile files", {
        HOSTILE: ["test_expressions", "test_files", "test_little_memory_is_enough"],
        "fuzz/test_document_fuzz.py": ["test_hostile_mebibyte_is_refused_at_once"]}, ["files"]),
    "S2": ("what is mutated at random", {
        FUZZ: ["test_expressions", "test_scenes_with_changes_in_their_text", "test_scenes_with_changes_in_their_nodes"],
        "fuzz/test_document_fuzz.py": ["test_fuzz_nothing_but_diagnostics_escapes"]}, []),
    "P1": ("cold starts", {
        "house/test_imports.py": ["test_help_imports_nothing_heavy", "test_frequencies_in_numbers",
                                  "test_the_package_alone_imports_nothing"]}, ["startup"]),
}
NUMBERS = [*(f"A{number}" for number in range(1, 22) if number != 16), "S1", "S2", "P1"]     # there is no A16


def missing(gates, parts, folder):
    """Tests and parts of the benchmark that are named and not there."""
    for gate, (_, files, measured) in gates.items():
        for file, names in files.items():
            tree = ast.parse((folder / file).read_text()) if (folder / file).exists() else ast.Module([], [])
            there = {one.name for one in ast.walk(tree) if isinstance(one, ast.FunctionDef)}
            yield from (f"{gate}: {file}::{name}" for name in names if name not in there)
        yield from (f"{gate}: part {part}" for part in measured if part not in parts)


def test_every_gate_has_tests_that_are_there():
    assert list(GATES) == NUMBERS and all(files for _, files, _ in GATES.values())
    assert list(missing(GATES, PARTS, TESTS)) == []


@pytest.mark.parametrize(("files", "parts", "expected"), [
    ({"test_a.py": ["test_b"]}, [], []), ({"test_a.py": ["test_c"]}, [], ["A1: test_a.py::test_c"]),
    ({"test_d.py": ["test_b"]}, [], ["A1: test_d.py::test_b"]), ({}, ["waves"], ["A1: part waves"])])
def test_what_is_missing_is_seen(files, parts, expected, tmp_path):
    (tmp_path / "test_a.py").write_text("def test_b():\n    pass\n")
    assert list(missing({"A1": ("", files, parts)}, PARTS, tmp_path)) == expected
