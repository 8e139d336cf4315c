// For one source of each test program that draws. Mesa 22's software renderer leaks some bytes per
// context, in a module that it unloads, so that no suppression can name it: such programs run
// without leak detection.
#pragma once

extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
