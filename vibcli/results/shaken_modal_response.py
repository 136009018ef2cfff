"""The motion in time of scenes with members whose supports are driven while `damping:` damps their modes."""

from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

from vibcli.results.damping_of_modes import damping_of_modes
from vibcli.results.modal_response import ModalResponse
from vibcli.results.not_by_modes import NotByModes
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.continuous.disturbances import Disturbances
    from vibcli.analyses.continuous.mode_basis import ModeBasis
    from vibcli.analyses.continuous.shaken_modes import ShakenTransfer, Shaking, Support
    from vibcli.analyses.continuous.start_of_fields import FieldStart
    from vibcli.symbolic.node import Node


class ShakenModalResponse(ModalResponse):
    """Small oscillations about the equilibrium; the displacements of supports are channels of their own, the last."""

    WORDS = "small oscillations about the equilibrium, by modes"
    estimated = True

    @cached_property
    def _transfer(self) -> "ShakenTransfer":
        import numpy as np

        from vibcli.analyses.continuous.exact_transfer import ExactTransfer
        from vibcli.analyses.continuous.shaken_modes import ShakenTransfer

        modal, moved = self.problem.modal, self._exact
        if any(mode.rigid for mode in modal.modes.shown()):
            raise NotByModes("supports are driven beside `damping:` of members that nothing holds",
                             "ask for steady(…), or take `damping:` out")
        M, C, K = self.matrices
        loads = ExactTransfer(np.array([K, C, M]), moved.pieces, (), self.spread_drives)
        return ShakenTransfer(loads, moved, self._supports, modal.modes, modal.member_damping)

    @cached_property
    def _supports(self) -> "list[Support]":
        """What each displacement that drives the scene puts on coordinates and driven ends."""
        import numpy as np

        from vibcli.analyses.continuous.shaken_modes import Support

        opened, n, found = self.configuration.with_inputs, len(self.matrices[0]), []
        for j in self._inputs:
            forces = np.zeros((2, n))
            for row, power in zip(forces, (0, 2), strict=True):
                for i, x in opened.columns[j][power].items():
                    row[i] += x
            for weight, row in (spring for placed in self.placed for spring in placed.springs):
                for i, x in row.items() if row.get(j) else ():
                    if i < n:
                        forces[0, i] += weight * x * row[j]
            rows = [self.placed[drive.piece].rows[drive.end] for drive in self._driven_ends]
            found.append(Support(forces, np.array([float(row.get(j, 0.0)) for row in rows])))
        return found

    def _shaking(self, basis: "ModeBasis") -> "Shaking":
        import numpy as np

        from vibcli.analyses.continuous.shaken_modes import Shaking, rate_share
        from vibcli.symbolic.evaluation import Floats, evaluate

        ends = np.array([-basis.end_forces(*drive) for drive in self._driven_ends]).reshape(-1, len(basis.squares))
        g = np.array([one.forces[0] @ basis.shapes + one.ends @ ends for one in self._supports]).T
        m = np.array([one.forces[1] @ basis.shapes for one in self._supports]).T
        c = damping_of_modes(self, self._transfer.pieces, len(basis.squares))
        r = rate_share(self.problem.modal.member_damping, basis.squares, c, g, m)
        scene, nodes = self.problem.scene, list(self._inputs.values())
        known = {**self.problem.numeric.floats, scene.time.name: 0.0}
        start = np.array([evaluate(part, Floats, known) for part in (nodes, [scene.rate(node) for node in nodes])])
        if not np.isfinite(start).all():
            raise NotByModes("a support jumps at t = 0 beside `damping:` of members", "let it begin without a jump")
        return Shaking(np.array([g, r, m]), start)

    def _disturbed(self, basis: "ModeBasis", inputs: "np.ndarray",
                   damping: "np.ndarray") -> "tuple[list[FieldStart], Callable[..., Disturbances]]":
        return super()._disturbed(basis, super()._felt(basis), damping)

    def _felt(self, basis: "ModeBasis") -> "np.ndarray":
        import numpy as np

        from vibcli.analyses.continuous.modal_start import of_drive

        spread = [of_drive(basis, drive)[:, None] for drive in self.spread_drives]
        return np.concatenate([basis.shapes.T, *spread], axis=1)

    @property
    def loaded(self) -> "tuple[dict[int, Node], int]":
        """{channel: node of the time} of coordinates without what displacements of supports put on them, of loads along
        members and of these, and how many there are."""
        table, scene, nodes = self.problem.scene.table, self.problem.scene, dict(self.drive)
        opened = self.configuration.with_inputs
        for j, u in self._inputs.items():
            rates = u, scene.rate(u), scene.rate(scene.rate(u))
            for column, rate in zip(opened.columns[j], rates, strict=True):
                for i, x in column.items():
                    nodes[i] = nodes.get(i, table.zero) - table.number(fraction_of(float(x))) * rate
        n = len(self.matrices[0])
        more = [*(force.weight for force in self.spread_forces), *(table.zero for _ in self.let_go),
                *self._inputs.values()]
        return nodes | dict(enumerate(more, n)), n + len(more)
