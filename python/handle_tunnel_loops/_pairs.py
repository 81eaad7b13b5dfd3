"""The table of the pairs of loops: columns of one dimension, some of which can be taken together."""

from __future__ import annotations

import html
from typing import Any, Dict, Iterable

import numpy as np

_xyz = "xyz"

# Vectors and boxes, by the columns that they consist of.
_together: Dict[str, np.ndarray] = {
    "centre": np.array([f"centre_{x}" for x in _xyz]),
    "box": np.array([[f"{x}{end}" for x in _xyz] for end in ("min", "max")]),
    "bore_axis": np.array([f"bore_axis_{x}" for x in _xyz]),
    "bore_centre": np.array([f"bore_centre_{x}" for x in _xyz]),
}


def _columns_together(table: Any, name: str) -> np.ndarray:
    names = _together[name]
    return np.stack([table[column] for column in names.flat], axis=-1).reshape(
        np.shape(table[names.flat[0]]) + names.shape
    )


class PairRow(np.record):
    """A row of the table."""

    def __getitem__(self, name: Any) -> Any:
        if isinstance(name, str) and name in _together:
            return _columns_together(self, name)
        return super().__getitem__(name)


class PairTable(np.ndarray):
    """A structured array of which each column has one dimension; ``table["centre"]`` is three of them."""

    def __getitem__(self, name: Any) -> Any:
        if not isinstance(name, str):
            return super().__getitem__(name)
        return _columns_together(self, name) if name in _together else np.asarray(self)[name]


def _reals(*names: str) -> list:
    return [(column, np.float64) for name in names for column in _together[name].flat]


_row = np.dtype(
    (
        PairRow,
        [
            ("pair", np.int64),
            ("handle_length", np.float64),
            ("tunnel_length", np.float64),
            ("size", np.float64),
            *_reals("centre", "box"),
            ("component", np.int64),
            ("handle_bounds", "U9"),
            ("tunnel_bounds", "U9"),
            ("diameter", np.float64),
            ("diameter_of", "U4"),
            ("out_of_roundness", np.float64),
            ("wall_diameter", np.float64),
            *_reals("bore_axis", "bore_centre"),
            ("bore_depth", np.float64),
            ("bore_deviation", np.float64),
            ("drilling", np.int64),
        ],
    )
)


def table_of(L: Any, diagonal: float, holes: Dict[str, np.ndarray]) -> PairTable:
    table = np.zeros(L.genus, dtype=_row)
    for i, (handle, tunnel) in enumerate(zip(L.handles, L.tunnels)):
        shorter = handle if handle.length <= tunnel.length else tunnel
        box = np.array([shorter.points.min(axis=0), shorter.points.max(axis=0)])
        is_bore = holes["drillings"][i] >= 0
        table[i] = (
            i,
            handle.length,
            tunnel.length,
            shorter.length / diagonal if diagonal > 0 else 0.0,
            *(holes["centres"][i] if is_bore else box[0] / 2 + box[1] / 2),
            *box.ravel(),
            handle.component,
            handle.bounds,
            tunnel.bounds,
            holes["diameters"][i],
            "bore" if is_bore else "hole",
            holes["out_of_roundness"][i],
            holes["walls"][i],
            *holes["axes"][i],
            *holes["centres"][i],
            holes["depths"][i],
            holes["deviations"][i],
            holes["drillings"][i],
        )
    return table[np.argsort(table["size"], kind="stable")].view(PairTable)


_shown = ("pair", "handle_length", "tunnel_length", "size", "handle_bounds", "tunnel_bounds", "diameter", "diameter_of")
_most_shown = 20


def html_table(title: str, table: PairTable) -> str:
    """The first rows, and the number of the others."""
    rest = len(table) - _most_shown
    return "\n".join(
        [
            f"<p>{html.escape(title)}</p>",
            "<table>",
            _html_row("th", (name.replace("_", " ") for name in _shown)),
            *(_html_row("td", map(_text_of, (row[name] for name in _shown))) for row in table[:_most_shown]),
            "</table>",
            *([f"<p>and {rest} more</p>"] if rest > 0 else []),
        ]
    )


def _html_row(kind: str, cells: Iterable[str]) -> str:
    return "<tr>" + "".join(f"<{kind}>{html.escape(cell)}</{kind}>" for cell in cells) + "</tr>"


def _text_of(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)
