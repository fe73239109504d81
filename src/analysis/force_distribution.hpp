// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How evenly the normal forces between beads are spread (thesis section 3.3.4, fig. 10.7). <F> is the mean
/// of all contacts between beads that push (`pushes`), f = F / <F>.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/contact_force.hpp"

namespace packbed::analysis {

/// Bins of f, from 0.
struct ForceBins {
  double width = 0.25;  ///< > 0
  double high = 10.0;   ///< end of the last one, > 0
};

/// P(f). Sum of density times width of the bins is 1 less `beyond` / `contacts`.
struct ForceDistribution {
  std::int64_t contacts = 0;         ///< between beads that push
  std::int64_t not_pushing = 0;      ///< between beads that touch without a push: left out
  double mean = 0.0;                 ///< <F> [N]
  double largest = 0.0;              ///< of f
  std::vector<double> edges;         ///< of f, one more than bins
  std::vector<std::int64_t> counts;  ///< contacts, one per bin
  std::vector<double> density;       ///< probability per f, one per bin
  std::int64_t beyond = 0;           ///< contacts above the last edge
};

/// ValueError for bins without width.
ForceDistribution force_distribution(std::span<const ContactForce> contacts,
                                     const ForceBins& bins = {});

/// Share of the contacts with f > multiple; thesis section 10.2.1 takes 6.
double share_above(std::span<const ContactForce> contacts, double multiple);

/// The exponential tail exp(-slope f) for f > 1, by maximum likelihood: slope = 1 / (<f of f > 1> - 1).
struct ForceTail {
  double slope = 0.0;         ///< 0 if no force is above the mean
  double error = 0.0;         ///< standard error, slope / sqrt(count)
  std::int64_t contacts = 0;  ///< with f > 1
};
ForceTail force_tail(std::span<const ContactForce> contacts);

/// Strong (f > 1) and weak network (Radjai et al., Phys. Rev. Lett. 80 (1998) 61).
struct ForceNetworks {
  double strong_share = 0.0;         ///< of the contacts
  double strong_load = 0.0;          ///< their share of the sum of F
  std::int64_t strong_beads = 0;     ///< beads with a strong contact
  double strong_coordination = 0.0;  ///< strong contacts per such bead
  double strong_mobilized = 0.0;     ///< mean of tangential / normal force, strong contacts
  double weak_mobilized = 0.0;       ///< the same, weak ones
};
ForceNetworks force_networks(std::span<const ContactForce> contacts);

}  // namespace packbed::analysis
