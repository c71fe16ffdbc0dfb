// Gaussian elimination with row pivoting, for any number type.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace odemark {

template <class T>
class WideLu {
 public:
  /// `matrix` is row by row. Returns false where it is singular to working precision or not finite.
  bool factor(std::vector<T> matrix, std::size_t size) {
    using std::abs, std::isfinite;
    m_ = std::move(matrix), n_ = size, pivots_.resize(size);
    for (std::size_t k = 0; k < n_; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < n_; ++i)
        if (abs(at(i, k)) > abs(at(pivot, k))) pivot = i;
      pivots_[k] = pivot;
      if (at(pivot, k) == 0 || !isfinite(at(pivot, k))) return false;
      if (pivot != k)
        for (std::size_t j = 0; j < n_; ++j) std::swap(at(k, j), at(pivot, j));
      for (std::size_t i = k + 1; i < n_; ++i) {
        if (at(i, k) == 0) continue;
        const T factor = at(i, k) /= at(k, k);
        for (std::size_t j = k + 1; j < n_; ++j) at(i, j) -= factor * at(k, j);
      }
    }
    return true;
  }
  void solve(T* x) const {
    for (std::size_t k = 0; k < n_; ++k)
      if (pivots_[k] != k) std::swap(x[k], x[pivots_[k]]);
    for (std::size_t i = 1; i < n_; ++i)
      for (std::size_t j = 0; j < i; ++j) x[i] -= at(i, j) * x[j];
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t j = i + 1; j < n_; ++j) x[i] -= at(i, j) * x[j];
      x[i] /= at(i, i);
    }
  }

 private:
  T& at(std::size_t i, std::size_t j) { return m_[i * n_ + j]; }
  const T& at(std::size_t i, std::size_t j) const { return m_[i * n_ + j]; }
  std::vector<T> m_;
  std::size_t n_ = 0;
  std::vector<std::size_t> pivots_;
};

}  // namespace odemark
