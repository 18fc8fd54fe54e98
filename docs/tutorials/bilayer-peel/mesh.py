#!/usr/bin/python3
"""Writes bilayer-peel.e, the mesh of docs/tutorials/bilayer-peel, into the working folder. Lengths in um.

    docs/tutorials/bilayer-peel/mesh.py [COLUMNS]"""
import sys

import ixos
import numpy as np

LENGTH, ARM = 600.0, 100.0  # of the film, and of its end that is not bonded
SOFT, BACKING = 15.0, 4.0  # thicknesses


def film(columns, soft_rows=3, backing_rows=2):
    """Returns the mesh of the flat film: the soft layer below, with its foot at y = 0, and the backing on it."""
    x = np.linspace(0, LENGTH, columns + 1)
    y = np.concatenate([np.linspace(0, SOFT, soft_rows + 1)[:-1],
                        np.linspace(SOFT, SOFT + BACKING, backing_rows + 1)])
    number = np.arange(len(y) * len(x)).reshape(len(y), len(x))  # of the node in a row and a column
    points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    cells = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], axis=-1)
    bonded = int(np.sum(x <= LENGTH - ARM + 1e-9))
    return ixos.Mesh(points,
                     blocks={"soft": cells[:soft_rows].reshape(-1, 4), "backing": cells[soft_rows:].reshape(-1, 4)},
                     node_sets={"left": number[:, 0], "end": [number[soft_rows + backing_rows // 2, -1]]},
                     side_sets={"foot": np.stack([number[0, :bonded - 1], number[0, 1:bonded]], axis=-1)})


if __name__ == "__main__":
    film(int(sys.argv[1]) if len(sys.argv) > 1 else 150).write("bilayer-peel.e", overwrite=True)
