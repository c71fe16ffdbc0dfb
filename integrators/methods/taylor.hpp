#pragma once
#include "integrators/taylor_method.hpp"

namespace odemark {

namespace detail {
constexpr Taylor taylor_of_order(std::string_view id, int order) {
  return {id, "R. Barrio, Appl. Math. Comput. 163 (2005) 525-545; the chapter's own series, carried on",
          order, order - 1};
}
}  // namespace detail

inline constexpr Taylor taylor1 = detail::taylor_of_order("taylor1", 1);
inline constexpr Taylor taylor2 = detail::taylor_of_order("taylor2", 2);
inline constexpr Taylor taylor3 = detail::taylor_of_order("taylor3", 3);
inline constexpr Taylor taylor4 = detail::taylor_of_order("taylor4", 4);
inline constexpr Taylor taylor5 = detail::taylor_of_order("taylor5", 5);
inline constexpr Taylor taylor6 = detail::taylor_of_order("taylor6", 6);
inline constexpr Taylor taylor7 = detail::taylor_of_order("taylor7", 7);
inline constexpr Taylor taylor8 = detail::taylor_of_order("taylor8", 8);
inline constexpr Taylor taylor9 = detail::taylor_of_order("taylor9", 9);
inline constexpr Taylor taylor10 = detail::taylor_of_order("taylor10", 10);
inline constexpr Taylor taylor11 = detail::taylor_of_order("taylor11", 11);
inline constexpr Taylor taylor12 = detail::taylor_of_order("taylor12", 12);
inline constexpr Taylor taylor13 = detail::taylor_of_order("taylor13", 13);
inline constexpr Taylor taylor14 = detail::taylor_of_order("taylor14", 14);
inline constexpr Taylor taylor15 = detail::taylor_of_order("taylor15", 15);
inline constexpr Taylor taylor16 = detail::taylor_of_order("taylor16", 16);
inline constexpr Taylor taylor17 = detail::taylor_of_order("taylor17", 17);
inline constexpr Taylor taylor18 = detail::taylor_of_order("taylor18", 18);
inline constexpr Taylor taylor19 = detail::taylor_of_order("taylor19", 19);
inline constexpr Taylor taylor20 = detail::taylor_of_order("taylor20", 20);

}  // namespace odemark
