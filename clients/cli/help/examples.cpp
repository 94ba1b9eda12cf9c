#include "clients/cli/help/examples.h"

#include <string_view>

namespace pelage {

namespace {

struct Example {
  std::string_view command;
  const char* line;
};

constexpr Example all_examples[] = {
    {"", "pelaged --data groom-data & pelage wait"},
    {"", "pelage new --name fox --file fox.glb"},
    {"", "pelage run fox clients/recipes/spot.json --dry-run"},
    {"", "pelage frame fox -o fox.png --quality detailed"},
    {"", "pelage export fox -o fox.usda --every 16"},
    {"wait", "pelaged --data groom-data & pelage wait --seconds 60"},
    {"get", "pelage get fox settings | jq .coat"},
    {"get", "pelage get fox 'mesh?triangles=5000' -o fox.glb"},
    {"get", "pelage get /metrics"},
    {"new", "pelage new --name fox --builtin creature --triangles 20000"},
    {"new", "pelage new --name koala --file koala.obj --front=-z"},
    {"load", "pelage load fox fox.glb --pose Run@0.3"},
    {"load", "pelage load scan scan.stl --up z --crease-degrees 40"},
    {"environment", "pelage environment fox studio.exr --intensity 1.5 --turn-degrees 90"},
    {"skin-texture", "pelage skin-texture fox skin.png"},
    {"subdivide", "pelage subdivide fox --levels 1 --masked"},
    {"turn", "pelage turn fox --up z --front -y"},
    {"list", "pelage list"},
    {"list", "pelage list --json | jq -r '.scenes[].name'"},
    {"info", "pelage info fox"},
    {"rename", "pelage rename fox \"arctic fox\""},
    {"rm", "pelage rm fox"},
    {"run", "pelage run fox groom.json --set fur=0.05"},
    {"run", "pelage run fox groom.json --dry-run"},
    {"run", "pelage run fox groom.json --watch"},
    {"run", R"(echo '{"op": "lift", "flood": true}' | pelage run fox -)"},
    {"undo", "pelage undo fox 2"},
    {"redo", "pelage redo fox"},
    {"revert", "pelage revert fox 5"},
    {"amend", "pelage amend fox 7 wider.json --dry-run"},
    {"amend", "pelage amend fox 7 --drop"},
    {"branch", "pelage branch fox \"darker fox\" --revision 7"},
    {"log", "pelage log fox"},
    {"log", "pelage log fox --lines > fox.jsonl"},
    {"frame", "pelage frame fox -o fox.png --quality detailed --camera left"},
    {"frame", "pelage frame fox -o bald.png --overlay bald"},
    {"frame", "pelage frame fox -o traced.png --progressive --for 20"},
    {"frame", "pelage frame fox -o layers.exr --aovs beauty,depth,normal"},
    {"pick", "pelage pick fox 256 200 --camera front"},
    {"pick", "pelage pick fox --farthest 0,1,0 --box 0.5,0.5,0.5,1,1,1 --as left_ear --places fox.places.json"},
    {"pick", "pelage pick fox --ray 0.5,2,0.5,0,-1,0"},
    {"compare", "pelage compare truth.exr test.exr --map error.png"},
    {"trade", "pelage trade -o trade --quick"},
    {"farm pack", "pelage farm pack fox -o fox.pelage"},
    {"farm pack", "pelage farm pack --file fox.glb --recipe groom.json -o fox.pelage"},
    {"farm submit", "pelage farm submit fox.json --engine slurm --max-parallel 20"},
    {"farm submit", "pelage farm submit fox.json --engine local"},
    {"farm submit", "pelage farm submit fox.farm"},
    {"farm status", "pelage farm status fox.farm --watch"},
    {"farm check", "pelage farm check fox.farm"},
    {"farm movie", "pelage farm movie fox.farm -o fox.mp4"},
    {"farm movie", "pelage farm movie \"out/fox.####.png\" -o fox.webp --fps 12 --width 320"},
    {"farm sheet", "pelage farm sheet fox.farm -o fox.jpg --count 12 --columns 4"},
    {"calibrate", "pelage calibrate --data groom-data"},
    {"export", "pelage export fox -o fox.usda --every 16 --widen"},
    {"export", "pelage export fox -o fox.pelage"},
    {"open", "pelage open fox.pelage --name \"another fox\""},
    {"guides", "pelage guides fox guides.usda --strength 0.8"},
    {"map get", "pelage map get fox length -o length.exr"},
    {"map put", "pelage map put fox density density.png --strength 0.5"},
    {"map upload", "pelage map upload fox mask.png"},
    {"completions", "pelage completions bash > ~/.local/share/bash-completion/completions/pelage"},
    {"completions", "pelage completions zsh > ~/.zfunc/_pelage"},
    {"completions", "pelage completions fish > ~/.config/fish/completions/pelage.fish"},
    {"man", "pelage man | man -l -"},
};

}  // namespace

std::vector<std::string> examples_of(const std::string& command) {
  std::vector<std::string> lines;
  for (const Example& example : all_examples)
    if (example.command == command) lines.emplace_back(example.line);
  return lines;
}

std::string footer_of(const std::string& command) {
  std::string footer;
  for (const std::string& line : examples_of(command)) footer += "  " + line + "\n";
  if (!footer.empty()) footer.insert(0, "Examples:\n");
  if (command.empty())
    footer += std::string("Exit codes: ") + exit_codes;
  else if (!footer.empty())
    footer.pop_back();
  return footer;
}

}  // namespace pelage
