// Names under which other libraries and books have methods of the suite: what people type first.
#pragma once

#include <array>
#include <string_view>

namespace odemark {

struct KnownAs {
  std::string_view name, id;
};

/// Of each the method meant, or the nearest one the suite has.
inline constexpr std::array known_as{
    KnownAs{"rk45", "dormand_prince54"},
    KnownAs{"ode45", "dormand_prince54"},
    KnownAs{"dopri5", "dormand_prince54"},
    KnownAs{"dopri54", "dormand_prince54"},
    KnownAs{"dp5", "dormand_prince54"},
    KnownAs{"dopri8", "dop853"},
    KnownAs{"dopri853", "dop853"},
    KnownAs{"dp8", "dop853"},
    KnownAs{"dormand_prince853", "dop853"},
    KnownAs{"dopri87", "dormand_prince87"},
    KnownAs{"rkf45", "fehlberg45"},
    KnownAs{"rkf78", "fehlberg78"},
    KnownAs{"rkck", "cash_karp54"},
    KnownAs{"rkck54", "cash_karp54"},
    KnownAs{"tsit5", "tsitouras54"},
    KnownAs{"rk23", "bogacki_shampine32"},
    KnownAs{"ode23", "bogacki_shampine32"},
    KnownAs{"bs3", "bogacki_shampine32"},
    KnownAs{"bs23", "bogacki_shampine32"},
    KnownAs{"bs5", "bogacki_shampine54"},
    KnownAs{"ode89", "verner98"},
    KnownAs{"vern6", "verner65"},
    KnownAs{"vern7", "verner76"},
    KnownAs{"vern8", "verner87"},
    KnownAs{"vern9", "verner98"},
    KnownAs{"odex", "gragg_bulirsch_stoer"},
    KnownAs{"bulirsch_stoer", "gragg_bulirsch_stoer"},
    KnownAs{"seulex", "linearly_implicit_euler_extrapolation"},
    KnownAs{"radau5", "radau_iia5"},
    KnownAs{"ode15s", "ndf"},
    KnownAs{"lsoda", "bdf"},
    KnownAs{"vode", "bdf"},
    KnownAs{"ode23s", "rosenbrock23"},
    KnownAs{"ode23tb", "tr_bdf2"},
    KnownAs{"ode113", "adams_bashforth_moulton45"},
    KnownAs{"euler", "explicit_euler"},
    KnownAs{"forward_euler", "explicit_euler"},
    KnownAs{"backward_euler", "implicit_euler"},
    KnownAs{"symplectic_euler", "semi_implicit_euler"},
    KnownAs{"improved_euler", "heun"},
    KnownAs{"rk2", "heun"},
    KnownAs{"midpoint", "explicit_midpoint"},
    KnownAs{"trapezoidal", "implicit_trapezoid"},
    KnownAs{"crank_nicolson", "implicit_trapezoid"},
    KnownAs{"verlet", "stormer_verlet"},
    KnownAs{"velocity_verlet", "stormer_verlet"},
    KnownAs{"forest_ruth", "yoshida4"},
};

}  // namespace odemark
