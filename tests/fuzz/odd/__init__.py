"""Odd combinations: random scenes, answered by the program and by a mechanics that shares no code with it.

    draw_*     scenes as YAML text
    scene_text a case over its scene, the texts of motions
    words      numbers with units and expressions, read from that text
    jets       a value with its first and second derivatives
    bodies     mass, moment of inertia and mass centre of each shape
    places     where bodies, points and stretches are, as jets of the coordinates
    ties       ropes, gears, joins, links: what holds between coordinates
    texts      parameters and expressions in numbers
    records    measured functions of the time
    written    what `energies` and `matrices` say
    figure     a scene read: inertias, springs, dampers, loads, each a number beside a jet
    mechanics  what is left of the equations of motion, equilibrium, M, C, K
    motion     small motions by exponentials of matrices, full ones by an integrator of high order
    friction   full motions with dry friction, from event to event
    signals    energies, places, stretches, forces in a state
    doors      the program, run: the same number by every way that it is told
    other_doors reports read back, letters with values set, digits, cases
    in_letters closed forms and their LaTeX
    compare    the two beside each other
    shrink     the smallest scene that comes to the same
    coverage   how often each kind of thing occurs
    sweep      many scenes, from the command line
"""
