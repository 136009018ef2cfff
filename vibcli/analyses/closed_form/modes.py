"""Natural frequencies in letters, with mode shapes and damping: every form is checked in numbers before it is shown."""


def closed_forms(problem):
    """The ClosedForms of a scene whose small oscillations are known in letters; None where there are none to read."""
    if not problem.linear_in_letters:
        return None
    M, C, G, K = problem.matrices_in_letters
    if len(problem.scene.q) == 1:
        from vibcli.analyses.closed_form.one_degree import one_degree

        zero = problem.scene.table.zero
        return one_degree(problem, *(matrix.get((0, 0), zero) for matrix in (M, C, K)))
    from vibcli.analyses.closed_form.many_degrees import several

    return several(problem, M, C, G, K)
