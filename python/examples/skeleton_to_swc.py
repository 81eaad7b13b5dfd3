"""Writes the curve skeleton of a surface, with its cycles, as SWC.

    python3 skeleton_to_swc.py [MESH.off [OUT.swc]]

SWC stores trees only: each cycle is cut at a point that is written twice, and comments list these points.
"""

import sys

import numpy as np

import handle_tunnel_loops as htl


def main(mesh=None, out="skeleton.swc"):
    V, F = htl.read(mesh, repair=True) if mesh else htl.generate("bicycle")
    S = htl.curve_skeleton(V, F)
    print(f"{len(S.arcs)} arcs, {S.is_on_cycle.sum()} of them on cycles; {S.number_of_cycles} independent cycles")
    print(f"length {S.lengths.sum():.4g}, median radius {np.median(S.radii):.3g}")
    print("certified" if S.certificate else f"not certified: {S.certificate.failure}")
    S.save(out)
    return S


if __name__ == "__main__":
    main(*sys.argv[1:])
