"""Random scenes whose full motions are known from Taylor series of equations written by hand."""
