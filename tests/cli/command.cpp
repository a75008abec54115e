// SPDX-License-Identifier: MIT

#include "tests/cli/command.h"
#include "tests/fixtures/source_folder.h"
#include "tests/fixtures/texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace internode::tests {
namespace {

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

} // namespace

Workspace::Workspace() {
    std::string name = (std::filesystem::temp_directory_path() / "internode-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
    std::filesystem::create_directory_symlink(tests::in_source_folder("data"), path_ / "data");
}

Workspace::~Workspace() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string Workspace::file(const std::string& name, std::string_view text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return name;
}

std::string Workspace::read(const std::string& name) const {
    return content(path_ / name);
}

Outcome Workspace::run(const std::vector<std::string>& arguments, std::string_view input) const {
    file(".in", input);
    std::string line = "\"$INTERNODE\"";
    for (const std::string& argument : arguments) line += ' ' + quoted(argument);
    return shell(line + " < .in");
}

Outcome Workspace::shell(const std::string& line) const {
    const std::string script = "cd " + quoted(path_.string()) + " && export INTERNODE=" + quoted(INTERNODE_COMMAND) +
                               "\n(set -o pipefail\n" + line + "\n) > .out 2> .err";
    const int status = std::system(("bash -c " + quoted(script)).c_str());
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.out = read(".out");
    outcome.err = read(".err");
    return outcome;
}

std::uint64_t Workspace::peak_memory(const std::vector<std::string>& arguments) const {
    std::vector<std::string> words{INTERNODE_COMMAND};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        if (::chdir(path_.c_str()) == 0) ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    int status = 0;
    struct rusage usage {};
    ::wait4(child, &status, 0, &usage);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

void expect_refused(const Outcome& outcome, const std::vector<std::string>& arguments, const std::string& words,
                    int code) {
    EXPECT_EQ(outcome.code, code) << testing::PrintToString(arguments) << outcome.err << outcome.out;
    EXPECT_THAT(outcome.err, testing::HasSubstr(words)) << testing::PrintToString(arguments);
    EXPECT_EQ(outcome.out, "");
}

std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> words;
    std::string word;
    bool inside = false;
    bool any = false;
    for (const char c : line) {
        if (c == '\'') {
            inside = !inside;
            any = true;
        } else if (c == ' ' && !inside) {
            if (any) words.push_back(std::exchange(word, {}));
            any = false;
        } else {
            word += c;
            any = true;
        }
    }
    if (any) words.push_back(word);
    return words;
}

} // namespace internode::tests
