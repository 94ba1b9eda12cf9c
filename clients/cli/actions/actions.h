// The action of each subcommand. Each prints its result and returns the exit code.
#pragma once

#include "clients/cli/session.h"

namespace pelage {

ExitCode perform(Session& session);

ExitCode wait_for_server(Session& session);
ExitCode get_address(Session& session);
ExitCode create_scene(Session& session);
ExitCode load_model(Session& session);
ExitCode load_environment(Session& session);
ExitCode load_skin_texture(Session& session);
ExitCode get_map(Session& session);
ExitCode put_map(Session& session);
ExitCode put_picture(Session& session);
ExitCode follow_guides(Session& session);
ExitCode list_scenes(Session& session);
ExitCode describe_scene(Session& session);
ExitCode subdivide_model(Session& session);
ExitCode turn_model(Session& session);
ExitCode rename_scene(Session& session);
ExitCode remove_scene(Session& session);

ExitCode run_file(Session& session);
ExitCode move_in_history(Session& session);
ExitCode amend_step(Session& session);
ExitCode branch_scene(Session& session);
ExitCode show_log(Session& session);

ExitCode draw_frame(Session& session);
ExitCode pick_position(Session& session);

ExitCode export_fur(Session& session);
ExitCode open_saved(Session& session);

}  // namespace pelage
