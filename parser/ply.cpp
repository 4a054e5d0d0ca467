// Stanford's .ply: a header that says what the numbers are, then text, or bytes of either order.
#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "math/error.hpp"
#include "parser/limits.hpp"
#include "parser/mesh_text.hpp"

namespace icespar {

bool MeshText::next_line() {
    if (at_ >= bytes_.size()) return false;
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    std::string_view line = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    ++line_;
    words_.clear();
    constexpr std::string_view spaces = " \t\r";
    while (!line.empty()) {
        const std::size_t first = line.find_first_not_of(spaces);
        if (first == std::string_view::npos) break;
        line.remove_prefix(first);
        const std::size_t length = std::min(line.find_first_of(spaces), line.size());
        words_.push_back(line.substr(0, length));
        line.remove_prefix(length);
    }
    return true;
}

double MeshText::number(std::string_view word) const {
    double value = 0;
    const char* last = word.data() + word.size();
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    const auto [end, error] = fast_float::from_chars(word.data(), last, value);
    if (error != std::errc() || end != last || !std::isfinite(value)) {
        fault("'" + std::string(word.substr(0, 40)) + "' is not a number");
    }
    return value;
}

void MeshText::fault(const std::string& what) const {
    throw Error("'" + name_ + "', line " + std::to_string(line_) + ": " + what);
}

namespace {

struct Kind {
    std::size_t size = 0;
    char sort = 'u';  ///< u: unsigned, i: signed, f: floating
};

std::optional<Kind> kind_named(std::string_view word) {
    struct Row {
        std::string_view name, other;
        Kind kind;
    };
    static constexpr std::array<Row, 8> rows{{{"char", "int8", {1, 'i'}},
                                              {"uchar", "uint8", {1, 'u'}},
                                              {"short", "int16", {2, 'i'}},
                                              {"ushort", "uint16", {2, 'u'}},
                                              {"int", "int32", {4, 'i'}},
                                              {"uint", "uint32", {4, 'u'}},
                                              {"float", "float32", {4, 'f'}},
                                              {"double", "float64", {8, 'f'}}}};
    for (const Row& row : rows) {
        if (word == row.name || word == row.other) return row.kind;
    }
    return std::nullopt;
}

struct Property {
    std::string_view name;
    Kind kind;
    std::optional<Kind> count;  ///< of a list
};

struct Element {
    std::string_view name;
    double count = 0;
    std::vector<Property> properties;
};

template <class T>
double as(const std::array<unsigned char, 8>& bytes) {
    T value{};
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
}

/// One number after the other, from text or from bytes.
class Numbers {
public:
    enum class Form { text, little, big };
    Numbers(const std::string& name, Form form, std::string_view rest)
        : name_(name), form_(form), rest_(rest) {}

    double next(const Kind& kind) { return form_ == Form::text ? word() : bytes(kind); }

private:
    [[noreturn]] void ends() const {
        throw Error("'" + name_ + "' ends before all that its header promises");
    }
    double word() {
        const std::size_t first = rest_.find_first_not_of(" \t\r\n");
        if (first == std::string_view::npos) ends();
        double value = 0;
        const auto [end, error] =
            fast_float::from_chars(rest_.data() + first, rest_.data() + rest_.size(), value);
        if (error != std::errc()) throw Error("'" + name_ + "' has a word where a number is due");
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }
    double bytes(const Kind& kind) {
        if (rest_.size() < kind.size) ends();
        std::array<unsigned char, 8> b{};
        for (std::size_t i = 0; i < kind.size; ++i) {
            const std::size_t to = form_ == Form::big ? kind.size - 1 - i : i;
            b[to % b.size()] = static_cast<unsigned char>(rest_[i]);
        }
        rest_.remove_prefix(kind.size);
        if (kind.sort == 'f') return kind.size == 4 ? as<float>(b) : as<double>(b);
        const bool negative = kind.sort == 'i';
        if (kind.size == 1) return negative ? as<std::int8_t>(b) : as<std::uint8_t>(b);
        if (kind.size == 2) return negative ? as<std::int16_t>(b) : as<std::uint16_t>(b);
        return negative ? as<std::int32_t>(b) : as<std::uint32_t>(b);
    }

    const std::string& name_;
    Form form_;
    std::string_view rest_;
};

struct Header {
    Numbers::Form form = Numbers::Form::text;
    std::vector<Element> elements;
};

Header read_header(MeshText& text) {
    Header header;
    if (!text.next_line() || text.words() != std::vector<std::string_view>{"ply"}) {
        text.fault("a PLY file starts with the word 'ply'");
    }
    while (text.next_line()) {
        const auto& words = text.words();
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
        if (words[0] == "end_header") return header;
        if (words[0] == "format" && words.size() == 3) {
            if (words[1] == "ascii") {
                header.form = Numbers::Form::text;
            } else if (words[1] == "binary_little_endian") {
                header.form = Numbers::Form::little;
            } else if (words[1] == "binary_big_endian") {
                header.form = Numbers::Form::big;
            } else {
                text.fault("a PLY file is ascii, binary_little_endian or binary_big_endian");
            }
        } else if (words[0] == "element" && words.size() == 3) {
            const double count = text.number(words[2]);
            if (!(count >= 0 && count <= static_cast<double>(limits::file_bytes))) {
                text.fault("there cannot be so many of them");
            }
            header.elements.push_back({words[1], count, {}});
        } else if (words[0] == "property" && !header.elements.empty()) {
            const bool list = words.size() == 5 && words[1] == "list";
            if (!list && words.size() != 3) text.fault("a property has a kind and a name");
            const auto kind = kind_named(words[list ? 3 : 1]);
            const auto count = list ? kind_named(words[2]) : std::nullopt;
            if (!kind || (list && !count)) text.fault("there is no such kind of number");
            header.elements.back().properties.push_back({words.back(), *kind, count});
        } else {
            text.fault("unexpected '" + std::string(words[0].substr(0, 40)) + "' in the header");
        }
    }
    text.fault("the header has no 'end_header'");
}

}  // namespace

MeshFile read_ply(const std::string& name, std::string_view bytes) {
    MeshText text(name, bytes);
    const Header header = read_header(text);
    Numbers numbers(name, header.form, text.rest());
    MeshFile mesh;
    std::vector<double> list;
    for (const Element& element : header.elements) {
        if (element.properties.empty()) continue;
        for (double i = 0; i < element.count; ++i) {
            std::array<double, 3> place{};
            for (const Property& property : element.properties) {
                if (!property.count) {
                    const double value = numbers.next(property.kind);
                    const std::size_t axis = std::string_view("xyz").find(property.name);
                    if (property.name.size() == 1 && axis < 3) place[axis] = value;
                    continue;
                }
                const double size = numbers.next(*property.count);
                list.clear();
                for (double k = 0; k < size; ++k) list.push_back(numbers.next(property.kind));
                if (element.name != "face" || !property.name.starts_with("vertex_ind")) continue;
                std::vector<std::uint32_t> corners;
                for (const double corner : list) {
                    if (!(corner >= 0 && corner < static_cast<double>(mesh.vertices.size()))) {
                        throw Error("'" + name + "': a face has a vertex that is not there");
                    }
                    corners.push_back(static_cast<std::uint32_t>(corner));
                }
                add_fan(mesh, corners);
            }
            if (element.name == "vertex") mesh.vertices.push_back({place[0], place[1], place[2]});
        }
    }
    return mesh;
}

}  // namespace icespar
