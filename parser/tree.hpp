// The syntax tree of a scene after evaluation: blocks of words, values and further blocks, with
// places.
#pragma once

#include <string_view>
#include <vector>

#include "parser/source.hpp"
#include "parser/value.hpp"

namespace icespar {

struct Item {
    enum class Kind { word, value, block, entry };  ///< entry: what stands within [ ]
    Kind kind = Kind::value;
    Place place;
    std::string_view word{};  ///< of words
    Value value{};            ///< of values
    BlockPtr block{};         ///< of blocks and entries
};

struct Block {
    std::string_view word;
    Place place;  ///< of the word before the brace
    std::vector<Item> items;
    int depth = 1;         ///< blocks within blocks, through declared ones too
    bool broken = false;   ///< a fault within ended it
    bool lacking = false;  ///< a fault was reported in place of one of its items
};

}  // namespace icespar
