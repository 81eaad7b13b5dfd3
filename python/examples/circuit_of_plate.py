"""The holes of a conducting plate, for a circuit or a finite element solver.

    python3 circuit_of_plate.py [MESH.off]

On a plate with holes, or on a shell with handles, a current is the gradient of a potential, up to one
number for each independent loop. The potential is single-valued on the surface cut along the duals of
those loops: across cut j it jumps by the current that belongs to loop j.
"""

import sys

import numpy as np

import handle_tunnel_loops as htl


def jumps_around(loop, cut, V, F):
    """By how much a potential that jumps by one across the cut changes once around the loop.

    The loop is followed from face to face; a step across an edge of the cut changes the potential.
    """
    jump = {}
    for (u, v), times in zip(cut.edges.tolist(), cut.times.tolist()):
        jump[u, v], jump[v, u] = times, -times  # from the right to the left of u -> v
    left = {}
    for a, b, c in F.tolist():
        for u, v in ((a, b), (b, c), (c, a)):
            left[u, v] = (a, b, c)
    faces = faces_along(loop, left, V)
    total = 0
    for here, there in zip(faces, faces[1:] + faces[:1]):
        if here != there:
            (edge,) = [e for e in zip(here, here[1:] + here[:1]) if left.get(e[::-1]) == there]
            total -= jump.get(edge, 0)
    return total


def faces_along(loop, left, V):
    """The faces along a loop, each adjacent to the next."""
    around = {}
    for (u, _), face in left.items():
        around.setdefault(u, set()).add(face)

    def faces_at(i):
        (u, v), t = loop.edges[i].tolist(), loop.ratios[i]
        if t in (0, 1):
            return around[u if t == 0 else v]
        return {left[e] for e in ((u, v), (v, u)) if e in left}

    common = [sorted(faces_at(i - 1) & faces_at(i))[0] for i in range(len(loop))]
    path = []
    for i, (here, there) in enumerate(zip(common, common[1:] + common[:1])):
        path += path_between(here, there, faces_at(i), left)
    return path


def path_between(start, end, allowed, left):
    """The faces of a fan from one to another, without the latter."""
    before = {start: None}
    queue = [start]
    for face in queue:
        for e in zip(face, face[1:] + face[:1]):
            next_face = left.get(e[::-1])
            if next_face in allowed and next_face not in before:
                before[next_face] = face
                queue.append(next_face)
    path = []
    while end is not None:
        path.append(end)
        end = before[end]
    return path[:0:-1]


def main(mesh=None):
    V, F = htl.read(mesh, repair=True) if mesh else htl.generate("sphere", faces=2000, holes=5)
    L = htl.loops(V, F)
    cuts = htl.dual_cuts(V, F)
    print(f"genus {L.genus}, {len(L.boundaries)} boundary curves: {len(cuts)} independent currents")
    matrix = np.array([[jumps_around(row.loop, column, V, F) for column in cuts] for row in cuts])
    print("jumps of the potentials (columns) around the loops (rows):")
    print(matrix)
    return matrix


if __name__ == "__main__":
    main(*sys.argv[1:])
