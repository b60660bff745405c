#include "apps/pliant/movie_file.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <spawn.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"

namespace pliant {
namespace {

constexpr int kRead = 0, kWrite = 1;  // ends of a pipe

std::vector<std::string> ffmpeg_command(const PictureSize& size, double rate,
                                        const std::filesystem::path& file) {
  return {"ffmpeg", "-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format", "rgb24",
          "-video_size", fmt::format("{}x{}", size.width, size.height), "-framerate",
          fmt::format("{:.9g}", rate), "-i", "pipe:0",
          // Most players want halved colour, and with it even sizes.
          "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-pix_fmt", "yuv420p", "-movflags",
          "+faststart", file.string()};
}

void check_file(const std::filesystem::path& file) {
  if (file.extension() != ".mp4") {
    throw InputError({"--movie"}, quoted_value(file.string()) + " is no film", "FILE.mp4");
  }
  const std::filesystem::path folder = file.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw InputError({"--movie"}, "there is no folder " + quoted_value(folder.string()),
                     "a file in a folder that exists");
  }
}

}  // namespace

MovieFile::MovieFile(std::filesystem::path file, const PictureSize& size, double rate)
    : file_(std::move(file)), part_(file_), messages_(std::tmpfile()) {
  check_file(file_);
  part_.replace_filename(fmt::format(".{}.{}.mp4", file_.stem().string(), getpid()));
  if (messages_ == nullptr) throw std::system_error(errno, std::generic_category(), "tmpfile");
  start(size, rate);
}

MovieFile::~MovieFile() {
  if (process_ > 0) kill(process_, SIGTERM);
  end();
  std::fclose(messages_);
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void MovieFile::start(const PictureSize& size, double rate) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[kRead], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(messages_), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(messages_), STDERR_FILENO);
  std::vector<std::string> words = ffmpeg_command(size, rate, part_);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int error = posix_spawnp(&process_, "ffmpeg", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[kRead]);
  pictures_ = fdopen(ends[kWrite], "wb");
  if (error != 0) {
    process_ = 0;
    end();
    throw InputError({"--movie"}, "the program ffmpeg, which makes films, was not found",
                     "an installed ffmpeg; `-o DIR` writes the pictures alone");
  }
}

void MovieFile::add(const Image& picture) {
  const std::vector<Pixel>& pixels = picture.pixels();
  if (std::fwrite(pixels.data(), sizeof(Pixel), pixels.size(), pictures_) != pixels.size()) fail();
}

void MovieFile::commit() {
  const bool written = std::fflush(pictures_) == 0;
  end();
  if (!written || status_ != 0) fail();
  std::error_code error;
  std::filesystem::rename(part_, file_, error);
  if (error) throw OutputError(file_.string(), error.message());
}

void MovieFile::end() {
  if (pictures_ != nullptr) std::fclose(pictures_);
  pictures_ = nullptr;
  if (process_ > 0) waitpid(process_, &status_, 0);
  process_ = 0;
}

void MovieFile::fail() {
  end();
  std::rewind(messages_);
  std::array<char, 500> text{};
  const size_t size = std::fread(text.data(), 1, text.size(), messages_);
  const std::string said = one_line({text.data(), size}, text.size());
  throw OutputError(file_.string(),
                    "ffmpeg could not make the film" + (said.empty() ? "" : ": " + said));
}

}  // namespace pliant
