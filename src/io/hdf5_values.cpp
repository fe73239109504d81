// SPDX-License-Identifier: BSD-3-Clause
// Single numbers and texts.
#include <algorithm>

#include "io/hdf5_detail.hpp"

namespace packbed::io::hdf5 {

using detail::file_type;
using detail::Local;
using detail::memory_type;
using detail::new_list;
using detail::ok;

void Object::write_attribute(const std::string& name, double value) const {
  const auto what = "writing " + label(name);
  const Local space(H5Screate(H5S_SCALAR), file_, what);
  const Local attribute(
      H5Acreate2(id_, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT), file_, what);
  ok(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value), file_, what);
}

void Object::write_attribute(const std::string& name, std::span<const std::int64_t> values) const {
  const auto what = "writing " + label(name);
  const hsize_t size = values.size();
  const Local space(size == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr), file_,
                    what);
  const Local attribute(
      H5Acreate2(id_, name.c_str(), H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT), file_, what);
  ok(H5Awrite(attribute, H5T_NATIVE_INT64, values.data()), file_, what);
}

void Object::write_attribute(const std::string& name, std::string_view ascii) const {
  const auto what = "writing " + label(name);
  const Local type(H5Tcopy(H5T_C_S1), file_, what);
  ok(H5Tset_size(type, ascii.size()), file_, what);
  ok(H5Tset_strpad(type, H5T_STR_NULLPAD), file_, what);
  const Local space(H5Screate(H5S_SCALAR), file_, what);
  const Local attribute(H5Acreate2(id_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), file_,
                        what);
  ok(H5Awrite(attribute, type, ascii.data()), file_, what);
}

namespace {

/// Reads a single number that has just this type.
template <class T>
T read_single(hid_t object,
              const std::string& name,
              Element element,
              const std::filesystem::path& file,
              const std::string& label) {
  if (H5Aexists(object, name.c_str()) <= 0) {
    throw DataError(fmt::format("{}: there is no {} in it", file.string(), label));
  }
  const auto what = "reading " + label;
  const Local attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), file, what);
  const Local space(H5Aget_space(attribute), file, what);
  const Local type(H5Aget_type(attribute), file, what);
  if (H5Sget_simple_extent_npoints(space) != 1 || H5Tequal(type, file_type(element)) <= 0) {
    throw DataError(fmt::format("{}: {} is no single {}", file.string(), label, name_of(element)));
  }
  T value{};
  ok(H5Aread(attribute, memory_type(element), &value), file, what);
  return value;
}

}  // namespace

bool Object::has_number(const std::string& name) const { return H5Aexists(id_, name.c_str()) > 0; }

double Object::read_number(const std::string& name) const {
  return read_single<double>(id_, name, Element::float64, file_, label(name));
}

std::int64_t Object::read_integer(const std::string& name) const {
  return read_single<std::int64_t>(id_, name, Element::int64, file_, label(name));
}

void Object::write_text(const std::string& name, std::string_view value, bool writes) const {
  const auto what = "writing " + label(name);
  const std::string kept(value.empty() ? std::string_view("\0", 1) : value);  // size 0 is no type
  const Local type(H5Tcopy(H5T_C_S1), file_, what);
  ok(H5Tset_size(type, kept.size()), file_, what);
  ok(H5Tset_strpad(type, H5T_STR_NULLPAD), file_, what);
  ok(H5Tset_cset(type, H5T_CSET_UTF8), file_, what);
  const auto list = new_list(H5P_DATASET_CREATE, file_);
  ok(H5Pset_obj_track_times(list, false), file_, what);
  ok(H5Pset_alloc_time(list, H5D_ALLOC_TIME_EARLY), file_, what);
  ok(H5Pset_fill_time(list, H5D_FILL_TIME_NEVER), file_, what);
  const auto links = new_list(H5P_LINK_CREATE, file_);
  ok(H5Pset_create_intermediate_group(links, 1), file_, what);
  const Local space(H5Screate(H5S_SCALAR), file_, what);
  const Local text(H5Dcreate2(id_, name.c_str(), type, space, links, list, H5P_DEFAULT), file_,
                   what);
  if (writes) ok(H5Dwrite(text, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, kept.data()), file_, what);
}

std::string Object::read_text(const std::string& name) const {
  const auto text = open_array(name);
  const auto what = "reading " + label(name);
  const Local type(H5Dget_type(text.id_), file_, what);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) {
    throw DataError(fmt::format("{}: {} is no text", file_.string(), label(name)));
  }
  std::string value(H5Tget_size(type), '\0');
  ok(H5Dread(text.id_, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()), file_, what);
  value.resize(std::min(value.find('\0'), value.size()));
  return value;
}

}  // namespace packbed::io::hdf5
