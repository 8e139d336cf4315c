"""Boxes and rejection, the baseline of perf/arrange.py: as generators of scenes do that let a simulator settle.

A thing is its box, upright, at any angle. It is drawn where its first relation that says a place may hold, else
anywhere on the board; turned to what it is to face; and drawn again where boxes overlap, leave the board or break a
relation: 100 tries a thing, 10 of the whole. Relations as problems of `trivet arrange` have them: right_of, near, facing.
"""
import itertools
import math
import random

TRIES, ATTEMPTS = 100, 10  # of a thing, and of the whole


def extent(points, d):
    return max(p[0] * d[0] + p[1] * d[1] for p in points)


def placed(points, angle, at):
    """Corners in the model's frame, counter-clockwise, turned about z and moved."""
    c, s = math.cos(angle), math.sin(angle)
    return [(at[0] + c * x - s * y, at[1] + s * x + c * y) for x, y in points]


def front(angle):  # -y of the model
    return math.sin(angle), -math.cos(angle)


def right(angle):  # as one who stands in front sees it
    return math.cos(angle), math.sin(angle)


def sides(polygon):
    return zip(polygon, polygon[1:] + polygon[:1])


def apart(a, b):
    """True of convex polygons that an edge of either separates."""
    for p, q in itertools.chain(sides(a), sides(b)):
        outwards = (q[1] - p[1], p[0] - q[0])
        opposite = (-outwards[0], -outwards[1])
        if -extent(b, opposite) > extent(a, outwards) or -extent(a, opposite) > extent(b, outwards):
            return True
    return False


def distance(a, b):
    """Distance of convex polygons: 0 where they overlap."""
    def to_side(p, q, r):
        along = (r[0] - q[0], r[1] - q[1])
        length = along[0] ** 2 + along[1] ** 2
        t = ((p[0] - q[0]) * along[0] + (p[1] - q[1]) * along[1]) / length if length else 0
        t = min(1, max(0, t))
        return math.hypot(q[0] + t * along[0] - p[0], q[1] + t * along[1] - p[1])
    if not apart(a, b):
        return 0
    return min(to_side(p, q, r) for x, y in ((a, b), (b, a)) for p in x for q, r in sides(y))


def middle_along(polygon, d):
    return 0.5 * (extent(polygon, d) - extent(polygon, (-d[0], -d[1])))


def centre(polygon, angle):
    """Middle of the extents along the polygon's own axes."""
    out = (0, 0)
    for d in (front(angle), right(angle)):
        middle = middle_along(polygon, d)
        out = (out[0] + middle * d[0], out[1] + middle * d[1])
    return out


def holds(relation, a, b, slack=0.0):
    """True if a relation holds of two outlines, each a polygon and the angle that it is turned by."""
    (of_a, angle_a), (of_b, angle_b) = a, b
    if relation["is"] == "near":
        return distance(of_a, of_b) <= relation["distance"] + slack
    if relation["is"] == "facing":
        f, from_, to = front(angle_a), centre(*a), centre(*b)
        off = abs(math.atan2(to[1] - from_[1], to[0] - from_[0]) - math.atan2(f[1], f[0]))
        return min(off, 2 * math.pi - off) <= math.radians(relation["tolerance"])
    d, across = right(angle_b), front(angle_b)
    gap = -extent(of_a, (-d[0], -d[1])) - extent(of_b, d)
    spans = [(-extent(p, (-across[0], -across[1])), extent(p, across)) for p in (of_a, of_b)]
    overlap = min(s[1] for s in spans) - max(s[0] for s in spans)
    wanted = 0.5 * min(s[1] - s[0] for s in spans)
    return relation["gap"][0] - slack <= gap <= relation["gap"][1] + slack and overlap >= wanted - slack


def beside(box, angle, other, d, gap, shift):
    """Position of a thing of this angle at a gap from another along d, shifted sideways by a share of half its width."""
    turned, across = placed(box, angle, (0, 0)), (-d[1], d[0])
    along = extent(other, d) + gap + extent(turned, (-d[0], -d[1]))
    half = 0.5 * (extent(other, across) + extent(other, (-across[0], -across[1])))
    sideways = middle_along(other, across) - middle_along(turned, across) + shift * half
    return [along * d[k] + sideways * across[k] for k in (0, 1)]


def turn_to(a, b):
    """Angle of a thing at a whose front points to b."""
    return math.atan2(b[1] - a[1], b[0] - a[0]) + math.pi / 2


def drawn(numbers, box, relations, others, half):
    """An angle and a position of a thing: one try."""
    angle, way = numbers.uniform(0, 2 * math.pi), numbers.uniform(0, 2 * math.pi)
    at = [numbers.uniform(-half, half) for _ in (0, 1)]
    target = next((r["b"] for r in relations if r["is"] == "facing"), None)
    for r in relations:
        if r["is"] == "facing":
            continue
        if target:
            angle = way - math.pi / 2
        polygon, angle_b = others[r["b"]]
        if r["is"] == "near":
            d, gap, shift = (math.cos(way), math.sin(way)), numbers.uniform(0, r["distance"]), 0
        else:
            d, gap, shift = right(angle_b), numbers.uniform(*r["gap"]), numbers.uniform(-1, 1)
        at = beside(box, angle, polygon, d, gap, shift)
        break
    if target:
        angle = turn_to(centre(placed(box, angle, at), angle), centre(*others[target]))
    return angle, at


def attempt(boxes, relations, half, numbers):
    others, out = {}, []
    for name, box in boxes.items():
        asked = [r for r in relations if r["a"] == name and r["b"] in boxes]
        for _ in range(TRIES):
            angle, at = drawn(numbers, box, asked, others, half)
            here = placed(box, angle, at)
            if (all(abs(x) <= half and abs(y) <= half for x, y in here)
                    and all(apart(here, o) for o, _ in others.values())
                    and all(holds(r, (here, angle), others[r["b"]]) for r in asked)):
                break
        else:
            return None
        others[name] = here, angle
        out.append((angle, at))
    return out


def by_rejection(boxes, relations, half, seed):
    """Angles and positions of things, in their order; None: in each attempt one had no place in all its tries.

    boxes: corners by name, seen from above, counter-clockwise. half: of the board's edge.
    """
    numbers = random.Random(seed)
    return next(filter(None, (attempt(boxes, relations, half, numbers) for _ in range(ATTEMPTS))), None)
