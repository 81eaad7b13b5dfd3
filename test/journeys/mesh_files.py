"""Meshes for the tests, and the simplest files of them."""

import math
import struct


def torus(around=24, across=12, large=2.0, small=0.75, shift=(0.0, 0.0, 0.0)):
    """Points and quadrangles of a torus."""
    points = []
    for i in range(around):
        for j in range(across):
            a, b = 2 * math.pi * i / around, 2 * math.pi * j / across
            r = large + small * math.cos(b)
            points.append((r * math.cos(a) + shift[0], r * math.sin(a) + shift[1], small * math.sin(b) + shift[2]))
    quads = [(i * across + j, (i + 1) % around * across + j, (i + 1) % around * across + (j + 1) % across,
              i * across + (j + 1) % across) for i in range(around) for j in range(across)]
    return points, quads


def washer(sides=32, inner=2.0, outer=5.0, height=1.5):
    """Points and quadrangles of a disk with a round bore."""
    ring = ((inner, 0.0), (outer, 0.0), (outer, height), (inner, height))
    points = [(r * math.cos(a), r * math.sin(a), z) for a in (2 * math.pi * i / sides for i in range(sides))
              for r, z in ring]
    quads = [(4 * i + j, 4 * ((i + 1) % sides) + j, 4 * ((i + 1) % sides) + (j + 1) % 4, 4 * i + (j + 1) % 4)
             for i in range(sides) for j in range(4)]
    return points, quads


def triangles_of(faces):
    return [(face[0], face[i], face[i + 1]) for face in faces for i in range(1, len(face) - 1)]


def write_off(file, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(repr(float(x)) for x in p) for p in points]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    file.write_text("\n".join(lines) + "\n")
    return file


def read_off(file):
    numbers = file.read_text().split()[1:]
    n, m = int(numbers[0]), int(numbers[1])
    points = [tuple(map(float, numbers[3 + 3 * i:6 + 3 * i])) for i in range(n)]
    faces, at = [], 3 + 3 * n
    for _ in range(m):
        size = int(numbers[at])
        faces.append(tuple(map(int, numbers[at + 1:at + 1 + size])))
        at += 1 + size
    return points, faces


def write_stl(file, points, triangles):
    """As bytes."""
    facets = [struct.pack("<12fH", 0, 0, 0, *(x for v in t for x in points[v]), 0) for t in triangles]
    file.write_bytes(b" " * 80 + struct.pack("<I", len(facets)) + b"".join(facets))
    return file


def read_stl(file):
    """Of bytes: points, the same ones once, and triangles."""
    data = file.read_bytes()
    count, = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count
    number, triangles = {}, []
    for i in range(count):
        x = struct.unpack_from("<12f", data, 84 + 50 * i)[3:]
        triangles.append(tuple(number.setdefault(x[3 * k:3 * k + 3], len(number)) for k in range(3)))
    return list(number), triangles
