"""Handle and tunnel loops of surfaces, and what they are good for.

A closed surface of genus g, like a mug (g = 1) or a sponge (g in the thousands), has g handle loops,
each of which bounds a disc-like surface in the solid inside, and g tunnel loops, each of which bounds
one in the space outside. This package finds short ones, and proves that they are a basis of the first
homology group H1(S; Z) of the surface before it returns them. A surface with boundary curves has loops
as well; with all curves but one of each component they are a basis.

Meshes are arrays: ``V``, the coordinates of the vertices, of shape (n, 3) and any real type, in any unit
of length; and ``F``, three numbers of vertices for each face, of shape (m, 3) and any integer type,
counting from 0, with all faces oriented alike. Nothing of the caller's is changed. Instead of ``V`` and
``F``, one mesh object of meshio, trimesh or PyVista is accepted.

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
    removal_costs   what it would take to remove each handle
    certify         what has been proved of loops
    throats         all narrow places of a mesh
    curve_skeleton  lines in the middle of the solid inside a mesh, with radii and a proof
    reeb            the Reeb graph of a function on a mesh
    clean           a closed solid, made of a mesh with something wrong
    remove_handles  a mesh without some of its handles
    cut_to_disk     a mesh cut open along a short graph, for parametrization
    cut_edges       the edges of that cut, as seams of textures
    dual_cuts       for each loop, a cut that crosses it once, for circuits
    html            a page in which the mesh can be turned, with its loops, its skeleton or Reeb graph, a cut, or
                    without some of its handles
    picture         the same as a picture, if has_pictures is true of the build
    survey          a table of many meshes
    generate        a mesh to try things on
    read            the arrays of a mesh file
    write           a mesh file
    repair          a surface from arrays that are none

Errors: `MeshError` (a ValueError) names the faces or vertices that keep arrays from being a surface, and
what helps; ValueError and TypeError are about other arguments, OSError is about files. While something
is computed other threads of Python run, and Ctrl-C is obeyed; ``progress=True`` shows a bar, and a callable
is told the fraction that is done and stops the computation by returning False (then `Interrupted` is
raised). ``threads`` is how many a call takes at most, whatever others take at the same time.
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
