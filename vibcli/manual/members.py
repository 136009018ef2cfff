"""The page about members: bars, shafts, beams and strings. Data alone."""

MEMBERS = [
    "Elastic members stand under `bars`, `shafts`, `beams` and `strings`, by their names: "
    "`{length: L, EI: EI, mass_per_length: mu, left: clamped}`. Their ends are `left` and `right`, what they carry "
    "is `attached`. One without density or mass per length is massless. A bar moves along its axis, a shaft turns "
    "about it, a beam or a string moves across; without a place none has weight.",
    "Drawn `from` a place `to` another they lie in the plane and have weight; there a beam with `EA` stretches too. "
    "Shafts have no place. Ends are held to bodies, `left: {clamped: base}`, and to other members, "
    "`right: {pinned: girder, at: L1}`; points on a member, `points: {mid: {body: wing, at: L/2}}`, take springs, "
    "dampers, ropes and forces.",
    "Nothing is cut into elements: frequencies are roots of the exact dynamic stiffness, counted (Wittrick & Williams "
    "1971), so that none is missed. `find: [{modes: 5}]`, `{modes: [990, 1000]}` and `{modes: {up_to: 2 kHz}}` say "
    "which; without it the unstable, the rigid and five more are printed. Motions are small ones about the "
    "equilibrium.",
    [
        ("wing.u(x)", "displacement at the place x from the left end, of bars along, of beams and strings to the left "
                      "of the way to the right end; `.phi` of a shaft"),
        ("wing.moment(x)", "as `.slope`, `.shear`, `.force` and `.stress`: `vibcli explain signals`"),
        ("mode[2][wing.u(L)]", "of a mode; `node[2][wing, 1]` the place of its first node"),
        ("frf[wing.u(L), drive](5 Hz)", "of a frequency response"),
    ],
    "Loads along them stand under `forces`: `{body: wing, per_length: q0*sin(pi*x/L), from: a, to: b}`. "
    "`initial: {wing.u: a*x^2}` starts with a shape. `vibcli draw FILE --diagrams` draws moments, shears and forces; "
    "`--insight` tells how near Rayleigh, Dunkerley, lumped masses and finite elements come.",
]
