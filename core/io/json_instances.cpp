#define TRIVET_JSON_INSTANCES
#include "core/io/json_instances.h"
