// What names stand for. As in POV-Ray a name is looked up through all callers' locals, then
// globally.
#include <algorithm>

#include "crystal/mineral.hpp"
#include "parser/parser.hpp"

namespace icespar {

Parser::SlotPtr Parser::find_shared(std::uint32_t name) {
    for (auto f = frames_.rbegin(); f != frames_.rend(); ++f) {
        for (const auto& [local, slot] : f->locals) {
            if (local == name && slot->used()) return slot;
        }
    }
    if (name < globals_.size() && globals_[name] && globals_[name]->used()) return globals_[name];
    return nullptr;
}

/// Where `#declare` puts a value: what the name stands for already, be it an empty name handed to a
/// macro.
Parser::SlotPtr Parser::declare_slot(std::uint32_t name) {
    for (auto f = frames_.rbegin(); f != frames_.rend(); ++f) {
        for (const auto& [local, slot] : f->locals) {
            if (local == name) return slot;
        }
    }
    return global_slot(name);
}

Parser::Slot* Parser::find(std::uint32_t name) {
    if (!names_[name].info.may_be_declared) return nullptr;
    return find_shared(name).get();
}

Parser::SlotPtr Parser::local_slot(std::uint32_t name) {
    for (const auto& [local, slot] : frame().locals) {
        if (local == name) return slot;
    }
    frame().locals.emplace_back(name, std::make_shared<Slot>());
    return frame().locals.back().second;
}

Parser::SlotPtr Parser::global_slot(std::uint32_t name) {
    if (name >= globals_.size()) globals_.resize(names_.size());
    if (!globals_[name]) globals_[name] = std::make_shared<Slot>();
    return globals_[name];
}

std::vector<std::string_view> Parser::declared_names() const {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < globals_.size(); ++i) {
        if (globals_[i] && globals_[i]->used()) {
            names.push_back(names_[static_cast<std::uint32_t>(i)].text);
        }
    }
    for (const Frame& f : frames_) {
        for (const auto& [name, slot] : f.locals) {
            if (slot->used()) names.push_back(names_[name].text);
        }
    }
    return names;
}

std::string Parser::hint_for_name(const Place& where, std::string_view word, bool called) {
    if (diagnostics_.quiet() || !hinted_.insert({where.file, where.begin}).second) return {};
    std::vector<std::string_view> candidates = declared_names();
    if (called) candidates.insert(candidates.end(), value_words().begin(), value_words().end());
    const std::vector<LibraryName>& library = library_declarations();
    for (const auto& [name, file] : library) {
        if (name == word) return "add #include \"" + std::string(file) + "\" above";
    }
    std::string small(word);
    std::transform(small.begin(), small.end(), small.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (small != word && (words_in(small) || word_info(small).kind == WordKind::value)) {
        return "the language's words are written small: '" + small + "'";
    }
    if (find_mineral(word)) return "write it in quotes: \"" + std::string(word) + "\"";
    std::string hint = did_you_mean(word, candidates);
    if (!hint.empty() || word.size() < 4) return hint;
    candidates.clear();
    for (const auto& [name, file] : library) candidates.push_back(name);
    const std::string_view found = likeliest(word, candidates);
    for (const auto& [name, file] : library) {
        if (name == found) {
            return "did you mean '" + std::string(name) + "' of " + std::string(file) + "?";
        }
    }
    return {};
}

}  // namespace icespar
