#pragma once
#include "integrators/damped_euler.hpp"

namespace odemark {

inline constexpr DampedEuler engine_drag_rule{
    .id = "engine_drag_rule",
    .source =
        "Unity manual, Rigidbody drag, and Godot's linear_damp: v *= max(0, 1 - drag dt) after the forces",
    .damping = DampedEuler::Damping::drag_rule,
    .note = "terminal speed g/d - g h, and the body freezes where d h >= 1",
    .advice = "to reproduce what an engine does; not for terminal speeds or strong drag: see the note",
};

}  // namespace odemark
