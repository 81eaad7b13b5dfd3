"""Draws what the journeys of the manual begin with and come to, of files that `htloops` wrote.

    python3 benchmark/python/journey_pictures.py beside OUT.png PICTURE...
    python3 benchmark/python/journey_pictures.py section OUT.png BEFORE.off AFTER.off
    python3 benchmark/python/journey_pictures.py changed OUT.png BEFORE.off AFTER.off
    python3 benchmark/python/journey_pictures.py cuts OUT.png MESH.off CUTS.json
    python3 benchmark/python/journey_pictures.py channels OUT.png MESH.off CHANNELS.csv
    python3 benchmark/python/journey_pictures.py survey OUT.png TABLE.csv PICTURE...

A section is through the plane y = 0, with the material in its plane red. Needs NumPy, SciPy and Pillow.
"""

import csv
import json
import pathlib
import sys

import mesh_drawing
import numpy as np
import removal_sheet
from PIL import Image, ImageDraw, ImageFont, ImageOps

SIZE = 400
SURFACE, MATERIAL = (0.78, 0.82, 0.88), (0.86, 0.40, 0.32)
COLOURS = np.array([(0.11, 0.41, 0.72), (0.20, 0.60, 0.25), (0.94, 0.63, 0.19), (0.55, 0.30, 0.65), (0.78, 0.13, 0.17)])


def behind(points, faces):
    """What lies at positive y; faces that the plane passes are cut."""
    side = (points[:, 1] >= 0)[faces]
    points, whole = list(points), list(faces[side.all(axis=1)])
    for face in faces[side.any(axis=1) & ~side.all(axis=1)]:
        corners = []
        for v, w in zip(face, np.roll(face, -1)):
            p, q = points[v], points[w]
            if p[1] >= 0:
                corners.append(v)
            if (p[1] >= 0) != (q[1] >= 0):
                corners.append(len(points))
                points.append(p + (q - p) * p[1] / (p[1] - q[1]))
        whole += [(corners[0], *corners[i : i + 2]) for i in range(1, len(corners) - 1)]
    return np.array(points), np.array(whole)


def as_picture(image):
    return Image.fromarray((255 * image).astype(np.uint8))


def cropped(picture, margin=8):
    """Without what is white around it."""
    dark = np.argwhere(np.array(picture.convert("L")) < 250)
    (top, left), (bottom, right) = dark.min(axis=0), dark.max(axis=0) + 1
    return ImageOps.expand(picture.crop((left, top, right, bottom)), margin, "white")


def beside(pictures):
    width, height = sum(p.width for p in pictures), max(p.height for p in pictures)
    whole, x = Image.new("RGB", (width, height), "white"), 0
    for picture in pictures:
        whole.paste(picture, (x, (height - picture.height) // 2))
        x += picture.width
    return whole


def section(*names):
    meshes = [mesh_drawing.read_off(name) for name in names]
    view = mesh_drawing.View((0, -1, 0.0), np.vstack([points for points, _ in meshes]), 2 * SIZE)
    return beside([cropped(as_picture(mesh_drawing.drawing(*behind(*mesh), view, SURFACE * np.ones((1, 1)), MATERIAL)))
                   for mesh in meshes])


def changed(before, after):
    change = removal_sheet.Change(*map(mesh_drawing.read_off, (before, after)), ())
    return cropped(removal_sheet.tile(change, 7 * SIZE // 8, False))


def cuts(name, cuts_name):
    """Each in a colour; what is hidden is pale."""
    points, faces = mesh_drawing.read_off(name)
    view = mesh_drawing.View((0.15, -0.6, 1), points, 3 * SIZE)
    picture = as_picture(mesh_drawing.drawing(points, faces, view, SURFACE * np.ones((1, 1)))).resize((3 * SIZE,) * 2)
    _, near = mesh_drawing.what_is_seen(points, faces, view)
    with open(cuts_name, encoding="utf-8") as file:
        found = json.load(file)["cuts"]
    draw = ImageDraw.Draw(picture)
    lines = []
    for cut, colour in zip(found, COLOURS):
        for v, w, _ in cut["edges"]:
            middle = view.seen((points[v] + points[w]) / 2)
            column, row = middle[:2].astype(int)
            is_seen = middle[2] > near[row, column] - 0.01 * view.size
            lines.append((bool(is_seen), [tuple(p[:2]) for p in view.seen(points[[v, w]])],
                          colour if is_seen else 0.25 * colour + 0.75 * np.array(SURFACE)))
    for _, ends, colour in sorted(lines, key=lambda line: line[0]):
        draw.line(ends, tuple((255 * np.array(colour)).astype(int)), 8)
    return cropped(picture.resize((3 * SIZE // 2,) * 2, Image.LANCZOS))


def ball(center, radius, around=24, across=12):
    longitude, latitude = np.meshgrid(np.linspace(0, 2 * np.pi, around), np.linspace(-np.pi / 2, np.pi / 2, across))
    points = np.stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)])
    number = np.arange(around * across).reshape(across, around)
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    faces = np.concatenate([np.stack(corners).reshape(3, -1).T for corners in ((a, b, c), (a, c, d))])
    return center + radius * points.reshape(3, -1).T, faces


def channels(name, channels_name):
    """What is behind the plane, and the balls of the channels."""
    points, faces = behind(*mesh_drawing.read_off(name))
    colours = np.tile(SURFACE, (len(faces), 1))
    with open(channels_name, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        own_points, own_faces = ball(np.array([float(row[key]) for key in "xyz"]), float(row["radius"]))
        faces = np.vstack([faces, own_faces + len(points)])
        points = np.vstack([points, own_points])
        colours = np.vstack([colours, np.tile(COLOURS[int(row["pair"]) % len(COLOURS)], (len(own_faces), 1))])
    view = mesh_drawing.View((0, -1, 0.0), points, 2 * SIZE)
    return cropped(as_picture(mesh_drawing.drawing(points, faces, view, colours, MATERIAL)))


def told(rows):
    """What the table says of a mesh."""
    if rows[0]["error"]:
        return "not read"
    return f"genus {rows[0]['genus']}, " + ("one row" if len(rows) == 1 else f"{len(rows)} rows")


def survey(table, *names):
    """A tile for each mesh: its picture, if there is one, and what the table says."""
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    pictures = {pathlib.Path(name).stem: name for name in names}
    font, tiles = ImageFont.truetype("DejaVuSans.ttf", 13), []
    for mesh in dict.fromkeys(row["mesh"] for row in rows):
        tile = Image.new("RGB", (SIZE // 2, SIZE // 2), "white")
        name = pathlib.Path(mesh).name
        if name in pictures:
            tile.paste(Image.open(pictures[name]).convert("RGB").resize((SIZE // 2, 3 * SIZE // 8), Image.LANCZOS))
        text = f"{name}: {told([row for row in rows if row['mesh'] == mesh])}"
        ImageDraw.Draw(tile).text((SIZE // 4, 7 * SIZE // 16), text, "black", font, anchor="mm")
        tiles.append(tile)
    return removal_sheet.sheet(tiles, 3)


def main():
    what, output, *names = sys.argv[1:]
    if what == "beside":
        whole = beside([Image.open(name).convert("RGB") for name in names])
    else:
        drawn = {"section": section, "changed": changed, "cuts": cuts, "channels": channels, "survey": survey}
        whole = drawn[what](*names)
    colours = whole.quantize(224, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    colours.save(output, optimize=True)


if __name__ == "__main__":
    main()
