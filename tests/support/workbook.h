#pragma once

#include <string>
#include <utility>
#include <vector>

#include <zip.h>

#include "pliant/base/number_text.h"

#include "io/temporary_folder.h"

namespace pliant::test {

/// A sheet of a workbook: its name, and its cells row by row.
using WorkbookSheet = std::pair<std::string, std::vector<std::vector<std::string>>>;

/// How a workbook keeps its texts: in a list of all, in each cell, or as what a formula came to.
enum class WorkbookTexts { shared, in_cells, of_formulas };

/// The bytes of a workbook (.xlsx): spreadsheet programs share its texts, instruments and scripts
/// write them into the cells; numbers are numbers.
inline std::string workbook(const std::vector<WorkbookSheet>& sheets,
                            WorkbookTexts storage = WorkbookTexts::shared) {
  const std::string main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
  const std::string office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
  const std::string package = "http://schemas.openxmlformats.org/package/2006/";
  const std::string xml = R"(<?xml version="1.0" encoding="UTF-8" standalone="yes"?>)";
  const std::string kind = "application/vnd.openxmlformats-officedocument.spreadsheetml.";
  std::vector<std::pair<std::string, std::string>> files;
  std::string types, names, relations, strings;
  int texts = 0;
  const auto relation = [&](const std::string& id, const std::string& type,
                            const std::string& target) {
    return "<Relationship Id=\"" + id + "\" Type=\"" + office + "/" + type + "\" Target=\"" +
           target + "\"/>";
  };
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    std::string data;
    for (std::size_t row = 0; row < sheets[i].second.size(); ++row) {
      const std::string line = std::to_string(row + 1);
      data += "<row r=\"" + line + "\">";
      for (std::size_t column = 0; column < sheets[i].second[row].size(); ++column) {
        const std::string& cell = sheets[i].second[row][column];
        if (cell.empty()) continue;
        const std::string at = static_cast<char>('A' + static_cast<char>(column)) + line;
        if (parse_number(cell)) {
          data += "<c r=\"" + at + "\"><v>" + cell + "</v></c>";
        } else if (storage == WorkbookTexts::in_cells) {
          data += "<c r=\"" + at + "\" t=\"inlineStr\"><is><t>" + cell + "</t></is></c>";
        } else if (storage == WorkbookTexts::of_formulas) {
          data += "<c r=\"" + at + "\" t=\"str\"><f>B1</f><v>" + cell + "</v></c>";
        } else {
          data += "<c r=\"" + at + "\" t=\"s\"><v>" + std::to_string(texts++) + "</v></c>";
          strings += "<si><t>" + cell + "</t></si>";
        }
      }
      data += "</row>";
    }
    files.emplace_back(
        "xl/worksheets/sheet" + number + ".xml",
        xml + "<worksheet xmlns=\"" + main + "\"><sheetData>" + data + "</sheetData></worksheet>");
    types += "<Override PartName=\"/xl/worksheets/sheet" + number + ".xml\" ContentType=\"" + kind +
             "worksheet+xml\"/>";
    names += "<sheet name=\"" + sheets[i].first + "\" sheetId=\"" + number + "\" r:id=\"rId" +
             number + "\"/>";
    relations += relation("rId" + number, "worksheet", "worksheets/sheet" + number + ".xml");
  }
  relations += relation("rIdS", "sharedStrings", "sharedStrings.xml");
  files.emplace_back("[Content_Types].xml",
                     xml + "<Types xmlns=\"" + package +
                         "content-types\"><Default Extension=\"rels\" ContentType=\"application/"
                         "vnd.openxmlformats-package.relationships+xml\"/><Override "
                         "PartName=\"/xl/workbook.xml\" ContentType=\"" +
                         kind +
                         "sheet.main+xml\"/><Override PartName=\"/xl/sharedStrings.xml\" "
                         "ContentType=\"" +
                         kind + "sharedStrings+xml\"/>" + types + "</Types>");
  files.emplace_back("_rels/.rels", xml + "<Relationships xmlns=\"" + package + "relationships\">" +
                                        relation("rId1", "officeDocument", "xl/workbook.xml") +
                                        "</Relationships>");
  files.emplace_back("xl/workbook.xml", xml + "<workbook xmlns=\"" + main + "\" xmlns:r=\"" +
                                            office + "\"><sheets>" + names +
                                            "</sheets></workbook>");
  files.emplace_back("xl/_rels/workbook.xml.rels", xml + "<Relationships xmlns=\"" + package +
                                                       "relationships\">" + relations +
                                                       "</Relationships>");
  files.emplace_back("xl/sharedStrings.xml",
                     xml + "<sst xmlns=\"" + main + "\">" + strings + "</sst>");

  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.xlsx").string();
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
  for (const auto& [name, content] : files) {
    zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
    zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  }
  zip_close(archive);
  return content_of(path);
}

}  // namespace pliant::test
