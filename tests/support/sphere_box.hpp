// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Spheres of one size in a cubic periodic box that are grown and shrunk slowly: the way to packings
/// at the edge of rigidity.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "tests/support/beads.hpp"

namespace packbed::test {

/// Of the beads that carry: those with at least a number of contacts with others that carry.
struct PackingFigures {
  double solid_fraction = 0.0;  ///< sphere volumes / box, overlaps counted twice
  double pressure = 0.0;        ///< virial of the normal forces / k_n over d, or over Y* (Hertz)
  double coordination = 0.0;
  std::int64_t contacts = 0;
  std::int64_t carrying = 0;  ///< beads
  double unbalanced = 0.0;    ///< mean unbalanced / mean contact force
};

class SphereBox {
 public:
  /// `count` beads S at random places. `least_contacts` that a bead needs to carry.
  SphereBox(const dem::ContactModel& model,
            int count,
            double solid_fraction,
            std::uint64_t seed,
            int least_contacts)
      : model_(model),
        count_(count),
        least_contacts_(least_contacts),
        side_(diameter_s * std::cbrt(count * std::numbers::pi / 6.0 / solid_fraction)),
        dem_(options_in_box(), random_beads(seed), {}) {}

  [[nodiscard]] double diameter() const { return 2.0 * dem_.particles().radius(0); }
  [[nodiscard]] double solid_fraction() const {
    return count_ * std::numbers::pi / 6.0 * std::pow(diameter() / side_, 3);
  }
  void set_solid_fraction(double phi) { dem_.scale_diameters(std::cbrt(phi / solid_fraction())); }
  [[nodiscard]] const dem::Dem& dem() const { return dem_; }

  /// Background damping times `share` sqrt(k / m) at least, from now on: beads stop at once where
  /// nothing pushes them.
  void set_least_damping(double share) { least_damping_ = share; }

  /// Mean overlap of touching pairs over the diameter.
  [[nodiscard]] double strain() const { return dem_.snapshot().mean_overlap / diameter(); }

  /// Runs with a step and a damping that suit the present overlaps.
  void run(std::int64_t steps) {
    set_pace(strain());
    dem_.run(steps);
  }

  /// Runs until the unbalanced force is below a share of the contact force, or until nothing presses
  /// (mean overlap below `loose` diameters), or for `most` steps. Returns whether it is at rest
  /// under load.
  bool relax(double share, std::int64_t most, double loose = 1e-8) {
    constexpr std::int64_t look = 500;
    for (std::int64_t done = 0; done < most; done += look) {
      run(look);
      const auto s = dem_.snapshot();
      if (s.mean_overlap < loose * diameter()) return false;
      if (s.mean_unbalanced_force < share * s.mean_contact_force) return true;
    }
    return false;
  }

  [[nodiscard]] PackingFigures figures() const {
    const auto pairs = touching();
    std::vector<int> contacts(static_cast<std::size_t>(count_), 0);
    auto carries = [&](const Touch& t) {
      return contacts[t.i] >= least_contacts_ && contacts[t.j] >= least_contacts_;
    };
    std::vector<int> next = contacts;
    for (const auto& t : pairs) ++next[t.i], ++next[t.j];
    while (next != contacts) {  // beads without enough contacts take those of others away
      contacts = next;
      std::ranges::fill(next, 0);
      for (const auto& t : pairs) {
        if (carries(t)) ++next[t.i], ++next[t.j];
      }
    }
    PackingFigures f{.solid_fraction = solid_fraction()};
    double virial = 0.0;
    for (const auto& t : pairs) {
      virial += t.distance * t.force;
      if (carries(t)) ++f.contacts;
    }
    f.carrying = std::ranges::count_if(contacts, [&](int c) { return c >= least_contacts_; });
    f.coordination = f.carrying > 0
                         ? 2.0 * static_cast<double>(f.contacts) / static_cast<double>(f.carrying)
                         : 0.0;
    f.pressure = virial / (3.0 * side_ * side_ * side_) / modulus();
    const auto s = dem_.snapshot();
    f.unbalanced =
        s.mean_contact_force > 0.0 ? s.mean_unbalanced_force / s.mean_contact_force : 0.0;
    return f;
  }

 private:
  struct Touch {
    std::size_t i, j;
    double distance, force;
  };

  [[nodiscard]] std::vector<Touch> touching() const {
    std::vector<Touch> list;
    const auto& p = dem_.particles();
    const auto box = dem_.contacts().box();
    for (const auto& c : dem_.contacts().pairs()) {
      const auto i = static_cast<std::size_t>(c.i);
      const auto j = static_cast<std::size_t>(c.j);
      const Vec3 shift{box.x * c.image[0], box.y * c.image[1], box.z * c.image[2]};
      const double r = norm(p.motion[i].x - p.motion[j].x - shift);
      const double overlap = p.radius(i) + p.radius(j) - r;
      if (overlap <= 0.0) continue;
      const double force = std::visit(
          [&](const auto& law) { return law(overlap, 0.0, c.coefficients).f_n; }, model_.contact);
      list.push_back({i, j, r, force});
    }
    return list;
  }

  [[nodiscard]] dem::DemOptions options_in_box() const {
    dem::DemOptions o;
    o.domain = {.low = {}, .size = {side_, side_, side_}, .periodic = {true, true, true}};
    o.model = model_;
    o.step = 1e-8;
    o.overlap_limit = 10.0;  // beads start anywhere
    return o;
  }

  [[nodiscard]] std::vector<dem::BeadStart> random_beads(std::uint64_t seed) const {
    std::vector<dem::BeadStart> beads;
    for (int i = 0; i < count_; ++i) {
      const auto u = [&](int axis) {
        return side_ *
               uniform(seed, Stream::bead_position, static_cast<std::uint64_t>(3 * i + axis));
      };
      beads.push_back(bead(i, {u(0), u(1), u(2)}));
    }
    return beads;
  }

  [[nodiscard]] dem::Pair pair() const {
    const double m = mass_of(diameter(), density_s);
    return {.i = material_s,
            .j = material_s,
            .r_eff = 0.25 * diameter(),
            .m_eff = 0.5 * m,
            .m_scaled = 0.5 * m};
  }

  /// k_n / d of Hooke's law; Y* of Hertz's.
  [[nodiscard]] double modulus() const {
    if (const auto* law = std::get_if<dem::Hooke>(&model_.contact)) {
      return law->coefficients(pair()).a / diameter();
    }
    return dem::effective_modulus(material_s, material_s);
  }

  /// Steps of 0.15 / w, w^2 = k / m; a background damping near the lowest frequencies of the packing,
  /// which fall as strain^(1/4) towards the edge of rigidity (shear modulus ~ excess contacts).
  void set_pace(double strain) {
    const auto stiffness = std::visit(
        [&](const auto& law) {
          return law.stiffness(std::max(strain, 1e-4) * diameter(), law.coefficients(pair()));
        },
        model_.contact);
    const double w = std::sqrt(stiffness / mass_of(diameter(), density_s));
    dem_.set_step(0.15 / w);
    const double slow = 0.2 * std::pow(std::clamp(strain, 1e-7, 1e-2), 0.25);
    dem_.set_background_damping(std::max(slow, least_damping_) * w);
  }

  dem::ContactModel model_;
  int count_;
  int least_contacts_;
  double side_;
  double least_damping_ = 0.0;
  dem::Dem dem_;
};

}  // namespace packbed::test
