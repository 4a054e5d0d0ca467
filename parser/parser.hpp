// Tokens to the evaluated tree. Directives run while tokens are read, as in POV-Ray: a macro, a
// loop or a condition may yield any piece of text, even half an expression.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "parser/diagnostic.hpp"
#include "parser/lexer.hpp"
#include "parser/load.hpp"
#include "parser/tree.hpp"

namespace icespar {

class Parser {
public:
    Parser(Sources& sources, Diagnostics& diagnostics, const LoadOptions& options);

    /// The whole file as a block named "scene", with the `#default` blocks first. Faults are in the
    /// diagnostics; throws Stop.
    BlockPtr parse(std::uint32_t file);

private:
    // --- what is declared (symbols.cpp) ---
    struct Macro {
        const TokenFile* file = nullptr;
        std::size_t begin = 0, end = 0;  ///< of the body
        std::vector<std::uint32_t> parameters;
    };
    /// A name's content; macro parameters that were given a name share its slot.
    struct Slot {
        std::optional<Value> value;
        std::shared_ptr<const Macro> macro;
        [[nodiscard]] bool used() const { return value || macro; }
    };
    using SlotPtr = std::shared_ptr<Slot>;

    Slot* find(std::uint32_t name);
    SlotPtr find_shared(std::uint32_t name);
    SlotPtr declare_slot(std::uint32_t name);
    SlotPtr local_slot(std::uint32_t name);
    SlotPtr global_slot(std::uint32_t name);
    [[nodiscard]] std::vector<std::string_view> declared_names() const;
    /// Empty when there is none, and when one for this place was looked for before.
    [[nodiscard]] std::string hint_for_name(const Place& where, std::string_view word, bool called);

    // --- the stream of tokens (stream.cpp) ---
    struct Condition {
        enum class Kind { branch, while_loop, for_loop, choice };
        Kind kind = Kind::branch;
        Token token;            ///< the directive that opened it
        std::size_t again = 0;  ///< where a loop's condition stands; loops start over after it
        std::size_t turns = 0;
        SlotPtr variable{};
        double value = 0, last = 0, step = 1;
    };
    struct Frame {
        const TokenFile* file = nullptr;
        std::size_t at = 0, end = 0;
        std::uint32_t route = 0;
        std::shared_ptr<const Macro> macro{};  ///< null: a file
        std::vector<Condition> conditions{};
        std::vector<std::pair<std::uint32_t, SlotPtr>> locals{};
    };

    /// The next token, directives executed and macros expanded; not consumed.
    const Token& peek();
    /// The same where an operator may follow: within a directive's own argument, a directive ends
    /// it.
    const Token& peek_operator();
    Token next();
    [[nodiscard]] bool peek_is(char kind) { return peek().kind == kind; }
    bool accept(char kind);
    /// `what` completes "expected ...".
    Token expect(char kind, std::string_view what);
    [[nodiscard]] Frame& frame() { return frames_.back(); }
    [[nodiscard]] const Token& raw(std::size_t ahead = 0) const;
    [[nodiscard]] Place place(const Token& token) const;
    [[nodiscard]] Place here() { return place(peek()); }
    [[nodiscard]] std::string shown(const Token& token) const;
    void pop_frame();
    void skip_line(const Token& from);
    void count_token();
    const TokenFile& read_tokens(std::uint32_t file);

    // --- directives (directives.cpp, loops.cpp, macros.cpp) ---
    void run_directive();
    void declare(bool local);
    void assign_element(const SlotPtr& slot, const Place& place);
    void undef();
    void include();
    void version();
    void text_directive(std::string_view kind, const Place& place);
    void set_default();
    void branch(const Token& directive, bool taken);
    bool defined_argument();
    void else_or_elseif(const Token& directive);
    void end_of_condition(const Token& directive);
    void start_while(const Token& directive);
    void start_for(const Token& directive);
    void start_switch(const Token& directive);
    void leave_by_break(const Token& directive);
    bool for_goes_on(Condition& condition);
    bool condition_value();
    /// Moves past raw tokens to the one of these directives that belongs to the open condition.
    std::string_view skip_to(std::initializer_list<std::string_view> directives,
                             const Token& opened);
    Token take_raw(char kind, std::string_view what);
    void define_macro(const Token& directive);
    [[nodiscard]] std::shared_ptr<const Macro> function_macro();
    void call_macro(std::shared_ptr<const Macro> macro);

    // --- expressions (expression.cpp, primary.cpp, functions.cpp) ---
    enum class Context { full, item, vector };  ///< item: '<' starts a vector; vector: '>' ends one
    Value expression(Context context = Context::full);
    Value logical(Context context);
    Value comparison(Context context);
    Value sum(Context context);
    Value product(Context context);
    Value factor(Context context);
    Value primary(Context context);
    Value postfix(Value value, const Place& start);
    Value name_value(const Token& token);
    Value vector_literal();
    Value colour_value(const Token& word, Context context);
    Value colour_components(Numbers colour);
    Value array_value(const Place& place);
    Value array_of(const std::vector<std::size_t>& sizes, std::size_t level);
    Value initialiser(const std::vector<std::size_t>& sizes, std::size_t level);
    Value function_call(std::string_view name, const Token& token);
    std::optional<Value> constant(std::string_view name);
    Value declared_value();
    Value checked(Numbers numbers, const Place& place) const;
    double number_argument(std::string_view what);
    [[nodiscard]] static std::size_t checked_index(double index, const Array& array,
                                                   const Place& place);
    void check_depth(int depth, const Place& place);
    void count_array(std::size_t elements, const Place& place);
    Value text_value(std::string text, const Place& place);

    // --- functions of light (formulas.cpp) ---
    Value function_value(const Token& word);
    Value spline_value(const Token& word);
    Value spline_points(const Place& where);
    void formula(Formula& out);
    void formula_level(Formula& out, int level);
    void formula_factor(Formula& out);
    void formula_call(Formula& out, std::string_view name, const Place& where);

    // --- blocks (blocks.cpp) ---
    BlockPtr block(const Token& word);
    void items(Block& block, char closer);
    bool item(Block& block, char closer);
    void word_item(Block& block, const Token& token);
    void matrix_items(Block& block);
    [[nodiscard]] bool of_file(const Token& word);
    BlockPtr block_of_file(const Token& word);
    void unknown_word(Block& block, const Token& token);
    void skip_braces(const Token& opener);
    void recover(int depth);
    void add(Block& block, Item item);

    /// Counts how deep the parser's own recursion is.
    struct Nesting {
        explicit Nesting(Parser& parser, const Place& place);
        ~Nesting() { --parser_.nesting_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;
        Parser& parser_;
    };
    /// Within a directive's argument: the frame the directive stands in; 0: not within one.
    struct Argument {
        Parser& parser;
        std::size_t saved;
        Argument(Parser& p, std::size_t frames) : parser(p), saved(p.argument_frame_) {
            p.argument_frame_ = frames;
        }
        ~Argument() { parser.argument_frame_ = saved; }
        Argument(const Argument&) = delete;
        Argument& operator=(const Argument&) = delete;
    };

    Sources& sources_;
    Diagnostics& diagnostics_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> hinted_;  ///< file and first character
    const LoadOptions& options_;
    Names names_;
    std::vector<std::unique_ptr<TokenFile>> files_;
    std::unordered_map<std::string, const TokenFile*> included_;
    std::vector<Frame> frames_;
    std::vector<SlotPtr> globals_;  ///< by name
    std::vector<std::uint32_t> random_;
    std::vector<Item> defaults_;
    std::size_t argument_frame_ = 0;
    int nesting_ = 0, braces_ = 0;
    double version_ = 3.7;
    /// The block word that a missing '}' let swallow; blocks close up to where it may stand.
    bool closing_ = false;
    std::size_t lexed_ = 0, tokens_ = 0, items_ = 0, array_elements_ = 0, bytes_ = 0,
                text_bytes_ = 0;
    Token last_;  ///< consumed
    Place last_place_;
};

}  // namespace icespar
