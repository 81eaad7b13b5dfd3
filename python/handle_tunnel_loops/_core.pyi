"""The compiled part. Its functions take and return arrays; what they do is said where they are called."""

from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np

_Progress = Optional[Callable[[float], Any]]
_Record = Dict[str, Any]

version: str

class Interrupted(RuntimeError): ...
class MeshError(ValueError): ...

def read(file: str, triangulate: bool, repair: bool) -> Tuple[np.ndarray, np.ndarray]: ...
def repair(
    points: np.ndarray, faces: np.ndarray
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, List[Tuple[int, str]]]: ...
def loops(
    points: np.ndarray,
    triangles: np.ndarray,
    basis: str,
    threads: int,
    seed: Optional[int],
    waists: bool,
    progress: _Progress,
) -> _Record: ...
def certify(points: np.ndarray, triangles: np.ndarray, loops: _Record) -> _Record: ...
def write_page(
    points: np.ndarray, triangles: np.ndarray, loops: _Record, file: str, title: str
) -> None: ...
def reeb(
    points: np.ndarray,
    triangles: np.ndarray,
    values: Any,
    simplify: Optional[float],
    measure: str,
    sources: Sequence[int],
    threads: int,
    progress: _Progress,
) -> _Record: ...
def remove_handles(
    points: np.ndarray, triangles: np.ndarray, options: _Record, threads: int, progress: _Progress
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, _Record]: ...
def cut_to_disk(
    points: np.ndarray,
    triangles: np.ndarray,
    cones: Sequence[int],
    cut_spheres: bool,
    threads: int,
    progress: _Progress,
) -> Tuple[np.ndarray, np.ndarray, _Record]: ...
def dual_cuts(
    points: np.ndarray, triangles: np.ndarray, threads: int, progress: _Progress
) -> List[_Record]: ...
def generate(kind: str, options: Dict[str, int]) -> Tuple[np.ndarray, np.ndarray]: ...
def kinds() -> Dict[str, str]: ...
