"""What is accepted as a mesh."""

from __future__ import annotations

from typing import Any, Tuple

import numpy as np

from ._core import MeshError


def arrays(mesh: Any, faces: Any = None, triangles: bool = True) -> Tuple[np.ndarray, np.ndarray]:
    """The arrays of a mesh: those that are given, or those of an object.

    An object has ``vertices`` and ``faces`` (trimesh), ``points`` and ``faces`` (PyVista: rows of a
    number of corners and the corners), or ``points`` and ``cells_dict`` (meshio); or it is a pair. The
    faces have to be triangles, or to have as many corners as each other.
    """
    if faces is not None:
        return np.asarray(mesh), np.asarray(faces)
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return np.asarray(mesh[0]), np.asarray(mesh[1])
    if hasattr(mesh, "cells_dict"):
        return np.asarray(mesh.points), _faces_of_cells(mesh.cells_dict, triangles)
    points = getattr(mesh, "vertices", None)
    if points is None:
        points = getattr(mesh, "points", None)
    if points is None or not hasattr(mesh, "faces"):
        raise TypeError(
            f"a mesh is two arrays, V and F, or an object with vertices or points and faces; "
            f"this is of type {type(mesh).__name__}"
        )
    corners = np.asarray(mesh.faces)
    return np.asarray(points), corners if corners.ndim == 2 else _faces_of_rows(corners, triangles)


def _faces_of_cells(cells: Any, triangles: bool) -> np.ndarray:
    kinds = sorted(kind for kind in cells if kind not in ("line", "vertex"))
    if kinds == ["triangle"] or (kinds == ["quad"] and not triangles):
        return np.asarray(cells[kinds[0]])
    if not kinds:
        raise MeshError("the mesh has no faces")
    raise MeshError(f"the mesh has cells that are no triangles: {', '.join(kinds)}{_remedy(kinds)}")


def _remedy(kinds: Any) -> str:
    return "; repair() makes triangles of them" if kinds == ["quad"] else ""


def _faces_of_rows(rows: np.ndarray, triangles: bool) -> np.ndarray:
    corners = int(rows[0]) if rows.size > 0 else 3
    if corners < 3 or rows.size % (corners + 1) != 0 or np.any(rows[:: corners + 1] != corners):
        raise MeshError("the faces of the mesh have different numbers of corners; triangulate it first")
    if triangles and corners != 3:
        raise MeshError(f"the faces of the mesh have {corners} corners; repair() makes triangles of them")
    return rows.reshape(-1, corners + 1)[:, 1:]
