"""What a start of a small motion may give."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

FOLLOWED = 1e-9     # of the start: how nearly a place must be that to which a coordinate follows the others


def check_start(problem: "Problem", motion: Any) -> None:
    """Refuses a velocity of what has no inertia, and a place of what nothing holds back."""
    record = problem.spec.get("initial")
    if motion.system is None or record is None:
        return
    names, reach = problem.scene.coordinates, abs(motion.start).max() + abs(motion.q0).max()
    for key in record:
        i = names.index(key.rstrip("'")) if key.rstrip("'") in names else None
        if i is None or motion.M[i, i]:
            continue
        if key.endswith("'"):
            raise PhysicsError(f"'{names[i]}' has no inertia: its velocity follows from the forces and cannot be given",
                               f"leave {key} out", record.place(key))
        if abs(motion.start[i] - motion.q0[i]) > FOLLOWED * reach:
            raise PhysicsError(f"nothing holds '{names[i]}' back, neither inertia nor a damper: at t = 0 it stands "
                               f"{motion.start[i]:.6g} from where it rests, not {motion.q0[i]:.6g}", f"leave {key} out",
                               record.place(key))
