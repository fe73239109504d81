// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/cell_window.hpp"

#include <algorithm>
#include <utility>

namespace packbed::coupling {

CellWindow::CellWindow(std::vector<std::int64_t> cuts,
                       std::int64_t reach,
                       bool is_periodic,
                       const Ranks& ranks)
    : cuts_(std::move(cuts)), ranks_(ranks) {
  const std::int64_t cells = cuts_.back();
  for (std::size_t r = 0; r + 1 < cuts_.size(); ++r) {
    if (is_periodic) {
      windows_.push_back({0, cells});
    } else {
      windows_.push_back(
          {std::max<std::int64_t>(cuts_[r] - reach, 0), std::min(cuts_[r + 1] + reach, cells)});
    }
  }
}

CellWindow::Run CellWindow::shared(std::size_t owner, std::size_t user) const {
  return {std::max(cuts_[owner], windows_[user].first),
          std::min(cuts_[owner + 1], windows_[user].last)};
}

void CellWindow::add_to_owners(std::span<double> values, std::size_t width) const {
  if (ranks_.size() == 1) return;
  const auto at = [&](std::int64_t cell) {
    return static_cast<std::size_t>(cell - first()) * width;
  };
  std::vector<std::vector<double>> in(static_cast<std::size_t>(ranks_.size()));
  std::vector<Ranks::Mail> mails;
  for (std::size_t r = 0; r < in.size(); ++r) {
    if (r == here()) continue;
    const Run out = shared(r, here());
    in[r].resize(static_cast<std::size_t>(shared(here(), r).size()) * width);
    if (out.size() == 0 && in[r].empty()) continue;
    const auto sent =
        out.size() == 0
            ? std::span<double>{}
            : values.subspan(at(out.first), static_cast<std::size_t>(out.size()) * width);
    mails.push_back({.rank = static_cast<int>(r),
                     .out = std::as_bytes(sent),
                     .in = std::as_writable_bytes(std::span(in[r]))});
  }
  ranks_.trade(mails);
  for (std::size_t r = 0; r < in.size(); ++r) {
    if (in[r].empty()) continue;
    double* own = &values[at(shared(here(), r).first)];
    for (std::size_t k = 0; k < in[r].size(); ++k) own[k] += in[r][k];
  }
}

void CellWindow::fill_from_owners(std::span<double> values, std::size_t width) const {
  if (ranks_.size() == 1) return;
  const auto part = [&](const Run& run) {
    return run.size() == 0 ? std::span<double>{}
                           : values.subspan(static_cast<std::size_t>(run.first - first()) * width,
                                            static_cast<std::size_t>(run.size()) * width);
  };
  std::vector<Ranks::Mail> mails;
  for (std::size_t r = 0; r < static_cast<std::size_t>(ranks_.size()); ++r) {
    if (r == here()) continue;
    const auto out = part(shared(here(), r));
    const auto in = part(shared(r, here()));
    if (out.empty() && in.empty()) continue;
    mails.push_back(
        {.rank = static_cast<int>(r), .out = std::as_bytes(out), .in = std::as_writable_bytes(in)});
  }
  ranks_.trade(mails);
}

}  // namespace packbed::coupling
