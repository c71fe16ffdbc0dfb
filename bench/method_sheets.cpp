#include "bench/method_sheets.hpp"

#include "bench/measured_facts.hpp"
#include "bench/stability_region.hpp"

namespace odemark {

std::vector<FactSheet> method_sheets(const std::vector<AnyMethod>& methods,
                                     const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<const AnyMethod*> ours;
  for (const auto& method : methods)
    if (method.provider == "odemark" && method.theory) ours.push_back(&method);
  std::vector<FactSheet> sheets;
  for (const auto* method : ours) {
    FactSheet sheet = fact_sheet(*method);
    sheet.measured = measure_facts(*method);
    const Theory theory = method->theory();
    if (!theory.numerator.empty() || !theory.rho.empty())
      sheet.region = stability_region(sheet.id, theory, std::nullopt, 80);
    sheets.push_back(std::move(sheet));
    if (progress) progress(sheets.size(), ours.size());
  }
  return sheets;
}

}  // namespace odemark
