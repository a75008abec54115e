// SPDX-License-Identifier: MIT

#include "internode/io/file/output_file.h"

#include "internode/io/file/input_file.h"
#include "tests/fixtures/stride.h"
#include "tests/fixtures/temporary_folder.h"
#include "tests/io/file/questions.h"

#include <atomic>
#include <csignal>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace internode {
namespace {

using tests::questions;
using tests::stop_at_third_question;

namespace fs = std::filesystem;
using Kind = FileError::Kind;

const int kills = tests::times(300, 60);

std::string content(const std::string& path) {
    const InputText input = read_input(path);
    return input.error ? "(" + input.error->message + ")" : input.text;
}

void write_whole(const std::string& path, std::string_view text) {
    OutputFile file(path);
    file.write(text);
    ASSERT_FALSE(file.commit());
}

std::optional<Kind> kind(const std::optional<FileError>& error) {
    return error ? std::optional(error->kind) : std::nullopt;
}

std::size_t entries(const tests::TemporaryFolder& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

mode_t mode(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(::lstat(path.c_str(), &status), 0);
    return status.st_mode;
}

/// Runs `work` in a child; returns its exit code, or 1000 + the signal that ended it.
template<typename Work>
int in_child(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

bool stop_now() {
    return true;
}

TEST(OutputFile, AppearsWholeAndOnlyOnCommit) {
    const tests::TemporaryFolder folder;
    const std::string large(1'000'003, 'x');
    OutputFile file(folder / "a");
    ASSERT_FALSE(file.error());
    EXPECT_FALSE(fs::exists(folder / "a"));
    EXPECT_TRUE(fs::exists(file.temporary_path()));
    EXPECT_TRUE(file.write("y"));
    EXPECT_TRUE(file.write(large));
    EXPECT_FALSE(fs::exists(folder / "a"));
    EXPECT_FALSE(file.commit());
    EXPECT_EQ(content(folder / "a"), "y" + large);
    EXPECT_EQ(entries(folder), 1U);
    EXPECT_EQ(file.temporary_path(), "");
    EXPECT_THROW((void)file.commit(), std::logic_error);
}

TEST(OutputFile, LeavesTheOldFileWithoutCommit) {
    const tests::TemporaryFolder folder;
    write_whole(folder / "a", "old");
    {
        OutputFile file(folder / "a");
        file.write(std::string(200'000, 'n'));
        EXPECT_EQ(content(folder / "a"), "old");
    }
    EXPECT_EQ(content(folder / "a"), "old");
    EXPECT_EQ(entries(folder), 1U);
}

TEST(OutputFile, MayBeEmptyAndMayBeMoved) {
    const tests::TemporaryFolder folder;
    write_whole(folder / "a", "");
    EXPECT_EQ(content(folder / "a"), "");
    OutputFile first(folder / "b");
    first.write("1");
    OutputFile second(std::move(first));
    second.write("2");
    OutputFile third(folder / "c");
    third = std::move(second);
    EXPECT_FALSE(third.commit());
    EXPECT_EQ(content(folder / "b"), "12");
}

TEST(OutputFile, NamesItsTemporaryFileAfterTheTarget) {
    const tests::TemporaryFolder folder;
    const OutputFile file(folder / "curve.csv");
    const std::string name = fs::path(file.temporary_path()).filename();
    EXPECT_EQ(name.rfind(".curve.csv.internode-", 0), 0U);
    EXPECT_EQ(name.substr(name.size() - 4), ".tmp");
    EXPECT_EQ(fs::path(file.temporary_path()).parent_path(), folder.path());
    write_whole(folder / std::string(255, 'n'), "longest");
    EXPECT_EQ(kind(OutputFile(folder / std::string(256, 'n')).error()), Kind::Unwritable);
}

TEST(OutputFile, KeepsTheModeOfTheTarget) {
    const tests::TemporaryFolder folder;
    for (const mode_t bits : {0600, 0640, 0755, 0666, 0602}) {
        write_whole(folder / "a", "old");
        ASSERT_EQ(::chmod((folder / "a").c_str(), bits), 0);
        write_whole(folder / "a", "new");
        EXPECT_EQ(mode(folder / "a") & 07777, bits);
        EXPECT_EQ(content(folder / "a"), "new");
    }
}

TEST(OutputFile, GivesANewFileTheModeThatTheUmaskLeaves) {
    const tests::TemporaryFolder folder;
    const mode_t before = ::umask(027);
    write_whole(folder / "a", "x");
    ::umask(before);
    EXPECT_EQ(mode(folder / "a") & 07777, 0640U);
}

TEST(OutputFile, FollowsSymbolicLinks) {
    const tests::TemporaryFolder folder;
    fs::create_directory(folder / "d");
    write_whole(folder / "d/target", "old");
    fs::create_symlink("d/target", folder / "link");
    fs::create_symlink(folder / "link", folder / "link2");
    fs::create_symlink("d/new", folder / "dangling");
    write_whole(folder / "link2", "new");
    write_whole(folder / "dangling", "made");
    EXPECT_TRUE(S_ISLNK(mode(folder / "link")));
    EXPECT_TRUE(S_ISLNK(mode(folder / "link2")));
    EXPECT_TRUE(S_ISLNK(mode(folder / "dangling")));
    EXPECT_EQ(content(folder / "d/target"), "new");
    EXPECT_EQ(content(folder / "d/new"), "made");
    fs::create_symlink("loop", folder / "loop");
    EXPECT_EQ(kind(OutputFile(folder / "loop").error()), Kind::Unwritable);
}

TEST(OutputFile, WritesIntoDevicesAndNeverReplacesThem) {
    for (const char* device : {"/dev/null", "/dev/zero"}) {
        OutputFile file(device);
        ASSERT_FALSE(file.error());
        EXPECT_EQ(file.temporary_path(), "");
        EXPECT_TRUE(file.write(std::string(200'000, 'x')));
        EXPECT_FALSE(file.commit());
        EXPECT_TRUE(S_ISCHR(mode(device)));
    }
    const tests::TemporaryFolder folder;
    fs::create_symlink("/dev/null", folder / "null");
    write_whole(folder / "null", "x");
    EXPECT_TRUE(S_ISLNK(mode(folder / "null")));
    EXPECT_TRUE(S_ISCHR(mode("/dev/null")));
}

TEST(OutputFile, WritesIntoAFifoAndNeverReplacesIt) {
    const tests::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    const std::string text(500'000, 'x');
    std::string read;
    std::thread reader([&] {
        ::usleep(100'000);
        read = content(folder / "fifo");
    });
    write_whole(folder / "fifo", text);
    reader.join();
    EXPECT_EQ(read, text);
    EXPECT_TRUE(S_ISFIFO(mode(folder / "fifo")));
}

TEST(OutputFile, StopsWaitingForTheReaderOfAFifo) {
    const tests::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    questions = 0;
    EXPECT_EQ(kind(OutputFile(folder / "fifo", stop_at_third_question).error()), Kind::Interrupted);
    const int reader = ::open((folder / "fifo").c_str(), O_RDWR | O_CLOEXEC); // never reads
    questions = 0;
    OutputFile file(folder / "fifo", [] { return ++questions >= 100; });
    ASSERT_FALSE(file.error());
    EXPECT_FALSE(file.write(std::string(1'000'000, 'x')));
    EXPECT_EQ(kind(file.commit()), Kind::Interrupted);
    ::close(reader);
}

TEST(OutputFile, WritesStandardOutputThroughEveryNameOfIt) {
    const tests::TemporaryFolder folder;
    for (const std::string name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
        const std::string path = folder / "out";
        EXPECT_EQ(in_child([&] {
                      const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
                      ::dup2(fd, STDOUT_FILENO);
                      (void)!::write(STDOUT_FILENO, "before ", 7);
                      OutputFile file(name);
                      file.write("text");
                      if (file.commit()) return 1;
                      (void)!::write(STDOUT_FILENO, " after", 6);
                      return 0;
                  }),
                  0);
        EXPECT_EQ(content(path), "before text after") << name;
        EXPECT_EQ(entries(folder), 1U);
    }
}

TEST(OutputFile, NoticesAClosedStandardOutput) {
    EXPECT_EQ(in_child([] {
                  ::close(STDOUT_FILENO);
                  return kind(OutputFile("-").error()) == Kind::Unwritable ? 0 : 1;
              }),
              0);
    EXPECT_EQ(in_child([] {
                  ::dup2(::open("/dev/null", O_RDONLY), STDOUT_FILENO);
                  return kind(OutputFile("-").error()) == Kind::Unwritable ? 0 : 1;
              }),
              0);
}

TEST(OutputFile, DoesNotBecomeStandardOutputItself) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(in_child([&] {
                  ::close(STDIN_FILENO);
                  ::close(STDOUT_FILENO);
                  ::close(STDERR_FILENO);
                  OutputFile file(folder / "a");
                  file.write("text");
                  if (::write(STDOUT_FILENO, "noise", 5) != -1) return 1;
                  return file.commit() ? 2 : 0;
              }),
              0);
    EXPECT_EQ(content(folder / "a"), "text");
}

TEST(OutputFile, KnowsAnUnwritableTargetBeforeAnythingIsComputed) {
    const tests::TemporaryFolder folder;
    write_whole(folder / "file", "x");
    EXPECT_EQ(kind(OutputFile(folder / "none/a").error()), Kind::Missing);
    EXPECT_EQ(kind(OutputFile(folder / "file/a").error()), Kind::Unwritable);
    EXPECT_EQ(kind(OutputFile(folder / "none/").error()), Kind::Missing);
    EXPECT_EQ(kind(OutputFile(folder.path().string()).error()), Kind::Directory);
    EXPECT_EQ(kind(OutputFile("").error()), Kind::Unwritable);
    EXPECT_EQ(kind(OutputFile("/dev/fd/77").error()), Kind::Unwritable);
    EXPECT_EQ(kind(OutputFile("/proc/nothing").error()), Kind::Unwritable);
    EXPECT_EQ(entries(folder), 1U);
}

TEST(OutputFile, RespectsPermissionsOfOthers) {
    const tests::TemporaryFolder folder;
    ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
    write_whole(folder / "file", "old");
    ASSERT_EQ(::chmod((folder / "file").c_str(), 0444), 0);
    fs::create_directory(folder / "closed");
    ASSERT_EQ(::chmod((folder / "closed").c_str(), 0555), 0);
    EXPECT_EQ(in_child([&] {
                  constexpr uid_t nobody = 65534;
                  if (::geteuid() == 0 && ::setuid(nobody) != 0) return 3;
                  if (kind(OutputFile(folder / "file").error()) != Kind::Unwritable) return 1;
                  return kind(OutputFile(folder / "closed/a").error()) == Kind::Unwritable ? 0 : 2;
              }),
              0);
    EXPECT_EQ(content(folder / "file"), "old");
}

TEST(OutputFile, NoticesAFullDevice) {
    OutputFile file("/dev/full");
    ASSERT_FALSE(file.error());
    EXPECT_TRUE(file.write("buffered"));
    const auto error = file.commit();
    EXPECT_EQ(kind(error), Kind::WriteFailed);
    EXPECT_EQ(error->path, "/dev/full");
    OutputFile large("/dev/full");
    EXPECT_FALSE(large.write(std::string(200'000, 'x')));
    EXPECT_FALSE(large.write("more"));
    EXPECT_EQ(kind(large.error()), Kind::WriteFailed);
}

TEST(OutputFile, SpeaksOfABrokenPipeByItsName) {
    EXPECT_EQ(in_child([] {
                  std::signal(SIGPIPE, SIG_IGN);
                  int ends[2];
                  if (::pipe(ends) != 0) return 3;
                  ::dup2(ends[1], STDOUT_FILENO);
                  ::close(ends[0]);
                  OutputFile file("-");
                  file.write("x");
                  return kind(file.commit()) == Kind::BrokenPipe ? 0 : 1;
              }),
              0);
}

TEST(OutputFile, NoticesAFileSizeLimitAtEveryByte) {
    const tests::TemporaryFolder folder;
    write_whole(folder / "a", "old");
    const std::string text = "x,y\n0,0\n0.25,1\n0.5,0.75\n";
    for (std::size_t limit = 0; limit <= text.size(); ++limit) {
        const int code = in_child([&] {
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit size{limit, limit};
            if (::setrlimit(RLIMIT_FSIZE, &size) != 0) return 3;
            OutputFile file(folder / "a");
            file.write(text);
            const auto error = file.commit();
            if (!error) return 0;
            return error->kind == Kind::WriteFailed ? 4 : 5;
        });
        EXPECT_EQ(code, limit < text.size() ? 4 : 0) << limit;
        EXPECT_EQ(content(folder / "a"), limit < text.size() ? "old" : text) << limit;
        EXPECT_EQ(entries(folder), 1U) << limit;
    }
}

TEST(OutputFile, StopsWhenAskedAndLeavesTheOldFile) {
    const tests::TemporaryFolder folder;
    write_whole(folder / "a", "old");
    OutputFile small(folder / "a", stop_now);
    EXPECT_TRUE(small.write("x")) << "still in the buffer";
    EXPECT_EQ(kind(small.commit()), Kind::Interrupted);
    OutputFile large(folder / "a", stop_now);
    EXPECT_FALSE(large.write(std::string(200'000, 'x')));
    EXPECT_EQ(kind(large.commit()), Kind::Interrupted);
    EXPECT_EQ(content(folder / "a"), "old");
    EXPECT_EQ(entries(folder), 1U);
}

TEST(OutputFile, IsOldOrNewAfterAKillAtAnyMoment) {
    const tests::TemporaryFolder folder;
    const std::string old_text(100'000, 'o');
    const std::string new_text(150'000, 'n');
    write_whole(folder / "a", old_text);
    std::mt19937 random(7);
    std::uniform_int_distribution<useconds_t> delay(0, 3000);
    int old_count = 0;
    for (int i = 0; i < kills; ++i) {
        const pid_t child = ::fork();
        if (child == 0) {
            while (true) {
                OutputFile file(folder / "a");
                for (std::size_t k = 0; k < 10; ++k) file.write(std::string_view(new_text).substr(k * 15'000, 15'000));
                if (file.commit()) ::_exit(1);
                OutputFile again(folder / "a");
                again.write(old_text);
                if (again.commit()) ::_exit(1);
            }
        }
        ::usleep(delay(random));
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status));
        const std::string text = content(folder / "a");
        ASSERT_TRUE(text == old_text || text == new_text) << "half a file of " << text.size() << " bytes";
        old_count += text == old_text ? 1 : 0;
        for (const auto& entry : fs::directory_iterator(folder.path()))
            ASSERT_TRUE(entry.path().filename() == "a" || entry.path().extension() == ".tmp");
    }
    RecordProperty("old", old_count);
}

TEST(OutputFile, LeavesNoDescriptorBehind) {
    const tests::TemporaryFolder folder;
    const int before = ::dup(0);
    ::close(before);
    write_whole(folder / "a", "x");
    { const OutputFile abandoned(folder / "a"); }
    { const OutputFile refused(folder / "none/a"); }
    write_whole("/dev/null", "x");
    const int after = ::dup(0);
    ::close(after);
    EXPECT_EQ(after, before);
}

} // namespace
} // namespace internode
