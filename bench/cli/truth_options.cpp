#include "bench/cli/truth_options.hpp"

#include <fmt/format.h>

#include "reference/bad_input.hpp"

namespace odemark {

void add_truth_options(CLI::App& app, TruthCommandOptions& truth, std::vector<std::string>& presets,
                       std::string& t) {
  app.add_option("problem", presets, "preset or family; with --verify any number of presets, or none for all")
      ->option_text("PROBLEM...");
  app.add_option("--set", truth.request.settings, "parameters, like k=6e5,m=168")->option_text("SETTINGS");
  app.add_option("--t", t, "time; default: the problem's t_end")->option_text("T");
  app.add_option("--digits", truth.request.digits, "digits asked for")->option_text("N");
  app.add_flag("--exact-inputs", truth.request.exact_inputs,
               "decimals at full value instead of rounded to double");
  app.add_option("--time-limit", truth.request.time_limit_seconds, "seconds")
      ->check(CLI::PositiveNumber)
      ->option_text("S");
  auto& verify = *app.add_flag("--verify", truth.verify, "compute the stored solutions again and compare");
  const auto with_verify = [&](CLI::Option* option, const char* text) {
    option->needs(&verify)->option_text(text);
    return option;
  };
  with_verify(
      app.add_option("--sample", truth.stored.sample, "only so many of them")->check(CLI::PositiveNumber),
      "N");
  with_verify(app.add_option("--seed", truth.stored.seed, "which: the same text chooses the same"), "TEXT");
  with_verify(app.add_option("--within", truth.stored.within, "only those computed in so many seconds before")
                  ->check(CLI::PositiveNumber),
              "S");
  with_verify(app.add_option("-j,--jobs", truth.stored.jobs, "threads")->check(CLI::Range(1, 256)), "N");
}

void settle_truth(TruthCommandOptions& truth, const std::vector<std::string>& presets) {
  truth.stored.presets = presets;
  if (truth.verify) return;
  if (presets.size() != 1)
    throw BadInput(presets.empty()
                       ? "truth needs a PROBLEM: a preset or family of `odemark list --problems`"
                       : fmt::format("truth solves one problem at a time, not {}", presets.size()));
  truth.request.problem = presets[0];
}

}  // namespace odemark
