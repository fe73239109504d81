// SPDX-License-Identifier: BSD-3-Clause
#include "app/frame_writer.hpp"

#include <algorithm>

#include "io/frames.hpp"

namespace packbed::app {
namespace {

/// Place of a bead by its id, in ascending order.
std::size_t place_of(const std::vector<std::int64_t>& ids, std::int64_t id) {
  return static_cast<std::size_t>(std::ranges::lower_bound(ids, id) - ids.begin());
}

std::vector<std::int32_t> contacts_per_bead(const std::vector<std::int64_t>& ids,
                                            const std::vector<dem::ContactReport>& contacts) {
  std::vector<std::int32_t> count(ids.size(), 0);
  for (const auto& c : contacts) {
    ++count[place_of(ids, c.id_i)];
    if (c.id_j >= 0) ++count[place_of(ids, c.id_j)];
  }
  return count;
}

io::ContactLine line_of(const dem::ContactReport& c) {
  // Positive where they push: along the normal on i, against the branch.
  const double push = -dot(c.normal, c.branch);
  return {.from = c.x,
          .to = c.x + c.branch,
          .id_i = c.id_i,
          .id_j = c.id_j,
          .normal_force = push >= 0.0 ? norm(c.normal) : -norm(c.normal),
          .tangential_force = norm(c.tangential),
          .overlap = c.overlap,
          .tangential = c.tangential};
}

std::vector<io::ContactLine> lines_of(const std::vector<dem::ContactReport>& contacts) {
  std::vector<io::ContactLine> lines;
  lines.reserve(contacts.size());
  for (const auto& c : contacts) lines.push_back(line_of(c));
  return lines;
}

}  // namespace

FrameWriter::FrameWriter(const std::filesystem::path& folder)
    : beads_(folder, "beads"), contacts_(folder, "contacts"), liquid_(folder, "liquid") {
  if (Ranks::all().is_first()) std::filesystem::create_directories(folder);
}

FrameWriter::FrameWriter(const std::filesystem::path& folder, const nlohmann::ordered_json& saved)
    : beads_(folder, "beads"), contacts_(folder, "contacts"), liquid_(folder, "liquid") {
  if (!Ranks::all().is_first()) return;
  const std::size_t frames = saved.at("beads");
  beads_ = io::FrameSeries::resume(folder, "beads", frames);
  contacts_ = io::FrameSeries::resume(folder, "contacts", frames);
  liquid_ = io::FrameSeries::resume(folder, "liquid",
                                    {.frames = saved.at("liquid"), .next_number = frames});
}

nlohmann::ordered_json FrameWriter::save() const {
  return {{"beads", beads_.size()}, {"liquid", liquid_.size()}};
}

void FrameWriter::write(const dem::Dem& dem, const column::CoupledBed* liquid) {
  write_beads(dem);
  if (liquid != nullptr) {
    write_liquid(liquid->fluid(), dem.time());
  } else {
    liquid_.skip();
  }
}

// Of a large bed each of snapshot, contacts and lines takes hundreds of bytes per bead: one goes before the next comes.
void FrameWriter::write_beads(const dem::Dem& dem) {
  std::vector<io::ContactLine> lines;
  {
    const auto contacts = dem.touching_contacts();
    write_points(dem, contacts);
    if (!dem.ranks().is_first()) return;
    lines = lines_of(contacts);
  }
  io::write_contact_frame(contacts_.next(), {.time = dem.time(), .contacts = lines});
  beads_.add(dem.time());
  contacts_.add(dem.time());
}

void FrameWriter::write_points(const dem::Dem& dem,
                               const std::vector<dem::ContactReport>& contacts) {
  const auto s = dem.snapshot();
  if (!dem.ranks().is_first()) return;
  std::vector<std::int64_t> id;
  std::vector<double> radius;
  for (const auto& bead : s.beads) {
    id.push_back(bead.id);
    radius.push_back(0.5 * bead.diameter);
  }
  const auto count = contacts_per_bead(id, contacts);
  io::write_bead_frame(beads_.next(),
                       {.time = s.time,
                        .x = s.x,
                        .radius = radius,
                        .id = id,
                        .more = {{"velocity_m_s", std::span<const Vec3>(s.v)},
                                 {"spin_rad_s", std::span<const Vec3>(s.w)},
                                 {"force_N", std::span<const Vec3>(s.force)},
                                 {"contacts", std::span<const std::int32_t>(count)}}});
}

// Ranks own runs of cells in the order of the mesh, so what they give stands in that order.
void FrameWriter::write_liquid(const fluid::Fluid& fluid, double time) {
  const auto& d = fluid.domain();
  const auto gather = [&](const auto& field) {
    return d.ranks.gather(std::vector(field.begin(), field.begin() + d.part.own));
  };
  const auto eps = gather(fluid.eps());
  const auto u = gather(fluid.u());
  const auto p = gather(fluid.dynamic_pressure());
  const auto gradient = gather(fluid.pressure_gradient());
  if (!d.ranks.is_first()) return;
  io::write_liquid_frame(liquid_.next(),
                         {.time = time,
                          .mesh = d.mesh,
                          .cells = {{"void_fraction", std::span<const double>(eps)},
                                    {"velocity_m_s", std::span<const Vec3>(u)},
                                    {"pressure_Pa", std::span<const double>(p)},
                                    {"pressure_gradient_Pa_m", std::span<const Vec3>(gradient)}}});
  liquid_.add(time);
}

}  // namespace packbed::app
