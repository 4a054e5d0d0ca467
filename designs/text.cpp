// Code page 1252 and UTF-8, and shortest numbers.
#include "designs/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace icespar {
namespace {

/// Of the bytes 0x80 to 0x9F in code page 1252; 0xFFFD where it has none.
constexpr std::array<char16_t, 32> from_0x80{
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

int following_bytes(unsigned char lead) {
    return lead < 0x80   ? 0
           : lead < 0xC2 ? -1
           : lead < 0xE0 ? 1
           : lead < 0xF0 ? 2
           : lead < 0xF5 ? 3
                         : -1;
}

/// Code page 1252 of UTF-8; nothing when a character is not in it.
std::optional<std::string> code_page(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const int following = following_bytes(lead);
        if (following == 0) {
            out += text[i];
            continue;
        }
        if (following < 0 || following > 2) return {};
        unsigned code = lead & (following == 1 ? 0x1Fu : 0x0Fu);
        for (int k = 0; k < following; ++k)
            code = code << 6 | (static_cast<unsigned char>(text[++i]) & 0x3Fu);
        if (code >= 0xA0 && code <= 0xFF) {
            out += static_cast<char>(code);
            continue;
        }
        const auto at = std::find(from_0x80.begin(), from_0x80.end(), static_cast<char16_t>(code));
        if (at == from_0x80.end() || code == 0xFFFD) return {};
        out += static_cast<char>(0x80 + (at - from_0x80.begin()));
    }
    return out;
}

}  // namespace

bool is_utf8(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    for (std::size_t i = 0; i < text.size();) {
        const unsigned lead = byte(i), next = byte(i + 1);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
        if (lead >= 0x80 && (lead < 0xc2 || lead > 0xf4)) return false;
        // Longer forms than need be, halves of pairs, and numbers beyond the last character.
        if ((lead == 0xe0 && next < 0xa0) || (lead == 0xed && next > 0x9f) ||
            (lead == 0xf0 && next < 0x90) || (lead == 0xf4 && next > 0x8f))
            return false;
        for (std::size_t k = 1; k < length; ++k) {
            if ((byte(i + k) & 0xc0) != 0x80) return false;
        }
        i += length;
    }
    return true;
}

std::string utf8(std::string_view text) {
    if (is_utf8(text)) return std::string(text);
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const unsigned code = byte >= 0x80 && byte < 0xA0 ? from_0x80[byte - 0x80u] : byte;
        if (code < 0x80) {
            out += static_cast<char>(code);
        } else if (code < 0x800) {
            out += static_cast<char>(0xC0 | code >> 6);
            out += static_cast<char>(0x80 | (code & 0x3F));
        } else {
            out += static_cast<char>(0xE0 | code >> 12);
            out += static_cast<char>(0x80 | (code >> 6 & 0x3F));
            out += static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return out;
}

std::string for_gemcad(std::string_view text) {
    if (!is_utf8(text)) return std::string(text);
    const auto page = code_page(text);
    return page && utf8(*page) == text ? *page : std::string(text);
}

std::string exact(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

std::string shown(std::string_view word) {
    std::string text = "'";
    for (const char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + (word.size() > 24 ? "...'" : "'");
}

std::string one_word(std::string_view text) {
    std::string out;
    for (const char c : text) out += c == ' ' || (c >= '\t' && c <= '\r') ? '_' : c;
    return out.empty() ? "-" : out;
}

}  // namespace icespar
