"""Scenes made by several processes."""
import multiprocessing

import numpy as np

import trivet

VERTICES = [[i & 1, i >> 1 & 1, i >> 2] for i in range(8)]
FACES = [[s[0], s[k], s[k + 1]] for s in ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))
         for k in (1, 2)]


def make(seed):
    """A few cubes of 5 to 10 cm, dropped onto each other."""
    rng = np.random.default_rng(seed)
    shape = trivet.Shape(VERTICES, FACES)
    scene = trivet.Scene()
    for i in range(4):
        cube = scene.add(f"cube{i}", shape, scale=rng.uniform(0.05, 0.1))
        while not cube.try_put([*rng.uniform(-0.05, 0.05, 2), 1.0], wxyz=trivet.random_rotation(rng)):
            pass
    return scene.snapshot()


if __name__ == "__main__":
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        made = pool.map(make, range(4))
    same = [(a.pose == b.pose).all() for k, one in enumerate(made) for a, b in zip(one.scene(), make(k).scene())]
    print(f"{len(made)} scenes, {'all as made here' if all(same) else 'DIFFERENT from those made here'}")
