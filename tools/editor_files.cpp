// Writes what is made from the parser's lists of words: the grammar for editors, and the fuzzers'
// dictionary. `editor_files ROOT` writes them below the repository's folder; `editor_files --check
// ROOT` says whether they are what it would write.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "parser/words.hpp"

namespace {

using namespace icespar;
namespace fs = std::filesystem;
using Words = std::vector<std::string_view>;

template <class Chosen>
Words chosen(Chosen&& is_chosen) {
    Words words = all_words();
    std::erase_if(words, [&](std::string_view word) { return !is_chosen(word); });
    return words;
}

/// A regular expression within a JSON string; `after` is what must follow.
std::string any_of(const Words& words, const std::string& after = {}) {
    std::string out = "\\\\b(?:";
    for (const std::string_view word : words)
        out += (word == words.front() ? "" : "|") + std::string(word);
    return out + ")\\\\b" + after;
}

std::string rule(const std::string& name, const std::string& match) {
    return "    {\"name\": \"" + name + ".spar\", \"match\": \"" + match + "\"}";
}

std::string grammar() {
    const auto kind = [](std::string_view word) { return word_info(word).kind; };
    const Words directives(directive_words().begin(), directive_words().end());
    const Words values = chosen([&](auto word) { return kind(word) == WordKind::value; });
    const Words blocks = chosen([&](auto word) {
        return words_in(word) && kind(word) != WordKind::skipped && kind(word) != WordKind::refused;
    });
    const Words words = chosen(
        [&](auto word) { return kind(word) == WordKind::word || kind(word) == WordKind::ours; });
    const Words skipped = chosen([&](auto word) { return kind(word) == WordKind::skipped; });
    const Words refused = chosen([&](auto word) { return kind(word) == WordKind::refused; });

    std::string directive = any_of(directives);
    directive.insert(0, "#[ \\\\t]*");
    const std::vector<std::string> rules{
        rule("keyword.control.directive", directive),
        rule("constant.numeric",
             "(?<![A-Za-z_])(?:\\\\d+\\\\.?\\\\d*|\\\\.\\\\d+)(?:[eE][-+]?\\\\d+)?"),
        rule("support.type.block", any_of(blocks, "(?=\\\\s*\\\\{)")),
        rule("support.function", any_of(values, "(?=\\\\s*\\\\()")),
        rule("constant.language", any_of(values)),
        rule("keyword.other", any_of(words)),
        rule("comment.unused.left-out", any_of(skipped)),
        rule("invalid.illegal.not-rendered", any_of(refused)),
        rule("keyword.operator", "[-+*/=<>!?:&|]"),
    };
    std::string text = R"({
  "$schema": "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json",
  "name": "icespar scene",
  "scopeName": "source.spar",
  "fileTypes": ["spar", "inc"],
  "comment": "Made by tools/editor_files.cpp from the parser's words; do not edit.",
  "patterns": [
    {"name": "comment.line.double-slash.spar", "match": "//.*$"},
    {"include": "#comment"},
    {"name": "string.quoted.double.spar", "begin": "\"", "end": "\"|$",
     "patterns": [{"name": "constant.character.escape.spar", "match": "\\\\."}]},
)";
    for (std::size_t i = 0; i < rules.size(); ++i)
        text += rules[i] + (i + 1 < rules.size() ? ",\n" : "\n");
    return text + R"(  ],
  "repository": {
    "comment": {"name": "comment.block.spar", "begin": "/\\*", "end": "\\*/",
                "patterns": [{"include": "#comment"}]}
  }
}
)";
}

std::string dictionary() {
    std::string text = "# Made by tools/editor_files.cpp from the parser's words; do not edit.\n";
    for (const std::string_view word : all_words()) text += "\"" + std::string(word) + "\"\n";
    for (const std::string_view word : directive_words())
        text += "\"#" + std::string(word) + "\"\n";
    return text;
}

std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

int main(int argc, char** argv) {
    const bool check = argc == 3 && std::string_view(argv[1]) == "--check";
    if (argc != 2 && !check) {
        std::cerr << "usage: editor_files [--check] ROOT\n";
        return 2;
    }
    const fs::path root = argv[argc - 1];
    bool stale = false;
    for (const auto& [name, text] :
         {std::pair{"editors/vscode/syntaxes/spar.tmLanguage.json", grammar()},
          std::pair{"tests/fuzz/spar.dict", dictionary()}}) {
        if (!check) {
            std::ofstream(root / name, std::ios::binary) << text;
        } else if (contents(root / name) != text) {
            std::cerr << name << " is out of date: make editors\n";
            stale = true;
        }
    }
    return stale ? 1 : 0;
}
