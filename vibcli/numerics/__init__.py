"""Mathematics that knows no mechanics: roots, eigenvalues, fixed point, quadrature."""
