// Compiled once: the test runner is slow to build.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
