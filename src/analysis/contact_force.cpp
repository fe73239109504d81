// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/contact_force.hpp"

namespace packbed::analysis {

std::vector<ContactForce> contact_forces(std::span<const dem::ContactReport> contacts) {
  std::vector<ContactForce> all;
  all.reserve(contacts.size());
  for (const auto& c : contacts) {
    const bool pulls = dot(c.normal, c.branch) > 0.0;
    all.push_back({.i = c.id_i,
                   .j = c.id_j,
                   .x = c.x,
                   .branch = c.branch,
                   .normal = pulls ? -norm(c.normal) : norm(c.normal),
                   .tangential = norm(c.tangential),
                   .overlap = c.overlap});
  }
  return all;
}

std::vector<Vec3> tangential_forces(std::span<const dem::ContactReport> contacts) {
  std::vector<Vec3> all;
  all.reserve(contacts.size());
  for (const auto& c : contacts) all.push_back(c.tangential);
  return all;
}

std::vector<TouchingPair> touching_pairs(std::span<const ContactForce> contacts) {
  std::vector<TouchingPair> pairs;
  pairs.reserve(contacts.size());
  for (const auto& c : contacts) pairs.push_back({c.i, c.with_wall() ? wall_id : c.j});
  return pairs;
}

Vec3 contact_normal(const ContactForce& contact) {
  const double length = norm(contact.branch);
  return length > 0.0 ? (1.0 / length) * contact.branch : Vec3{};
}

double mean_force(std::span<const ContactForce> contacts) {
  double sum = 0.0;
  std::int64_t count = 0;
  for (const auto& c : contacts) {
    if (!pushes(c)) continue;
    sum += c.normal;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace packbed::analysis
