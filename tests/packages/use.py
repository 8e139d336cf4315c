"""Uses Python's package: puts a model from a file and one from arrays, prints all bits of their poses."""

import sys

import numpy as np
import trivet

corners = np.array([[x, y, z] for x in (-0.1, 0.1) for y in (-0.2, 0.2) for z in (-0.05, 0.05)])
triangles = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
             (1, 5, 7), (1, 7, 3)]
scene = trivet.Scene()
cup = scene.add("cup", trivet.Shape.load(sys.argv[1]))
cup.put([0, 0, 1])
brick = scene.add("brick", trivet.Shape(corners, np.array(triangles)))
brick.put([0.01, 0.02, 2])
assert scene.check().ok
for thing in (cup, brick):
    print(thing.name, " ".join(float(value).hex() for value in np.asarray(thing.matrix).ravel()))
print(trivet.__version__)
