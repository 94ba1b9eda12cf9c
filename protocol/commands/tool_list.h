// The tools, one row for each. The names on the wire, the decoder, the log and the evaluation follow from this list.
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

#include "protocol/commands/map.h"
#include "protocol/commands/tools.h"

namespace pelage {

template <class... Commands>
struct CommandList {
  template <class C>
  static constexpr bool holds = (std::is_same_v<C, Commands> || ...);
  static constexpr std::size_t count = sizeof...(Commands);
};

/// Commands that change the fields.
using Tools = CommandList<Comb,         //
                          Blow,         //
                          Attract,      //
                          Interpolate,  //
                          Flow,         //
                          Smooth,       //
                          Noise,        //
                          Unify,        //
                          Part,         //
                          Whorl,        //
                          Length,       //
                          Trim,         //
                          Lift,         //
                          Erase,        //
                          Clump,        //
                          Curl,         //
                          Paint,        //
                          ChangeMask,   //
                          ApplyMap,     //
                          Retarget>;

template <class C>
concept ToolCommand = Tools::holds<C>;

}  // namespace pelage
