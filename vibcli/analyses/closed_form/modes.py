"""Natural frequencies in letters, with mode shapes and damping: every form is checked in numbers before it is shown."""


def closed_forms(symbolic, modal):
    """The ClosedForms of a scene whose small oscillations are known in letters; None where there are none to read."""
    if not symbolic.linearisable:
        return None
    M, C, G, K = symbolic.matrices
    if len(symbolic.scene.q) == 1:
        from vibcli.analyses.closed_form.one_degree import one_degree

        zero = symbolic.scene.table.zero
        return one_degree(symbolic, modal, *(matrix.get((0, 0), zero) for matrix in (M, C, K)))
    from vibcli.analyses.closed_form.many_degrees import several

    return several(symbolic, modal, M, C, G, K)
