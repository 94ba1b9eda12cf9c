// Rules about which members of a struct go together, which its list of members does not state. A rule refuses the value
// that the struct was read from; structs without rules pass.
#pragma once

#include "protocol/commands/command.h"
#include "protocol/commands/export.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/job.h"
#include "protocol/commands/map.h"
#include "protocol/commands/pick.h"
#include "protocol/commands/quality.h"
#include "protocol/commands/scene.h"
#include "protocol/json/reader.h"

namespace pelage::json_parts {

/// Sets members whose default depends on the members that were given.
template <class T>
void set_dependent_defaults(const Value&, T&) {}
void set_dependent_defaults(const Value& value, Camera& camera);
void set_dependent_defaults(const Value& value, Tracing& tracing);

template <class T>
void check(const Value&, const T&) {}
void check(const Value& value, const Camera& camera);
void check(const Value& value, const Stroke& stroke);
void check(const Value& value, const Coat& coat);
void check(const Value& value, const Environment& environment);
void check(const Value& value, const Eye& eye);
void check(const Value& value, const Tracing& tracing);
void check(const Value& value, const Knobs& knobs);
void check(const Value& value, const FrameRequest& request);
void check(const Value& value, const PickFarthest& farthest);
void check(const Value& value, const ImportOptions& options);
void check(const Value& value, const MapRequest& map);
void check(const Value& value, const ExportRequest& wanted);
void check(const Value& value, const MapUpload& map);
void check(const Value& value, const ParameterKeys& keys);
void check(const Value& value, const RenderJob& job);

void check_command(const Value& value, const Command& command);

/// Refuses a number that is no UDIM tile, and any tile of a list of vertices.
void refuse_tile(const Value& value, int tile, MapEncoding encoding);

/// Refuses a map of the field in an encoding that cannot hold it.
void refuse_encoding(const Value& value, Field field, MapEncoding encoding);

}  // namespace pelage::json_parts
