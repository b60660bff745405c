#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "pliant/capture/dic_session.h"
#include "pliant/capture/frame_doubts.h"
#include "pliant/study/imported_study.h"

namespace pliant {

/// The folder of the session among the files of an import.
inline constexpr const char* kDicSessionFolder = "sheet";

/// A study, and what it was made from.
struct DicImport {
  ImportedStudy study;  ///< without the files of the session, see make_session_files
  DicSession made;
  std::vector<FrameDoubt> doubts;
};

/// What a dic/1 file describes as a study: a session/1 directory `sheet/`, study.yaml that fits
/// it; and where two clips pull and their force is known, the table of what the middle of the
/// sample did, middle.csv, with strip.yaml, the study of it in one dimension.
/// @param read_picture  where the program can; else pictures are refused
/// @throws InputError
DicImport import_dic(const std::filesystem::path& file, const ReadPicture& read_picture,
                     const RunContext& context);

/// The files of the session, one after the other; of a bias strip in the axes of its yarns.
/// @param take  is given the name and the content of each
void make_session_files(const DicImport& imported,
                        const std::function<void(const std::string&, std::string)>& take);

}  // namespace pliant
