// All rooted trees up to an order, each as an earlier tree with one more branch: weights are then products.
#pragma once

#include "integrators/stepper.hpp"

namespace odemark {

struct BranchedTree {
  static constexpr std::size_t none = std::size_t(-1);
  // this tree is the tree `rest` with `branch` grown on its root; none for the single node
  std::size_t rest = none, branch = none;
  int order = 1, branches = 0;
  int equal_branches = 0;               // how many branches equal the last one
  Coefficient gamma = 1, symmetry = 1;  // density and order of the symmetry group
};

/// Ordered by order. Every tree once: branches are grown in descending order of their place in the list.
inline std::vector<BranchedTree> rooted_trees(int highest) {
  std::vector<BranchedTree> trees(1);
  std::vector<std::size_t> first{0, 0, 1};  // first[n]: where order n begins
  for (int order = 2; order <= highest; ++order) {
    for (int size = 1; size < order; ++size)
      for (std::size_t branch = first[std::size_t(size)]; branch < first[std::size_t(size) + 1]; ++branch)
        for (std::size_t rest = first[std::size_t(order - size)]; rest < first[std::size_t(order - size) + 1];
             ++rest) {
          const BranchedTree r = trees[rest], b = trees[branch];
          if (r.branches > 0 && branch > r.branch) continue;
          BranchedTree t;
          t.rest = rest, t.branch = branch, t.order = order, t.branches = r.branches + 1;
          t.equal_branches = r.branches > 0 && r.branch == branch ? r.equal_branches + 1 : 1;
          t.gamma = r.gamma / Coefficient(r.order) * b.gamma * Coefficient(order);
          t.symmetry = r.symmetry * b.symmetry * Coefficient(t.equal_branches);
          trees.push_back(t);
        }
    first.push_back(trees.size());
  }
  return trees;
}

}  // namespace odemark
