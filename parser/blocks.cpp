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
    const TokenFile& tokens = read_tokens(file);
    frames_.push_back({&tokens, 0, tokens.tokens.size() - 1, 0});
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
                const bool directive = frame().at < frame().end && raw().kind == tok::directive;
                if (!first && braces_ <= depth && directive) break;
                const Token& token = peek();
                if (token.kind == tok::end) break;
                if (!first && braces_ <= depth && token.kind == tok::word && raw(1).kind == '{' &&
                    contains(scene_words, names_[token.index].text)) {
                    break;
                }
                next();
            } catch (const Fault&) {
                diagnostics_.pass_over();
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
    if (block->lacking || block->broken) diagnostics_.excuse(block->place);
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
            diagnostics_.pass_over();
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
            if (after_comma) {
                const bool decimal = raw(1).kind == tok::number && last_.kind == tok::number;
                throw Fault{here(), "unexpected ','",
                            decimal ? "decimals are written with a point" : ""};
            }
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
    const auto lacks = [](const BlockPtr* inner) {
        return inner && *inner && ((*inner)->lacking || (*inner)->broken);
    };
    block.lacking = block.lacking || lacks(&item.block) || lacks(item.value.block()) ||
                    (item.kind == Item::Kind::value && item.value.empty());
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
            throw Fault{where,
                        "unexpected " + shown(token) + " in '" + std::string(block.word) + "'",
                        token.kind == '=' ? "a word is followed by its value, without '='" : ""};
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

}  // namespace icespar
