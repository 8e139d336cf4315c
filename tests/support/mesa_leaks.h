// For test programs that draw. Mesa 22's software renderer leaks some bytes per context, in a
// module that it unloads, so that no suppression can name it: such programs run without leak
// detection.
#pragma once

// Weak: several sources of a program may have it.
extern "C" __attribute__((weak)) const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
