"""Plots loops with matplotlib; comments show the same with PyVista.

    python3 plot_loops.py [MESH.off [OUT.png]]
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import handle_tunnel_loops as htl

# In PyVista:
#
#   plotter = pyvista.Plotter()
#   plotter.add_mesh(pyvista.make_tri_mesh(V, F), opacity=0.5)
#   for loop in L.handles:
#       plotter.add_lines(loop.closed(), connected=True, color="tab:orange")
#   plotter.show()


def main(mesh=None, out="loops.png"):
    V, F = htl.read(mesh, repair=True) if mesh else htl.generate("multi-torus", faces=6000, genus=3)
    L = htl.loops(V, F)
    axes = plt.figure(figsize=(8, 6)).add_subplot(projection="3d")
    axes.plot_trisurf(*V.T, triangles=F, color="lightgrey", alpha=0.3)
    for loop in L.handles + L.tunnels:
        axes.plot(*loop.closed().T, color="tab:orange" if loop.kind == "handle" else "tab:blue")
    axes.set_box_aspect(V.max(axis=0) - V.min(axis=0))
    plt.savefig(out)
    return L


if __name__ == "__main__":
    main(*sys.argv[1:])
