// SPDX-License-Identifier: MIT

#include "internode/io/file/input_file.h"

#include "tests/fixtures/temporary_folder.h"
#include "tests/io/file/questions.h"

#include <atomic>
#include <csignal>
#include <string>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <gmock/gmock.h>

namespace internode {
namespace {

using Kind = FileError::Kind;
using testing::HasSubstr;
using tests::questions;
using tests::stop_at_third_question;

void put(const std::string& path, std::string_view text) {
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    ASSERT_GE(fd, 0);
    ASSERT_EQ(::write(fd, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    ::close(fd);
}

Kind kind(const InputText& input) {
    EXPECT_TRUE(input.error);
    EXPECT_TRUE(input.text.empty());
    return input.error ? input.error->kind : Kind::WriteFailed;
}

/// Standard input replaced while it lives.
class StandardInput {
public:
    explicit StandardInput(int fd)
        : saved_(::dup(STDIN_FILENO)) {
        if (fd >= 0)
            ::dup2(fd, STDIN_FILENO);
        else
            ::close(STDIN_FILENO);
    }
    StandardInput(const StandardInput&) = delete;
    StandardInput& operator=(const StandardInput&) = delete;
    ~StandardInput() {
        ::dup2(saved_, STDIN_FILENO);
        ::close(saved_);
    }

private:
    int saved_;
};

TEST(InputFile, ReadsAFileWhole) {
    const tests::TemporaryFolder folder;
    put(folder / "a", "");
    EXPECT_EQ(read_input(folder / "a").text, "");
    const std::string large(3'000'001, 'x');
    put(folder / "b", large);
    const InputText input = read_input(folder / "b");
    EXPECT_FALSE(input.error);
    EXPECT_EQ(input.text, large);
    EXPECT_EQ(input.source, folder / "b");
    EXPECT_GT(read_input("/proc/self/status").text.size(), 100U) << "a file that says its size is 0";
}

TEST(InputFile, ReadsStandardInput) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const std::string text(300'000, 'y');
    std::thread writer([&] {
        for (std::size_t i = 0; i < text.size(); i += 1000) (void)!::write(ends[1], text.data() + i, 1000);
        ::close(ends[1]);
    });
    {
        const StandardInput standard_input(ends[0]);
        const InputText input = read_input("-");
        EXPECT_EQ(input.text, text);
        EXPECT_EQ(input.source, "<stdin>");
    }
    writer.join();
    ::close(ends[0]);
    const StandardInput closed(-1);
    EXPECT_EQ(kind(read_input("-")), Kind::Unreadable);
}

TEST(InputFile, SaysWhatIsMissing) {
    const tests::TemporaryFolder folder;
    put(folder / "file", "x");
    for (const std::string& path : {folder / "none", folder / "none/none", folder / "file/none", std::string(),
                                    std::string(5000, 'n'), folder / std::string("file\0x", 6)})
        EXPECT_EQ(kind(read_input(path)), Kind::Missing) << path;
}

TEST(InputFile, RefusesFoldersAndSockets) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(kind(read_input(folder.path().string())), Kind::Directory);
    EXPECT_EQ(kind(read_input("/")), Kind::Directory);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = folder / "s";
    ASSERT_LT(path.size(), sizeof address.sun_path);
    path.copy(address.sun_path, path.size());
    const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    ASSERT_EQ(::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(kind(read_input(path)), Kind::Unreadable);
    ::close(fd);
}

TEST(InputFile, AcceptsTheLimitAndRefusesOneMore) {
    const tests::TemporaryFolder folder;
    put(folder / "a", "12345");
    EXPECT_EQ(read_input(folder / "a", {.max_bytes = 5}).text, "12345");
    const InputText input = read_input(folder / "a", {.max_bytes = 4});
    EXPECT_EQ(kind(input), Kind::TooLarge);
    EXPECT_THAT(input.error->message, HasSubstr("4 bytes"));
    EXPECT_EQ(kind(read_input("/proc/self/status", {.max_bytes = 10})), Kind::TooLarge);
}

TEST(InputFile, RefusesAHugeSparseFileUnread) {
    const tests::TemporaryFolder folder;
    put(folder / "sparse", "");
    ASSERT_EQ(::truncate((folder / "sparse").c_str(), off_t{5} << 30), 0);
    questions = 0;
    EXPECT_EQ(kind(read_input(folder / "sparse", {.should_stop = stop_at_third_question})), Kind::TooLarge);
    EXPECT_EQ(questions, 0) << "nothing was read";
}

TEST(InputFile, EndsAtTheFirstChunkOfEndlessZeros) {
    questions = 0;
    EXPECT_EQ(kind(read_input("/dev/zero", {.should_stop = stop_at_third_question})), Kind::NotText);
    EXPECT_EQ(questions, 1);
}

TEST(InputFile, SaysWhereAByteZeroStands) {
    const tests::TemporaryFolder folder;
    put(folder / "a", std::string_view("x,y\n\xC3\xA9,\0z", 9));
    const InputText input = read_input(folder / "a");
    EXPECT_EQ(kind(input), Kind::NotText);
    EXPECT_EQ(input.error->line, 2U);
    EXPECT_EQ(input.error->column, 3U);
}

TEST(InputFile, StopsWaitingForASilentFifo) {
    const tests::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    questions = 0;
    EXPECT_EQ(kind(read_input(folder / "fifo", {.should_stop = stop_at_third_question})), Kind::Interrupted);
    const int writer = ::open((folder / "fifo").c_str(), O_RDWR | O_CLOEXEC); // open at both ends, says nothing
    questions = 0;
    EXPECT_EQ(kind(read_input(folder / "fifo", {.should_stop = stop_at_third_question})), Kind::Interrupted);
    ::close(writer);
}

TEST(InputFile, ReadsAFifoToItsEnd) {
    const tests::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    std::thread writer([&] {
        const int fd = ::open((folder / "fifo").c_str(), O_WRONLY | O_CLOEXEC);
        ::usleep(100'000);
        (void)!::write(fd, "1,2\n", 4);
        ::close(fd);
    });
    EXPECT_EQ(read_input(folder / "fifo").text, "1,2\n");
    writer.join();
}

/// Where should_stop of the next test writes; until it has written, poll is refused and read goes without it.
int late_writer = -1;
rlimit usual_files{};

bool write_at_second_question() {
    ++questions;
    rlimit files = usual_files;
    if (questions == 1) files.rlim_cur = 0;
    ::setrlimit(RLIMIT_NOFILE, &files);
    if (questions == 2) {
        (void)!::write(late_writer, "1,2\n", 4);
        ::close(late_writer);
    }
    return false;
}

/// Interrupts a sleeping read again and again while it lives.
class Alarms {
public:
    Alarms() {
        struct sigaction action {};
        action.sa_handler = [](int) {};
        ::sigaction(SIGALRM, &action, &saved_);
        const itimerval often{{0, 20'000}, {0, 20'000}};
        ::setitimer(ITIMER_REAL, &often, nullptr);
    }
    Alarms(const Alarms&) = delete;
    Alarms& operator=(const Alarms&) = delete;
    ~Alarms() {
        const itimerval never{};
        ::setitimer(ITIMER_REAL, &never, nullptr);
        ::sigaction(SIGALRM, &saved_, nullptr);
    }

private:
    struct sigaction saved_ {};
};

TEST(InputFile, ReadsOnAfterAReadThatFoundNothingOrWasInterrupted) {
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &usual_files), 0);
    for (const int flags : {O_NONBLOCK, 0}) {
        int ends[2];
        ASSERT_EQ(::pipe2(ends, flags | O_CLOEXEC), 0);
        late_writer = ends[1];
        questions = 0;
        const StandardInput standard_input(ends[0]);
        const Alarms alarms;
        const InputText input = read_input("-", {.should_stop = write_at_second_question});
        ::setrlimit(RLIMIT_NOFILE, &usual_files);
        EXPECT_FALSE(input.error) << input.error->message;
        EXPECT_EQ(input.text, "1,2\n");
        EXPECT_EQ(questions, 3) << "nothing, the text, the end";
        ::close(ends[0]);
    }
}

TEST(InputFile, LeavesNoDescriptorBehindAndNoneBelowThree) {
    const tests::TemporaryFolder folder;
    put(folder / "a", "x");
    const int before = ::dup(0);
    ::close(before);
    {
        const StandardInput closed(-1);
        EXPECT_EQ(read_input(folder / "a").text, "x");
        EXPECT_EQ(::fcntl(STDIN_FILENO, F_GETFD), -1);
    }
    (void)read_input("/");
    (void)read_input(folder / "none");
    const int after = ::dup(0);
    ::close(after);
    EXPECT_EQ(after, before);
}

} // namespace
} // namespace internode
