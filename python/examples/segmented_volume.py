"""A surface of genus 0 from a segmented volume.

    python3 segmented_volume.py

The volume is generated: a ball whose surface is as noisy as the segmentation of a brain. The mesh consists
of the faces between inner and outer voxels. Where voxels meet only in an edge or a corner, it is not a
manifold; `repair` splits it there.
"""

import numpy as np

import handle_tunnel_loops as htl


def ball_with_noise(n=24, noise=0.25, seed=7):
    axis = np.arange(n) - (n - 1) / 2
    x, y, z = np.meshgrid(axis, axis, axis, indexing="ij")
    distance = np.sqrt(x * x + y * y + z * z)
    random = np.random.default_rng(seed).normal(size=distance.shape)
    return distance + noise * n / 8 * random < n / 3


def largest_piece(volume):
    """The voxels that are connected to the middle one through faces."""
    piece = np.zeros_like(volume)
    middle = tuple(np.array(volume.shape) // 2)
    piece[middle] = True
    while True:
        grown = piece.copy()
        for axis in range(3):
            for shift in (-1, 1):
                grown |= np.roll(piece, shift, axis)
        grown &= volume
        if np.array_equal(grown, piece):
            return piece
        piece = grown


def faces_of_voxels(volume):
    """Vertices (n, 3), and quads (m, 4) that face outwards."""
    volume = np.pad(volume, 1)
    quads = []
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            behind = np.roll(volume, 1 - 2 * side, axis)
            at = np.argwhere(volume & ~behind)
            steps = [(0, 0), (0, 1), (1, 1), (1, 0)] if side == 0 else [(0, 0), (1, 0), (1, 1), (0, 1)]
            corners = np.repeat(at[:, np.newaxis, :], 4, axis=1)
            corners[:, :, axis] += side
            for i, (db, dc) in enumerate(steps):
                corners[:, i, b] += db
                corners[:, i, c] += dc
            quads.append(corners)
    all_corners = np.concatenate(quads).reshape(-1, 3)
    V, at = np.unique(all_corners, axis=0, return_inverse=True)
    return V.astype(float), at.reshape(-1, 4)


def main():
    V, quads = faces_of_voxels(largest_piece(ball_with_noise()))
    V, F, _, _, changes = htl.repair(V, quads)
    for count, words in changes:
        print(f"{count:6} {words}")
    L = htl.loops(V, F)
    print(f"{L.number_of_components} components, total genus {L.genus}")
    V, F, _, report = htl.remove_handles(V, F, genus=0, loops=L)
    print(f"after the removal of {len(report['removed'])} handles: genus {report['genus_after']}")
    return report


if __name__ == "__main__":
    main()
