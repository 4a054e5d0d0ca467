// Blocks: words, values and further blocks between braces. What is wrong in one block is reported
// there, and reading goes on after it.
#include <algorithm>

#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {
namespace {

bool contains(std::span<const std::string_view> words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

Parser::Parser(Sources& sources, Diagnostics& diagnostics, const LoadOptions& options)
    : sources_(sources), diagnostics_(diagnostics), options_(options) {}

BlockPtr Parser::parse(std::uint32_t file) {
    files_.push_back(std::make_unique<TokenFile>(tokenize(file, sources_.file(file).text, names_)));
    const TokenFile* tokens = files_.back().get();
    frames_.push_back({tokens, 0, tokens->tokens.size() - 1, 0});
    Block scene;
    scene.word = "scene";
    const auto scene_words = *words_in("scene");
    std::size_t recovered_at = 0;
    for (;;) {
        try {
            items(scene, tok::end);
            if (peek_is(tok::end)) break;
            throw Fault{here(), "unexpected '}'", "there is no '{' for it"};
        } catch (const Fault& fault) {
            diagnostics_.error(fault);
        }
        // On to where a block of the scene seems to begin.
        diagnostics_.set_quiet(true);
        const int depth = braces_;
        bool first = tokens_ == recovered_at;
        for (;; first = false) {
            try {
                const Token& token = peek();
                if (token.kind == tok::end) break;
                if (!first && braces_ <= depth && token.kind == tok::word && raw(1).kind == '{' &&
                    contains(scene_words, names_[token.index].text)) {
                    break;
                }
                next();
            } catch (const Fault&) {
                if (frame().at < frame().end) ++frame().at;
            }
        }
        diagnostics_.set_quiet(false);
        braces_ = 0;
        recovered_at = tokens_;
    }
    while (!frame().conditions.empty()) {
        const Token token = frame().conditions.back().token;
        const std::string name = names_[token.index].text;
        diagnostics_.error(place(token), "this '#" + name + "' has no '#end'");
        frame().conditions.pop_back();
    }
    scene.items.insert(scene.items.begin(), defaults_.begin(), defaults_.end());
    return std::make_shared<const Block>(std::move(scene));
}

BlockPtr Parser::block(const Token& word) {
    auto block = std::make_shared<Block>();
    block->word = names_[word.index].text;
    block->place = place(word);
    const Nesting nesting(*this, block->place);
    const Argument none(*this, 0);
    if (word.kind == tok::word) next();
    next();
    const int depth = braces_;
    try {
        items(*block, '}');
        if (closing_) {
            --braces_;
        } else {
            next();
        }
    } catch (const Fault& fault) {
        diagnostics_.error(fault);
        block->broken = true;
        recover(depth);
    }
    return block;
}

/// Up to and past the '}' that closes the block opened at this depth.
void Parser::recover(int depth) {
    diagnostics_.set_quiet(true);
    for (;;) {
        try {
            if (peek_is(tok::end)) break;
            if (next().kind == '}' && braces_ < depth) break;
        } catch (const Fault&) {
            if (frame().at < frame().end) ++frame().at;
        }
    }
    diagnostics_.set_quiet(false);
    braces_ = std::min(braces_, depth - 1);
}

void Parser::items(Block& block, char closer) {
    bool after_comma = true;
    for (;;) {
        const Token token = peek();
        if (token.kind == closer) return;
        if (token.kind == tok::end && closer != tok::end) {
            if (!closing_) {
                diagnostics_.error(block.place, "this '" + std::string(block.word) +
                                                    "' is never closed: '}' is missing");
            }
            closing_ = true;
            return;
        }
        if (token.kind == '}') return;
        if (token.kind == ';') {
            next();
            continue;
        }
        if (token.kind == ',') {
            if (after_comma) throw Fault{here(), "unexpected ','", {}};
            after_comma = true;
            next();
            continue;
        }
        if (!item(block, closer)) return;
        after_comma = false;
    }
}

void Parser::add(Block& block, Item item) {
    if (++items_ > limits::items) {
        diagnostics_.fatal(item.place, "the scene has more than " + std::to_string(limits::items) +
                                           " words, values and blocks, the bound");
    }
    const int depth = 1 + std::max(depth_of(item.value), item.block ? item.block->depth : 0);
    block.depth = std::max(block.depth, depth);
    check_depth(block.depth, item.place);
    block.items.push_back(std::move(item));
}

/// False when the block must close here although its '}' is missing.
bool Parser::item(Block& block, char closer) {
    const Token token = peek();
    const Place where = place(token);
    switch (token.kind) {
        case '[': {
            next();
            const Nesting nesting(*this, where);
            auto entry = std::make_shared<Block>();
            entry->word = block.word;
            entry->place = where;
            items(*entry, ']');
            if (closing_) return false;
            expect(']', "']'");
            add(block, {Item::Kind::entry, joined(where, last_place_), {}, {}, entry});
            return true;
        }
        case tok::number:
        case tok::text:
        case '<':
        case '(':
        case '-':
        case '+':
        case '!': {
            Value value = expression(Context::item);
            add(block, {Item::Kind::value, joined(where, last_place_), {}, std::move(value), {}});
            return true;
        }
        case tok::bad:
            next();
            throw Fault{where, shown(token), {}};
        case tok::word:
            break;
        default:
            throw Fault{
                where, "unexpected " + shown(token) + " in '" + std::string(block.word) + "'", {}};
    }
    const Name& name = names_[token.index];
    const bool opens = raw(1).kind == '{';
    const auto legal = words_in(block.word);
    if (opens && closer == '}' && legal && is_scene_block(name.text) &&
        !contains(*legal, name.text)) {
        if (!closing_) {
            diagnostics_.error(
                block.place,
                "this '" + std::string(block.word) + "' is not closed before '" + name.text +
                    "' in line " +
                    std::to_string(sources_.line_column(where.file, where.begin).line),
                "is a '}' missing?");
        }
        closing_ = true;
        return false;
    }
    closing_ = false;
    word_item(block, token);
    return true;
}

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
        if (opens) {
            BlockPtr inner = this->block(token);
            add(block, {Item::Kind::block, where, name.text, {}, std::move(inner)});
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
        diagnostics_.error(where, quoted + " cannot be rendered", std::string(info.advice));
    } else if (info.kind == WordKind::name) {
        return unknown_word(block, token);
    } else {
        std::string hint;
        if (legal && !legal->empty()) hint = did_you_mean(name.text, *legal);
        diagnostics_.error(where, quoted + " does not belong in '" + std::string(block.word) + "'",
                           hint);
    }
    next();
    // A word that is left out stays in the tree as one, so that what follows is not taken for
    // another's.
    add(block, {Item::Kind::word, where, {}, {}, {}});
    if (opens) skip_braces(token);
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
    if (legal) hint = did_you_mean(text, *legal);
    if (hint.empty() && after != '{') hint = hint_for_name(text, false);
    if (hint.empty()) hint = did_you_mean(text, skipped_words());
    const bool top = block.word == "scene";
    diagnostics_.error(
        where, "unknown word " + quoted + (top ? "" : " in '" + std::string(block.word) + "'"),
        hint);
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
