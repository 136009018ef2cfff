"""Natural frequencies in letters, with mode shapes and damping: every form is checked in numbers before it is shown."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.closed_forms import ClosedForms
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.symbolic_system import SymbolicSystem


def closed_forms(symbolic: "SymbolicSystem", modal: "ModalAnalysis") -> "ClosedForms | None":
    """The ClosedForms of a scene whose small oscillations are known in letters; None where there are none to read."""
    if not symbolic.linearisable:
        return None
    if symbolic.system.scene.members and symbolic.scene.pieces:
        from vibcli.analyses.closed_form.endless_forms import endless_forms
        from vibcli.analyses.closed_form.hanging_forms import hanging_forms

        return endless_forms(symbolic) or hanging_forms(symbolic)
    M, C, G, K = symbolic.matrices
    if len(symbolic.scene.q) == 1:
        from vibcli.analyses.closed_form.one_degree import one_degree

        zero = symbolic.scene.table.zero
        return one_degree(symbolic, modal, *(matrix.get((0, 0), zero) for matrix in (M, C, K)))
    from vibcli.analyses.closed_form.many_degrees import several

    return several(symbolic, modal, M, C, G, K)
