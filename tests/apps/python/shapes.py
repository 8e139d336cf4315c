"""Shapes for the tests, and stand-ins for packages that Debian has not."""
import os

import numpy as np

import trivet

SANITIZED = "TRIVET_ASAN_LIBRARIES" in os.environ  # many times slower, and memory is not given back

SIDES = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))


def box_arrays(x, y, z):
    """Vertices and faces of a closed box of these half extents about the origin."""
    vertices = np.array([[x if i & 1 else -x, y if i & 2 else -y, z if i & 4 else -z] for i in range(8)], float)
    faces = [[s[0], s[1], s[2]] for s in SIDES] + [[s[0], s[2], s[3]] for s in SIDES]
    return vertices, np.array(faces)


def box(x=0.05, y=0.05, z=0.05):
    return trivet.Shape(*box_arrays(x, y, z))


def torus_arrays(around, across, radius=0.1, thickness=0.03):
    """A closed torus of 2 * around * across faces about the z axis."""
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    u, v = 2 * np.pi * i / around, 2 * np.pi * j / across
    ring = radius + thickness * np.cos(v)
    vertices = np.stack([ring * np.cos(u), ring * np.sin(u), thickness * np.sin(v)], -1).reshape(-1, 3)
    a, b = i * across + j, (i + 1) % around * across + j
    c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
    faces = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])
    return vertices, faces


def torus(around=20, across=12, **sizes):
    return trivet.Shape(*torus_arrays(around, across, **sizes))


def at(x, y, z):
    """A (4, 4) translation."""
    out = np.eye(4)
    out[:3, 3] = x, y, z
    return out


class TrimeshStandIn:
    """Stands in for trimesh.Trimesh, which Debian has not: what of it Trivet uses."""

    def __init__(self, vertices, faces):
        self.vertices, self.faces = np.asarray(vertices, float), np.asarray(faces)

    def apply_transform(self, matrix):
        self.vertices = self.vertices @ matrix[:3, :3].T + matrix[:3, 3]


class TrimeshSceneStandIn:
    """Stands in for trimesh.Scene: geometry, graph.nodes_geometry, graph[node]."""

    def __init__(self, placed):
        self.geometry = {name: mesh for name, mesh, _ in placed}
        self.graph = self
        self.nodes_geometry = ["node_" + name for name, _, _ in placed]
        self._at = {"node_" + name: (matrix, name) for name, _, matrix in placed}

    def __getitem__(self, node):
        return self._at[node]


class TrimeshStandInPackage:
    """Stands in for the package: a Scene that is filled by geometry[name] and graph.update()."""

    @staticmethod
    def Trimesh(vertices, faces, face_colors, process):
        assert process is False and face_colors.shape == (len(faces), 4)
        return TrimeshStandIn(vertices, faces)

    class Scene(TrimeshSceneStandIn):
        def __init__(self):
            super().__init__([])

        def update(self, frame_to, matrix, geometry):
            self.nodes_geometry.append(frame_to)
            self._at[frame_to] = (matrix, geometry)


def table_with_cup():
    """A fixed table of 1 m, its top at z = 0.1, and a cup (a torus) at rest on it."""
    scene = trivet.Scene()
    scene.add("table", box(0.5, 0.5, 0.05), pose=at(0, 0, 0.05 + 2e-6), fixed=True)
    scene.add("cup", torus()).put([0.1, 0.1, 1.0])
    return scene
