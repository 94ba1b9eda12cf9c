#include "clients/cli/actions/actions.h"
#include "clients/cli/terminal/files.h"

namespace pelage {

namespace {

using Perform = ExitCode (*)(Session&);

/// Returns the function for an action; null for actions that need no session, which main.cpp handles.
Perform action_of(Action action) {
  switch (action) {
    case Action::wait: return wait_for_server;
    case Action::get: return get_address;
    case Action::create: return create_scene;
    case Action::load: return load_model;
    case Action::environment: return load_environment;
    case Action::skin_texture: return load_skin_texture;
    case Action::get_map: return get_map;
    case Action::put_map: return put_map;
    case Action::put_picture: return put_picture;
    case Action::guides: return follow_guides;
    case Action::run: return run_file;
    case Action::frame: return draw_frame;
    case Action::export_fur: return export_fur;
    case Action::open_saved: return open_saved;
    case Action::undo:
    case Action::redo:
    case Action::revert: return move_in_history;
    case Action::amend: return amend_step;
    case Action::branch: return branch_scene;
    case Action::log: return show_log;
    case Action::pick: return pick_position;
    case Action::list: return list_scenes;
    case Action::remove: return remove_scene;
    case Action::info: return describe_scene;
    case Action::subdivide: return subdivide_model;
    case Action::turn: return turn_model;
    case Action::rename: return rename_scene;
    default: return nullptr;
  }
}

/// Checks that the output file can be written before the server computes its content.
Status check_outputs(const Options& options) {
  const bool writes =
      options.action == Action::frame || options.action == Action::export_fur || options.action == Action::get_map;
  if (writes && !options.dry_run) return check_output(options.output);
  if (options.action == Action::pick && !options.places.empty()) return check_output(options.places);
  return {};
}

}  // namespace

ExitCode perform(Session& session) {
  if (const Status bad = check_outputs(session.options()); !bad.ok()) return report(bad);
  const Perform action = action_of(session.options().action);
  return action ? action(session) : failed;
}

}  // namespace pelage
