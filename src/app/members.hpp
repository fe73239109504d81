// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace packbed::app {

/// One member of all rows, times a factor: a column of a table or an axis of a plot.
template <class Row>
std::vector<double> column_of(const std::vector<Row>& rows,
                              double Row::*member,
                              double factor = 1.0) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const auto& row : rows) values.push_back(row.*member * factor);
  return values;
}

}  // namespace packbed::app
