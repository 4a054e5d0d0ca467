// A word within a block: it belongs there, is left out, cannot be rendered, or was misspelt.
#include <algorithm>
#include <array>

#include "parser/parser.hpp"

namespace icespar {
namespace {

bool contains(std::span<const std::string_view> words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

void Parser::word_item(Block& block, const Token& token) {
    const Place where = place(token);
    const Name& name = names_[token.index];
    const WordInfo& info = name.info;
    const bool opens = raw(1).kind == '{';
    const auto legal = words_in(block.word);
    const bool belongs = legal && contains(*legal, name.text);
    const SlotPtr slot = info.may_be_declared && !belongs ? find_shared(token.index) : nullptr;

    if ((slot && slot->value) || (info.kind == WordKind::value && !opens && !belongs)) {
        Value value = expression(Context::item);
        add(block, {Item::Kind::value, joined(where, last_place_), {}, std::move(value), {}});
        return;
    }
    const std::string quoted = "'" + name.text + "'";
    if (belongs) {
        if (opens && name.text != "function") {
            BlockPtr inner = this->block(token);
            add(block, {Item::Kind::block, where, name.text, {}, std::move(inner)});
        } else if (name.text == "function") {
            Value function = function_value(token);
            add(block, {Item::Kind::value, where, {}, std::move(function), {}});
        } else if (of_file(token)) {
            add(block, {Item::Kind::block, where, name.text, {}, block_of_file(token)});
        } else {
            next();
            add(block, {Item::Kind::word, where, name.text, {}, {}});
            if (name.text == "matrix") matrix_items(block);
        }
        return;
    }
    if (info.kind == WordKind::skipped) {
        diagnostics_.warning(where, quoted + " is left out: " + std::string(info.advice), {},
                             name.text);
    } else if (info.kind == WordKind::refused) {
        std::string hint = legal && block.word != "scene" ? did_you_mean(name.text, *legal) : "";
        if (hint.empty()) hint = info.advice;
        diagnostics_.error(where, quoted + " cannot be rendered", hint);
    } else if (info.kind == WordKind::name) {
        return unknown_word(block, token);
    } else if (info.kind == WordKind::directive) {
        diagnostics_.error(where, quoted + " is a directive", "write '#" + name.text + "'");
        return skip_line(token);
    } else {
        std::string hint;
        if (legal && !legal->empty()) hint = did_you_mean(name.text, *legal);
        diagnostics_.error(where, quoted + " does not belong in '" + std::string(block.word) + "'",
                           hint);
    }
    block.lacking = block.lacking || info.kind != WordKind::skipped;
    next();
    // A word that is left out stays in the tree as one, so that what follows is not taken for
    // another's.
    add(block, {Item::Kind::word, where, {}, {}, {}});
    if (opens) return skip_braces(token);
    // Words such as `utf8` after `charset` are of no use but to it.
    while (info.kind == WordKind::skipped && raw().kind == tok::word &&
           names_[raw().index].info.kind == WordKind::other) {
        next();
    }
}

/// `spectrum "file.csv"`, `mesh "ring.obj"`: as blocks that hold the name.
bool Parser::of_file(const Token& word) {
    const std::string& name = names_[word.index].text;
    return raw(1).kind == tok::text && (name == "spectrum" || name == "mesh");
}

BlockPtr Parser::block_of_file(const Token& word) {
    auto block = std::make_shared<Block>();
    block->word = names_[word.index].text;
    block->place = place(word);
    next();
    Value file = primary(Context::item);
    add(*block, {Item::Kind::value, last_place_, {}, std::move(file), {}});
    return block;
}

/// The twelve numbers of a matrix are more than a vector holds: they become four vectors of 3.
void Parser::matrix_items(Block& block) {
    expect('<', "'<' and twelve numbers");
    const Argument none(*this, 0);
    std::array<Item, 4> rows;
    for (std::size_t i = 0; i < 12; ++i) {
        if (i > 0) expect(',', "',' and twelve numbers in all");
        const Place at = here();
        const Value value = expression(Context::vector);
        const Numbers* n = value.numbers();
        if (!value.empty() && (!n || n->size != 1)) {
            throw Fault{joined(at, last_place_), "expected a float, found " + kind_of(value), {}};
        }
        Item& row = rows[i / 3];
        if (i % 3 == 0) row = {Item::Kind::value, at, {}, Numbers{{}, 3, false}, {}};
        if (n) std::get<Numbers>(row.value.is).c[i % 3] = n->c[0];
    }
    expect('>', "'>' after twelve numbers");
    for (Item& row : rows) add(block, std::move(row));
}

void Parser::unknown_word(Block& block, const Token& token) {
    const Place where = place(token);
    const std::string quoted = "'" + names_[token.index].text + "'";
    const char after = raw(1).kind;
    const auto legal = words_in(block.word);
    const bool wants_value = !block.items.empty() && block.items.back().kind == Item::Kind::word &&
                             !block.items.back().word.empty();
    const bool operates = std::string_view("*/+-.,)[?").find(after) != std::string_view::npos;
    const std::string& text = names_[token.index].text;
    // The words of the language are written small: a capital letter makes it a name.
    const bool capital =
        std::any_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    if (after == '(' ||
        (after != '{' && (wants_value || operates || capital || (legal && legal->empty())))) {
        // In the place of a value it is a name.
        Value value = expression(Context::item);
        add(block, {Item::Kind::value, where, {}, std::move(value), {}});
        return;
    }
    std::string hint;
    if (diagnostics_.quiet()) {
        next();
        if (after == '{') skip_braces(token);
        return diagnostics_.pass_over();
    }
    if (legal) hint = did_you_mean(text, *legal);
    if (hint.empty() && after != '{') hint = hint_for_name(where, text, false);
    if (hint.empty()) hint = did_you_mean(text, skipped_words());
    const bool top = block.word == "scene";
    diagnostics_.error(
        where, "unknown word " + quoted + (top ? "" : " in '" + std::string(block.word) + "'"),
        hint);
    block.lacking = true;
    next();
    add(block, {Item::Kind::word, where, {}, {}, {}});
    if (after == '{') skip_braces(token);
}

/// What stands between braces, unread.
void Parser::skip_braces(const Token& opener) {
    const Place where = place(opener);
    int depth = 0;
    do {
        const Token& token = raw();
        if (frame().at >= frame().end) {
            if (frames_.size() > 1) {
                pop_frame();
                continue;
            }
            throw Fault{where, "the '{' after this is never closed: '}' is missing", {}};
        }
        if (token.kind == '{') ++depth;
        if (token.kind == '}') --depth;
        ++frame().at;
        count_token();
    } while (depth > 0);
}

Value Parser::declared_value() {
    const Token token = peek();
    if (token.kind == tok::word && of_file(token)) return block_of_file(token);
    if (token.kind == tok::word && names_[token.index].text == "function") {
        return function_value(token);
    }
    if (token.kind == tok::word && names_[token.index].text == "spline") return spline_value(token);
    if (token.kind == tok::word && raw(1).kind == '{') {
        const Name& name = names_[token.index];
        const Place where = place(token);
        const std::string quoted = "'" + name.text + "'";
        if (words_in(name.text) && name.text != "scene" &&
            !(name.info.may_be_declared && find(token.index))) {
            BlockPtr value = block(token);
            check_depth(value->depth, where);
            return value;
        }
        if (name.info.kind == WordKind::skipped) {
            diagnostics_.warning(where, quoted + " is left out: " + std::string(name.info.advice),
                                 {}, name.text);
        } else if (name.info.kind == WordKind::refused) {
            diagnostics_.error(where, quoted + " cannot be rendered",
                               std::string(name.info.advice));
        } else if (name.text != "array") {
            const auto blocks = *words_in("scene");
            diagnostics_.error(where, "unknown word " + quoted, did_you_mean(name.text, blocks));
        }
        if (name.text != "array") {
            next();
            skip_braces(token);
            return {};
        }
    }
    return expression();
}

}  // namespace icespar
