// What a problem does over time, and what a coarse step makes of it.
#pragma once

#include "bench/data/pictures.hpp"
#include "reports/chart.hpp"

namespace odemark {

/// The exact curve and the runs of a scene; a run that leaves the picture is cut where it leaves.
Chart trajectory_chart(const Scene& scene);

}  // namespace odemark
