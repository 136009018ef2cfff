"""A linear system as independent blocks."""

from vibcli.analyses.response.poles import one_degree


def spectrum(M, C, K, modes=None):
    """The Blocks of M q̈ + C q̇ + K q = f."""
    if len(M) == 1:
        return [one_degree(M[0, 0], C[0, 0], K[0, 0])]
    from vibcli.analyses.response.general import general

    return general(M, C, K)
