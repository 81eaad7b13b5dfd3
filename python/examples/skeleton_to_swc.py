"""The skeleton of a surface, with its cycles, as SWC.

    python3 skeleton_to_swc.py [MESH.off [OUT.swc]]

SWC knows trees only: cycles are opened, and comments say which points are the same.
"""

import sys

import numpy as np

import handle_tunnel_loops as htl


def main(mesh=None, out="skeleton.swc"):
    V, F = htl.read(mesh, repair=True) if mesh else htl.generate("bicycle")
    G = htl.reeb(V, F)
    on_cycles = G.is_on_cycle.sum()
    print(f"{len(G.arcs)} arcs, {on_cycles} of them on cycles, of which there are {G.number_of_cycles}")
    print(f"length {G.lengths.sum():.4g}, median radius {np.median(np.concatenate(G.radii)):.3g}")
    print(f"{G.to_swc(out)} points in {out}")
    return G


if __name__ == "__main__":
    main(*sys.argv[1:])
