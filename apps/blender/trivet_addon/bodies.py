"""Bodies: what of a scene moves as one, as triangles; and how far Blender may be from where they should be. Without bpy."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Optional

import numpy as np

CLEARANCE = 2.0 ** -20  # of a scene's size: how far objects stay apart


@dataclass(eq=False)
class Part:
    """A mesh as Blender shows it: vertices times the linear half of its matrix, and where they are from.

    vertices : (n, 3) float64; faces : (m, 3) int32, counter-clockwise seen from outside; offset : (3,) world, metres.
    """

    vertices: np.ndarray
    faces: np.ndarray
    offset: np.ndarray


@dataclass(eq=False)
class Body:
    """Objects of Blender that move as one, by the object on top of them, and what Trivet is told of it."""

    name: str
    parts: list = field(default_factory=list)
    matrix: np.ndarray = field(default_factory=lambda: np.eye(4))  # (4, 4) of the object on top, when it was read
    fixed: bool = True
    friction: float = 0.5
    density: float = 1000.0

    @property
    def origin(self) -> np.ndarray:
        return self.matrix[:3, 3]

    def arrays(self):
        """(vertices from `origin`, faces) of all parts together."""
        if len(self.parts) == 1 and np.array_equal(self.parts[0].offset, self.origin):
            return self.parts[0].vertices, self.parts[0].faces
        starts = np.cumsum([0] + [len(part.vertices) for part in self.parts[:-1]])
        vertices = [part.vertices + (part.offset - self.origin) for part in self.parts]
        faces = [part.faces + start for part, start in zip(self.parts, starts)]
        return np.concatenate(vertices), np.concatenate(faces).astype(np.int32)

    def world(self) -> np.ndarray:
        """(n, 3) vertices of all parts, world."""
        return np.concatenate([part.vertices + part.offset for part in self.parts])

    def bounds(self) -> np.ndarray:
        """(2, 3) world."""
        points = self.world()
        return np.array([points.min(axis=0), points.max(axis=0)])

    @property
    def num_faces(self) -> int:
        return sum(len(part.faces) for part in self.parts)


def part_of(coordinates: np.ndarray, faces: np.ndarray, matrix: np.ndarray) -> Part:
    """A mesh below a matrix; faces of mirrored ones are turned round.

    coordinates : (n, 3) of the mesh; matrix : (4, 4), any affine one
    """
    linear = matrix[:3, :3]
    turned = faces if np.linalg.det(linear) >= 0 else faces[:, ::-1]
    return Part(coordinates.astype(np.float64) @ linear.T, turned, matrix[:3, 3].copy())


def scaled(body: Body, factor: float) -> Body:
    """The same in another unit."""
    matrix = body.matrix.copy()
    matrix[:3, 3] *= factor
    parts = [Part(part.vertices * factor, part.faces, part.offset * factor) for part in body.parts]
    return replace(body, parts=parts, matrix=matrix)


NOT_FINITE = "has coordinates that are not finite"


def fault_of(body: Body) -> Optional[str]:
    """Why Trivet cannot take it; None if it can."""
    if not body.parts or body.num_faces == 0:
        return "has no surface"
    if not all(np.isfinite(part.vertices).all() and np.isfinite(part.offset).all() for part in body.parts):
        return NOT_FINITE
    if not np.ptp(body.bounds(), axis=0).any():
        return "is a single point"
    return None


def translation(by) -> np.ndarray:
    out = np.eye(4)
    out[:3, 3] = by
    return out


def motion_of(body: Body, pose: np.ndarray) -> np.ndarray:
    """(4, 4) rigid: from where the body was read to `pose`, which takes vertices from `origin` to the world."""
    return pose @ translation(-body.origin)


def moved(points: np.ndarray, motion: np.ndarray) -> np.ndarray:
    return points @ motion[:3, :3].T + motion[:3, 3]


def usual_clearance(bodies) -> float:
    """Metres for a scene in which these move: a millionth of their extent or their largest coordinate."""
    if not bodies:
        return 0.0
    boxes = np.array([body.bounds() for body in bodies])
    extent = float(np.linalg.norm(boxes[:, 1].max(axis=0) - boxes[:, 0].min(axis=0)))
    return CLEARANCE * max(extent, float(np.abs(boxes).max()))


def reach_of(body: Body) -> np.ndarray:
    """(2, 3) box in which it is looked at what a body meets that is let go: its size around it, and all below."""
    low, high = body.bounds()
    size = float(np.linalg.norm(high - low))
    return np.array([[low[0] - size, low[1] - size, -np.inf], high + size])


def meets(boxes: np.ndarray, low: np.ndarray, high: np.ndarray) -> bool:
    """True if a box overlaps one of these. boxes : (k, 2, 3)"""
    return bool(((boxes[:, 0] <= high) & (low <= boxes[:, 1])).all(axis=1).any())


def holds(boxes: np.ndarray, low: np.ndarray, high: np.ndarray) -> bool:
    """True if a box is inside one of these."""
    return bool(((boxes[:, 0] <= low) & (high <= boxes[:, 1])).all(axis=1).any())


def deviation(expected: Body, motion: np.ndarray, shown: Body) -> float:
    """Metres by which a vertex is elsewhere than it should be; infinity if it is another mesh."""
    a, b = moved(expected.world(), motion), shown.world()
    return float(np.abs(a - b).max()) if a.shape == b.shape else float("inf")


_AXES = {"XYZ": (0, 1, 2), "XZY": (0, 2, 1), "YXZ": (1, 0, 2), "YZX": (1, 2, 0), "ZXY": (2, 0, 1), "ZYX": (2, 1, 0)}
_EVEN = {"XYZ", "YZX", "ZXY"}
_NEAR_LOCK = 0.2  # cosine of the second angle
_LOCKED = 1e-12


def angles_near_lock(rotation: np.ndarray, order: str) -> Optional[tuple]:
    """Euler angles, radians, of a rotation whose second angle is nearly 90 degrees; None if it is not.

    There Blender finds the others from two small float32 numbers each, and is off by far more than a rounding. Here the
    last angle makes up for what the first is off.
    order : as Blender's rotation modes, the first axis first
    """
    if order not in _AXES:
        return None
    i, j, k = _AXES[order]
    r = rotation
    cosine = math.hypot(r[i, i], r[j, i])
    if cosine > _NEAR_LOCK:
        return None
    sign = 1.0 if order in _EVEN else -1.0
    angles = [0.0, 0.0, 0.0]
    angles[j] = sign * math.atan2(-r[k, i], cosine)
    angles[i] = sign * (math.atan2(r[k, j], r[k, k]) if cosine > _LOCKED else math.atan2(-r[j, k], r[j, j]))
    rest = r @ (rotation_about(j, angles[j]) @ rotation_about(i, angles[i])).T
    a, b = (k + 1) % 3, (k + 2) % 3
    angles[k] = math.atan2(rest[b, a] - rest[a, b], rest[a, a] + rest[b, b])
    return tuple(angles)


def rotation_about(axis: int, angle: float) -> np.ndarray:
    """(3, 3) about x, y or z. angle : radians"""
    out = np.eye(3)
    a, b = (axis + 1) % 3, (axis + 2) % 3
    out[a, a] = out[b, b] = math.cos(angle)
    out[b, a] = math.sin(angle)
    out[a, b] = -out[b, a]
    return out


def is_sheared(matrix: np.ndarray) -> bool:
    """True if a matrix cannot be written as location, rotation and scale; to float32."""
    columns = matrix[:3, :3]
    lengths = np.linalg.norm(columns, axis=0)
    if not (lengths > 0).all():
        return False
    cosines = (columns / lengths).T @ (columns / lengths)
    return bool(np.abs(cosines - np.eye(3)).max() > 1e-4)
