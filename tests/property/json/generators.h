// Random requests, answers and their parts, each within its limits and often at their ends.
#pragma once

#include <rapidcheck.h>

#include "protocol/commands/command.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/history.h"
#include "protocol/commands/scene.h"
#include "protocol/commands/settings.h"

namespace pelage::testing {

/// A number of any magnitude within a range.
double number(double low, double high);

template <class E>
E one_of(E last) {
  return static_cast<E>(*rc::gen::inRange(0, static_cast<int>(last) + 1));
}

glm::dvec3 direction();  // not 0
glm::vec3 colour();
Camera camera();
Stroke random_stroke();
NewScene new_scene();
FrameRequest frame_request();
BranchRequest branch_request();
AmendRequest amend_request();
Command set_coat();
Command set_environment();
Command set_skin_texture();
/// Any kind of command.
Command command();
/// A random answer; T is one of the structs of decode_answers.h.
template <class T>
T answer();

}  // namespace pelage::testing
