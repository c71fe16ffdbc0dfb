// What each subcommand needs, and what it returns as an exit code.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "bench/plan.hpp"
#include "reference/truth_report.hpp"
#include "reference/verify_solutions.hpp"

namespace odemark {

/// 0 ran; 1 a threshold was violated; 2 a usage error; 3 the gate is incomplete; 4 a case or a reference
/// solver failed where a result was required; 130 interrupted, finished rows kept.
enum ExitCode {
  exit_ok = 0,
  exit_violated = 1,
  exit_usage = 2,
  exit_incomplete = 3,
  exit_failed = 4,
  exit_interrupted = 130
};

enum class ProgressStyle { automatic, bar, lines, none };

struct CommonOptions {
  bool quiet = false;
  ProgressStyle progress = ProgressStyle::automatic;
};

struct RunOptions : CommonOptions {
  PlanOptions plan;
  std::string output = "out";
  int jobs = 1;
  bool resume = false, stability = true;
};

struct ReportOptions : CommonOptions {
  std::string output = "out", title;
  std::string pages =
      "auto";  // of methods and families: all, those of the results (used), or as the suite is
};

struct CheckCommandOptions : CommonOptions {
  std::string output = "out", thresholds = "thresholds.toml", baseline = "baseline.json";
  std::string junit, markdown, json;
  bool github = false, strict = false;
};

struct ApproveCommandOptions : CommonOptions {
  std::string output = "out", baseline = "baseline.json", only, reason;
  bool dry_run = false, force = false;
};

struct CompareCommandOptions : CommonOptions {
  std::vector<std::string> files;
  std::string only = "changed", format = "table";
};

struct ListOptions {
  bool methods = false, problems = false, suites = false;
  std::string format = "table";
};

struct MethodsCommandOptions : CommonOptions {
  std::vector<std::string> names;
  std::string format = "table";
  bool measured = false;
};

struct StabilityCommandOptions : CommonOptions {
  std::string methods, problem, settings, format = "table";
  double dt = 0;  // 0: limits; else a verdict on this dt
  int jobs = 1;
};

struct TruthCommandOptions : CommonOptions {
  TruthRequest request;
  bool verify = false;  // the stored ones, instead of one solution
  VerifyRequest stored;
};

struct DoctorOptions {
  std::string format = "text";
};

int run_command(const Registry&, const RunOptions&, const std::atomic<bool>& stop);
int report_command(const Registry&, const ReportOptions&);
int check_command(const CheckCommandOptions&);
int approve_command(const ApproveCommandOptions&);
int compare_command(const CompareCommandOptions&);
int list_command(const Registry&, const ListOptions&);
int methods_command(const Registry&, const MethodsCommandOptions&);
int stability_command(const Registry&, const StabilityCommandOptions&);
int truth_command(const Registry&, const TruthCommandOptions&, const std::atomic<bool>& stop);
int bench_command(const std::vector<std::string>& arguments);
int doctor_command(const DoctorOptions&);

/// The whole program on a registry; what main() calls.
int odemark_main(int argc, char** argv, const Registry& registry);

}  // namespace odemark
