// Tuning constants that several files share, with unit, meaning and the effect of changing them.
// Most of the values under "settling" come from measurements on real models.
#pragma once

#include <cstddef>

namespace trivet {

// --- clearance -----------------------------------------------------------------------------------

/// Default clearance, relative to the scene's size or its largest coordinate. 16 times float32's
/// half-ulp: with less, float32 export makes contacts touch; with more, gaps become visible.
inline constexpr double kRelativeClearance = 1.0 / (1 << 20);
/// Metres: the default clearance follows what lies within this distance of an object, and up to
/// this size, as far as the sizes of objects allow (see coarse_size()): 0.0095 mm. With less,
/// scenes of a room would depend on where in it something is put; with more, gaps become visible,
/// and float32 copies could touch.
inline constexpr double kClearanceReach = 10.0;
/// Diagonals of an object that may move up to which the default clearance follows sizes, too.
inline constexpr double kCoarseDiagonals = 4.0;
/// A pair of faces that starts closer than this many clearances is in contact: it stops a motion
/// only if its gap shrinks to kRestingShrink of its start. With 1, pivots block themselves.
inline constexpr double kHysteresis = 2.0;
inline constexpr double kRestingShrink = 0.5;
/// Relative error allowed in the distance at which a motion stops; bounds the number of separating
/// planes that a pair of turning edges needs.
inline constexpr double kTargetSlack = 0.06;
/// Features within this many clearances are in contact. Must equal kHysteresis, so that the pairs
/// in contact are the pairs allowed to shrink.
inline constexpr double kContactTolerance = kHysteresis;

// --- first contact -------------------------------------------------------------------------------

/// Separating planes tried for a pair of faces before it counts as blocking (safe: stops early).
inline constexpr int kMaxSeparatingPlanes = 1000;
/// sin^2 of the angle below which two edges count as parallel when a separating plane is built.
inline constexpr double kParallelSquaredSine = 1e-16;

// --- contacts ------------------------------------------------------------------------------------

/// Slope by which a surface may dip through the plane of a contact point before the point is taken
/// to lie past the end of a face. Larger accepts wrong normals, smaller loses contacts.
inline constexpr double kConeSlope = 1e-3;
/// Distance (in clearances) by which the foot of a perpendicular may be outside a face and still
/// count as inside.
inline constexpr double kFootSlack = 0.05;
/// The same in heights: beside a face by more, what is nearest is an edge or a corner of it, in
/// another direction. Larger takes the sides of flush boxes that nearly touch for contacts.
inline constexpr double kFootSlope = 0.05;
/// Principal extents below this fraction of the object's size count as zero: point, line or area
/// contact.
inline constexpr double kContactExtent = 1e-4;

// --- moves along contacts
// -------------------------------------------------------------------------

/// Before sliding, gaps (in clearances) below the first are opened to the second: faces that come
/// near on the way stop the motion at up to 1 + kTargetSlack, and the supporting faces must not be
/// among them. Below kContactTolerance, so that contacts stay contacts.
inline constexpr double kSlideBelow = 1.15;
inline constexpr double kSlideGap = 1.3;

// --- settling ------------------------------------------------------------------------------------

/// Clearances by which every executed motion must lower the centre of mass. With 0, settling never
/// ends; with 10, it gets stuck.
inline constexpr double kEnergyDrop = 0.1;
/// The same for an object that would otherwise be wedged: a final turn that closes a gap may lower
/// the centre by very little.
inline constexpr double kLastEnergyDrop = 1e-3;
/// Distance of the centre of mass inside the support polygon that counts as rest, relative to the
/// object's size.
inline constexpr double kRestMargin = 1e-6;
/// Gaps below this many clearances are reopened (a sliding edge halves its gap at every event).
inline constexpr double kSeparateBelow = 0.5;
/// Largest length of a separating motion, in clearances; at most kMaxSeparatingMotions are made.
inline constexpr double kLargestSeparatingMotion = 20;
inline constexpr int kMaxSeparatingMotions = 200;
inline constexpr int kLiftSweeps = 300;
/// After so many lifts an object whose contacts balance, and that cannot sink by more than
/// kBalanceTolerance, is at rest: thinner than the contacts' tolerance, it would rock to and fro.
inline constexpr int kLiftsOfRocking = 8;
/// Contacts within this many clearances may carry once nothing can sink any further: a final
/// closing motion shorter than kEnergyDrop is not executed.
inline constexpr double kBalanceTolerance = 20;
/// Accepted clearances, relative to the scene's size: smaller ones drown in rounding, larger ones
/// are visible gaps.
inline constexpr double kSmallestClearance = 1e-10;
inline constexpr double kLargestClearance = 1e-3;

// --- weights -------------------------------------------------------------------------------------

/// Wall thickness assumed for objects without volume (sheets, shells, open meshes), relative to
/// their size.
inline constexpr double kWallThickness = 0.01;

// --- export to simulators ------------------------------------------------------------------------

/// Thickness given to flat convex parts, relative to their size: simulators need a volume. Larger
/// overlaps the support, smaller is lost in float32.
inline constexpr double kFlatPartThickness = 1e-4;
/// Meshes of more components become one hull: simulators test all pairs of parts.
inline constexpr size_t kMaxParts = 64;
/// Volume defect, relative to the hull, up to which a component counts as convex.
inline constexpr double kConvexEnough = 0.02;
/// Concavity that a decomposition may leave, relative to the object's size.
inline constexpr double kDecompositionConcavity = 0.02;
/// Components with more faces are not decomposed, as it would take minutes.
inline constexpr size_t kMaxDecomposedFaces = 20'000;

// --- curved surfaces -----------------------------------------------------------------------------

/// Default chordal deviation of triangles from a curved surface, relative to the model's size; and
/// the smallest accepted one, near float32's rounding.
inline constexpr double kRelativeChord = 1e-3;
inline constexpr double kSmallestRelativeChord = 1e-6;
/// Attempts to polygonise a part with a smaller tolerance if the measured deviation exceeds the
/// requested one.
inline constexpr int kMaxPolygonisations = 6;
/// Faces whose edges are within this fraction of the model's size are sewn together.
inline constexpr double kSewingTolerance = 1e-5;

// --- places --------------------------------------------------------------------------------------

/// Pixels across an object, and places across its support, in the search for a free place. More
/// pixels find tighter places and cost their square.
inline constexpr double kPlacePixelsAcross = 40;
inline constexpr double kPlacesAcross = 256;
/// Places at which PUT is tried before it is refused, for example because the object tips over.
inline constexpr int kPlaceTrials = 48;

}  // namespace trivet
