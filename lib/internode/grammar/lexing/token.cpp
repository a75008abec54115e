// SPDX-License-Identifier: MIT
//
// The only source that knows PEGTL. Every rule either consumes at least one byte or is not in a loop, and no rule
// refers to itself: the time is linear in the text and the stack does not grow with it.

#include "internode/grammar/lexing/token.h"

#include <cassert>
#include <limits>

#include <tao/pegtl.hpp>

namespace internode {

namespace {

namespace pegtl = tao::pegtl;

struct ByteOrderMark : pegtl::utf8::bom {};
struct Blank : pegtl::plus<pegtl::one<' ', '\t'>> {};
struct Newline : pegtl::sor<pegtl::string<'\r', '\n'>, pegtl::one<'\n', '\r'>> {};
struct Control : pegtl::sor<pegtl::range<'\x00', '\x08'>, pegtl::range<'\x0B', '\x0C'>, pegtl::range<'\x0E', '\x1F'>,
                            pegtl::one<'\x7F'>> {};
struct NotUtf8 : pegtl::seq<pegtl::not_at<pegtl::utf8::any>, pegtl::any> {};
struct Broken : pegtl::sor<pegtl::plus<Control>, pegtl::plus<NotUtf8>> {};
struct Sound : pegtl::seq<pegtl::not_at<Control>, pegtl::utf8::any> {};

struct CommentStart : pegtl::two<'/'> {};
struct CommentText : pegtl::plus<pegtl::not_at<pegtl::one<'\n', '\r'>>, Sound> {};
struct Comment : pegtl::seq<CommentStart, pegtl::star<pegtl::sor<CommentText, Broken>>> {};

struct Run : pegtl::plus<pegtl::sor<pegtl::alnum, pegtl::one<'_', '\''>>> {};
struct LineEnd : pegtl::one<'\n', '\r'> {};
struct Escaped : pegtl::seq<pegtl::one<'\\'>, pegtl::not_at<LineEnd>, Sound> {};
struct Plain : pegtl::seq<pegtl::not_at<pegtl::one<'"', '\\', '\n', '\r'>>, Sound> {};
struct TextBody : pegtl::seq<pegtl::one<'"'>, pegtl::star<pegtl::sor<Escaped, Plain>>> {};
struct Text : pegtl::seq<TextBody, pegtl::one<'"'>> {};
struct OpenText : TextBody {};

struct Arrow : pegtl::sor<pegtl::string<'-', '>'>, pegtl::utf8::one<0x2192>> {};
struct Mark : pegtl::range<'!', '~'> {};
struct Epsilon : pegtl::utf8::one<0x03B5> {};
struct Comparison : pegtl::utf8::one<0x2264, 0x2265, 0x2260> {};
struct Foreign : Sound {};

struct Item
    : pegtl::sor<Blank, Run, Newline, Comment, Text, OpenText, Arrow, Mark, Epsilon, Comparison, Foreign, Broken> {};
struct Source : pegtl::seq<pegtl::opt<ByteOrderMark>, pegtl::star<Item>> {};

struct Tokens {
    const char* start;
    std::vector<Token> found;
};

template<TokenKind Kind>
struct Keep {
    template<typename Input>
    static void apply(const Input& input, Tokens& tokens) {
        tokens.found.push_back(
            {static_cast<std::uint32_t>(input.begin() - tokens.start), static_cast<std::uint32_t>(input.size()), Kind});
    }
};

template<typename Rule>
struct Action : pegtl::nothing<Rule> {};
template<>
struct Action<Run> : Keep<TokenKind::Run> {};
template<>
struct Action<Newline> : Keep<TokenKind::Newline> {};
template<>
struct Action<Text> : Keep<TokenKind::Text> {};
template<>
struct Action<OpenText> : Keep<TokenKind::OpenText> {};
template<>
struct Action<Arrow> : Keep<TokenKind::Arrow> {};
template<>
struct Action<Mark> : Keep<TokenKind::Mark> {};
template<>
struct Action<Epsilon> : Keep<TokenKind::Epsilon> {};
template<>
struct Action<Comparison> : Keep<TokenKind::Comparison> {};
template<>
struct Action<Foreign> : Keep<TokenKind::Foreign> {};
template<>
struct Action<Broken> : Keep<TokenKind::Broken> {};

} // namespace

std::vector<Token> tokenize(std::string_view text) {
    assert(text.size() <= std::numeric_limits<std::uint32_t>::max());
    Tokens tokens{text.data(), {}};
    pegtl::memory_input<pegtl::tracking_mode::lazy> input(text.data(), text.data() + text.size(), "");
    pegtl::parse<Source, Action>(input, tokens);
    return std::move(tokens.found);
}

} // namespace internode
