// All numbers that were chosen, not derived: what they mean, their unit, and what happens when they
// are changed. SETTLING means the measurements of the settling prototype.
#pragma once

#include <cstddef>

namespace trivet {

// --- clearance -----------------------------------------------------------------------------------

/// Default clearance, of the scene's size or its largest coordinate. 16 times float32's half-ulp:
/// smaller, and float32 export makes contacts touch; larger, and gaps become visible.
inline constexpr double kRelativeClearance = 1.0 / (1 << 20);
/// A pair of faces that starts closer than this many clearances is in contact: it stops a motion
/// only when its gap shrinks to kRestingShrink of itself. 1 makes pivots block themselves.
inline constexpr double kHysteresis = 2.0;
inline constexpr double kRestingShrink = 0.5;
/// A motion's stop may be this much (relative) outside its target distance; bounds the number of
/// separating planes that a pair of turning edges needs.
inline constexpr double kTargetSlack = 0.06;
/// Contacts are features within this many clearances; must equal kHysteresis, so that what is in
/// contact and what only shrinks are the same pairs.
inline constexpr double kContactTolerance = kHysteresis;

// --- first contact -------------------------------------------------------------------------------

/// Separating planes tried for one pair of faces before it is given up as blocking (safe, early).
inline constexpr int kMaxSeparatingPlanes = 1000;
/// sin^2 of the angle below which edges are parallel for the purpose of a separating plane.
inline constexpr double kParallelSquaredSine = 1e-16;

// --- contacts ------------------------------------------------------------------------------------

/// Slope by which a surface may dip through the plane of a contact point, before the point counts
/// as lying past the end of a face. Larger accepts wrong normals, smaller loses contacts.
inline constexpr double kConeSlope = 1e-3;
/// How far (in clearances) a foot may be outside a face and still count as inside.
inline constexpr double kFootSlack = 0.05;
/// The same in heights: beside a face by more, what is nearest is an edge or a corner of it, in
/// another direction. Larger takes the sides of flush boxes that nearly touch for contacts.
inline constexpr double kFootSlope = 0.05;
/// Principal extents below this part of the object's size count as nothing: point, line or area.
inline constexpr double kContactExtent = 1e-4;

// --- moves along contacts
// -------------------------------------------------------------------------

/// Before something slides, gaps (in clearances) below the first are opened to the second: faces
/// that come near on the way stop it at up to 1 + kTargetSlack, and what it slides on is to be none
/// of them. Below kContactTolerance, so that contacts stay contacts.
inline constexpr double kSlideBelow = 1.15;
inline constexpr double kSlideGap = 1.3;

// --- settling ------------------------------------------------------------------------------------

/// Clearances by which every executed motion must lower the centre of mass. 0 never ends, 10 gets
/// stuck.
inline constexpr double kEnergyDrop = 0.1;
/// The same for an object that would be wedged otherwise: a last turn that closes a gap may lower
/// the centre by very little.
inline constexpr double kLastEnergyDrop = 1e-3;
/// Part of the object's size that the centre of mass must be inside the hull, to count as at rest.
inline constexpr double kRestMargin = 1e-6;
/// Gaps below this many clearances are opened again (a sliding edge halves its gap at every event).
inline constexpr double kLiftBelow = 0.5;
/// A lift is at most this many clearances long; at most kMaxLifts are made.
inline constexpr double kLargestLift = 20;
inline constexpr int kMaxLifts = 200;
inline constexpr int kLiftSweeps = 300;
/// After so many lifts an object whose contacts balance, and that cannot sink by more than
/// kBalanceTolerance, is at rest: thinner than the contacts' tolerance, it would rock to and fro.
inline constexpr int kLiftsOfRocking = 8;
/// Contacts within this many clearances may carry when nothing can sink any more: a last closing
/// motion shorter than kEnergyDrop is not executed.
inline constexpr double kBalanceTolerance = 20;
/// An object farther than this many clearances from everything hovers.
inline constexpr double kHoverTolerance = 8;
/// Clearances that may be asked for, as parts of the scene's size: smaller drowns in rounding,
/// larger is hovering.
inline constexpr double kSmallestClearance = 1e-10;
inline constexpr double kLargestClearance = 1e-3;

// --- weights -------------------------------------------------------------------------------------

/// Wall of objects without volume, of their size: what a sheet, a shell or an open mesh weighs.
inline constexpr double kWallThickness = 0.01;

// --- export to simulators ------------------------------------------------------------------------

/// Thickness of convex parts that are flat, of their size: simulators need a volume. Larger
/// overlaps what the part lies on, smaller is lost in float32.
inline constexpr double kFlatPartThickness = 1e-4;
/// Meshes of more components become one hull: simulators test all pairs of parts.
inline constexpr size_t kMaxParts = 64;
/// Part of its hull's volume by which a component may differ and still counts as convex.
inline constexpr double kConvexEnough = 0.02;
/// Depth of the dents that a decomposition leaves, of the object's size.
inline constexpr double kDecompositionConcavity = 0.02;
/// Components with more faces are not decomposed, as it would take minutes.
inline constexpr size_t kMaxDecomposedFaces = 20'000;

// --- curved surfaces -----------------------------------------------------------------------------

/// Default distance of triangles from a curved surface, of the model's size; the smallest that may
/// be asked for, as float32 rounds to about that.
inline constexpr double kRelativeChord = 1e-3;
inline constexpr double kSmallestRelativeChord = 1e-6;
/// How often a part is polygonised with a smaller tolerance when the result is measured to be worse
/// than asked for.
inline constexpr int kMaxPolygonisations = 6;
/// Faces whose edges are within this part of the model's size are joined along them.
inline constexpr double kSewingTolerance = 1e-5;

// --- places --------------------------------------------------------------------------------------

/// Pixels across an object, and places across its support, when a free place is looked for. More
/// find tighter places and cost their square.
inline constexpr double kPlacePixelsAcross = 40;
inline constexpr double kPlacesAcross = 256;
/// Places at which PUT is tried before it is refused: where the object tips over, for example.
inline constexpr int kPlaceTrials = 48;

}  // namespace trivet
