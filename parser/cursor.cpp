// Typed reading of a block's items.
#include "parser/cursor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace icespar {
namespace {

std::string plain(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", value);
    return text.data();
}

}  // namespace

bool has_gaps(const Block& block) {
    return block.broken || std::any_of(block.items.begin(), block.items.end(), [](const Item& i) {
               if (i.kind == Item::Kind::word) return i.word.empty();
               if (i.kind == Item::Kind::value) return i.value.empty();
               return i.block && i.block->broken;
           });
}

Fault unexpected(const Item& item, std::string_view block, std::string hint) {
    const std::string in = "'" + std::string(block) + "'";
    if (item.kind == Item::Kind::value) {
        return {item.place, kind_of(item.value) + " where " + in + " expects none",
                std::move(hint)};
    }
    const std::string what = item.kind == Item::Kind::entry ? "[" : std::string(item.word);
    return {item.place, "unexpected '" + what + "' in " + in, std::move(hint)};
}

bool Cursor::next_is_number() const {
    return next_is(Item::Kind::value) && (peek().value.numbers() || peek().value.empty());
}

bool Cursor::accept_word(std::string_view word) {
    if (!next_is_word(word)) return false;
    ++at_;
    return true;
}

void Cursor::skip_values() {
    while (next_is(Item::Kind::value) || next_is(Item::Kind::entry)) ++at_;
}

const Value& Cursor::value(std::string_view what) {
    if (!next_is(Item::Kind::value)) {
        const bool after_word = at_ > 0 && block_.items[at_ - 1].kind == Item::Kind::word;
        const std::string owner(after_word ? block_.items[at_ - 1].word : block_.word);
        throw Fault{place(), "'" + owner + "' needs " + std::string(what), {}};
    }
    const Value& value = take().value;
    if (value.empty()) throw Poisoned{place()};
    return value;
}

double Cursor::number(std::string_view what) {
    const Value& v = value(what);
    const Numbers* n = v.numbers();
    if (!n || n->size != 1) {
        throw Fault{place(), "expected " + std::string(what) + ", found " + kind_of(v), {}};
    }
    return n->c[0];
}

double Cursor::number(std::string_view what, double least, double most) {
    const double n = number(what);
    if (!(n >= least && n <= most)) {
        std::string bounds = std::isinf(most)    ? "at least " + plain(least)
                             : std::isinf(least) ? "at most " + plain(most)
                                                 : "from " + plain(least) + " to " + plain(most);
        throw Fault{place(), std::string(what) + " is " + bounds + ", not " + plain(n), {}};
    }
    return n;
}

Vec3 Cursor::vector(std::string_view what) {
    const Value& v = value(what);
    const Numbers* n = v.numbers();
    if (!n || n->colour || n->size > 3) {
        throw Fault{
            place(), "expected " + std::string(what) + " (a vector of 3), found " + kind_of(v), {}};
    }
    if (n->size == 1) return {n->c[0], n->c[0], n->c[0]};
    if (n->size == 2) {
        throw Fault{place(),
                    "expected " + std::string(what) + " (a vector of 3), found a vector of 2",
                    "add the third component"};
    }
    return {n->c[0], n->c[1], n->c[2]};
}

std::array<double, 5> Cursor::colour(std::string_view what) {
    const Value& v = value(what);
    const Numbers* n = v.numbers();
    if (!n || (!n->colour && n->size != 1 && n->size != 3)) {
        throw Fault{place(), "expected " + std::string(what) + ", found " + kind_of(v),
                    "write rgb <red, green, blue>"};
    }
    if (n->size == 1) return {n->c[0], n->c[0], n->c[0], 0, 0};
    if (n->size == 3) return {n->c[0], n->c[1], n->c[2], 0, 0};
    return n->c;
}

std::string Cursor::text(std::string_view what) {
    const Value& v = value(what);
    if (!v.text()) {
        throw Fault{
            place(), "expected " + std::string(what) + " in quotes, found " + kind_of(v), {}};
    }
    return *v.text();
}

}  // namespace icespar
