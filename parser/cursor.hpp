// Reading the items of a block one after the other, with messages for what is missing or of the
// wrong kind.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "math/vec3.hpp"
#include "parser/diagnostic.hpp"
#include "parser/tree.hpp"

namespace icespar {

/// Thrown where a value is missing because a fault in it was reported before: what needs it is left
/// out.
struct Poisoned {
    Place place;
};

/// The fault that an item does not belong in this kind of block.
[[nodiscard]] Fault unexpected(const Item& item, std::string_view block, std::string hint = {});

/// Values are read with a word for what they are ("a radius"), which the message shows.
class Cursor {
public:
    explicit Cursor(const Block& block) : block_(block) {}

    [[nodiscard]] bool more() const { return at_ < block_.items.size(); }
    [[nodiscard]] const Item& peek() const { return block_.items[at_]; }
    const Item& take() { return block_.items[at_++]; }
    /// Place of the item taken last; of the block before any was taken.
    [[nodiscard]] Place place() const {
        return at_ > 0 ? block_.items[at_ - 1].place : block_.place;
    }
    [[nodiscard]] bool next_is(Item::Kind kind) const { return more() && peek().kind == kind; }
    [[nodiscard]] bool next_is_word(std::string_view word) const {
        return next_is(Item::Kind::word) && peek().word == word;
    }
    /// A value that is a float, a vector or a colour (or was at fault).
    [[nodiscard]] bool next_is_number() const;
    bool accept_word(std::string_view word);
    /// Past the values that belong to a word which is left out.
    void skip_values();

    [[nodiscard]] double number(std::string_view what);
    /// Within the bounds; the message says so.
    [[nodiscard]] double number(std::string_view what, double least, double most);
    [[nodiscard]] Vec3 vector(std::string_view what);
    /// Red, green, blue, filter, transmit; a float is a grey.
    [[nodiscard]] std::array<double, 5> colour(std::string_view what);
    [[nodiscard]] std::string text(std::string_view what);

private:
    const Value& value(std::string_view what);

    const Block& block_;
    std::size_t at_ = 0;
};

}  // namespace icespar
