// Puts the chapter page's numbers together and answers the seven claims from them.
#include "bench/chapter.hpp"

#include "bench/chapter_lab.hpp"

namespace odemark {

ChapterData chapter_data() {
  using namespace chapter;
  ChapterData data;
  data.tables = table_7_1();
  data.oscillator_k = 1, data.oscillator_m = 1, data.oscillator_dt = 0.1;
  data.figures = figures(data.oscillator_k, data.oscillator_m, data.oscillator_dt);
  data.local_errors = local_errors();
  data.listing = listing_hashes();
  data.faces = faces();
  data.growth = growth();
  data.stalls = stalls();
  data.errors = error_curves();
  data.clocks = clocks();
  data.limits = limits();
  data.doublings = doublings();
  data.equal_cost = equal_cost();
  data.listing_on_spring = listing_on_spring();
  data.memory = memory();
  data.same_step = same_step(data.errors);
  data.crossovers = crossovers(data.errors);
  data.costs = costs(data.errors);
  data.adaptive = adaptive_runs();
  data.zero_estimate = zero_estimate();
  for (int claim = 1; claim <= 7; ++claim) data.answers.at(std::size_t(claim - 1)) = answer(claim, data);
  return data;
}

}  // namespace odemark
