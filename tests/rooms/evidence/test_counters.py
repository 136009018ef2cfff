"""What twenty problems count is what it was: dearer answers are seen without a clock.

Where a change is meant, `PYTHONPATH=tests python tests/rooms/evidence/test_counters.py` writes the counters anew.
"""

import json
from pathlib import Path

import pytest
from support.counted import CALLS, counters, differences

PROBLEMS = Path(__file__).resolve().parents[3] / "problems"
KEPT = Path(__file__).with_name("counters.json")
NAMED = (
    "1_statics_and_energy/ladder_held_by_spring", "2_lagrange/bead_on_swinging_rod", "3_free_undamped/taut_bead",
    "4_free_damped/sagging_boom", "4_free_damped/door_closer_critical", "4_free_damped/plate_swings_in_water",
    "4_free_damped/galloping_sign_arm", "4_free_damped/relay_armature_in_oil", "5_forced/half_power_of_a_braked_lever",
    "5_forced/press_with_two_blows", "5_forced/accelerometer_on_a_casing", "6_two_degrees/cart_with_pendulum",
    "6_two_degrees/double_pendulum_rods", "7_forced_two_degrees/washing_machine_on_a_bench",
    "7_forced_two_degrees/two_storeys_on_shaken_ground", "7_more_degrees/six_storeys_shaken_at_the_top",
    "8_continuous/cantilever_with_tip_mass", "8_continuous/portal_frame", "8_continuous/mast_on_a_cart",
    "8_continuous/hanging_chain")


def found():
    return {name: counters(str(PROBLEMS / f"{name}.yaml")) for name in NAMED}


def test_twenty_problems_are_named():
    kept = json.loads(KEPT.read_text(encoding="utf-8"))
    assert len(set(NAMED)) == 20 and set(kept) == set(NAMED)
    counted = {*CALLS, "expressions made", "modules", "exit"}
    assert all(one["exit"] == 0 and set(one) == counted for one in kept.values())
    assert all(any(one[what] for one in kept.values()) for what in CALLS)


@pytest.mark.sweep
@pytest.mark.parametrize("name", NAMED)
def test_what_is_counted_is_what_it_was(name):
    kept = json.loads(KEPT.read_text(encoding="utf-8"))
    assert differences({name: kept[name]}, {name: counters(str(PROBLEMS / f"{name}.yaml"))}) == []


def test_a_doubled_loop_and_an_extra_module_are_seen():
    before = {"a": {"factorisations": 8, "modules": 160}, "b": {"modules": 1}}
    now = {"a": {"factorisations": 16, "modules": 161}, "c": {"modules": 1}}
    assert differences(before, now) == ["b: counted on one side alone", "c: counted on one side alone",
                                        "a: factorisations 8 → 16", "a: modules 160 → 161"]


if __name__ == "__main__":
    KEPT.write_text(json.dumps(found(), indent=1) + "\n", encoding="utf-8")
