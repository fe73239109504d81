// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/bed.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::fluid {
namespace {

template <class T>
void fill(std::vector<T>& field, std::size_t own, const T& value) {
  if (field.empty()) field.assign(own, value);
}

}  // namespace

Bed filled(const Bed& bed, std::size_t own) {
  Bed all = bed;
  fill(all.eps, own, 1.0);
  fill(all.exchange, own, 0.0);
  fill(all.u_solid, own, Vec3{});
  fill(all.source, own, 0.0);
  fill(all.force, own, Vec3{});
  for (const auto size : {all.eps.size(), all.exchange.size(), all.u_solid.size(),
                          all.source.size(), all.force.size()}) {
    if (size == own) continue;
    throw ValueError(
        fmt::format("a field of the bed has {} values; this rank owns {} cells", size, own));
  }
  return all;
}

void check(const Bed& bed, const Domain& domain, double time) {
  for (std::size_t c = 0; c < domain.own(); ++c) {
    const auto& x = domain.part.center[c];
    const double eps = bed.eps[c];
    if (!(eps > 0.0 && eps <= 1.0)) {
      throw DivergenceError(fmt::format(
          "void fraction {} in cell {} at ({:.6g}, {:.6g}, {:.6g}) m, {:.6g} s; it must be above 0 "
          "and at most 1",
          eps, domain.part.cell[c], x.x, x.y, x.z, time));
    }
    if (!(bed.exchange[c] >= 0.0 && std::isfinite(bed.exchange[c]))) {
      throw DivergenceError(fmt::format(
          "exchange coefficient {} kg/(m3 s) in cell {} at ({:.6g}, {:.6g}, {:.6g}) m, {:.6g} s; "
          "drag cannot drive",
          bed.exchange[c], domain.part.cell[c], x.x, x.y, x.z, time));
    }
  }
}

}  // namespace packbed::fluid
