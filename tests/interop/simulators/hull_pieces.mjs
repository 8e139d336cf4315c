// A convex hull in pieces of few corners, for engines that take no more.

/** The unit normal of a triangle. */
export function normal([a, b, c]) {
  const u = b.map((v, k) => v - a[k]), v = c.map((w, k) => w - a[k]);
  const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...n);
  return n.map((w) => w / length);
}

/** The mean of the corners, inside of their hull. */
export function middleOf(points) {
  return [0, 1, 2].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);
}

/**
 * Hulls of at most `limit` corners whose union is the hull: patches of its surface, each with the
 * middle. Patches are cut across `down`, so that the face on which it stands is in one.
 */
export function hullPieces(hull, down, limit) {
  const {points, triangles} = hull;
  if (points.length <= limit) return [hull];
  const middle = middleOf(points);
  const slope = (triangle) => normal(triangle.map((i) => points[i])).reduce((sum, v, k) => sum + v * down[k], 0);
  const slopes = new Map(triangles.map((triangle) => [triangle, slope(triangle)]));
  const patches = [new Set()];
  for (const triangle of [...triangles].sort((a, b) => slopes.get(b) - slopes.get(a))) {
    if (patches.at(-1).size + 4 > limit) patches.push(new Set());
    triangle.forEach((i) => patches.at(-1).add(i));
  }
  return patches.map((patch) => ({points: [...[...patch].map((i) => points[i]), middle]}));
}
