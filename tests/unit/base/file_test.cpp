#include "base/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "temporary_folder.h"

namespace saddle {
namespace {

namespace fs = std::filesystem;

/// More than the buffer that a stream collects before it writes.
const std::string kLargeText(3'000'000, 'x');

std::function<void(std::ostream&)> writer(const std::string& content) {
  return [content](std::ostream& out) { out << content; };
}

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The message of the Error that `action` throws, which must be of status Machine.
std::string failure(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Machine);
    return std::string(error.what()) + "\n" + error.hint();
  }
  ADD_FAILURE() << "no error";
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Runs `action` without the superuser's rights, where the tests have them.
void as_ordinary_user(const std::function<void()>& action) {
  constexpr uid_t kNobody = 65534;
  const uid_t user = geteuid();
  ASSERT_EQ(seteuid(user == 0 ? kNobody : user), 0);
  action();
  ASSERT_EQ(seteuid(user), 0);
}

class WriteFileWhole : public testing::Test {
 protected:
  std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder)) {
      result.insert(entry.path().filename().string());
    }
    return result;
  }

  const TemporaryFolder temporary;
  const fs::path& folder = temporary.path();
};

using FileNames = std::set<std::string>;
using CheckWritable = WriteFileWhole;
using ReadFile = WriteFileWhole;

TEST_F(WriteFileWhole, WritesTheContentAndNothingElse) {
  write_file_whole(folder / "a", writer("hello"));
  EXPECT_EQ(content_of(folder / "a"), "hello");
  EXPECT_EQ(names(), FileNames{"a"});
}

TEST_F(WriteFileWhole, WritesAnEmptyFile) {
  write_file_whole(folder / "a", [](std::ostream&) {});
  EXPECT_EQ(names(), FileNames{"a"});
  EXPECT_EQ(fs::file_size(folder / "a"), 0u);
}

TEST_F(WriteFileWhole, WritesMoreThanItsBufferByLettersAndByBlocks) {
  std::string expected = kLargeText + kLargeText;
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = static_cast<char>(i * 31 / 7);
  write_file_whole(folder / "a", [&](std::ostream& out) {
    const std::size_t half = expected.size() / 2;
    for (std::size_t i = 0; i < half; ++i) out.put(expected[i]);
    out.write(expected.data() + half, static_cast<std::streamsize>(expected.size() - half));
  });
  EXPECT_TRUE(content_of(folder / "a") == expected);
}

TEST_F(WriteFileWhole, ReplacesAFileOnlyOnceTheNewOneIsWhole) {
  write_file_whole(folder / "a", writer("old"));
  write_file_whole(folder / "a", [&](std::ostream& out) {
    out << kLargeText << std::flush;
    EXPECT_EQ(content_of(folder / "a"), "old");
    EXPECT_EQ(names().size(), 2u);
  });
  EXPECT_EQ(content_of(folder / "a").size(), kLargeText.size());
  EXPECT_EQ(names(), FileNames{"a"});
}

TEST_F(WriteFileWhole, LeavesEverythingAsItWasWhenTheWriterThrows) {
  const auto throwing = [](std::ostream& out) {
    out << kLargeText;
    throw std::runtime_error("mine");
  };
  EXPECT_THROW(write_file_whole(folder / "new", throwing), std::runtime_error);
  EXPECT_EQ(names(), FileNames{});
  write_file_whole(folder / "a", writer("old"));
  EXPECT_THROW(write_file_whole(folder / "a", throwing), std::runtime_error);
  EXPECT_EQ(content_of(folder / "a"), "old");
  EXPECT_EQ(names(), FileNames{"a"});
}

TEST_F(WriteFileWhole, FailsWhenTheWriterFindsItsStreamBroken) {
  const auto broken = [](std::ostream& out) { out.setstate(std::ios::failbit); };
  EXPECT_TRUE(contains(failure([&] { write_file_whole(folder / "a", broken); }), "cannot write"));
  EXPECT_EQ(names(), FileNames{});
}

TEST_F(WriteFileWhole, SaysThatThereIsNoSpaceLeft) {
  const std::string message = failure([] { write_file_whole("/dev/full", writer("x")); });
  EXPECT_TRUE(contains(message, "/dev/full")) << message;
  EXPECT_TRUE(contains(message, "No space left")) << message;
}

TEST_F(WriteFileWhole, LeavesEverythingAsItWasWhenTheSystemStopsWriting) {
  write_file_whole(folder / "a", writer("old"));
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_action = signal(SIGXFSZ, SIG_IGN);
  const rlimit limited{kLargeText.size() / 2, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limited), 0);
  const std::string by_stream =
      failure([&] { write_file_whole(folder / "a", writer(kLargeText)); });
  // The system's reason wins over a writer that throws because its stream is broken.
  const std::string by_throw = failure([&] {
    write_file_whole(folder / "a", [](std::ostream& out) {
      out << kLargeText << std::flush;
      if (!out) throw std::runtime_error("stream broken");
    });
  });
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  signal(SIGXFSZ, old_action);
  EXPECT_TRUE(contains(by_stream, "File too large")) << by_stream;
  EXPECT_TRUE(contains(by_throw, "File too large")) << by_throw;
  EXPECT_EQ(content_of(folder / "a"), "old");
  EXPECT_EQ(names(), FileNames{"a"});
}

mode_t mode_of(const fs::path& path) {
  struct stat info {};
  EXPECT_EQ(stat(path.c_str(), &info), 0);
  return info.st_mode & 07777u;
}

TEST_F(WriteFileWhole, GivesANewFileThePermissionsThatTheUserAsksFor) {
  const mode_t before = umask(027);
  write_file_whole(folder / "a", writer("x"));
  umask(before);
  EXPECT_EQ(mode_of(folder / "a"), 0640u);
}

TEST_F(WriteFileWhole, KeepsThePermissionsOfAFileThatExists) {
  write_file_whole(folder / "a", writer("old"));
  ASSERT_EQ(chmod((folder / "a").c_str(), 0606), 0);
  write_file_whole(folder / "a", writer("new"));
  EXPECT_EQ(mode_of(folder / "a"), 0606u);
  EXPECT_EQ(content_of(folder / "a"), "new");
}

TEST_F(WriteFileWhole, KeepsTheOwnerOfAFileThatExists) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser can give files away";
  write_file_whole(folder / "a", writer("old"));
  ASSERT_EQ(chown((folder / "a").c_str(), 1234, 4321), 0);
  write_file_whole(folder / "a", writer("new"));
  struct stat info {};
  ASSERT_EQ(stat((folder / "a").c_str(), &info), 0);
  EXPECT_EQ(info.st_uid, 1234u);
  EXPECT_EQ(info.st_gid, 4321u);
}

TEST_F(WriteFileWhole, KeepsTheUserAloneAndTheGroupAlone) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser can give files away";
  for (const auto& [user, group] : {std::pair(1234, 0), std::pair(0, 4321)}) {
    write_file_whole(folder / "a", writer("old"));
    ASSERT_EQ(chown((folder / "a").c_str(), user, group), 0);
    ASSERT_EQ(chmod((folder / "a").c_str(), 0664), 0);
    write_file_whole(folder / "a", writer("new"));
    struct stat info {};
    ASSERT_EQ(stat((folder / "a").c_str(), &info), 0);
    EXPECT_EQ(info.st_uid, static_cast<uid_t>(user));
    EXPECT_EQ(info.st_gid, static_cast<gid_t>(group));
    EXPECT_EQ(mode_of(folder / "a"), 0664U);
    fs::remove(folder / "a");
  }
}

TEST_F(WriteFileWhole, GivesAnotherUsersGroupNoRightsToAFileThatIsOurs) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser can make another user's file";
  write_file_whole(folder / "a", writer("old"));
  ASSERT_EQ(chmod((folder / "a").c_str(), 0676), 0);
  ASSERT_EQ(chmod(folder.c_str(), 0777), 0);
  as_ordinary_user([&] { write_file_whole(folder / "a", writer("new")); });
  EXPECT_EQ(content_of(folder / "a"), "new");
  EXPECT_EQ(mode_of(folder / "a"), 0606U);
}

TEST_F(WriteFileWhole, DoesNotReplaceAFileThatIsReadOnly) {
  write_file_whole(folder / "a", writer("old"));
  ASSERT_EQ(chmod((folder / "a").c_str(), 0444), 0);
  ASSERT_EQ(chmod(folder.c_str(), 0777), 0);
  as_ordinary_user([&] {
    EXPECT_TRUE(contains(failure([&] { write_file_whole(folder / "a", writer("new")); }),
                         "Permission denied"));
  });
  EXPECT_EQ(content_of(folder / "a"), "old");
}

TEST_F(WriteFileWhole, WritesThroughLinks) {
  fs::create_directory(folder / "deep");
  write_file_whole(folder / "deep/file", writer("old"));
  fs::create_symlink("deep/file", folder / "one");
  fs::create_symlink(folder / "one", folder / "two");
  write_file_whole(folder / "two", writer("new"));
  EXPECT_EQ(content_of(folder / "deep/file"), "new");
  EXPECT_TRUE(fs::is_symlink(folder / "one"));
  EXPECT_TRUE(fs::is_symlink(folder / "two"));
}

TEST_F(WriteFileWhole, CreatesTheFileThatALinkLeadsTo) {
  fs::create_symlink("missing", folder / "link");
  write_file_whole(folder / "link", writer("new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content_of(folder / "missing"), "new");
}

TEST_F(WriteFileWhole, RefusesLinksThatRunInACircle) {
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  EXPECT_TRUE(
      contains(failure([&] { write_file_whole(folder / "a", writer("x")); }), "Too many levels"));
}

TEST_F(WriteFileWhole, WritesNamesAsLongAsTheSystemAllows) {
  // The temporary's name has to be cut, here in the middle of a two-byte character.
  std::string longest = "a";
  while (longest.size() < 255) longest += "\u03C0";
  ASSERT_EQ(longest.size(), 255u);
  write_file_whole(folder / longest, writer("x"));
  EXPECT_EQ(names(), FileNames{longest});
  EXPECT_TRUE(contains(failure([&] { write_file_whole(folder / (longest + "a"), writer("x")); }),
                       "File name too long"));
}

TEST_F(WriteFileWhole, IsWholeWhenSeveralWriteTheSameName) {
  std::vector<std::jthread> threads;
  for (const char letter : {'a', 'b', 'c', 'd'}) {
    threads.emplace_back([this, letter] {
      for (int i = 0; i < 5; ++i) {
        write_file_whole(folder / "f", writer(std::string(100'000, letter)));
      }
    });
  }
  threads.clear();
  const std::string content = content_of(folder / "f");
  EXPECT_EQ(content, std::string(100'000, content.at(0)));
  EXPECT_EQ(names(), FileNames{"f"});
}

TEST_F(WriteFileWhole, WritesStraightIntoAPipe) {
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::string received;
  std::jthread reader([&] { received = content_of(folder / "pipe"); });
  write_file_whole(folder / "pipe", writer(kLargeText));
  reader.join();
  EXPECT_TRUE(received == kLargeText);
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST_F(WriteFileWhole, ContinuesAnOpenFileThroughItsDescriptor) {
  for (const char* kind : {"/dev/fd/", "/proc/self/fd/"}) {
    const fs::path file = folder / "f";
    const int number = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ASSERT_EQ(write(number, "head ", 5), 5);
    write_file_whole(kind + std::to_string(number), writer("body"));
    ASSERT_EQ(write(number, " tail", 5), 5);
    close(number);
    EXPECT_EQ(content_of(file), "head body tail");
  }
}

TEST_F(CheckWritable, CreatesNothingAndTruncatesNothing) {
  check_writable(folder / "a");
  EXPECT_EQ(names(), FileNames{});
  write_file_whole(folder / "a", writer("old"));
  check_writable(folder / "a");
  EXPECT_EQ(content_of(folder / "a"), "old");
  EXPECT_EQ(names(), FileNames{"a"});
}

TEST_F(CheckWritable, AcceptsANameInTheCurrentFolderAndDevices) {
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  EXPECT_NO_THROW(check_writable("a"));
  fs::current_path(before);
  EXPECT_NO_THROW(check_writable("/dev/null"));
  EXPECT_NO_THROW(check_writable("/dev/stdout"));
}

TEST_F(CheckWritable, SaysHowToCreateAMissingFolder) {
  const fs::path path = folder / "no" / "a.png";
  const std::string message = failure([&] { check_writable(path); });
  EXPECT_TRUE(contains(message, "cannot write " + path.string() + ": No such file")) << message;
  EXPECT_TRUE(contains(message, "mkdir -p " + (folder / "no").string())) << message;
}

TEST_F(CheckWritable, RefusesFoldersAndFilesInPlaceOfFolders) {
  EXPECT_TRUE(contains(failure([&] { check_writable(folder); }), "Is a directory"));
  EXPECT_TRUE(contains(failure([&] { check_writable(folder / "a/"); }), "Is a directory"));
  write_file_whole(folder / "a", writer("x"));
  EXPECT_TRUE(contains(failure([&] { check_writable(folder / "a/b"); }), "Not a directory"));
  EXPECT_TRUE(contains(failure([&] { check_writable(""); }), "No such file"));
}

TEST_F(CheckWritable, RefusesWhatThePermissionsForbid) {
  write_file_whole(folder / "a", writer("x"));
  ASSERT_EQ(chmod((folder / "a").c_str(), 0444), 0);
  ASSERT_EQ(chmod(folder.c_str(), 0555), 0);
  as_ordinary_user([&] {
    for (const char* name : {"a", "new"}) {
      EXPECT_TRUE(contains(failure([&] { check_writable(folder / name); }), "Permission denied"));
    }
  });
  ASSERT_EQ(chmod(folder.c_str(), 0755), 0);  // so that it can be removed
}

TEST_F(CheckWritable, RefusesAFileWhoseFolderTakesNoOther) {
  write_file_whole(folder / "a", writer("x"));
  ASSERT_EQ(chmod((folder / "a").c_str(), 0666), 0);
  ASSERT_EQ(chmod(folder.c_str(), 0555), 0);
  as_ordinary_user([&] {
    const std::string message = failure([&] { check_writable(folder / "a"); });
    EXPECT_TRUE(contains(message, "its folder " + folder.string())) << message;
    EXPECT_NO_THROW(check_writable("/dev/null")) << "it is written, not replaced";
  });
  ASSERT_EQ(chmod(folder.c_str(), 0755), 0);
}

TEST_F(CheckWritable, RefusesADescriptorThatIsClosedOrOnlyRead) {
  const int number = open("/dev/null", O_RDONLY);
  const std::string name = "/dev/fd/" + std::to_string(number);
  EXPECT_TRUE(contains(failure([&] { check_writable(name); }), "Bad file descriptor"));
  close(number);
  EXPECT_TRUE(contains(failure([&] { check_writable(name); }), "Bad file descriptor"));
}

TEST_F(ReadFile, ReturnsEveryByte) {
  const std::string content = kLargeText + std::string("\0\r\n\xFF", 4);
  write_file_whole(folder / "a", writer(content));
  EXPECT_TRUE(read_file(folder / "a") == content);
}

TEST_F(ReadFile, GivesTheSystemsReason) {
  const std::string missing = failure([&] { read_file(folder / "a"); });
  EXPECT_TRUE(contains(missing, "cannot read " + (folder / "a").string() + ": No such file"));
  EXPECT_TRUE(contains(failure([&] { read_file(folder); }), "Is a directory"));
}

TEST_F(WriteFileWhole, AStagedFileHasItsNameWhenItIsPublished) {
  write_file_whole(folder / "a", writer("old"));
  StagedFile file(folder / "a", writer("new"));
  EXPECT_EQ(content_of(folder / "a"), "old");
  file.publish();
  EXPECT_EQ(content_of(folder / "a"), "new");
}

TEST_F(WriteFileWhole, NothingIsLeftOfAFileThatIsNotPublished) {
  {
    const StagedFile file(folder / "a", writer("new"));
    EXPECT_FALSE(fs::is_empty(folder));
    EXPECT_FALSE(fs::exists(folder / "a"));
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(WriteFileWhole, AStagedFileFailsIfItsNameHasBecomeAFolders) {
  StagedFile file(folder / "a", writer("new"));
  fs::create_directories(folder / "a/deep");
  const std::string message = failure([&] { file.publish(); });
  EXPECT_TRUE(contains(message, "cannot write " + (folder / "a").string())) << message;
}

TEST_F(WriteFileWhole, AStagedFileGoesToADescriptorWhenItIsPublished) {
  const int number = open((folder / "f").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  StagedFile file("/dev/fd/" + std::to_string(number), writer(kLargeText));
  EXPECT_EQ(content_of(folder / "f"), "");
  file.publish();
  close(number);
  EXPECT_TRUE(content_of(folder / "f") == kLargeText);
}

TEST_F(WriteFileWhole, SeveralFilesAreThereTogether) {
  const std::vector<FileToWrite> files = {{folder / "a", writer("1")}, {folder / "b", writer("2")}};
  write_files_whole(files);
  EXPECT_EQ(content_of(folder / "a"), "1");
  EXPECT_EQ(content_of(folder / "b"), "2");
  EXPECT_EQ(names(), (FileNames{"a", "b"}));
}

TEST_F(WriteFileWhole, NoneOfSeveralFilesIsThereIfOneFails) {
  const auto fail = [](std::ostream&) { throw std::runtime_error("no data"); };
  const std::vector<FileToWrite> files = {{folder / "a", writer("new")}, {folder / "b", fail}};
  EXPECT_THROW(write_files_whole(files), std::runtime_error);
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace saddle
