// The bounds that keep a hostile scene from exhausting the machine. Every message names the one it
// hit.
#pragma once

#include <cstddef>

namespace icespar::limits {

#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
inline constexpr std::size_t share = 20;  ///< a fuzzer's program is that much slower
#else
inline constexpr std::size_t share = 1;
#endif

inline constexpr int errors = 20;
inline constexpr int errors_passed_over = 2'000;  ///< repeated in loops, or within broken blocks
inline constexpr int warnings = 200;
inline constexpr int include_depth = 32;
inline constexpr int macro_depth = 200;
inline constexpr int nesting_depth = 200;  ///< blocks, brackets and directives within each other
inline constexpr int block_depth = 1000;   ///< declared blocks within declared blocks
inline constexpr std::size_t loop_turns = 1'000'000 / share;  ///< of one loop
inline constexpr std::size_t tokens =
    20'000'000 / share;  ///< in a file, and read in a run, loops counted every turn
inline constexpr std::size_t names = 1'000'000 / share;  ///< that differ
inline constexpr std::size_t name_bytes = 1000;
inline constexpr std::size_t items = 4'000'000 / share;  ///< words, values and blocks kept in a run
inline constexpr std::size_t string_bytes = 65'536;
inline constexpr std::size_t string_bytes_in_all = (256 << 20) / share;
inline constexpr std::size_t array_elements = 1'000'000;
inline constexpr std::size_t array_elements_in_all = 4'000'000 / share;
inline constexpr std::size_t spline_points = 10'000;
inline constexpr std::size_t file_bytes = 64 << 20;
inline constexpr std::size_t file_bytes_in_all = 128 << 20;
inline constexpr std::size_t objects =
    200'000 / share;  ///< stones, things and lights, instances counted
inline constexpr std::size_t build_steps =
    4'000'000 / share;  ///< items looked at while the scene is built
inline constexpr std::size_t stone_points = 10'000 / share;       ///< planes or points of one stone
inline constexpr std::size_t mesh_triangles = 2'000'000 / share;  ///< of one mesh

}  // namespace icespar::limits
