#include "pliant/measurement/tester_preamble.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

std::string told(std::string_view field, std::string_view preamble) {
  const auto facts = tester_facts(preamble);
  const TesterFact* fact = find_fact(facts, field);
  return fact ? fact->value : "";
}

TEST(TesterFacts, TellTheSpeedInItsUnit) {
  EXPECT_EQ(told("speed", "Prüfgeschwindigkeit;100;mm/min\n"), "100 mm/min");
  EXPECT_EQ(told("speed", "\"Crosshead speed\",\"100.00\",\"mm/min\"\n"), "100 mm/min");
}

TEST(TesterFacts, LeaveOutTheNumberOfALabel) {
  EXPECT_EQ(told("speed", "\"Rate 1\",\"20.00 mm/min\"\n"), "20 mm/min");
  EXPECT_EQ(told("width", "Width 50;mm\n"), "50 mm");
  EXPECT_EQ(told("length", "Gauge length 1,5 cm\n"), "1.5 cm");
}

TEST(TesterFacts, LeaveOutTheSymbolOfASize) {
  EXPECT_EQ(told("width", "Probenbreite b0;50,00;mm\n"), "50 mm");
  EXPECT_EQ(told("width", "Probenbreite b01;50,00;mm\n"), "");
  EXPECT_EQ(told("length", "Gauge length L0 (mm);100\n"), "100 mm");
}

TEST(TesterFacts, TakeTheDirectionFromANameWhereNoLineTellsIt) {
  EXPECT_EQ(told("direction", "\"Specimen label\",\"warp-1\"\n"), "warp");
  EXPECT_EQ(told("direction", "Probe;Kette 3\nRichtung;Schuss\n"), "weft");
  EXPECT_EQ(told("direction", "Sample;poplin\n"), "");
}

}  // namespace
}  // namespace pliant
