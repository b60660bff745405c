#include "pliant/io/answer_file.h"

#include <cerrno>
#include <cstring>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/digest.h"

namespace pliant {
namespace {

constexpr double kPeriod = 2;  // s, what a crash may lose
constexpr std::string_view kHeading = "pliant: answers/1\n";

std::string record_bytes(const std::string& question, const Journal::Numbers& answer) {
  std::string content = question;
  content += as_bytes(answer);
  return fmt::format("{} {} {}\n", question.size(), answer.size(), sha256_of(content)) + content;
}

/// Whether it is there.
bool read_heading(std::ifstream& in) {
  std::string heading(kHeading.size(), '\0');
  in.read(heading.data(), static_cast<std::streamsize>(heading.size()));
  return in && heading == kHeading;
}

}  // namespace

/// An answer of the file; one that is not whole has no bytes.
struct AnswerFile::Record {
  std::string question;
  Numbers answer;
  std::size_t bytes = 0;
};

AnswerFile::AnswerFile(std::filesystem::path file, std::function<void(const std::string&)> begin)
    : file_(std::move(file)), begin_(std::move(begin)) {}

void AnswerFile::resume() {
  known_.open(file_, std::ios::binary);
  if (!known_) {
    throw InputError({file_.string()}, "is not there: nothing was stopped that could go on",
                     "the results folder of a run that was stopped");
  }
  if (!read_heading(known_)) {
    throw InputError({file_.string()}, "is no progress of such a run",
                     "one that the same command wrote");
  }
  whole_ = kHeading.size();
}

int AnswerFile::count(const std::filesystem::path& file) {
  AnswerFile answers(file, {});
  answers.resume();
  int count = 0;
  while (const std::size_t bytes = answers.read_record().bytes) {
    answers.whole_ += bytes;
    ++count;
  }
  return count;
}

AnswerFile::Record AnswerFile::read_record() {
  std::string line, digest;
  std::size_t characters = 0, numbers = 0;
  if (!std::getline(known_, line)) return {};
  std::istringstream lengths(line);
  if (!(lengths >> characters >> numbers >> digest)) return {};
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file_, error);
  if (error || whole_ > size) return {};
  const std::uintmax_t left = size - whole_;
  if (characters > left || numbers > (left - characters) / sizeof(double)) return {};
  Record record{std::string(characters, '\0'), Numbers(numbers)};
  known_.read(record.question.data(), static_cast<std::streamsize>(characters));
  known_.read(reinterpret_cast<char*>(record.answer.data()),
              static_cast<std::streamsize>(sizeof(double) * numbers));
  const std::string bytes = record_bytes(record.question, record.answer);
  if (known_ && bytes.starts_with(line + "\n")) record.bytes = bytes.size();
  return record;
}

Journal::Numbers AnswerFile::answer(const std::string& question,
                                    const std::function<Numbers()>& work) {
  if (known_.is_open()) {
    Record record = read_record();
    is_of_another_ = record.bytes > 0 && record.question != question;
    if (is_of_another_) {
      throw InputError({file_.string()},
                       "is the progress of a run with other data, settings or version",
                       "those that it began with, or the command without --resume");
    }
    whole_ += record.bytes;
    if (record.bytes > 0) return std::move(record.answer);
    known_.close();
    std::filesystem::resize_file(file_, whole_);
  }
  Numbers found = work();
  unwritten_ += record_bytes(question, found);
  if (since_saved_.seconds() > kPeriod) save();
  return found;
}

bool AnswerFile::save() {
  if (!unwritten_.empty()) {
    if (whole_ == 0) {
      unwritten_.insert(0, kHeading);
      begin_(unwritten_);
    } else {
      std::ofstream out(file_, std::ios::binary | std::ios::app);
      out << unwritten_ << std::flush;
      if (!out) throw OutputError(file_.string(), std::strerror(errno));
    }
    whole_ += unwritten_.size();
    unwritten_.clear();
    since_saved_ = {};
  }
  return whole_ > 0;
}

bool is_answer_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return read_heading(in);
}

}  // namespace pliant
