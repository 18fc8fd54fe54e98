// What a scene file may not say: sizes, depths, characters, values that are nearly right.
#include "scene/scene_file.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <vector>

#include "base/error.hpp"
#include "parameters/list_xml.hpp"
#include "scene/read/parameters.hpp"

namespace ixos {
namespace {

std::string refusal(const std::string& xml) {
  try {
    read_scene_text(xml, "scene.xml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refused(const std::string& xml, const std::string& message) {
  const std::string found = refusal(xml);
  EXPECT_EQ(found.substr(0, message.size()), message) << found.substr(0, 500);
}

std::string repeated(std::size_t times, const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

std::string nested(std::size_t depth) {
  return repeated(depth, "<ParameterList name=\"a\">") + repeated(depth, "</ParameterList>");
}

std::string parameter(const std::string& type, const std::string& value) {
  return "<ParameterList><Parameter name=\"p\" type=\"" + type + "\" value=\"" + value + "\"/></ParameterList>";
}

TEST(SceneFileTest, DeepListsAreRefused) {
  EXPECT_EQ(refusal(nested(deepest_list)), "accepted");
  expect_refused(nested(deepest_list + 2), "scene.xml: a/a/");
  EXPECT_NE(refusal(nested(deepest_list + 2)).find("lists are nested deeper than 100 levels"), std::string::npos);
  EXPECT_NE(refusal(nested(300000)).find("lists are nested deeper than 100 levels"), std::string::npos);
  EXPECT_NE(refusal("<ParameterList><Validators>" + repeated(1000, "<v>")).find("deeper than 100"), std::string::npos);
}

TEST(SceneFileTest, LargeFilesAndFilesWithoutAnEndAreRefused) {
  expect_refused("<ParameterList name=\"" + std::string(100000000, 'x') + "\"/>",
                 "scene.xml: is larger than 16777216 bytes");
  EXPECT_THROW(read_scene_file("/dev/zero"), InputError);
}

TEST(SceneFileTest, LongNamesAreRefused) {
  expect_refused("<ParameterList><ParameterList name=\"" + std::string(256, 'x') + "\"/></ParameterList>",
                 "scene.xml: x");
  EXPECT_NE(refusal("<ParameterList><ParameterList name=\"" + std::string(256, 'x') + "\"/></ParameterList>")
                .find("is not a valid name: it has 256 bytes, at most 255 are allowed"),
            std::string::npos);
}

TEST(SceneFileTest, OnlyListsAndParametersAreAllowed) {
  expect_refused("<!DOCTYPE a [<!ENTITY x \"y\">]><ParameterList name=\"&x;\"/>",
                 "scene.xml: <!DOCTYPE is not allowed");
  expect_refused("<ParameterList>\nMesh</ParameterList>", "scene.xml: line 2 has text outside of tags: \"Mesh\"");
  expect_refused("<ParameterList><List/></ParameterList>",
                 "scene.xml:: <List> is neither <Parameter> nor <ParameterList>");
  expect_refused("<ParameterList><ParameterList/></ParameterList>",
                 "scene.xml:: <ParameterList> has no attribute \"name\"");
  expect_refused(
      "<ParameterList><Parameter name=\"p\" type=\"int\" value=\"1\"><Parameter/></Parameter></ParameterList>",
      "scene.xml: p: <Parameter> inside a parameter");
  expect_refused("<ParameterList><ParameterList name=\"a\"/>\n<ParameterList name=\"a\"/></ParameterList>",
                 "scene.xml: a is given twice");
  expect_refused("<ParameterList>\n\n<", "scene.xml: XML parse error at line 3: ");
  EXPECT_EQ(
      refusal("<?xml version=\"1.0\"?><ParameterList> <!-- a > b --> <Validators><V/></Validators></ParameterList>"),
      "accepted");
}

TEST(SceneFileTest, ControlCharactersAndBrokenTextAreRefused) {
  expect_refused("<ParameterList name=\"\xff\"/>", "scene.xml: XML parse error at line 1: not well-formed");
  expect_refused(parameter("string", "a&#10;b"), "scene.xml: p: \"a\nb\" is not of type string: byte 2");
  expect_refused("<ParameterList><ParameterList name=\"a&#9;b\"/></ParameterList>",
                 "scene.xml: a\tb: \"a\tb\" is not a valid name: it contains a control");
  expect_refused(
      "<ParameterList><ParameterList name=\"&lt;any name>\"/></ParameterList>",
      "scene.xml: <any name>: \"<any name>\" is not a valid name: it must not be enclosed in angle brackets");
  Teuchos::ParameterList scene;
  EXPECT_THROW(set_parameter(scene, scene_parameters(), "Units/Time=a\x1b[2J"), InputError);
  EXPECT_THROW(set_parameter(scene, scene_parameters(), "Linear Solver/\xff=1"), InputError);
}

TEST(SceneFileTest, ArraysHaveNoEmptyElements) {
  for (const char* value : {"{1,,2}", "{1,}", "{,}", "{,1}", "{ , }"})
    expect_refused(parameter("Array(int)", value),
                   "scene.xml: p: \"" + std::string(value) + "\" is not of type Array(int)");
  expect_refused(parameter("Array(string)", "{a,}"), "scene.xml: p: \"{a,}\" is not of type Array(string)");
  expect_refused(parameter("double", "+-1"), "scene.xml: p: \"+-1\" is not of type double");
  const Teuchos::ParameterList list = read_scene_text(parameter("Array(int)", "{ 1 ,2}"), "scene.xml");
  EXPECT_EQ(list.get<Teuchos::Array<int>>("p").toVector(), (std::vector<int>{1, 2}));
  EXPECT_TRUE(read_scene_text(parameter("Array(double)", "{ }"), "scene.xml").get<Teuchos::Array<double>>("p").empty());
}

TEST(SceneFileTest, AnyTextComesBackAsItWasWritten) {
  Teuchos::ParameterList list("\"<&>' \xc3\xa9");
  list.set("<&\"'", std::string("]]> &amp; ' \" {a, b}"));
  list.sublist("a/b").set("x", 0.1 + 0.2);
  const Teuchos::ParameterList back = read_scene_text(scene_text(list), "scene.xml");
  EXPECT_EQ(back.name(), list.name());
  EXPECT_EQ(back.get<std::string>("<&\"'"), list.get<std::string>("<&\"'"));
  EXPECT_EQ(back.sublist("a/b").get<double>("x"), 0.1 + 0.2);
}

}  // namespace
}  // namespace ixos
