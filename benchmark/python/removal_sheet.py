"""Makes a sheet of meshes before and after their handles are removed, to be looked at.

    python3 benchmark/python/removal_sheet.py --htloops build/bin/htloops -o sheet.png MESH...

Both pictures of a mesh are seen from the same side, the loops that are removed along drawn on the
first one. --shrink 3 makes the same sheet small: what is odd at that size is odd for all to see.
Needs NumPy.
"""

import argparse
import pathlib
import struct
import subprocess
import tempfile
import zlib

import numpy as np

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def chunks_of(data):
    at = len(SIGNATURE)
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        yield data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        at += 12 + size


def unfiltered(kind, line, above, channels):
    """A row of a PNG, by the rule that it was filtered with."""
    if kind == 0:
        return line
    if kind == 1:
        return (np.cumsum(line.reshape(-1, channels), axis=0) & 255).reshape(-1)
    if kind == 2:
        return (line + above) & 255
    row, up = [0] * channels + line.tolist(), [0] * channels + above.tolist()
    for x in range(channels, len(row)):
        left, corner = row[x - channels], up[x - channels]
        if kind == 3:
            guess = (left + up[x]) // 2
        else:
            sum_ = left + up[x] - corner
            guess = min((left, up[x], corner), key=lambda value: abs(sum_ - value))
        row[x] = (row[x] + guess) & 255
    return np.array(row[channels:])


def read_png(path):
    """8 bits for each of three or four channels: (height, width, 3)."""
    data = pathlib.Path(path).read_bytes()
    width = height = channels = 0
    packed = b""
    for name, content in chunks_of(data):
        if name == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", content[:10])
            channels = {2: 3, 6: 4}[colours]
            assert depth == 8
        elif name == b"IDAT":
            packed += content
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, -1)
    image = np.zeros((height, width * channels), np.int32)
    above = np.zeros(width * channels, np.int32)
    for y, row in enumerate(rows):
        above = image[y] = unfiltered(row[0], row[1:].astype(np.int32), above, channels)
    return image.reshape(height, width, channels)[:, :, :3].astype(np.uint8)


def write_png(path, image):
    height, width, _ = image.shape
    rows = np.zeros((height, 3 * width + 1), np.uint8)
    rows[:, 1:] = image.reshape(height, -1)

    def chunk(name, content):
        check = struct.pack(">I", zlib.crc32(name + content))
        return struct.pack(">I", len(content)) + name + content + check

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    pathlib.Path(path).write_bytes(
        SIGNATURE
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows.tobytes(), 9))
        + chunk(b"IEND", b"")
    )


def shrunk(image, by):
    height, width = (size // by * by for size in image.shape[:2])
    parts = image[:height, :width].reshape(height // by, by, width // by, by, 3)
    return parts.mean(axis=(1, 3)).astype(np.uint8)


def before_and_after(htloops, mesh, folder, size, view):
    """The two pictures of a mesh side by side; None if it cannot be read."""
    looks = ["--size", f"{size},{size}", "--view", view, "-q"]
    before, after, result = folder / "before.png", folder / "after.png", folder / "after.ply"
    for command in (
        [htloops, "remove", mesh, "-o", result, "--picture", before, *looks],
        [htloops, "loops", result, "--picture", after, *looks],
    ):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if done.returncode != 0:
            print(f"{mesh}: {done.stderr.strip()}")
            return None
    return np.hstack([read_png(before), read_png(after)])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="+", metavar="MESH")
    parser.add_argument("--htloops", default="build/bin/htloops", help="the tool")
    parser.add_argument("-o", "--output", default="sheet.png", help="the sheet, as PNG")
    parser.add_argument("--columns", type=int, default=4, help="meshes in a row")
    parser.add_argument("--size", type=int, default=400, help="of one picture, in pixels")
    parser.add_argument("--shrink", type=int, default=1, help="divides all sizes at the end")
    parser.add_argument("--view", default="1,-1.3,0.9", help="direction that is looked from")
    wanted = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        pictures = [
            before_and_after(wanted.htloops, mesh, pathlib.Path(folder), wanted.size, wanted.view)
            for mesh in wanted.meshes
        ]
    pictures = [picture for picture in pictures if picture is not None]
    while len(pictures) % wanted.columns != 0:
        pictures.append(np.full((wanted.size, 2 * wanted.size, 3), 255, np.uint8))
    rows = [
        np.hstack(pictures[i : i + wanted.columns])
        for i in range(0, len(pictures), wanted.columns)
    ]
    write_png(wanted.output, shrunk(np.vstack(rows), wanted.shrink))


if __name__ == "__main__":
    main()
