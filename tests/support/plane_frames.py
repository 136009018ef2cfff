"""Random frames in the plane whose beams bend and stretch: as scenes, and by finite elements of their own."""

import random

import numpy as np

from vibcli.bench.random_members import bar_element, beam_element


def random_frame(seed):
    """{nodes, held, masses, members}: a chain of two to four beams, at times closed to a ring by one more; members as
    (left node, right node, EI, EA, mu, right end pinned?)."""
    draw = random.Random(seed)
    count = draw.randint(2, 4)
    nodes = [(0.0, 0.0)]
    for _ in range(count):
        turn, size = draw.uniform(-1.4, 1.4), draw.uniform(0.6, 1.5)
        x, y = nodes[-1]
        nodes.append((round(x + size * np.cos(turn), 3), round(y + size * np.sin(turn), 3)))
    held = {0} | ({count} if draw.random() < 0.5 else set())
    ends = [(i, i + 1) for i in range(count)] + ([(0, count)] if count > 2 and draw.random() < 0.4 else [])
    members = []
    for left, right in ends:
        size = np.hypot(*np.subtract(nodes[left], nodes[right]))
        EI = round(10 ** draw.uniform(0, 2), 3)
        EA = round(EI / size**2 * 10 ** draw.uniform(0, 4), 3)
        members.append((left, right, EI, EA, round(draw.uniform(0.2, 2), 3), draw.random() < 0.2))
    masses = {i: (round(draw.uniform(0.1, 2), 3), round(draw.uniform(0.01, 0.2), 3))
              for i in range(count + 1) if i not in held and draw.random() < 0.4}
    return {"nodes": nodes, "held": held, "masses": masses, "members": members}


def scene_of(frame):
    """The frame as text; pinned ends where nothing else turns the node are clamped."""
    lines = ["bodies:"]
    for i, (x, y) in enumerate(frame["nodes"]):
        if i not in frame["held"]:
            mass, inertia = frame["masses"].get(i, (0, 0))
            lines.append(f"  n{i}: {{mass: {mass} kg, inertia: {inertia} kg*m^2, at: [{x} m, {y} m], "
                         f"move: [x{i}, y{i}, p{i}]}}")
    lines.append("beams:")
    for k, (left, right, EI, EA, mu, pinned) in enumerate(frame["members"]):
        (x0, y0), (x1, y1) = (frame["nodes"][i] for i in (left, right))
        ends = {"left": "clamped" if left in frame["held"] else f"{{clamped: n{left}}}"}
        word = "pinned" if pinned else "clamped"
        ends["right"] = word if right in frame["held"] else f"{{{word}: n{right}}}"
        lines.append(f"  b{k}: {{from: [{x0} m, {y0} m], to: [{x1} m, {y1} m], EI: {EI} N*m^2, EA: {EA} N, "
                     f"mass_per_length: {mu} kg/m, left: {ends['left']}, right: {ends['right']}}}")
    if len(lines) and lines[1] == "beams:":
        lines.pop(0)
    return "\n".join(lines) + "\n"


def stiffness_and_inertia(frame, parts):
    """K and M of the frame, so many elements a member; three unknowns x, y, turn a node."""
    index, n = {}, 0
    for i in range(len(frame["nodes"])):
        if i not in frame["held"]:
            index[i] = [n, n + 1, n + 2]
            n += 3
    blocks = [(index[i], np.zeros((3, 3)), np.diag([m, m, J])) for i, (m, J) in frame["masses"].items()]
    for left, right, EI, EA, mu, pinned in frame["members"]:
        start, end = (np.array(frame["nodes"][i]) for i in (left, right))
        length = np.hypot(*(end - start))
        c, s = (end - start) / length
        turned = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]])
        here, size = index.get(left), length / parts
        for part in range(parts):
            if part < parts - 1:
                there, n = [n, n + 1, n + 2], n + 3
            else:
                there = index.get(right)
                if pinned:
                    there, n = [*(there[:2] if there else [None, None]), n], n + 1
            middle, n = n, n + 1
            k, m = np.zeros((7, 7)), np.zeros((7, 7))
            for which, (stiff, heavy) in (((1, 2, 4, 5), beam_element(size, EI, 0.0, mu, 0.0)),
                                          ((0, 3, 6), bar_element(size, EA, mu, 0.0))):
                k[np.ix_(which, which)], m[np.ix_(which, which)] = stiff, heavy
            T = np.eye(7)
            T[:3, :3] = turned
            T[3:6, 3:6] = turned
            blocks.append(([*(here or [None] * 3), *(there or [None] * 3), middle], T.T @ k @ T, T.T @ m @ T))
            here = there
    K, M = np.zeros((n, n)), np.zeros((n, n))
    for where, k, m in blocks:
        kept = [i for i, at in enumerate(where) if at is not None]
        at = [where[i] for i in kept]
        K[np.ix_(at, at)] += k[np.ix_(kept, kept)]
        M[np.ix_(at, at)] += m[np.ix_(kept, kept)]
    return K, M


def frequencies(frame, count, parts=16):
    """The lowest ω, each a little too high."""
    K, M = stiffness_and_inertia(frame, parts)
    # eigenvalues of K x = ω² M x; a node without mass of its own has that of its elements
    inverse = np.linalg.inv(np.linalg.cholesky(M))
    return np.sqrt(np.abs(np.linalg.eigvalsh(inverse @ K @ inverse.T)[:count]))
