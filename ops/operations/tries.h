// PUT from several starts: the one that was asked for, and, where the object would topple or be
// wedged there, others near it.
//
//   start n (n = 1, 2, ...)  turned about the vertical by n x 137.5 degrees, shifted by within x
//                            size x sqrt(n / (tries - 1)) in a direction of 2.1 times that angle
//   interpenetrates, or leaves the container (container.h)
//                            shifted by a half, a quarter, nothing instead; then skipped
//   leans across a gap       tried at three more; taken if none of these does better
//   got over a wall from the first start
//                            tried at all others; taken if none of these ends in the container
//   else                     an operation of its own, proved as any other; the first that is done
//                            and ends in the container is taken. From starts after the first the
//                            whole has to stand at once
//   all were refused         as many starts more, the farthest, in other directions; then the two
//                            starts at which the fewest would move, where others may move now. Not
//                            where several left the container
//   first contacts of fine meshes
//                            count more, by the root of the number of faces: where they add up to
//                            seconds, no further start is tried, but for what got over a wall
//   cores that are free      try several starts at once, also beside a first one that takes long,
//                            before it is known whether all of them are needed; what is done does
//                            not depend on it
#pragma once

#include "ops/operations/start_trials.h"

namespace trivet {

/// The first start from which `put` is done. Otherwise the refusal of the one that was asked for,
/// with the number of tries. @param o  without a place, with more than one try.
/// @param budget  of the first start.
OperationResult put_by_tries(Transaction& transaction, ObjectId id, const PutOperation& o,
                             const PutSteps& put, Budget budget, OperationRun& run);

}  // namespace trivet
