// SPDX-License-Identifier: BSD-3-Clause
// P9: the walls of a narrow column carry a dry bed as Janssen says, where their friction is at its limit.
#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "validation/support/settled_bed.hpp"
#include "validation/support/validation.hpp"

namespace packbed::validation {
namespace {

constexpr int beds = 4;
constexpr double diameter = 3e-3;  // of the column [m]
constexpr double wall_friction = 0.3;

/// Dry, narrow and tall, with rough walls. Grains a tenth as stiff as the resin take longer steps; they are
/// still pressed together by less than a hundredth of their size.
std::string janssen_case(int seed) {
  return fmt::format(
      "[column]\nshape = \"cylinder\"\ninner_diameter = \"3 mm\"\nheight = \"24 mm\"\n"
      "[resin]\nname = \"CM Sepharose 6FF\"\ncoarse_grain = 3\nwall_friction = 0.3\n"
      "youngs_modulus = \"3 MPa\"\n[numerics]\nseed = {}\n"
      "[[protocol]]\nstep = \"settle\"\nbed_height = \"16 mm\"\n",
      seed);
}

constexpr int planes = 20;

/// Depth of the k-th plane [m].
double plane_depth(double height, int k) { return height * (k + 1) / (planes + 0.5); }

/// What acts above planes, summed over looks.
struct Above {
  std::vector<double> force =
      std::vector<double>(planes, 0.0);  ///< through the plane, by contacts [N]
  std::vector<double> weight = std::vector<double>(planes, 0.0);  ///< of the grains above [N]
  std::vector<double> pushed =
      std::vector<double>(planes, 0.0);  ///< sum of normal forces of the wall [N]
  std::vector<double> carried =
      std::vector<double>(planes, 0.0);  ///< by the friction of the wall [N]
};

void look_above_planes(const dem::Dem& dem, double height, Above& above) {
  const auto s = dem.snapshot();
  const auto contacts = dem.touching_contacts();
  for (int k = 0; k < planes; ++k) {
    const double z = height - plane_depth(height, k);
    const auto at = static_cast<std::size_t>(k);
    for (const auto& c : contacts) {
      const bool is_above = c.x.z > z;
      if (c.id_j < 0) {
        if (is_above && std::abs(c.branch.z) < 0.5 * norm(c.branch)) {  // not the floor
          above.pushed[at] += norm(c.normal);
          above.carried[at] += c.tangential.z;
        }
        continue;
      }
      if (is_above == (c.x.z + c.branch.z > z)) continue;
      const double up_on_i = c.normal.z + c.tangential.z;
      above.force[at] += is_above ? up_on_i : -up_on_i;
    }
    for (std::size_t i = 0; i < s.beads.size(); ++i) {
      if (s.x[i].z > z) above.weight[at] += s.beads[i].weight;
    }
  }
}

/// A bed at rest to 1e-6 of its contact forces misses some 3e-6 of its weight. It rests a little longer here.
double rested_budget_error(Settled& bed) {
  bed.dem.set_background_damping(1.0 / 5e-3);
  bed.dem.run(20'000);
  bed.dem.set_background_damping(0.0);
  return budget_error(bed);
}

/// After a deposition walls are not at the limit of friction. So the tube is drawn up slowly, by a
/// grain, until it is; then forces are averaged over another grain.
Table stress_table(int seed) {
  auto bed = settle(janssen_case(seed));
  const double budget = rested_budget_error(bed);
  constexpr double pace = 1e-3;  // [m/s]
  for (auto& wall : bed.dem.walls()) {
    if (std::holds_alternative<dem::Tube>(wall.surface)) wall.velocity = {0, 0, pace};
  }
  constexpr double grain = 261e-6;
  constexpr int looks = 60;
  const auto steps = [&](double way) {
    return static_cast<std::int64_t>(way / pace / bed.dem.options().step);
  };
  bed.dem.run(steps(grain));
  const double height = height_of(bed);
  Above above;
  for (int look = 0; look < looks; ++look) {
    bed.dem.run(steps(grain / looks));
    look_above_planes(bed.dem, height, above);
  }
  Table t{.columns = {"depth_m", "force_N", "weight_above_N", "wall_normal_above_N",
                      "wall_friction_above_N", "budget_error"},
          .rows = {}};
  for (std::size_t k = 0; k < planes; ++k) {
    t.rows.push_back({plane_depth(height, static_cast<int>(k)), above.force[k] / looks,
                      above.weight[k] / looks, above.pushed[k] / looks, above.carried[k] / looks,
                      budget});
  }
  return t;
}

std::string piece(int seed) { return fmt::format("bed-{}", seed); }

std::vector<double> mean_column(const Results& results, const std::string& name) {
  std::vector<double> sum(planes, 0.0);
  for (int seed = 1; seed <= beds; ++seed) {
    const auto column = results.at(piece(seed)).column(name);
    for (std::size_t k = 0; k < planes; ++k) sum[k] += column[k] / beds;
  }
  return sum;
}

// Force through a plane under the weight W: F = W_s (1 - exp(-W / W_s)), which is Janssen's law at any density;
// W_s = A rho g D / (4 mu K) is the weight of a saturation length.
struct Deviation {
  double largest = 0.0;  ///< of the saturated force
  double rms = 0.0;
};

Deviation deviation(const std::vector<double>& weight,
                    const std::vector<double>& force,
                    double saturation) {
  Deviation d;
  for (std::size_t k = 0; k < planes; ++k) {
    const double expected = saturation * (1.0 - std::exp(-weight[k] / saturation));
    const double off = std::abs(force[k] - expected) / saturation;
    d.largest = std::max(d.largest, off);
    d.rms += off * off / planes;
  }
  d.rms = std::sqrt(d.rms);
  return d;
}

/// Saturation with the least squares of deviations [N].
double fitted_saturation(const std::vector<double>& weight, const std::vector<double>& force) {
  double best = 0.0;
  double least = 1e300;
  for (double s = 0.01 * weight.back(); s < 10.0 * weight.back(); s *= 1.002) {
    const double squares = s * deviation(weight, force, s).rms;
    if (squares < least) {
      least = squares;
      best = s;
    }
  }
  return best;
}

std::vector<Check> judge(const Results& results) {
  std::vector<Check> checks;
  const auto weight = mean_column(results, "weight_above_N");
  const auto force = mean_column(results, "force_N");
  const auto depth = mean_column(results, "depth_m");
  const double pushed = mean_column(results, "wall_normal_above_N").back();
  const double carried = mean_column(results, "wall_friction_above_N").back();
  // K from the same run: the stress on the wall over the vertical one, both averaged over the depth.
  double sum = -0.5 * force.back();  // trapezoids, from zero at the surface
  for (const double f : force) sum += f;
  const double ratio = pushed * diameter * planes / (4.0 * sum * depth.back());
  const double measured = weight.back() / depth.back() * diameter / (4.0 * wall_friction * ratio);
  const double fitted = fitted_saturation(weight, force);
  checks.push_back({"friction of the wall at work, of its limit",
                    carried / (wall_friction * pushed), 0.9, 1.0 + 1e-9, "tube drawn up"});
  checks.push_back({"stress ratio K of the run", ratio, 0.2, 1.2, "told"});
  checks.push_back({"saturated force, fitted over that of K", fitted / measured, 0.9, 1.1, "aim"});
  const auto off = deviation(weight, force, fitted);
  checks.push_back({"largest deviation of the shape, of the saturated force", off.largest, 0.0,
                    0.05, "P9, mean of four beds, one length fitted"});
  checks.push_back({"the same, root of mean square", off.rms, 0.0, 0.05, "P9"});
  for (int seed = 1; seed <= beds; ++seed) {
    checks.push_back({fmt::format("bed {}, floor and walls carry the weight, error", seed),
                      std::abs(results.at(piece(seed)).column("budget_error").front()), 0.0, 1e-6,
                      "P9"});
  }
  return checks;
}

}  // namespace
}  // namespace packbed::validation

int main(int argc, char** argv) {
  using namespace packbed::validation;  // NOLINT
  Validation v;
  for (int seed = 1; seed <= beds; ++seed) {
    v.pieces.push_back({piece(seed), [seed] { return stress_table(seed); }});
  }
  v.judge = judge;
  return validation_main(argc, argv, v);
}
