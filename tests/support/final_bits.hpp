// How the programs of the test same_bits_everywhere print where a run ended.
#pragma once

#include <cstdio>
#include <cstring>
#include <string_view>
#include <vector>

template <class T>
void print_bits(std::string_view problem, std::string_view method, const char* type,
                const std::vector<T>& y) {
  std::printf("%.*s/%.*s/%s", int(problem.size()), problem.data(), int(method.size()), method.data(), type);
  for (const T& x : y) {
    unsigned long long bits = 0;
    std::memcpy(&bits, &x, sizeof(T));
    std::printf(" %016llx", bits);
  }
  std::printf("\n");
}
