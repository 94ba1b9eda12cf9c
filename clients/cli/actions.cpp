#include "clients/cli/actions.h"

namespace pelage {

ExitCode perform(Session& session) {
  switch (session.options().action) {
    case Action::create: return create_scene(session);
    case Action::load: return load_model(session);
    case Action::environment: return load_environment(session);
    case Action::skin_texture: return load_skin_texture(session);
    case Action::get_map: return get_map(session);
    case Action::put_map: return put_map(session);
    case Action::put_picture: return put_picture(session);
    case Action::run: return run_file(session);
    case Action::frame: return draw_frame(session);
    case Action::undo:
    case Action::redo:
    case Action::revert: return move_in_history(session);
    case Action::amend: return amend_step(session);
    case Action::branch: return branch_scene(session);
    case Action::log: return show_log(session);
    case Action::pick: return pick_pixel(session);
    case Action::list: return list_scenes(session);
    case Action::remove: return remove_scene(session);
    case Action::info: return describe_scene(session);
    case Action::subdivide: return subdivide_model(session);
    case Action::compare:
    case Action::trade:
    case Action::calibrate: break;  // need no session: pelage-compare, pelage-trade and pelaged do them
  }
  return failed;
}

}  // namespace pelage
