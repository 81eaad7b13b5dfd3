"""Makes the meshes of the journeys that `htloops generate` does not: quadrangles, and round bores.

    python3 benchmark/python/journey_meshes.py FOLDER

writes cup.obj and part.stl. Needs NumPy.
"""

import pathlib
import sys

import numpy as np

STEPS = np.array([(1, 0, 0), (0, 1, 0), (0, 0, 1)])
SIDES = 64  # of a bore, a multiple of 8


def is_in_cup(x, y, z):
    """Of a cup without a bottom."""
    radius = np.hypot(x, y)
    wall = (radius > 7) & (radius < 10) & (np.abs(z) < 10)
    handle = np.hypot(np.hypot(x - 9.5, 0.75 * z) - 6, y) < 1.9
    return wall | (handle & (radius > 8.5))


def boundary_quads(is_full):
    """Quadrangles between full cells and empty ones, as corners of cells, looking outwards."""
    quads = []
    for axis in range(3):
        u, v = STEPS[(axis + 1) % 3], STEPS[(axis + 2) % 3]
        change = np.diff(is_full.astype(int), axis=axis)
        for sign in (1, -1):
            corner = np.argwhere(change == -sign) + STEPS[axis]
            turns = (0, u, u + v, v) if sign > 0 else (0, v, u + v, u)
            quads.append(np.stack([corner + turn for turn in turns], axis=1))
    return np.concatenate(quads)


def smoothed(points, quads, times):
    """Points in the middle of their neighbours, many times."""
    ends = np.concatenate([quads, np.roll(quads, -1, axis=1)], axis=0).ravel()
    others = np.concatenate([np.roll(quads, -1, axis=1), quads], axis=0).ravel()
    count = np.bincount(ends, minlength=len(points))[:, None]
    for _ in range(times):
        sums = np.stack([np.bincount(ends, points[others, i], len(points)) for i in range(3)], axis=1)
        points = 0.5 * points + 0.5 * sums / count
    return points


def cup():
    """Points and quadrangles."""
    grid = np.mgrid[-12:21, -12:13, -14:15]
    quads = boundary_quads(is_in_cup(*grid))
    points, numbers = np.unique(quads.reshape(-1, 3), axis=0, return_inverse=True)
    quads = numbers.reshape(-1, 4)
    return smoothed(points.astype(float), quads, 8), quads


def write_obj(path, points, faces):
    lines = ["v %.9g %.9g %.9g" % tuple(p) for p in points]
    lines += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def quad(*corners):
    return [corners[:3], (corners[0], *corners[2:])]


def bored_cell(corner, size, diameter, height, open_sides):
    """Triangles of a block with a round bore upright in its middle, with these of its four sides."""
    angle = 2 * np.pi * np.arange(SIDES) / SIDES  # those of the corners, too
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    square = circle / np.abs(circle).max(axis=1)[:, None]
    middle = np.array(corner) + size / 2
    low, high = np.zeros((SIDES, 1)), np.full((SIDES, 1), height)
    rim, hole = ([np.hstack([middle + flat, z]) for z in (low, high)]
                 for flat in (square * size / 2, circle * diameter / 2))
    triangles = []
    for i in range(SIDES):
        j = (i + 1) % SIDES
        triangles += quad(rim[1][i], rim[1][j], hole[1][j], hole[1][i])
        triangles += quad(hole[0][i], hole[0][j], rim[0][j], rim[0][i])
        triangles += quad(hole[1][i], hole[1][j], hole[0][j], hole[0][i])
        side = (square[i] + square[j]) / 2
        if tuple(np.trunc(side + 1e-9 * np.sign(side)).astype(int)) in open_sides:
            triangles += quad(rim[0][i], rim[0][j], rim[1][j], rim[1][i])
    return triangles


def part(diameters, size=20.0, height=8.0):
    """Triangles of a plate with a bore in each of its squares."""
    rows, columns = len(diameters), len(diameters[0])
    triangles = []
    for j, row in enumerate(diameters):
        for i, diameter in enumerate(row):
            sides = {side for side, is_open in (((1, 0), i == columns - 1), ((-1, 0), i == 0),
                                                ((0, 1), j == rows - 1), ((0, -1), j == 0)) if is_open}
            triangles += bored_cell((size * i, size * j), size, diameter, height, sides)
    return np.array(triangles).round(6).astype("<f4")


def write_stl(path, triangles):
    """As bytes."""
    facets = np.zeros(len(triangles), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    facets["corners"] = triangles
    path.write_bytes(b" " * 80 + np.uint32(len(facets)).astype("<u4").tobytes() + facets.tobytes())


def main():
    folder = pathlib.Path(sys.argv[1])
    write_obj(folder / "cup.obj", *cup())
    write_stl(folder / "part.stl", part(((3.2, 5, 12, 8.5), (6, 3.2, 4.3, 10))))


if __name__ == "__main__":
    main()
