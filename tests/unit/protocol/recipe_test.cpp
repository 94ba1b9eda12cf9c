// Recipes: variables, included recipes, positions, and refusals with their pointers.
#include "protocol/recipes/recipe.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "clients/cli/recipe/gather.h"

namespace pelage {
namespace {

using Files = std::map<std::string, std::string>;
using Variables = std::vector<std::pair<std::string, std::string>>;

Result<PickAnswer> no_picks(const PickRequest&) { return failure(Code::invalid, "There is no scene."); }

Result<std::vector<FilledStep>> filled(const Files& files, const Variables& variables = {}) {
  const auto read = [&files](const std::string& name) -> Result<std::string> {
    const auto file = files.find(name);
    if (file == files.end()) return failure(Code::not_found, "Cannot read " + name + ".");
    return file->second;
  };
  const auto request = gather_recipe({"main.json", files.at("main.json"), variables}, read);
  if (!request) return request.status();
  return fill_recipe(*request, {{{-1, 0, 10}, {1, 4, 30}}, no_picks});
}

std::vector<std::string> texts(const Files& files, const Variables& variables = {}) {
  const auto steps = filled(files, variables);
  EXPECT_TRUE(steps.ok()) << (steps ? "" : steps.status().message);
  std::vector<std::string> all;
  if (steps) {
    for (const FilledStep& step : *steps) all.push_back(step.text);
  }
  return all;
}

void expect_refusal(const Files& files, const std::string& pointer, const std::string& words,
                    const Variables& variables = {}) {
  const auto steps = filled(files, variables);
  ASSERT_FALSE(steps.ok()) << words;
  EXPECT_EQ(pointer_in_file(steps.status().pointer), pointer) << steps.status().message;
  EXPECT_NE(steps.status().message.find(words), std::string::npos) << steps.status().message;
}

TEST(Recipe, IsDistinguishedFromCommands) {
  EXPECT_TRUE(is_recipe(R"({"steps": []})"));
  EXPECT_TRUE(is_recipe(R"({"include": []})"));
  EXPECT_FALSE(is_recipe(R"({"op": "comb"})"));
  EXPECT_FALSE(is_recipe(R"({"commands": []})"));
  EXPECT_FALSE(is_recipe(R"([{"steps": []}])"));
  EXPECT_FALSE(is_recipe("{\"op\": \"a\"}\n{\"op\": \"b\"}\n"));
  EXPECT_FALSE(is_recipe("{"));
}

TEST(Recipe, FillsVariablesOfEveryType) {
  const Files files = {
      {"main.json",
       R"({"description": "d", "variables": {"n": 0.25, "list": [1, "${n}"], "word": "lift", "both": "x ${word} ${n}"},
    "steps": [{"op": "${word}", "a": "${n}", "b": "${list}", "c": "${both}", "d": {"e": "is ${word}"}}]})"}};
  EXPECT_EQ(texts(files),
            std::vector<std::string>{R"({"a":0.25,"b":[1,0.25],"c":"x lift 0.25","d":{"e":"is lift"},"op":"lift"})"});
}

TEST(Recipe, TakesWhatTheUserSetsAsJsonOrElseAsText) {
  const Files files = {
      {"main.json",
       R"({"variables": {"a": 1, "b": 2, "c": "${a}"}, "steps": [{"op": "x", "a": "${a}", "b": "${b}", "c": "${c}"}]})"}};
  EXPECT_EQ(texts(files, {{"a", "[1, 2]"}, {"b", "plain words"}}),
            std::vector<std::string>{R"({"a":[1,2],"b":"plain words","c":[1,2],"op":"x"})"});
  EXPECT_EQ(texts(files, {{"a", ".5"}, {"b", "+2"}}), std::vector<std::string>{R"({"a":0.5,"b":2,"c":0.5,"op":"x"})"});
  EXPECT_EQ(texts(files, {{"a", "+."}, {"b", "1.2.3"}}),
            std::vector<std::string>{R"({"a":"+.","b":"1.2.3","c":"+.","op":"x"})"});
  expect_refusal(files, "/variables/aa", "\"aa\"", {{"aa", "1"}});
}

TEST(Recipe, NamesPositionsByTheirShareOfTheBox) {
  const Files files = {{"main.json", R"({"variables": {"nose": [0.5, 1, 0]}, "steps": [
    {"op": "x", "a": {"at": [0, 0, 0]}, "b": {"at": "${nose}", "by": [0.25, -0.5, 1]}, "ramp": [{"at": 0.5}, {"at": 1, "colour": "#fff"}]}]})"}};
  EXPECT_EQ(texts(files),
            std::vector<std::string>{
                R"({"a":[-1.0,0.0,10.0],"b":[0.5,2.0,30.0],"op":"x","ramp":[{"at":0.5},{"at":1,"colour":"#fff"}]})"});
  expect_refusal({{"main.json", R"({"steps": [{"op": "x", "a": {"at": [0, 0]}}]})"}}, "/steps/0/a", "three shares");
  expect_refusal({{"main.json", R"({"steps": [{"op": "x", "a": {"at": [0, 0, 0], "by": 1}}]})"}}, "/steps/0/a",
                 "three shares");
}

TEST(Recipe, UsesFilesWithValuesOfTheirVariables) {
  const Files files = {
      {"main.json", R"({"variables": {"n": 7}, "include": ["parts/ear.json"], "steps": [
         {"comment": "nothing"}, {"use": "ear"}, {"use": "ear", "with": {"a": "${n}"}, "comment": "two"}]})"},
      {"parts/ear.json",
       R"({"variables": {"a": 1, "n": 2}, "include": ["../tip.json"], "steps": [{"op": "x", "a": "${a}", "n": "${n}"}, {"use": "tip"}]})"},
      {"tip.json", R"({"steps": [{"commands": [{"op": "y"}]}]})"}};
  EXPECT_EQ(texts(files), (std::vector<std::string>{R"({"a":1,"n":2,"op":"x"})", R"({"commands":[{"op":"y"}]})",
                                                    R"({"a":7,"n":2,"op":"x"})", R"({"commands":[{"op":"y"}]})"}));
  const auto steps = filled(files);
  EXPECT_EQ(steps->at(0).file, "parts/ear.json");
  EXPECT_EQ(steps->at(0).pointer, "/files/parts~1ear.json/steps/0");
  EXPECT_EQ(steps->at(3).file, "tip.json");
}

TEST(Recipe, RefusesWithFileAndPointer) {
  const auto one = [](const std::string& text) { return Files{{"main.json", text}}; };
  expect_refusal(one("{"), "", "main.json");
  expect_refusal(one("[]"), "", "object");
  expect_refusal(one(R"({"variables": {}})"), "/steps", "missing");
  expect_refusal(one(R"({"step": [], "steps": []})"), "/step", "\"step\"");
  expect_refusal(one(R"({"steps": {}})"), "/steps", "type");
  expect_refusal(one(R"({"steps": []})"), "/steps", "no commands");
  expect_refusal(one(R"({"steps": [1]})"), "/steps/0", "object");
  expect_refusal(one(R"({"steps": [{"comment": "a", "b": 1}]})"), "/steps/0", "A step is");
  expect_refusal(one(R"({"steps": [{"op": "x", "y": [0, "${z}"]}]})"), "/steps/0/y/1", "\"z\"");
  expect_refusal(one(R"({"steps": [{"op": "${x"}]})"), "/steps/0/op", "closed");
  expect_refusal(one(R"({"variables": {"a": [1]}, "steps": [{"op": "a ${a}"}]})"), "/steps/0/op", "within a text");
  expect_refusal(one(R"({"steps": [{"use": "ear"}]})"), "/steps/0/use", "\"ear\"");
  expect_refusal(one(R"({"steps": [{"use": 1}]})"), "/steps/0/use", "A use");
  expect_refusal(one(R"({"include": ["none.json"], "steps": []})"), "/include/0", "none.json");
  expect_refusal(one(R"({"include": ["/etc/x.json"], "steps": []})"), "/include/0", "folder");
  expect_refusal(one(R"({"include": [1], "steps": []})"), "/include/0", "folder");
  expect_refusal({{"main.json", R"({"include": ["a.json"], "steps": [{"use": "a", "with": {"lenght": 1}}]})"},
                  {"a.json", R"({"variables": {"length": 1}, "steps": []})"}},
                 "/steps/0/with/lenght", "a.json");
  expect_refusal({{"main.json", R"({"include": ["a.json"], "steps": [{"use": "a"}]})"},
                  {"a.json", R"({"steps": [{"op": "${q}"}]})"}},
                 "/steps/0/op", "a.json");
  expect_refusal({{"main.json", R"({"include": ["a.json", "b/a.json"], "steps": []})"},
                  {"a.json", R"({"steps": []})"},
                  {"b/a.json", R"({"steps": []})"}},
                 "/include/1", "called");
}

TEST(Recipe, RefusesCirclesAndDepth) {
  expect_refusal({{"main.json", R"({"include": ["a.json"], "steps": []})"},
                  {"a.json", R"({"include": ["./b/../main.json"], "steps": []})"}},
                 "/include/0", "main.json -> a.json -> main.json");
  expect_refusal({{"main.json", R"({"variables": {"a": "${b}", "b": "${a}"}, "steps": [{"op": "${a}"}]})"}},
                 "/variables/b", "circle");
  Files chain;
  for (int k = 0; k <= recipe_depth; ++k) {
    chain[k == 0 ? "main.json" : "f" + std::to_string(k) + ".json"] =
        R"({"include": ["f)" + std::to_string(k + 1) + R"(.json"], "steps": []})";
  }
  chain["f" + std::to_string(recipe_depth + 1) + ".json"] = R"({"steps": []})";
  expect_refusal(chain, "/include/0", "too deeply");
}

TEST(Recipe, CountsTheBytesOfTexts) {
  std::string uses;
  for (int k = 0; k < 2000; ++k) uses += std::string(k ? ", " : "") + R"({"op": "${long}"})";
  const auto steps = filled(
      {{"main.json", R"({"variables": {"long": ")" + std::string(10'000, 'a') + R"("}, "steps": [)" + uses + "]}"}});
  ASSERT_FALSE(steps.ok());
  EXPECT_EQ(steps.status().limit, "at most 1000000 values");
  std::string list = "1";
  for (int k = 1; k < 3000; ++k) list += ",1";
  const auto keys = filled({{"main.json", R"({"steps": [{"for": {"k": [)" + list + R"(]}, "steps": [{"op": "x", ")" +
                                              std::string(10'000, 'k') + R"(": 1}]}]})"}});
  ASSERT_FALSE(keys.ok()) << "names count as texts do";
  EXPECT_EQ(keys.status().limit, "at most 1000000 values");
}

TEST(Recipe, RefusesWhatGrowsWithoutEnd) {
  std::string variables = R"("v0": [1, 1, 1, 1, 1, 1, 1, 1, 1, 1])";
  for (int k = 1; k < 10; ++k) {
    variables += ", \"v" + std::to_string(k) + "\": [";
    for (int j = 0; j < 10; ++j) variables += std::string(j ? ", " : "") + "\"${v" + std::to_string(k - 1) + "}\"";
    variables += "]";
  }
  const auto steps = filled({{"main.json", "{\"variables\": {" + variables + R"(}, "steps": [{"op": "${v9}"}]})"}});
  ASSERT_FALSE(steps.ok());
  EXPECT_EQ(steps.status().limit, "at most 1000000 values");

  Files files = {{"f4.json", R"({"steps": [{"op": "x"}]})"}};
  for (int k = 3; k >= 0; --k) {
    const std::string next = "f" + std::to_string(k + 1);
    std::string uses;
    for (int j = 0; j < 20; ++j) uses += std::string(j ? ", " : "") + "{\"use\": \"" + next + "\"}";
    files[k == 0 ? "main.json" : "f" + std::to_string(k) + ".json"] =
        "{\"include\": [\"" + next + ".json\"], \"steps\": [" + uses + "]}";
  }
  const auto many = filled(files);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.status().limit, "at most 10000");
}

const std::filesystem::path source_folder = PELAGE_SOURCE_DIR;

Result<std::string> file_text(const std::string& name) {
  std::ifstream file(name);
  if (!file) return failure(Code::not_found, "Cannot read " + name + ".");
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

Result<std::vector<RecipeStep>> expanded(const std::string& file, const std::string& text) {
  const auto request = gather_recipe({file, text}, file_text);
  if (!request) return request.status();
  return expand_recipe(*request, {{{-1, -1, -1}, {1, 1, 1}}, no_picks});
}

TEST(Recipe, RefusesWhatNoCommandIsWithItsPointerInTheRequest) {
  const auto steps = expanded(
      "main.json", R"({"steps": [{"comment": "none"}, {"op": "lift", "flood": true, "brush": {"raduis": 1}}]})");
  ASSERT_FALSE(steps.ok());
  EXPECT_EQ(steps.status().pointer, "/recipe/steps/1/brush/raduis");
  EXPECT_EQ(steps.status().nearest, "radius");
}

TEST(Recipe, TheOneInTheDocumentationWorks) {
  const std::string page = *file_text((source_folder / "docs/recipes.md").string());
  const std::size_t begin = page.find("```json") + 7;
  const std::string text = page.substr(begin, page.find("```", begin) - begin);
  const std::string name = (source_folder / "clients/recipes/example.json").string();
  const auto steps = expanded(name, text);
  ASSERT_TRUE(steps.ok()) << steps.status().message << " " << steps.status().pointer;
  EXPECT_EQ(steps->size(), 3u);
}

TEST(Recipe, ThoseOfTheClientAreAtMostSixtyCommandsThatTheServerTakes) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder / "clients/recipes")) {
    if (entry.is_directory()) continue;  // recipes with picks need a server (grooming/test_recipes.py)
    ++count;
    const std::string name = entry.path().string();
    const auto steps = expanded(name, *file_text(name));
    ASSERT_TRUE(steps.ok()) << steps.status().message << " " << steps.status().pointer;
    std::size_t commands = 0;
    for (const RecipeStep& step : *steps) commands += step.commands.size();
    EXPECT_LE(commands, 60u) << name;
  }
  EXPECT_GE(count, 5);
}

}  // namespace
}  // namespace pelage
