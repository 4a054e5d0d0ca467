// Describing values in messages.
#include "parser/value.hpp"

#include "parser/tree.hpp"

namespace icespar {

std::string kind_of(const Value& value) {
    if (const Numbers* n = value.numbers()) {
        if (n->colour) return "a colour";
        return n->size == 1 ? "a float" : "a vector of " + std::to_string(n->size);
    }
    if (value.text()) return "a string";
    if (value.array()) return "an array";
    if (value.formulas()) return "a function";
    if (value.spline()) return "a spline";
    if (const BlockPtr* block = value.block()) return "a '" + std::string((*block)->word) + "'";
    return "nothing";
}

int depth_of(const Value& value) {
    if (const auto* array = value.array()) return (*array)->depth;
    if (const auto* block = value.block()) return (*block)->depth;
    return 0;
}

}  // namespace icespar
