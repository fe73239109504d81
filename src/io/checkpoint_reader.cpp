// SPDX-License-Identifier: BSD-3-Clause
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_seal.hpp"
#include "io/on_all.hpp"

namespace packbed::io {
namespace {

hdf5::Object open_checked(const std::filesystem::path& file, const Ranks& ranks) {
  on_first(ranks, [&] { check_seal(file, checkpoint_format); });
  std::optional<hdf5::Object> opened;
  on_all(ranks, [&] { opened.emplace(hdf5::open_file(file)); });
  return std::move(*opened);
}

/// As it is stored: type, and values per row.
template <class T>
struct Stored {
  using Number = T;
  static constexpr std::size_t width = 1;
};
template <>
struct Stored<Vec3> {
  using Number = double;
  static constexpr std::size_t width = 3;
};

}  // namespace

CheckpointReader::CheckpointReader(const std::filesystem::path& file, const Ranks& ranks)
    : file_(file), content_(open_checked(file, ranks)) {}

bool CheckpointReader::has_array(const std::string& name) const {
  return content_.has("arrays/" + name);
}

std::int64_t CheckpointReader::rows(const std::string& name) const {
  return content_.open_array("arrays/" + name).form().rows;
}

std::size_t CheckpointReader::width(const std::string& name) const {
  return content_.open_array("arrays/" + name).form().width;
}

std::vector<std::string> CheckpointReader::arrays() const {
  return content_.open_group("arrays").arrays();
}

template <class T>
std::vector<T> CheckpointReader::read(const std::string& name,
                                      std::int64_t first,
                                      std::int64_t count) const {
  const auto array = content_.open_array("arrays/" + name);
  auto form = array.form();
  constexpr auto element = hdf5::element_of<typename Stored<T>::Number>();
  constexpr auto width = Stored<T>::width;
  if (form.element != element || form.width % width != 0) {
    throw DataError(fmt::format("{}: array \"{}\" holds {} x {} in a row, not {} x {}",
                                file_.string(), name, form.width, hdf5::name_of(form.element),
                                width, hdf5::name_of(element)));
  }
  if (first < 0 || count < 0 || count > form.rows - first) {
    throw DataError(fmt::format("{}: array \"{}\" has {} rows; {} from row {} on are not there",
                                file_.string(), name, form.rows, count, first));
  }
  std::vector<T> values(static_cast<std::size_t>(count) * form.width / width);
  form.rows = count;
  array.read_rows(first, form, values.data());
  return values;
}

template std::vector<double> CheckpointReader::read(const std::string&,
                                                    std::int64_t,
                                                    std::int64_t) const;
template std::vector<Vec3> CheckpointReader::read(const std::string&,
                                                  std::int64_t,
                                                  std::int64_t) const;
template std::vector<std::int64_t> CheckpointReader::read(const std::string&,
                                                          std::int64_t,
                                                          std::int64_t) const;
template std::vector<std::int32_t> CheckpointReader::read(const std::string&,
                                                          std::int64_t,
                                                          std::int64_t) const;
template std::vector<std::int8_t> CheckpointReader::read(const std::string&,
                                                         std::int64_t,
                                                         std::int64_t) const;
template std::vector<std::uint8_t> CheckpointReader::read(const std::string&,
                                                          std::int64_t,
                                                          std::int64_t) const;

bool CheckpointReader::has_number(const std::string& name) const {
  return content_.open_group("numbers").has_number(name);
}

double CheckpointReader::number(const std::string& name) const {
  return content_.open_group("numbers").read_number(name);
}

std::int64_t CheckpointReader::integer(const std::string& name) const {
  return content_.open_group("numbers").read_integer(name);
}

std::string CheckpointReader::text(const std::string& name) const {
  return content_.read_text("texts/" + name);
}

}  // namespace packbed::io
