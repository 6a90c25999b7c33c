#pragma once

// Catch2 3 has a header for all of it, Catch2 2 (Debian 12) is one header.
#if __has_include(<catch2/catch_all.hpp>)
#  include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#  include <catch2/catch.hpp>
#endif
