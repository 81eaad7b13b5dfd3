"""Handle and tunnel loops of surfaces, and tools built on them.

A closed surface of genus g, like a mug (g = 1) or a sponge (g in the thousands), has g handle loops,
each of which bounds a surface in the solid inside, and g tunnel loops, each of which bounds a surface
in the space outside. This package finds short ones. Before it returns them, it proves that they are a
basis of the first homology group H1(S; Z) of the surface. A surface with boundary curves also has such
loops; together with the boundary curves, except one of each component, they are a basis.

A mesh is two arrays. ``V`` has the coordinates of the vertices: shape (n, 3), any real type, any unit of
length. ``F`` has the three vertices of each face: shape (m, 3), any integer type, counted from 0, with
all faces oriented consistently. The functions never change their arguments. Instead of ``V`` and ``F``,
you can pass one mesh object of meshio, trimesh or PyVista.

    >>> import handle_tunnel_loops as htl
    >>> V, F = htl.generate("torus", faces=2000)
    >>> L = htl.loops(V, F)
    >>> L.genus
    1
    >>> L.handles[0].bounds, L.tunnels[0].bounds
    ('inside', 'outside')

Functions

    loops           the handle and tunnel loops of a mesh
    measure         how thick handles are, and how wide their holes
    removal_costs   what removing each handle would change
    certify         a certificate for loops on a mesh
    throats         all throats of a mesh
    curve_skeleton  the curve skeleton of the solid inside a mesh, with radii and a certificate
    reeb            the Reeb graph of a function on a mesh
    clean           a closed solid from a defective mesh
    remove_handles  a mesh without some of its handles
    cut_to_disk     a mesh cut open along a short graph, for parametrization
    cut_edges       the edges of that cut, as texture seams
    dual_cuts       for each loop, a cut that crosses it once, for field computations
    html            an interactive page of a mesh with its loops, skeleton, Reeb graph or cut, or of a removal
    picture         the same as an image, if has_pictures is True for the build
    survey          a table of many meshes
    generate        a test mesh of known genus
    read            the arrays of a mesh file
    write           a mesh file
    repair          an oriented manifold from defective arrays

Errors: `MeshError` (a ValueError) names the faces or vertices at which the arrays are not a surface, and
says what helps. ValueError and TypeError concern other arguments, OSError concerns files. Other Python
threads run during a computation, and Ctrl-C stops it. ``progress=True`` shows a bar. A callable is called
with the fraction that is done, and stops the computation by returning False (`Interrupted` is raised).
``threads`` is the largest number of threads of one call, independent of other calls.
"""

from ._core import Interrupted, MeshError, has_pictures, version as _version
from ._cleaning import clean
from ._loops import Certificate, Loop, Loops, certify, loops
from ._measures import Balls, Measures, RemovalCosts, Way, measure, removal_costs
from ._pictures import html, picture
from ._reeb import ReebGraph, reeb
from ._skeleton import CurveSkeleton, SkeletonCertificate, curve_skeleton
from ._sources import generate, kinds, read, repair, write
from ._surgery import DualCut, cut_edges, cut_to_disk, dual_cuts, remove_handles
from ._survey import survey
from ._throats import Throat, throats

__version__ = _version.split()[1].rstrip(",")

__all__ = [
    "Balls",
    "Certificate",
    "CurveSkeleton",
    "DualCut",
    "Interrupted",
    "Loop",
    "Loops",
    "Measures",
    "MeshError",
    "ReebGraph",
    "RemovalCosts",
    "SkeletonCertificate",
    "Throat",
    "Way",
    "certify",
    "clean",
    "curve_skeleton",
    "cut_edges",
    "cut_to_disk",
    "dual_cuts",
    "generate",
    "has_pictures",
    "html",
    "kinds",
    "loops",
    "measure",
    "picture",
    "read",
    "reeb",
    "removal_costs",
    "remove_handles",
    "repair",
    "survey",
    "throats",
    "write",
]
