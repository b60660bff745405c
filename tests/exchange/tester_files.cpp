#include "exchange/tester_files.h"

#include "support/workbook.h"

namespace pliant::test {
namespace {

/// UTF-8 text of Latin letters in Latin-1.
std::string latin1(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool two = text[i] == '\xC3' || text[i] == '\xC2';
    const char c = two ? text[++i] : text[i];
    bytes += text[i - (two ? 1 : 0)] == '\xC3' ? static_cast<char>(c + 0x40) : c;
  }
  return bytes;
}

/// The same in UTF-16, little end first.
std::string utf16(const std::string& text, bool mark) {
  std::string bytes = mark ? "\xFF\xFE" : "";
  for (const char c : latin1(text)) bytes += {c, '\0'};
  return bytes;
}

const std::string kBluehill =
    "\"Test Method\",\"strip, 50 mm.im_tens\"\n\"Sample\",\"A7\"\n\"Specimen label\",\"3\"\n"
    "\"Rate 1\",\"100.00\",\"mm/min\"\n\"Width\",\"50.00\",\"mm\"\n\"Length\",\"100.00\",\"mm\"\n"
    "\n\"Time\",\"Extension\",\"Load\"\n\"(s)\",\"(mm)\",\"(N)\"\n\"0.00\",\"0.0\",\"0.0\"\n"
    "\"0.02\",\"2.0\",\"4.0\"\n\"0.04\",\"5.0\",\"9.0\"\n\"0.06\",\"1.0\",\"2.0\"\n";

const std::string kTestXpert =
    "Prüfer;KL\nPrüfnorm;DIN EN ISO 13934-1\nPrüfgeschwindigkeit;100;mm/min\n"
    "Einspannlänge;100,00;mm\nProbenbreite;50,00;mm\nRichtung;Kette\n\n"
    "Prüfzeit;Standardweg;Standardkraft\ns;mm;N\n0,0;0,0;0,0\n0,1;2,0;4,0\n0,2;5,0;9,0\n"
    "0,3;1,0;2,0\n";

std::vector<MadeUpFile> instron_files() {
  const std::string rows = "0,0,0\n1,2,4\n2,5,9\n3,1,2\n";
  return {{"Bluehill", "pull.csv", kBluehill, "direction"},
          {"BluehillUtf16", "pull.csv", utf16(kBluehill, true), "direction"},
          {"BluehillUtf16WithoutMark", "pull.csv", utf16(kBluehill, false), "direction"},
          {"BluehillGerman", "pull.csv",
           latin1("Breite;50,00;mm\nAnfangsmesslänge;100,00;mm\n\nZeit;Verlängerung;Kraft\n"
                  "(s);(mm);(N)\n0,0;0,0;0,0\n0,1;2,0;4,0\n0,2;5,0;9,0\n0,3;1,0;2,0\n"),
           "direction"},
          {"BluehillResultsAbove", "warp-3.csv",
           "Results Table 1\n,Maximum Load (N),Extension at Break (mm)\n1,9.0,5.0\nMean,9.0,5.0\n\n"
           "Time (s),Extension (mm),Load (N)\n" +
               rows,
           "length width"},
          {"BluehillSpecimensBelow",
           "pull.csv",
           "Specimen 1\nTime (s),Extension (mm),Load (N)\n" + rows +
               "\nSpecimen 2\nWidth,50,mm\nTime (s),Extension (mm),Load (N)\n" + rows,
           "direction length width",
           {},
           2},
          {"BluehillStrain", "pull.csv",
           "Time (s),Load (N),Tensile strain (mm/mm)\n0,0,0\n1,4,0.02\n2,9,0.05\n3,2,0.01\n"}};
}

std::vector<MadeUpFile> zwick_files() {
  const std::string side_by_side =
      "Standardweg;Standardkraft;Standardweg;Standardkraft\nmm;N;mm;N\n0,0;0,0;0,0;0,0\n"
      "2,0;4,0;2,0;4,0\n5,0;9,0;5,0;9,0\n1,0;2,0;1,0;2,0\n";
  return {{"TestXpert", "probe_03.txt", kTestXpert, ""},
          {"TestXpertLatin1", "probe_03.txt", latin1(kTestXpert), ""},
          {"TestXpertEnglish", "03.tra",
           "Grip to grip separation at the start position\t100\tmm\nGauge length\t100\tmm\n"
           "Test time\tStandard travel\tStandard force\ns\tmm\tN\n0\t0\t0\n1\t2\t4\n2\t5\t9\n"
           "3\t1\t2\n",
           "direction width"},
          {"TestXpertSideBySide",
           "schuss.csv",
           ";Probe 1;;Probe 2\n" + side_by_side,
           "length width",
           {},
           2},
          {"TestXpertSideBySideWithASpacer",
           "weft.csv",
           "Weg (mm);Kraft (N);;Weg (mm);Kraft (N)\n0;0;;0;0\n2;4;;2;4\n5;9;;5;9\n1;2;;1;2\n",
           "length width",
           {},
           2},
          {"TestXpertWorkbook", "kette.xlsx",
           workbook({{"Ergebnisse", {{"Bediener", "KL"}, {"Einspannlänge", "100", "mm"}}},
                     {"Probe 1",
                      {{"Probenbreite", "50", "mm"},
                       {},
                       {"Standardweg", "Standardkraft"},
                       {"mm", "N"},
                       {"0", "0"},
                       {"2", "4"},
                       {"5", "9"},
                       {"1", "2"}}}}),
           "length"}};
}

std::vector<MadeUpFile> other_tensile_files() {
  return {
      {"MtsTestSuite", "pull.txt",
       "Data Acquisition: Axial\nStation Name: 5 kN\nGauge Length: 100.0 mm\n\n"
       "Axial Displacement\tAxial Force\tTime\nmm\tN\tSec\n0\t0\t0\n2\t4\t1\n5\t9\t2\n1\t2\t3\n",
       "direction width"},
      {"MtsTestWorks", "pull.csv",
       "Crosshead (mm),Load (kN),Time (sec)\n0,0,0\n2,0.004,1\n5,0.009,2\n1,0.002,3\n"},
      {"Trapezium", "pull.csv",
       "\"1 _ 1\",\"\",\"\"\n\"Time\",\"Force\",\"Stroke\"\n\"sec\",\"N\",\"mm\"\n0,0,0\n1,4,2\n"
       "2,9,5\n3,2,1\n"},
      {"TrapeziumSideBySide",
       "pull.csv",
       "\"1 _ 1\",\"\",\"\",\"1 _ 2\",\"\",\"\"\n\"Time\",\"Force\",\"Stroke\",\"Time\",\"Force\","
       "\"Stroke\"\n\"sec\",\"N\",\"mm\",\"sec\",\"N\",\"mm\"\n0,0,0,0,0,0\n1,4,2,1,4,2\n"
       "2,9,5,2,9,5\n3,2,1,3,2,1\n",
       "direction length width",
       {},
       2},
      {"TiniusOlsen", "bias_2.csv",
       "Specimen Width: 50 mm\nGauge Length (mm),100\nForce (N),Position "
       "(mm)\n0,0\n4,2\n9,5\n2,1\n",
       ""},
      {"TiniusOlsenWithoutHeader",
       "pull.csv",
       "0.0,0.0\n2.0,4.0\n5.0,9.0\n1.0,2.0\n",
       "direction length width extension force",
       {{"force", "2 (N)"}, {"extension", "1 (mm)"}}},
      {"Hounsfield", "pull.txt", "FORCE (N)\tEXT. (mm)\n0\t0\n4\t2\n9\t5\n2\t1\n"},
      {"HounsfieldWithoutUnits",
       "pull.csv",
       "Force,Extension\n0,0\n4,2\n9,5\n2,1\n",
       "direction length width extension force",
       {{"force", "Force (N)"}, {"extension", "Extension (mm)"}}},
      {"UnknownNames",
       "pull.csv",
       "Kanal 1;Kanal 2\n0;0\n2;4\n5;9\n1;2\n",
       "direction length width extension force",
       {{"force", "Kanal 2 (N)"}, {"extension", "Kanal 1 (mm)"}}},
      {"Workbook", "pull.xlsx",
       workbook(
           {{"Data",
             {{"Load (N)", "Extension (mm)"}, {"0", "0"}, {"4", "2"}, {"9", "5"}, {"2", "1"}}}})}};
}

std::vector<MadeUpFile> kes_files() {
  return {{"KesShear",
           "kes.txt",
           "KES-FB1-A SHEAR\nAngle (deg)\tShear force (gf/cm)\n0\t0\n2\t4\n5\t9\n1\t2\n",
           "",
           {},
           1,
           "shear-cycles"},
          {"KesBending",
           "warp kes.csv",
           "K (1/cm);M (gf.cm/cm)\n0;0\n2;4\n5;9\n1;2\n",
           "",
           {},
           1,
           "pure-bending"}};
}

/// The four readings in the names and units of many.
std::vector<MadeUpFile> plain_files() {
  return {
      {"CapitalsAndBrackets", "pull.csv",
       "Time (s),Extension (mm),Force (N)\n0,0,0\n1,2,4\n2,5,9\n3,1,2\n"},
      {"LoadInMillinewtons", "pull.csv",
       "Load [mN]\tDisplacement [cm]\n0\t0\n4000\t0.2\n9000\t0.5\n2000\t0.1\n"},
      {"UnitsRow", "pull.csv", "Standard force,Standard travel\nN,mm\n0,0\n4,2\n9,5\n2,1\n"},
      {"BracketedUnitsRow", "pull.csv", "Load,Tensile extension\n(N),(mm)\n0,0\n4,2\n9,5\n2,1\n"},
      {"GermanPerCent", "pull.csv", "Kraft in N;Dehnung in %\n0;0\n4;2\n9;5\n2;1\n"},
      {"ElongationPerCent", "pull.csv", "Load (N),Elongation (%)\n0,0\n4,2\n9,5\n2,1\n"},
      {"ExtensionPerCent", "pull.csv", "Force (N),Extension (%)\n0,0\n4,2\n9,5\n2,1\n"},
      {"Preamble", "pull.csv",
       "Test method;ISO 13934-1\nOperator;KL\nGauge length;100;mm\n\nNo;Extension / mm;Load / N\n"
       "1;0;0\n2;2;4\n3;5;9\n4;1;2\n",
       "direction width"},
      {"LengthOfTheSpecimen", "pull.csv",
       "Length (mm),Extension (mm),Force (N)\n100,0,0\n100,2,4\n100,5,9\n100,1,2\n"},
      {"TimeOfDay", "pull.csv",
       "Time (s),Load (N),Elongation (mm),Elongation "
       "(%)\n00:00:01,0,0,0\n00:00:02,4,2,2\n00:00:03,9,5,5\n00:00:04,2,1,1\n"},
      {"Chinese", "pull.csv",
       "\xCA\xB1\xBC\xE4,\xCE\xBB\xD2\xC6,\xC1\xA6\n(s),(mm),(N)\n\"0.00\",\"0.0\",\"0.0\"\n"
       "\"0.02\",\"2.0\",\"4.0\"\n\"0.04\",\"5.0\",\"9.0\"\n\"0.06\",\"1.0\",\"2.0\"\n"},
      {"CapitalUnits", "pull.csv", "EXTENSION_MM,FORCE_KN\n0,0\n2,0.004\n5,0.009\n1,0.002\n"},
      {"CapitalUnitsInBrackets", "pull.csv", "KRAFT [N];WEG [MM]\n0;0\n4;2\n9;5\n2;1\n"},
      {"CapitalUmlaut", "pull.csv", "KRAFT [N];LÄNGENÄNDERUNG [MM]\n0;0\n4;2\n9;5\n2;1\n"},
      {"SmallUnit", "pull.csv", "Load (n),Stroke (mm)\n0,0\n4,2\n9,5\n2,1\n"},
      {"CapitalUnitsRow", "pull.csv", "Load,Stroke\nN,MM\n0,0\n4,2\n9,5\n2,1\n"},
      {"UnitsInWords", "pull.csv", "Load (Newton),Stroke (Millimeters)\n0,0\n4,2\n9,5\n2,1\n"},
      {"Pounds", "pull.csv",
       "Load (lbs),Extension (inches)\n0,0\n0.899235772398842,0.07874015748031496\n"
       "2.0232804878973947,0.19685039370078741\n0.449617886199421,0.03937007874015748\n"},
      {"CrossheadDisplacement", "pull.csv",
       "Primary load (N),Crosshead displacement (mm)\n0,0\n4,2\n9,5\n2,1\n"},
      {"MachineExtension", "pull.csv", "Last (N);Machine extension (mm)\n0;0\n4;2\n9;5\n2;1\n"},
      {"PrimaryExtension", "pull.csv",
       "Primary load (N),Primary extension (mm)\n0,0\n4,2\n9,5\n2,1\n"},
      {"Ausdehnung", "pull.csv", "Last [N];Ausdehnung [mm]\n0;0\n4;2\n9;5\n2;1\n"},
      {"Traverse", "pull.csv", "Kraft [N];Traverse [mm]\n0;0\n4;2\n9;5\n2;1\n"},
      {"DashForNoUnit", "pull.csv", "Nr;Weg;Kraft\n-;mm;N\n1;0;0\n2;2;4\n3;5;9\n4;1;2\n"},
      {"UnitsInALineAbove", "pull.csv",
       "Units: N, mm, s\nForce,Extension,Time\n0,0,0\n4,2,1\n9,5,2\n2,1,3\n"},
      {"UnitsAboveTheirColumns", "pull.csv",
       "Model,A\nUnit,N,mm\nNo,Force,Displacement\n1,0,0\n2,4,2\n3,9,5\n4,2,1\n"},
      {"SecondsShortened", "pull.csv",
       "Load [N],Travel [mm],Time [sec.]\n0,0,0\n4,2,1\n9,5,2\n2,1,3\n"},
      {"SizesWithTheirSymbols", "pull.csv",
       "Einspannlänge bei Startposition;100,00;mm\nProbenbreite b0;50,00;mm\nProbe;Kette 3\n\n"
       "Standardweg;Standardkraft\nmm;N\n0,0;0,0\n2,0;4,0\n5,0;9,0\n1,0;2,0\n",
       ""},
      {"EndOfTest", "pull.csv", "Load (N),Stroke (mm)\n0,0\n4,2\n9,5\n2,1\nEnd of test\n"},
      {"DistanceOfAPull", "pull.csv", "Force (N),Distance (mm)\n0,0\n4,2\n9,5\n2,1\n"},
      {"DistanceOfTheClamps", "pull.csv", "Force (N),Distance (mm)\n0,100\n4,102\n9,105\n2,101\n"},
      {"AnotherScript", "pull.csv", "\xD1\xE8\xEB\xE0 (N),\xD5\xEE\xE4 (mm)\n0,0\n4,2\n9,5\n2,1\n"},
      {"WordsThatNobodyListed", "pull.csv", "Messwert A [N];Messwert B [mm]\n0;0\n4;2\n9;5\n2;1\n"},
      {"StrainOfNoName", "pull.csv", "Load (N),Signal 2 [%]\n0,0\n4,2\n9,5\n2,1\n"},
      {"NominalStrain", "pull.csv", "Load (N),Nominal strain (%)\n0,0\n4,2\n9,5\n2,1\n"},
      {"GripSeparation", "pull.csv", "FORCE_N,GRIP SEPARATION (mm)\n0,100\n4,102\n9,105\n2,101\n"}};
}

}  // namespace

std::string reference_rows(const std::string& type) {
  const std::string rows = "0,0\n4,2\n9,5\n2,1\n";
  if (type == "shear-cycles") return "force_gf_per_cm,angle_deg\n" + rows;
  if (type == "pure-bending") return "moment_gf_cm_per_cm,curvature_1_per_cm\n" + rows;
  return "force_N,extension_mm\n" + rows;
}

std::vector<MadeUpFile> good_files() {
  std::vector<MadeUpFile> files;
  for (const auto& some :
       {instron_files(), zwick_files(), other_tensile_files(), kes_files(), plain_files()}) {
    files.insert(files.end(), some.begin(), some.end());
  }
  return files;
}

std::vector<RefusedFile> refused_files() {
  std::string remarks;
  for (int i = 0; i < 300; ++i) remarks += "a remark\n";
  return {
      {"UnitThatThereIsNot", "pull.csv", "Kraft (kp);Weg (mm)\n0;0\n4;2\n9;5\n2;1\n",
       "columns.force"},
      {"MegaOrMilli", "pull.csv", "FORCE_MN,WEG_MM\n0,0\n4,2\n9,5\n2,1\n", "columns.force"},
      {"ForceAlone", "pull.csv", "Time (s),Load (N)\n0,0\n1,4\n2,9\n3,2\n", "columns.extension"},
      {"LongPreamble", "pull.csv", remarks + "Load (N),Stroke (mm)\n0,0\n4,2\n9,5\n2,1\n",
       "skip_rows"}};
}

}  // namespace pliant::test
