"""The compiled part. Its functions take and return arrays; they are documented where they are called."""

from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

_Record = Dict[str, Any]
_Mesh = Tuple[np.ndarray, np.ndarray]

version: str

class Interrupted(RuntimeError): ...
class MeshError(ValueError): ...

class Watch:
    """What a computation is asked: how far it is, and to stop."""

    def stop(self) -> None: ...
    @property
    def fraction(self) -> float: ...

has_pictures: bool

def read(name: str, content: bytes, triangulate: bool, repair: bool, watch: Watch) -> _Mesh: ...
def write(file: str, points: np.ndarray, triangles: np.ndarray, watch: Watch) -> None: ...
def repair(
    points: np.ndarray,
    faces: Sequence[np.ndarray],
    watch: Watch,
    steps: Optional[List[str]] = None,
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, List[Tuple[int, str]]]: ...
def clean(
    points: np.ndarray,
    faces: Sequence[np.ndarray],
    chosen: _Record,
    threads: int,
    watch: Watch,
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, _Record]: ...
def loops(
    points: np.ndarray,
    triangles: np.ndarray,
    basis: str,
    threads: int,
    seed: Optional[int],
    waists: bool,
    layers: bool,
    time_budget: Optional[float],
    watch: Watch,
) -> _Record: ...
def throats(
    points: np.ndarray,
    triangles: np.ndarray,
    loops: _Record,
    through: Sequence[int],
    least_prominence: float,
    threads: int,
    watch: Watch,
) -> _Record: ...
def certify(
    points: np.ndarray, triangles: np.ndarray, loops: _Record, watch: Watch
) -> _Record: ...
def measure(
    points: np.ndarray,
    triangles: np.ndarray,
    loops: _Record,
    threads: int,
    watch: Watch,
) -> _Record: ...
def removal_costs(
    points: np.ndarray, triangles: np.ndarray, loops: _Record, threads: int, watch: Watch
) -> _Record: ...
def page(
    file: bytes,
    points: np.ndarray,
    triangles: np.ndarray,
    kind: str,
    record: _Record,
    title: str,
    watch: Watch,
) -> None: ...
def picture(
    file: bytes,
    points: np.ndarray,
    triangles: np.ndarray,
    kind: str,
    record: _Record,
    size: Sequence[float],
    watch: Watch,
) -> None: ...
def reeb(
    points: np.ndarray,
    triangles: np.ndarray,
    values: Optional[np.ndarray],
    simplify: Optional[float],
    measure: Optional[str],
    shortest_arc: float,
    is_capped: bool,
    is_drawn_inside: bool,
    sources: Sequence[int],
    threads: int,
    watch: Watch,
) -> _Record: ...
def curve_skeleton(
    points: np.ndarray,
    triangles: np.ndarray,
    shortest_limb: float,
    threads: int,
    watch: Watch,
) -> _Record: ...
def save_skeleton(file: str, record: _Record, watch: Watch) -> None: ...
def remove_handles(
    points: np.ndarray,
    triangles: np.ndarray,
    loops: _Record,
    chosen: _Record,
    threads: int,
    watch: Watch,
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, _Record]: ...
def check_noise(sizes: np.ndarray, text: str, below: float, diagonal: float) -> None: ...
def cut_to_disk(
    points: np.ndarray, triangles: np.ndarray, chosen: _Record, threads: int, watch: Watch
) -> _Mesh: ...
def cut_edges(
    points: np.ndarray, triangles: np.ndarray, chosen: _Record, threads: int, watch: Watch
) -> np.ndarray: ...
def dual_cuts(
    points: np.ndarray, triangles: np.ndarray, threads: int, watch: Watch
) -> List[_Record]: ...
def generate(kind: str, options: Dict[str, int], watch: Watch) -> _Mesh: ...
def kinds() -> Dict[str, str]: ...
