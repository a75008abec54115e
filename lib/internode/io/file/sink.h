// SPDX-License-Identifier: MIT
//
// Where bytes go: a file, a pipe, a string. Writers of formats know only this.
//
// A sink remembers its first failure and swallows what comes after it. A writer looks at the answer of write() once in
// a while and stops, and the owner of the sink learns the reason from it (OutputFile::commit).

#pragma once

#include <string>
#include <string_view>

namespace internode {

class Sink {
public:
    virtual ~Sink() = default;
    /// Takes the bytes. False once the sink has failed: nothing more will arrive.
    virtual bool write(std::string_view bytes) = 0;

protected:
    Sink() = default;
    Sink(const Sink&) = default;
    Sink(Sink&&) = default;
    Sink& operator=(const Sink&) = default;
    Sink& operator=(Sink&&) = default;
};

/// A sink in memory, for tests and small outputs.
class StringSink final : public Sink {
public:
    bool write(std::string_view bytes) override {
        text_.append(bytes);
        return true;
    }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

} // namespace internode
