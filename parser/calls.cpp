// Calling functions: of numbers, of vectors, of strings and of what is declared.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "parser/functions.hpp"
#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {

std::optional<Value> Parser::constant(std::string_view name) {
    const auto axis = [](int size, std::size_t i) {
        Numbers v{{}, size, false};
        v.c[i] = 1;
        return Value(v);
    };
    if (name.size() == 1) {
        switch (name[0]) {
            case 'x':
                return axis(3, 0);
            case 'y':
                return axis(3, 1);
            case 'z':
                return axis(3, 2);
            case 'u':
                return axis(2, 0);
            case 'v':
                return axis(2, 1);
            case 't':
                return axis(4, 3);
            default:
                return std::nullopt;
        }
    }
    if (name == "pi") return std::numbers::pi;
    if (name == "tau") return 2 * std::numbers::pi;
    if (name == "on" || name == "yes" || name == "true") return 1.0;
    if (name == "off" || name == "no" || name == "false") return 0.0;
    if (name == "clock") return options_.clock;
    if (name == "image_width") return static_cast<double>(options_.width);
    if (name == "image_height") return static_cast<double>(options_.height);
    if (name == "version") return 3.7;
    if (name == "clock_on" || name == "clock_delta" || name == "initial_clock") return 0.0;
    if (name == "final_clock" || name == "frame_number" || name == "initial_frame" ||
        name == "final_frame") {
        return 1.0;
    }
    return std::nullopt;
}

double Parser::number_argument(std::string_view what) {
    const Place start = here();
    const Value value = expression();
    if (value.empty()) return 1;
    const Numbers* n = value.numbers();
    if (!n || n->size != 1) {
        throw Fault{joined(start, last_place_),
                    "expected " + std::string(what) + ", found " + kind_of(value),
                    {}};
    }
    return n->c[0];
}

namespace {

using Vec = std::array<double, 3>;

Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// In left-handed coordinates, thumb of the left hand along the axis.
Vec turned(const Vec& v, const Vec& unit, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), along = dot(unit, v) * (1 - c);
    const Vec side = cross(unit, v);
    Vec out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = v[i] * c + side[i] * s + unit[i] * along;
    return out;
}

Numbers vector_of(const Vec& v) { return {{v[0], v[1], v[2]}, 3, false}; }

/// The arguments of a call, checked one by one as the function asks for them.
struct Arguments {
    std::string_view name;
    Place whole;
    std::vector<Value> values;
    std::vector<Place> places;

    void count(std::size_t least, std::size_t most) const {
        if (values.size() >= least && values.size() <= most) return;
        throw Fault{whole,
                    "'" + std::string(name) + "' takes " + std::to_string(least) +
                        (most == least ? "" : " or more") +
                        (most == 1 ? " argument, not " : " arguments, not ") +
                        std::to_string(values.size()),
                    {}};
    }
    [[noreturn]] void wrong(std::size_t i, std::string_view wanted) const {
        throw Fault{places[i],
                    "'" + std::string(name) + "' needs " + std::string(wanted) + " here, not " +
                        kind_of(values[i]),
                    {}};
    }
    [[nodiscard]] double number(std::size_t i) const {
        const Numbers* n = values[i].numbers();
        if (!n || n->size != 1) wrong(i, "a float");
        return n->c[0];
    }
    [[nodiscard]] int integer(std::size_t i) const {
        return static_cast<int>(std::clamp(number(i), -1e9, 1e9));
    }
    [[nodiscard]] Vec vector(std::size_t i) const {
        const Numbers* n = values[i].numbers();
        if (!n || (n->size > 3 && !n->colour)) wrong(i, "a vector of 3");
        if (n->size == 1) return {n->c[0], n->c[0], n->c[0]};
        return {n->c[0], n->c[1], n->size > 2 ? n->c[2] : 0};
    }
    [[nodiscard]] const std::string& text(std::size_t i) const {
        if (!values[i].text()) wrong(i, "a string");
        return *values[i].text();
    }
};

std::optional<Value> vector_function(std::string_view name, const Arguments& a) {
    if (name == "vlength" || name == "vnormalize") {
        a.count(1, 1);
        Vec v = a.vector(0);
        const double length = std::sqrt(dot(v, v));
        if (name == "vlength") return length;
        if (!(length > 0)) throw Fault{a.whole, "a vector of length 0 has no direction", {}};
        for (double& c : v) c /= length;
        return vector_of(v);
    }
    if (name == "vdot" || name == "vcross") {
        a.count(2, 2);
        if (name == "vdot") return dot(a.vector(0), a.vector(1));
        return vector_of(cross(a.vector(0), a.vector(1)));
    }
    if (name == "vaxis_rotate") {
        a.count(3, 3);
        Vec axis = a.vector(1);
        const double length = std::sqrt(dot(axis, axis));
        if (!(length > 0)) throw Fault{a.places[1], "the axis of rotation has length 0", {}};
        for (double& c : axis) c /= length;
        return vector_of(turned(a.vector(0), axis, a.number(2) * std::numbers::pi / 180));
    }
    if (name == "vrotate") {
        a.count(2, 2);
        Vec v = a.vector(0);
        const Vec angles = a.vector(1);
        for (std::size_t i = 0; i < 3; ++i) {
            Vec axis{};
            axis[i] = 1;
            v = turned(v, axis, angles[i] * std::numbers::pi / 180);
        }
        return vector_of(v);
    }
    return std::nullopt;
}

std::string mapped(std::string text, int (*f)(int)) {
    for (char& c : text) c = static_cast<char>(f(static_cast<unsigned char>(c)));
    return text;
}

/// Functions that yield strings, or measure them.
std::optional<std::variant<double, std::string>> string_function(std::string_view name,
                                                                 const Arguments& a) {
    if (name == "strlen") {
        a.count(1, 1);
        return static_cast<double>(a.text(0).size());
    }
    if (name == "strcmp") {
        a.count(2, 2);
        const int order = a.text(0).compare(a.text(1));
        return order < 0 ? -1.0 : order > 0 ? 1.0 : 0.0;
    }
    if (name == "asc") {
        a.count(1, 1);
        if (a.text(0).empty()) throw Fault{a.whole, "an empty string has no first character", {}};
        return static_cast<double>(static_cast<unsigned char>(a.text(0)[0]));
    }
    if (name == "val") {
        a.count(1, 1);
        const double value = std::strtod(a.text(0).c_str(), nullptr);
        return std::isfinite(value) ? value : 0.0;
    }
    if (name == "chr") {
        a.count(1, 1);
        const int code = a.integer(0);
        if (code < 1 || code > 255) throw Fault{a.whole, "chr() takes a number from 1 to 255", {}};
        return std::string(1, static_cast<char>(code));
    }
    if (name == "concat") {
        std::string out;
        for (std::size_t i = 0; i < a.values.size(); ++i) {
            out += a.text(i);
            if (out.size() > limits::string_bytes) break;
        }
        return out;
    }
    if (name == "strlwr" || name == "strupr") {
        a.count(1, 1);
        return mapped(
            a.text(0), name == "strlwr" ? [](int c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; }
                                        : [](int c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
    }
    if (name == "substr") {
        a.count(3, 3);
        const int first = a.integer(1), length = a.integer(2);
        const auto size = static_cast<int>(a.text(0).size());
        if (first < 1 || length < 0 || first - 1 > size || length > size - (first - 1)) {
            throw Fault{a.whole,
                        "the string has " + std::to_string(size) +
                            " characters, counted from 1: there is no such part of it",
                        {}};
        }
        return a.text(0).substr(static_cast<std::size_t>(first - 1),
                                static_cast<std::size_t>(length));
    }
    if (name == "str") {
        a.count(3, 3);
        return number_text(a.number(0), a.integer(1), a.integer(2));
    }
    if (name == "vstr") {
        a.count(5, 5);
        const int size = std::clamp(a.integer(0), 2, 5);
        const Numbers* n = a.values[1].numbers();
        if (!n) a.wrong(1, "a vector");
        std::string out;
        for (int i = 0; i < size; ++i) {
            if (i > 0) out += a.text(2);
            const auto k = static_cast<std::size_t>(i);
            out += number_text(n->size == 1 ? n->c[0] : n->c[k], a.integer(3), a.integer(4));
        }
        return out;
    }
    return std::nullopt;
}

}  // namespace

Value Parser::function_call(std::string_view name, const Token& token) {
    const Place start = place(token);
    expect('(', "'('");
    if (name == "defined") {
        const Token what = raw();
        if (what.kind != tok::word) {
            throw Fault{place(what), "expected a name, found " + shown(what), {}};
        }
        const bool known = find(what.index) != nullptr;
        ++frame().at;
        expect(')', "')'");
        return known ? 1.0 : 0.0;
    }
    Arguments a{name, start, {}, {}};
    while (!peek_is(')')) {
        if (!a.values.empty()) expect(',', "',' or ')'");
        const Place at = here();
        a.values.push_back(expression());
        a.places.push_back(joined(at, last_place_));
        if (a.values.size() > 1000)
            throw Fault{at, "a call has at most 1000 arguments, the bound", {}};
    }
    next();
    a.whole = joined(start, last_place_);
    for (const Value& value : a.values) {
        if (value.empty()) return {};
    }

    if (const NumberFunction* f = number_function(name)) {
        const auto count = static_cast<std::size_t>(f->arguments);
        a.count(count, count);
        const double p = a.number(0), q = count > 1 ? a.number(1) : 0;
        const std::string_view fault = f->fault ? f->fault(p, q) : std::string_view();
        if (!fault.empty()) {
            throw Fault{a.whole,
                        "'" + std::string(name) + "' has no value here: " + std::string(fault),
                        {}};
        }
        return checked({{f->f(p, q)}, 1, false}, a.whole);
    }
    if (auto value = vector_function(name, a)) {
        return value->numbers() ? checked(*value->numbers(), a.whole) : *value;
    }
    if (auto value = string_function(name, a)) {
        if (const double* n = std::get_if<double>(&*value)) return *n;
        return text_value(std::get<std::string>(std::move(*value)), a.whole);
    }
    if (name == "max" || name == "min") {
        a.count(1, 1000);
        double best = a.number(0);
        for (std::size_t i = 1; i < a.values.size(); ++i) {
            best = name == "max" ? std::max(best, a.number(i)) : std::min(best, a.number(i));
        }
        return best;
    }
    if (name == "select") {
        a.count(3, 4);
        const double sign = a.number(0);
        if (sign < 0) return a.values[1];
        return sign == 0 || a.values.size() == 3 ? a.values[2] : a.values[3];
    }
    if (name == "seed") {
        a.count(1, 1);
        if (random_.size() >= 10000) throw Fault{a.whole, "more than 10000 seeds, the bound", {}};
        random_.push_back(static_cast<std::uint32_t>(static_cast<std::int64_t>(a.integer(0))));
        return static_cast<double>(random_.size() - 1);
    }
    if (name == "rand") {
        a.count(1, 1);
        const int stream = a.integer(0);
        if (stream < 0 || stream >= static_cast<int>(random_.size())) {
            throw Fault{a.whole, "rand() takes what seed() gave",
                        "#declare Dice = seed(1); ... rand(Dice)"};
        }
        // The generator of POV-Ray, so that scattered stones lie where they lay.
        std::uint32_t& state = random_[static_cast<std::size_t>(stream)];
        state = state * 1812433253U + 12345U;
        return static_cast<double>(state) / 4294967295.0;
    }
    if (name == "dimensions" || name == "dimension_size") {
        a.count(name == "dimensions" ? 1 : 2, name == "dimensions" ? 1 : 2);
        if (!a.values[0].array()) a.wrong(0, "an array");
        std::vector<std::size_t> sizes;
        for (Value level = a.values[0]; level.array();) {
            const std::shared_ptr<Array> array = *level.array();
            sizes.push_back(array->elements.size());
            if (array->elements.empty()) break;
            level = array->elements.front();
        }
        if (name == "dimensions") return static_cast<double>(sizes.size());
        const int which = a.integer(1);
        if (which < 1 || which > static_cast<int>(sizes.size())) {
            throw Fault{
                a.places[1], "the array has " + std::to_string(sizes.size()) + " dimensions", {}};
        }
        return static_cast<double>(sizes[static_cast<std::size_t>(which - 1)]);
    }
    if (name == "file_exists") {
        a.count(1, 1);
        const auto found = sources_.find(a.text(0), sources_.file(start.file).folder);
        return found.path || library_file(a.text(0)) ? 1.0 : 0.0;
    }
    throw Fault{start, "'" + std::string(name) + "' is not a function here", {}};
}

}  // namespace icespar
