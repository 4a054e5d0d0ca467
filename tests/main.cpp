// The main function that every C++ test program shares.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
