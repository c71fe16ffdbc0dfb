// What a reader of the numbers must know of this machine and of the libraries measured beside the suite.
#pragma once

#include <string>
#include <vector>

namespace odemark {

struct Diagnosis {
  std::string id;
  bool applies = false;
  std::string measured, advice;
  std::vector<std::string> affects;  // methods
};

/// Clock source and load, frequency governor, denormals, contraction, and every check of the third-party
/// solvers.
std::vector<Diagnosis> diagnose();

/// One footnote per finding that affects methods; goes into the header of a results file.
std::vector<std::string> footnotes();

}  // namespace odemark
