// SPDX-License-Identifier: MIT
//
// Text gathered before it goes to a sink, so that a file of 10^7 lines needs 64 KiB.

#pragma once

#include "internode/io/file/sink.h"
#include "internode/text/number.h"

#include <string>
#include <string_view>

namespace internode {

class TextBuffer {
public:
    explicit TextBuffer(Sink& sink)
        : sink_(sink) {}

    TextBuffer& operator<<(std::string_view text) {
        text_ += text;
        return *this;
    }
    TextBuffer& operator<<(char c) {
        text_ += c;
        return *this;
    }
    TextBuffer& operator<<(double value) {
        append(text_, value);
        return *this;
    }
    TextBuffer& operator<<(std::size_t value) {
        text_ += std::to_string(value);
        return *this;
    }

    /// At the end of a line: passes the text on when there is enough of it. False once the sink has failed.
    bool end_line() {
        text_ += '\n';
        return pass_on();
    }

    /// Within a long line: passes the text on when there is enough of it. False once the sink has failed.
    bool pass_on() {
        constexpr std::size_t enough = std::size_t{1} << 16;
        return text_.size() < enough || flush();
    }

    bool flush() {
        const bool good = sink_.write(text_);
        text_.clear();
        return good;
    }

private:
    Sink& sink_;
    std::string text_;
};

} // namespace internode
