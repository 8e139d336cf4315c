// Private to gpu.
#pragma once

#include "core/base/error.h"
#include "core/base/sentence.h"

namespace trivet {

inline Error environment_error(const Sentence& sentence) {
  return {Error::Kind::Environment, sentence};
}

}  // namespace trivet
