// Constants, and calling functions by name.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "math/error.hpp"
#include "parser/arguments.hpp"
#include "parser/builder.hpp"
#include "parser/functions.hpp"
#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {
namespace {

/// A point taken through a transform, or back; empty when the transform was told to be at fault.
Value transformed(const Arguments& a, bool back) {
    a.count(2, 2);
    const auto v = a.vector(0);
    const BlockPtr* block = a.values[1].block();
    if (!block || (*block)->word != "transform") a.wrong(1, "a transform");
    try {
        const Transform t = transform_of(**block);
        const Vec3 p = (back ? t.inverse() : t).point({v[0], v[1], v[2]});
        return Numbers{{p.x, p.y, p.z}, 3, false};
    } catch (const Poisoned&) {
        return {};
    } catch (const Error& error) {
        throw Fault{a.places[1], error.what(), {}};
    }
}

}  // namespace

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
    if (name == "version") return version_;
    const double frames = options_.final_frame - options_.initial_frame;
    if (name == "frame_number") return static_cast<double>(options_.frame_number);
    if (name == "initial_frame") return static_cast<double>(options_.initial_frame);
    if (name == "final_frame") return static_cast<double>(options_.final_frame);
    if (name == "initial_clock") return options_.initial_clock;
    if (name == "final_clock") return options_.final_clock;
    if (name == "clock_on") return frames > 0 ? 1.0 : 0.0;
    if (name == "clock_delta") {
        return frames > 0 ? (options_.final_clock - options_.initial_clock) / frames : 0.0;
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
        a.values.push_back(declared_value());
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
    if (name == "vtransform" || name == "vinv_transform") {
        const Value moved = transformed(a, name[1] == 'i');
        return moved.empty() ? moved : checked(*moved.numbers(), a.whole);
    }
    throw Fault{start, "'" + std::string(name) + "' is not a function here", {}};
}

}  // namespace icespar
