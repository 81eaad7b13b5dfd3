"""Draws triangle meshes from a direction, with flat shades and dark lines at creases. Needs NumPy."""

import itertools

import numpy as np

AXES = [tuple(sign * np.roll((1, 0.3, 0.35), axis)) for axis in range(3) for sign in (1, -1)]
CORNERS = list(itertools.product((1, -1), (1.3, -1.3), (0.9, -0.9)))
DIRECTIONS = np.array(CORNERS + AXES)

LIGHT = np.array([-0.45, 0.55, 0.7])  # to the right, upwards, towards who looks
PIXELS_AT_ONCE = 4_000_000


def read_off(path):
    """Points and triangles of an OFF file without comments, as htloops writes it."""
    with open(path, encoding="ascii") as file:
        assert file.readline().strip() == "OFF"
        points, faces, _ = map(int, file.readline().split())
        numbers = np.array(file.read().split(), float)
    return (
        numbers[: 3 * points].reshape(-1, 3),
        numbers[3 * points : 3 * points + 4 * faces].reshape(-1, 4)[:, 1:].astype(int),
    )


class View:
    """Where points of space are in a square picture, in pixels, and how near."""

    def __init__(self, direction, points, size, margin=0.04):
        towards = np.array(direction, float) / np.linalg.norm(direction)
        right = np.cross((0, 0, 1), towards)
        right /= np.linalg.norm(right)
        self.axes = np.array([right, np.cross(towards, right), towards])
        seen = points @ self.axes.T
        low, high = seen.min(axis=0), seen.max(axis=0)
        self.size = size
        self.middle = (low + high) / 2
        self.scale = size * (1 - 2 * margin) / max((high - low)[:2].max(), 1e-300)

    def seen(self, points):
        at = (points @ self.axes.T - self.middle) * self.scale
        return at * (1, -1, 1) + (self.size / 2, self.size / 2, 0)


def counted(counts):
    """Of each number as many copies of its place, and 0, 1, ... for each of them."""
    owners = np.repeat(np.arange(len(counts)), counts)
    firsts = np.cumsum(counts) - counts
    return owners, np.arange(len(owners)) - firsts[owners]


def between(low, high, size):
    """The first of the pixels with a middle from low to high, and how many there are."""
    first = np.clip(np.ceil(low - 0.5), 0, size).astype(int)
    return first, np.clip(np.ceil(high - 0.5), 0, size).astype(int) - first


def spans(corners, size):
    """Rows of pixels of triangles: whose, which row, the first pixel, and how many."""
    top, rows = between(corners[:, :, 1].min(axis=1), corners[:, :, 1].max(axis=1), size)
    owner, row = counted(rows)
    row += top[owner]
    left, right = np.full(len(row), np.inf), np.full(len(row), -np.inf)
    for i in range(3):
        a, b = corners[owner, i], corners[owner, (i + 1) % 3]
        with np.errstate(divide="ignore", invalid="ignore"):
            part = (row + 0.5 - a[:, 1]) / (b[:, 1] - a[:, 1])
            x = a[:, 0] + part * (b[:, 0] - a[:, 0])
        crossed = (part >= 0) & (part <= 1)
        left = np.where(crossed, np.minimum(left, x), left)
        right = np.where(crossed, np.maximum(right, x), right)
    return (owner, row, *between(left, np.maximum(left, right), size))


def slopes(corners):
    """How the nearness of triangles grows to the right and downwards."""
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normals = np.cross(u, v)
    across = np.where(np.abs(normals[:, 2]) < 1e-12, np.inf, normals[:, 2])
    return -normals[:, :2] / across[:, None]


def what_is_seen(points, faces, view):
    """For each pixel the face that is seen there, -1 for none, and how near it is."""
    corners, size = view.seen(points)[faces], view.size
    slope = slopes(corners)
    seen, near = np.full(size * size, -1), np.full(size * size, -np.inf)
    owner, row, first, length = spans(corners, size)
    parts = max(1, -(-length.sum() // PIXELS_AT_ONCE))
    for part in np.array_split(np.arange(len(owner)), parts):
        span, x = counted(length[part])
        face = owner[part][span]
        x, y = x + first[part][span], row[part][span]
        offset = np.stack([x, y], axis=1) + 0.5 - corners[face, 0, :2]
        depth = corners[face, 0, 2] + (offset * slope[face]).sum(axis=1)
        order = np.argsort(depth, kind="stable")
        pixel, face, depth = (y * size + x)[order], face[order], depth[order]
        last = len(pixel) - 1 - np.unique(pixel[::-1], return_index=True)[1]
        nearer = last[depth[last] > near[pixel[last]]]
        seen[pixel[nearer]], near[pixel[nearer]] = face[nearer], depth[nearer]
    return seen.reshape(size, size), near.reshape(size, size)


def unit_normals(points, faces):
    a, b, c = points[faces].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    return normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]


def creases(seen, near, normals, degrees=35, step=0.03):
    """Pixels beside others whose faces look elsewhere or are much further away."""
    size = len(seen)
    dark = np.zeros((size, size), bool)
    for axis in (0, 1):
        one = tuple(slice(0, -1) if i == axis else slice(None) for i in (0, 1))
        other = tuple(slice(1, None) if i == axis else slice(None) for i in (0, 1))
        same = (normals[seen[one]] * normals[seen[other]]).sum(axis=-1)
        with np.errstate(invalid="ignore"):
            far = np.abs(near[one] - near[other]) > step * size
        dark[one] |= (seen[one] != seen[other]) & ((same < np.cos(np.radians(degrees))) | far)
    return dark


def drawing(points, faces, view, colours, material=None):
    """The picture, of twice the width and height of the one that is made of it: (size, size, 3).

    With a colour of the material, the mesh is what is behind a plane that faces who looks: where a face is
    seen from inside there is material in the plane.
    """
    seen, near = what_is_seen(points, faces, view)
    normals = unit_normals(points, faces)
    light = LIGHT / np.linalg.norm(LIGHT)
    if material is not None:
        inside = normals @ view.axes[2] < 0
        normals[inside] = view.axes[2]
        colours = np.where(inside[:, None], material, colours)
        near[inside[seen] & (seen >= 0)] = view.seen(points)[:, 2].max()
    bright = 0.35 + 0.65 * np.abs(normals @ view.axes.T @ light)
    image = np.where((seen < 0)[:, :, None], 1.0, (colours * bright[:, None])[seen])
    image[creases(seen, near, normals)] *= 0.35
    half = view.size // 2
    return image.reshape(half, 2, half, 2, 3).mean(axis=(1, 3))
