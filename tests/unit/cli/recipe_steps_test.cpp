// Recipes: picks, loops, expressions, asserts and files of positions.
#include <gtest/gtest.h>

#include "clients/cli/recipe/gather.h"
#include "clients/cli/recipe/places.h"
#include "protocol/json/encode.h"
#include "protocol/recipes/expression.h"
#include "protocol/recipes/recipe.h"

namespace pelage {
namespace {

/// Expands recipes for a box from (0, 0, 0) to (2, 4, 8). Picks get the next of `answers`, and their requests are kept
/// in `asked`.
struct Kitchen {
  std::vector<PickAnswer> answers;
  std::vector<std::string> asked;
  std::string places;
  std::map<std::string, std::string> files;

  Result<std::vector<FilledStep>> expand(const std::string& text) {
    const auto read = [this](const std::string& name) { return Result<std::string>(files.at(name)); };
    const auto request = gather_recipe({"main.json", text, {}, places}, read);
    if (!request) return request.status();
    return fill_recipe(*request, {{{0, 0, 0}, {2, 4, 8}}, [this](const PickRequest& pick) -> Result<PickAnswer> {
                                    asked.push_back(encode(pick));
                                    return answers.at(asked.size() - 1);
                                  }});
  }

  std::vector<std::string> texts(const std::string& text) {
    const auto steps = expand(text);
    EXPECT_TRUE(steps.ok()) << (steps ? "" : steps.status().message + steps.status().pointer);
    std::vector<std::string> all;
    if (steps)
      for (const FilledStep& step : *steps) all.push_back(step.text);
    return all;
  }

  void refuses(const std::string& text, const std::string& pointer, const std::string& words) {
    const auto steps = expand(text);
    ASSERT_FALSE(steps.ok()) << text;
    EXPECT_EQ(pointer_in_file(steps.status().pointer), pointer) << steps.status().message;
    EXPECT_NE(steps.status().message.find(words), std::string::npos) << steps.status().message;
    EXPECT_NE((steps.status().message + steps.status().limit).find("main.json"), std::string::npos);
  }
};

using Texts = std::vector<std::string>;

double worked_out(const std::string& text) {
  const auto value = evaluate(text, [](const std::string& name) -> Result<double> {
    if (name == "fur") return 0.5;
    if (name == "ear.length") return 3.0;
    return failure(Code::invalid, "no " + name);
  });
  EXPECT_TRUE(value.ok()) << text << (value ? "" : value.status().message);
  return value ? *value : -1;
}

TEST(Expressions, AreSumsAndProducts) {
  EXPECT_EQ(worked_out("fur * 0.5"), 0.25);
  EXPECT_EQ(worked_out("1 + 2 * 3 - 4 / 8"), 6.5);
  EXPECT_EQ(worked_out("-(fur + .5) * -2"), 2);
  EXPECT_EQ(worked_out("8 - 4 - 2"), 2);
  EXPECT_EQ(worked_out("2*ear.length"), 6);
  EXPECT_EQ(worked_out("1e-1 + 0"), 0.1);
}

TEST(Expressions, AreRefusedWhereTheyAreNone) {
  const auto one = [](const std::string&) { return Result<double>(1.0); };
  for (const std::string text : {"", "1 +", "(1", "1)", "1 2", "a b", "1 / 0", "* 2", "1e999", "a ^ 2", "1..2"})
    EXPECT_FALSE(evaluate(text, one).ok()) << text;
  EXPECT_TRUE(evaluate(std::string(32, '(') + "1" + std::string(32, ')'), one).ok());
  EXPECT_FALSE(evaluate(std::string(33, '(') + "1" + std::string(33, ')'), one).ok());
  EXPECT_FALSE(evaluate(std::string(100'000, '-') + "1", one).ok());
}

TEST(RecipeExpressions, StandWhereVariablesDo) {
  EXPECT_EQ(Kitchen().texts(R"({"variables": {"fur": 0.5, "n": 3, "a-b": 7, "list": [1]}, "steps": [
      {"op": "x", "a": "${fur * 2}", "b": "${n / 2}", "c": "${a-b}", "d": "is ${n + 1}", "e": ["${-fur}"]}]})"),
            Texts{R"({"a":1,"b":1.5,"c":7,"d":"is 4","e":[-0.5],"op":"x"})"});
  Kitchen().refuses(R"({"variables": {"list": [1]}, "steps": [{"op": "x", "a": "${list * 2}"}]})", "/steps/0/a",
                    "\"list\" is no number");
  Kitchen().refuses(R"({"variables": {"fur": 1}, "steps": [{"op": "x", "a": "${furr * 2}"}]})", "/steps/0/a",
                    "no variable \"furr\"");
}

TEST(RecipeLoops, GoThroughTheirLists) {
  EXPECT_EQ(Kitchen().texts(R"({"variables": {"left": [1, 0, 0], "k": "kept"}, "steps": [
      {"for": {"place": ["${left}", [0, 0, 0]], "k": [1, 2]}, "comment": "both sides",
       "steps": [{"op": "x", "at": {"at": "${place}"}, "k": "${k}"}]}, {"op": "y", "k": "${k}"}]})"),
            (Texts{R"({"at":[2.0,0.0,0.0],"k":1,"op":"x"})", R"({"at":[0.0,0.0,0.0],"k":2,"op":"x"})",
                   R"({"k":"kept","op":"y"})"}));
  const auto steps = Kitchen().expand(R"({"steps": [{"for": {"a": [1, 2]}, "steps": [{"op": "x"}]}]})");
  EXPECT_EQ(steps->at(1).pointer, "/recipe/steps/0/steps/0");
}

TEST(RecipeLoops, NestAndEndWithTheirVariables) {
  EXPECT_EQ(Kitchen().texts(R"({"steps": [{"for": {"a": [1, 2]}, "steps": [
      {"for": {"b": [3, 4]}, "steps": [{"op": "x", "v": "${a * 10 + b}"}]}]}]})"),
            (Texts{R"({"op":"x","v":13})", R"({"op":"x","v":14})", R"({"op":"x","v":23})", R"({"op":"x","v":24})"}));
  Kitchen().refuses(R"({"steps": [{"for": {"a": [1]}, "steps": []}, {"op": "x", "v": "${a}"}]})", "/steps/1/v",
                    "\"a\"");
}

TEST(RecipeLoops, AreRefusedWhereTheyAreNone) {
  const auto loop = [](const std::string& text) { return "{\"steps\": [" + text + "]}"; };
  Kitchen().refuses(loop(R"({"for": {"a": 1}, "steps": []})"), "/steps/0/for/a", "lists");
  Kitchen().refuses(loop(R"({"for": {"a": [1, 2], "b": [1]}, "steps": []})"), "/steps/0/for/b", "lists");
  Kitchen().refuses(loop(R"({"for": {}, "steps": []})"), "/steps/0/for", "variable");
  Kitchen().refuses(loop(R"({"for": {"a": [1]}})"), "/steps/0/steps", "loop");
  Kitchen().refuses(loop(R"({"for": {"a": [1]}, "steps": [], "op": "x"})"), "/steps/0/op", "loop");
}

TEST(RecipeLoops, KeepToTheLimits) {
  std::string list = "1";
  for (int k = 1; k < 200; ++k) list += ", 1";
  const std::string loops =
      R"({"for": {"a": [)" + list + R"(]}, "steps": [{"for": {"b": [)" + list + R"(]}, "steps": [)";
  Kitchen().refuses("{\"steps\": [" + loops + R"({"op": "x"}]}]}]})", "/steps/0/steps/0/steps/0", "too many steps");
  const std::string big = R"("big": [)" + list + "]";
  const auto steps =
      Kitchen().expand("{\"variables\": {" + big + "}, \"steps\": [" + loops + R"({"op": "x", "v": "${big}"}]}]}]})");
  ASSERT_FALSE(steps.ok());
  EXPECT_EQ(steps.status().limit, "at most 1000000 values");
}

TEST(RecipePicks, BecomeVariables) {
  Kitchen kitchen{{{.hit = true, .position = {1, 4, 2}, .normal = {0, 1, 0}, .length = 0.5}}, {}, "", {}};
  EXPECT_EQ(kitchen.texts(R"({"variables": {"above": {"at": "${ear}", "by": [0, 0.5, 0]}}, "steps": [
      {"comment": "the tip", "pick": {"farthest": {"direction": [0, 1, 0], "min": {"at": [0.5, 0.5, 0]}, "max": {"at": [1, 1, 1]}}},
       "as": "ear"},
      {"op": "x", "p": {"at": "${ear}"}, "n": "${ear.normal}", "l": "${ear.length * 2}", "q": "${ear.position}", "a": "${above}"}]})"),
            Texts{R"({"a":[1.0,6.0,2.0],"l":1,"n":[0.0,1.0,0.0],"op":"x","p":[1.0,4.0,2.0],"q":[1.0,4.0,2.0]})"});
  EXPECT_EQ(kitchen.asked,
            Texts{R"({"farthest":{"direction":[0.0,1.0,0.0],"min":[1.0,2.0,0.0],"max":[2.0,4.0,8.0]}})"});
}

TEST(RecipePicks, AreCheckedBeforeTheyAreSent) {
  Kitchen kitchen{{{.hit = false}}, {}, "", {}};
  kitchen.refuses(R"({"steps": [{"pick": {"nearest": [1, 2]}, "as": "a"}]})", "/steps/0/pick/nearest", "");
  kitchen.refuses(R"({"steps": [{"pick": {"nearest": [1, 2, 3]}}]})", "/steps/0/as", "pick");
  kitchen.refuses(R"({"steps": [{"pick": {"ray": {"orign": [1, 2, 3]}}, "as": "a"}]})", "/steps/0/pick/ray/origin", "");
  EXPECT_TRUE(kitchen.asked.empty());
  kitchen.refuses(R"({"steps": [{"op": "x"}, {"pick": {"nearest": [1, 2, 3]}, "as": "a"}]})", "/steps/1/pick",
                  "finds nothing");
  EXPECT_EQ(kitchen.asked.size(), 1u);
}

TEST(RecipePicks, HaveALimit) {
  std::string list = "1";
  for (std::size_t k = 0; k < recipe_picks; ++k) list += ",1";
  Kitchen kitchen{std::vector<PickAnswer>(recipe_picks, {.hit = true, .position = {1, 1, 1}}), {}, "", {}};
  kitchen.refuses(
      R"({"steps": [{"for": {"k": [)" + list + R"(]}, "steps": [{"pick": {"nearest": [1, 2, 3]}, "as": "a"}]}]})",
      "/steps/0/steps/0", "too many picks");
}

TEST(RecipePlaces, StandForVariablesAndPicks) {
  const std::string text = R"({"variables": {"nose": [0, 0, 0]}, "steps": [
      {"pick": {"farthest": {"direction": [0, 1, 0]}}, "as": "ear"}, {"op": "x", "n": "${nose}", "e": "${ear}"}]})";
  Kitchen kitchen{{{.hit = true, .position = {1, 2, 4}}}, {}, R"({"nose": [0.5, 0, 1], "ear": [0.5, 0.25, 1]})", {}};
  EXPECT_EQ(kitchen.texts(text), Texts{R"({"e":[0.5,0.5,0.5],"n":[0.5,0,1],"op":"x"})"});
  EXPECT_EQ(kitchen.asked, Texts{R"({"nearest":[1.0,1.0,8.0]})"});
  kitchen.places = R"({"nose": [1, 2]})";
  const auto refused = kitchen.expand(text);
  EXPECT_EQ(refused.status().pointer, "/places/nose");
}

TEST(RecipePlaces, OfAFileAreNotForThoseThatItUses) {
  Kitchen kitchen{{}, {}, R"({"nose": [1, 1, 1]})", {}};
  kitchen.files["part.json"] = R"({"variables": {"nose": [0, 0, 0]}, "steps": [{"op": "x", "n": "${nose}"}]})";
  EXPECT_EQ(kitchen.texts(R"({"include": ["part.json"], "steps": [{"use": "part"}]})"),
            Texts{R"({"n":[0,0,0],"op":"x"})"});
}

TEST(RecipePlaces, AreWrittenOneALine) {
  const auto first = with_place("", "nose", {0.5, 1.0 / 3, 1});
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(*first, "{\n  \"nose\": [0.5,0.333333,1.0]\n}\n");
  const auto both = with_place(*with_place(*first, "ear", {0, 0, 0}), "nose", {0, 1, 0});
  EXPECT_EQ(*both, "{\n  \"ear\": [0.0,0.0,0.0],\n  \"nose\": [0.0,1.0,0.0]\n}\n");
  EXPECT_FALSE(with_place("[1]", "nose", {0, 0, 0}).ok());
}

TEST(RecipeAsserts, AreTakenFromCommands) {
  const auto steps = Kitchen().expand(R"({"variables": {"few": 3}, "steps": [
      {"op": "x", "assert": {"min_vertices": "${few}"}},
      {"commands": [{"op": "y"}, {"op": "z", "assert": {"max_vertices": 9}}]}, {"op": "w"}]})");
  ASSERT_TRUE(steps.ok()) << steps.status().message;
  EXPECT_EQ(steps->at(0).text, R"({"op":"x"})");
  ASSERT_EQ(steps->at(0).asserts.size(), 1u);
  EXPECT_EQ(steps->at(0).asserts[0].min_vertices, 3u);
  EXPECT_EQ(steps->at(1).text, R"({"commands":[{"op":"y"},{"op":"z"}]})");
  ASSERT_EQ(steps->at(1).asserts.size(), 1u);
  EXPECT_EQ(steps->at(1).asserts[0].command, 1u);
  EXPECT_EQ(steps->at(1).asserts[0].max_vertices, 9u);
  EXPECT_TRUE(steps->at(2).asserts.empty());
}

TEST(RecipeAsserts, AreRefusedWhereTheyAreNone) {
  const auto step = [](const std::string& text) { return "{\"steps\": [" + text + "]}"; };
  Kitchen().refuses(step(R"({"op": "x", "assert": 1})"), "/steps/0/assert", "how many");
  Kitchen().refuses(step(R"({"op": "x", "assert": {"min_vertexes": 1}})"), "/steps/0/assert/min_vertexes", "not known");
  Kitchen().refuses(step(R"({"op": "x", "assert": {"min_vertices": -1}})"), "/steps/0/assert/min_vertices", "count");
  Kitchen().refuses(step(R"({"commands": [{"op": "x"}], "assert": {"min_vertices": 1}})"), "/steps/0/assert", "batch");
}

}  // namespace
}  // namespace pelage
