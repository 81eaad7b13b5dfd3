"""Counts and locates the tunnels of a scan, and removes those in a box.

    python3 remove_tunnels_in_box.py [MESH.off [OUT.obj]]

Without a mesh, it uses a generated one that resembles a scan: a surface with tiny bridges and tunnels.
"""

import sys

import numpy as np

import handle_tunnel_loops as htl


def write_obj(path, V, F):
    with open(path, "w", encoding="ascii") as file:
        np.savetxt(file, V, fmt="v %.17g %.17g %.17g")
        np.savetxt(file, F + 1, fmt="f %d %d %d")


def main(mesh=None, out=None):
    V, F = htl.read(mesh, repair=True) if mesh else htl.generate("scan", faces=40000)
    L = htl.loops(V, F)
    table = L.table()
    print(f"{len(table)} pairs of loops; the smallest:")
    for row in table[:5]:
        x, y, z = row["centre"]
        print(f"  pair {row['pair']:3}  {100 * row['size']:5.2f}% of the diagonal, at {x:.3g} {y:.3g} {z:.3g}")

    # The half with small x. The table has the box of the shorter loop of each pair.
    low, high = V.min(axis=0), V.max(axis=0)
    box = low, np.array([(low[0] + high[0]) / 2, high[1], high[2]])
    inside = np.all(table["box"][:, 0] >= box[0], axis=1) & np.all(table["box"][:, 1] <= box[1], axis=1)
    small = inside & (table["size"] < 0.1)
    new_V, new_F, face_origin, report = htl.remove_handles(V, F, pairs=table["pair"][small], loops=L)
    print(f"genus {report['genus_before']} -> {report['genus_after']}; "
          f"{np.mean(face_origin >= 0):.1%} of the faces are unchanged")
    for handle in report["refused"]:
        print(f"  pair {handle['pair']} is kept: {handle['reason']}")
    if out:
        write_obj(out, new_V, new_F)
    return report


if __name__ == "__main__":
    main(*sys.argv[1:])
