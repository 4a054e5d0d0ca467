// The tables of words and the blocks in which each may stand.
#include "parser/words.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>
#include <vector>

#include "parser/word_lists.hpp"

namespace icespar {
namespace {

using Words = std::vector<std::string_view>;

Words split(std::string_view text) {
    Words words;
    while (!text.empty()) {
        const std::size_t space = std::min(text.find(' '), text.size());
        if (space > 0) words.push_back(text.substr(0, space));
        text.remove_prefix(std::min(space + 1, text.size()));
    }
    return words;
}

struct Vocabulary {
    std::unordered_map<std::string_view, WordInfo> info;
    std::unordered_map<std::string_view, Words> blocks;
    Words skipped;
    Words values = split(word_lists::values), directives = split(word_lists::directives);

    Vocabulary() {
        for (const auto& block : word_lists::blocks) {
            Words& words = blocks[block.name] = split(block.words);
            if (block.modifiers) {
                for (const auto more : split(*block.modifiers)) words.push_back(more);
            }
        }
        // The first kind a word is given stays.
        for (const auto word : values) info.try_emplace(word, WordInfo{WordKind::value});
        for (const auto word : split(word_lists::ours))
            info.try_emplace(word, WordInfo{WordKind::ours});
        for (const auto& [name, words] : blocks) {
            info.try_emplace(name, WordInfo{WordKind::word});
            for (const auto word : words) info.try_emplace(word, WordInfo{WordKind::word});
        }
        for (const auto& row : word_lists::skipped) {
            for (const auto word : split(row.words)) {
                info.try_emplace(word, WordInfo{WordKind::skipped, row.advice});
                skipped.push_back(word);
            }
        }
        for (const auto& row : word_lists::refused) {
            for (const auto word : split(row.words)) {
                info.try_emplace(word, WordInfo{WordKind::refused, row.advice});
            }
        }
        for (const auto word : directives) info.try_emplace(word, WordInfo{WordKind::directive});
        for (const auto word : split(word_lists::others))
            info.try_emplace(word, WordInfo{WordKind::other});
        info.erase("scene");
        for (const auto list :
             {word_lists::ours, word_lists::ours_later, word_lists::macros_of_includes}) {
            for (const auto word : split(list)) info[word].may_be_declared = true;
        }
    }
};

const Vocabulary& vocabulary() {
    static const Vocabulary words;
    return words;
}

}  // namespace

WordInfo word_info(std::string_view word) {
    const auto found = vocabulary().info.find(word);
    if (found == vocabulary().info.end()) return {WordKind::name, {}, true};
    return found->second;
}

std::optional<std::span<const std::string_view>> words_in(std::string_view block) {
    const auto found = vocabulary().blocks.find(block);
    if (found == vocabulary().blocks.end()) return std::nullopt;
    return std::span<const std::string_view>(found->second);
}

bool is_scene_block(std::string_view word) {
    static constexpr std::array<std::string_view, 9> blocks{
        "global_settings", "camera", "light_source", "environment", "background",
        "sky_sphere",      "gem",    "plane",        "union"};
    return std::find(blocks.begin(), blocks.end(), word) != blocks.end();
}

bool is_pov_include(std::string_view file) {
    static const Words files = split(word_lists::pov_includes);
    return file.ends_with(".inc") &&
           std::find(files.begin(), files.end(), file.substr(0, file.size() - 4)) != files.end();
}

std::span<const std::string_view> value_words() { return vocabulary().values; }
std::span<const std::string_view> directive_words() { return vocabulary().directives; }

std::vector<std::string_view> all_words() {
    std::vector<std::string_view> words;
    for (const auto& [word, info] : vocabulary().info) words.push_back(word);
    std::sort(words.begin(), words.end());
    return words;
}

std::span<const std::string_view> skipped_words() { return vocabulary().skipped; }

}  // namespace icespar
