// Version of Trivet. Semantic versioning: before 1.0 a new minor version may change this interface.
#pragma once

#define TRIVET_VERSION_MAJOR 0
#define TRIVET_VERSION_MINOR 9
#define TRIVET_VERSION_PATCH 0
/// One number to compare: 10203 for 1.2.3.
#define TRIVET_VERSION_NUMBER \
  (TRIVET_VERSION_MAJOR * 10000 + TRIVET_VERSION_MINOR * 100 + TRIVET_VERSION_PATCH)
