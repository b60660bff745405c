// Which vertices pins and clips hold.

#include "pliant/scene/vertex_selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"
#include "pliant/scene/held_vertices.h"

#include "io/input_error_of.h"
#include "scene/scene_text.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::read_scene_text;
using test::TemporaryFolder;
using test::with_more;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The cloth of `with_more`: vertices 0 1 2 at the bottom, 6 7 8 at the top.
ClothVertices sheet() {
  return {regular_grid(0.1, 0.1, 3, 3).positions,
          {{"collar", {7, 8}}, {"hem", {0, 1}}, {"nobody", {}}}};
}

std::vector<int> selected(const std::string& criteria) {
  const Scene scene = read_scene_text(with_more("pins: [{cloth: sheet, " + criteria + "}]"));
  return selected_vertices(scene.pins.at(0).vertices, sheet());
}

InputError refusal_of(const std::string& more) {
  return input_error_of([&] {
    const Scene scene = read_scene_text(with_more(more));
    held_vertices(scene, std::vector{sheet()});
  });
}

TEST(VertexSelection, TakesNumbers) {
  EXPECT_THAT(selected("vertices: [4, 0, 4]"), ElementsAre(0, 4));
}

TEST(VertexSelection, TakesEdgesOfARectangle) {
  EXPECT_THAT(selected("edges: [bottom]"), ElementsAre(0, 1, 2));
  EXPECT_THAT(selected("edges: [top]"), ElementsAre(6, 7, 8));
  EXPECT_THAT(selected("edges: [left]"), ElementsAre(0, 3, 6));
  EXPECT_THAT(selected("edges: [right]"), ElementsAre(2, 5, 8));
}

TEST(VertexSelection, TakesCornersOfARectangle) {
  EXPECT_THAT(selected("corners: [bottom-left]"), ElementsAre(0));
  EXPECT_THAT(selected("corners: [bottom-right]"), ElementsAre(2));
  EXPECT_THAT(selected("corners: [top-left, top-right]"), ElementsAre(6, 8));
}

TEST(VertexSelection, TakesWhatLiesInABoxWithItsFaces) {
  EXPECT_THAT(selected("within: {box: {low: [0.05, 0, 0], high: [0.1, 0.05, 0]}}"),
              ElementsAre(1, 2, 4, 5));
}

TEST(VertexSelection, JoinsItsCriteria) {
  EXPECT_THAT(selected("vertices: [4], corners: [top-left], edges: [bottom]"),
              ElementsAre(0, 1, 2, 4, 6));
}

TEST(VertexSelection, RefusesAVertexThatIsNotThereWithItsPlaceInTheList) {
  const InputError error = refusal_of("pins:\n  - {cloth: sheet, vertices: [0, 9]}");
  EXPECT_EQ(error.where().line, 6);
  EXPECT_EQ(error.where().field, "pins[0].vertices[1]");
  EXPECT_EQ(error.problem(), "there is no vertex 9");
  EXPECT_EQ(error.expected(), "a number below 9");
}

TEST(VertexSelection, RefusesABoxWithoutVertices) {
  const InputError error =
      refusal_of("pins: [{cloth: sheet, within: {box: {low: [1, 1, 1], high: [2, 2, 2]}}}]");
  EXPECT_EQ(error.where().line, 5);
  EXPECT_EQ(error.where().field, "pins[0].within.box");
  EXPECT_EQ(error.problem(), "holds no vertex");
  EXPECT_THAT(error.expected(), HasSubstr("spans [0, 0, 0] to [0.1, 0.1, 0] m"));
}

TEST(VertexSelection, RefusesABoxWithoutVerticesBesideOtherCriteria) {
  EXPECT_EQ(refusal_of("pins: [{cloth: sheet, edges: [top],"
                       " within: {box: {low: [1, 1, 1], high: [2, 2, 2]}}}]")
                .where()
                .field,
            "pins[0].within.box");
}

TEST(VertexSelection, TakesTheVertexNearestToAPointAndToEachOfSeveral) {
  EXPECT_THAT(selected("nearest: [0.07, 0.04, 0.02]"), ElementsAre(4));
  EXPECT_THAT(selected("nearest: [[0, 0.11, 0], [0.09, 0.01, 0]]"), ElementsAre(2, 6));
}

TEST(VertexSelection, RefusesAPointFarFromTheClothWithItsPlace) {
  const InputError error = refusal_of("pins: [{cloth: sheet, nearest: [[0, 0, 0], [50, 50, 0]]}]");
  EXPECT_EQ(error.where().field, "pins[0].nearest[1]");
  EXPECT_THAT(error.problem(), HasSubstr("from the nearest vertex"));
}

TEST(VertexSelection, TakesVertexGroupsOfTheMeshFile) {
  EXPECT_THAT(selected("groups: [hem, collar]"), ElementsAre(0, 1, 7, 8));
}

TEST(VertexSelection, RefusesAGroupThatIsNotThereAndOneThatIsEmptyByName) {
  const InputError unknown = refusal_of("pins: [{cloth: sheet, groups: [hem, colar]}]");
  EXPECT_EQ(unknown.where().field, "pins[0].groups[1]");
  EXPECT_EQ(unknown.problem(), "the mesh has no vertex group \"colar\" (did you mean \"collar\"?)");
  EXPECT_EQ(unknown.expected(), "\"collar\", \"hem\" or \"nobody\"");
  EXPECT_EQ(refusal_of("pins: [{cloth: sheet, groups: [nobody]}]").problem(),
            "the vertex group \"nobody\" is empty");
}

TEST(HeldVertices, ArePinsAndClipsInTheirOrder) {
  const Scene scene = read_scene_text(
      with_more("pins: [{cloth: sheet, corners: [top-left]}, {cloth: sheet, vertices: [8]}]\n"
                "clips: [{name: c, cloth: sheet, edges: [bottom], mass: 1 g, free: true}]"));
  const HeldVertices held = held_vertices(scene, std::vector{sheet()});
  EXPECT_THAT(held.pins, ElementsAre(ElementsAre(6), ElementsAre(8)));
  EXPECT_THAT(held.clips, ElementsAre(ElementsAre(0, 1, 2)));
}

TEST(HeldVertices, MayBeHeldByTwoPinsInTwoDirections) {
  const Scene scene =
      read_scene_text(with_more("pins: [{cloth: sheet, vertices: [1], directions: [x, y]},"
                                " {cloth: sheet, edges: [bottom], directions: [z]}]"));
  EXPECT_NO_THROW(held_vertices(scene, std::vector{sheet()}));
}

TEST(HeldVertices, AreRefusedWhereTwoPinsHoldOneInOneDirection) {
  const InputError error = refusal_of(
      "pins:\n  - {cloth: sheet, vertices: [1], directions: [z]}\n"
      "  - {cloth: sheet, edges: [bottom]}");
  EXPECT_EQ(error.where().line, 7);
  EXPECT_EQ(error.problem(), "vertex 1 is held twice, first on line 6");
}

TEST(HeldVertices, AreRefusedWhereAClipHoldsAPinnedOne) {
  const InputError error = refusal_of(
      "pins:\n  - {cloth: sheet, vertices: [1], directions: [z]}\n"
      "clips:\n  - {name: c, cloth: sheet, edges: [bottom], mass: 1 g}");
  EXPECT_EQ(error.where().line, 8);
  EXPECT_EQ(error.where().field, "clips[0]");
}

TEST(HeldVertices, AreAskedForAtTheVertexOfACord) {
  const InputError error = refusal_of(
      "clips:\n  - {name: c, cloth: sheet, edges: [bottom], mass: 1 g, free: true,\n"
      "     cords: [{vertex: 9, force: [0, 0, 1]}]}");
  EXPECT_EQ(error.where().line, 7);
  EXPECT_EQ(error.where().field, "clips[0].cords[0].vertex");
}

class IndexFile : public ::testing::Test {
 protected:
  std::vector<int> read(const std::string& text, int count = 10) {
    list_.file = folder_.write("numbers.txt", text);
    list_.where = {"scene.yaml", 3, "pins[0].vertices"};
    return numbers_of(list_, count, "vertex");
  }

  TemporaryFolder folder_;
  IndexList list_;
};

TEST_F(IndexFile, HoldsNumbersAmongBlanksCommasAndComments) {
  EXPECT_THAT(read("# left edge\n0, 3 6\n\n 9 # the corner\r\n"), ElementsAre(0, 3, 6, 9));
}

TEST_F(IndexFile, IsRefusedWithTheLineOfWhatIsNoNumber) {
  for (const char* word : {"-1", "1.5", "two", "99999999999"}) {
    const InputError error = input_error_of([&] { read(std::string("0\n1 ") + word + "\n"); });
    EXPECT_EQ(error.where().file, list_.file.string());
    EXPECT_EQ(error.where().line, 2);
    EXPECT_THAT(error.problem(), HasSubstr(word));
  }
}

TEST_F(IndexFile, IsRefusedWithTheLineOfANumberOfNothing) {
  const InputError error = input_error_of([&] { read("0\n1\n10\n"); });
  EXPECT_EQ(error.where().line, 3);
  EXPECT_EQ(error.problem(), "there is no vertex 10");
}

TEST_F(IndexFile, IsRefusedWhereTheSceneNamesItWhenItIsEmpty) {
  const InputError error = input_error_of([&] { read("# nothing\n"); });
  EXPECT_EQ(error.where().line, 3);
  EXPECT_THAT(error.problem(), HasSubstr("lists no vertex"));
}

}  // namespace
}  // namespace pliant
