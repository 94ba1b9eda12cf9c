// Completions, the manual page and examples, all generated from the command line itself.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "clients/cli/help/command_tree.h"
#include "clients/cli/help/completions.h"
#include "clients/cli/help/examples.h"
#include "clients/cli/help/man.h"
#include "clients/cli/line/declare.h"
#include "clients/cli/line/flags.h"
#include "clients/cli/terminal/report.h"

namespace pelage {
namespace {

CommandHelp small_tree() {
  CLI::App app{"Does it."};
  bool json = false;  // never parsed
  app.add_flag("--json", json, "As JSON");
  CLI::App* map = app.add_subcommand("map", "Fields");
  CLI::App* get = map->add_subcommand("get", "It's a field");
  get->add_option("field", "Which")->required();
  get->add_option("-o,--output", "Where")->default_str("x.png");
  return tree_of(app);
}

/// The whole command line, without `parse_line`, which prints.
struct WholeLine {
  CLI::App app{"Grooms."};
  Options options;
  WholeLine() { declare_line(app, options); }
};

/// Splits a shell line into words, up to a pipe or a redirection. Quotes hold words together.
std::vector<std::string> words_of_line(std::string line) {
  if (const std::size_t pipe = line.rfind("| pelage"); pipe != std::string::npos) line.erase(0, pipe + 2);
  std::vector<std::string> words(1);
  char quote = 0;
  for (const char c : line) {
    if (!quote && (c == '>' || c == '|' || c == '&')) break;
    if (c == quote)
      quote = 0;
    else if (!quote && (c == '"' || c == '\''))
      quote = c;
    else if (!quote && c == ' ')
      words.emplace_back();
    else
      words.back() += c;
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

TEST(CommandTree, HasCommandsOptionsAndArguments) {
  const CommandHelp root = small_tree();
  const auto all = all_commands(root);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[2]->name, "map get");
  ASSERT_EQ(all[2]->arguments.size(), 1u);
  EXPECT_EQ(all[2]->arguments[0].names, std::vector<std::string>{"field"});
  EXPECT_TRUE(all[2]->arguments[0].required);
  ASSERT_EQ(all[2]->options.size(), 2u);  // with --help
  EXPECT_EQ(all[2]->options[1].names, (std::vector<std::string>{"-o", "--output"}));
  EXPECT_TRUE(all[2]->options[1].takes_value);
  EXPECT_EQ(all[2]->options[1].default_value, "x.png");
  EXPECT_FALSE(all[0]->options[1].takes_value);
}

TEST(Completions, NameWhatCanComeNext) {
  const CommandHelp root = small_tree();
  const std::string bash = bash_completions(root);
  EXPECT_NE(bash.find("'map' | 'map get') named="), std::string::npos) << bash;
  EXPECT_NE(bash.find("'map get') words='-h --help -o --output --json' ;;"), std::string::npos) << bash;
  EXPECT_NE(bash.find("'') words='map -h --help --json' ;;"), std::string::npos) << bash;
  EXPECT_NE(zsh_completions(root).find(R"('get:It'\''s a field')"), std::string::npos) << zsh_completions(root);
  const std::string fish = fish_completions(root);
  EXPECT_NE(fish.find(R"(-f -a get -d 'It\'s a field')"), std::string::npos) << fish;
  EXPECT_NE(fish.find("complete -c pelage -n '__fish_seen_subcommand_from map; and __fish_seen_subcommand_from get' "
                      "-s o -l output -r -d 'Where'"),
            std::string::npos)
      << fish;
}

TEST(ManPage, HasEachCommandWithItsOptions) {
  const std::string page = man_page(small_tree(), "pelage 1.2.3");
  EXPECT_EQ(page.find(".TH PELAGE 1 \"\" \"pelage 1.2.3\""), 0u);
  EXPECT_NE(page.find(".SS map get\n.B pelage map get [OPTIONS] FIELD\n"), std::string::npos) << page;
  EXPECT_NE(page.find(".B \\-o VALUE, \\-\\-output VALUE\nWhere [x.png]\n"), std::string::npos) << page;
  EXPECT_EQ(page.find("\n'"), std::string::npos);  // roff would take it for a request
}

TEST(Examples, EachCommandHasSomeThatItTakes) {
  const CommandHelp root = tree_of(WholeLine().app);
  for (const CommandHelp* command : all_commands(root)) {
    if (!command->commands.empty() && !command->name.empty()) continue;  // skips groups
    EXPECT_FALSE(examples_of(command->name).empty()) << command->name;
    for (const std::string& line : examples_of(command->name)) {
      std::vector<std::string> words = words_of_line(line);
      if (words.front() != "pelage") continue;
      WholeLine whole;
      std::reverse(words.begin(), words.end());
      words.pop_back();
      EXPECT_NO_THROW(whole.app.parse(words)) << line;
    }
  }
}

TEST(Flags, AreFoundByTheMemberThatTheyGive) {
  WholeLine whole;
  whole.app.parse("frame fox --fov 30 --from 3", false);
  const auto flags = flags_of(whole.app);
  EXPECT_EQ(flags.at("fov_degrees"), "--fov");
  EXPECT_EQ(flags.at("max_seconds"), "--max-seconds");
  EXPECT_EQ(flags.at("overlay_from"), "--from");
  WholeLine run;
  run.app.parse("run fox groom.json", false);
  EXPECT_TRUE(flags_of(run.app).empty());
}

TEST(Report, NamesTheFlagOfAMemberAndElseTheMember) {
  set_report_style({.json = false, .flags = {{"width", "--width"}}});
  testing::internal::CaptureStderr();
  EXPECT_EQ(report(failure(Code::invalid, "Too wide.", "/view/width", "at most 8192")), refused);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("  flag:    --width\n"), std::string::npos);
  testing::internal::CaptureStderr();
  report(failure(Code::invalid, "Too long.", "/brush/radius/0"));
  EXPECT_NE(testing::internal::GetCapturedStderr().find("  field:   /brush/radius/0\n"), std::string::npos);
  set_report_style({.json = true, .flags = {{"pixel", "x"}}});
  testing::internal::CaptureStderr();
  report(failure(Code::invalid, "Outside.", "/pixel/0"), "step 3");
  const std::string json = testing::internal::GetCapturedStderr();
  for (const char* member : {"\"status\":422", "\"pointer\":\"/pixel/0\"", "\"flag\":\"x\"", "\"context\":\"step 3\"",
                             "\"next\":\"", "urn:pelage:problem:invalid"})
    EXPECT_NE(json.find(member), std::string::npos) << member << " " << json;
  EXPECT_EQ(json.find('\n'), json.size() - 1);
  set_report_style({});
}

}  // namespace
}  // namespace pelage
