// SPDX-License-Identifier: BSD-3-Clause
#include "io/hdf5_detail.hpp"

#include <array>
#include <cstdlib>
#include <cstring>

namespace packbed::io::hdf5 {

std::size_t bytes_of(Element element) {
  switch (element) {
    case Element::float64:
    case Element::int64:
      return 8;
    case Element::float32:
    case Element::int32:
      return 4;
    default:
      return 1;
  }
}

std::string name_of(Element element) {
  constexpr std::array names = {"float64", "float32", "int64", "int32", "int8", "uint8"};
  return names.at(static_cast<std::size_t>(element));
}

namespace detail {
namespace {

/// HDF5 notes the reason of the operating system as "errno = 28" in the text of its innermost error.
herr_t find_errno(unsigned /*depth*/, const H5E_error2_t* error, void* found) {
  const char* text = error->desc != nullptr ? std::strstr(error->desc, "errno = ") : nullptr;
  if (text != nullptr) *static_cast<int*>(found) = std::atoi(text + std::strlen("errno = "));
  return 0;
}

herr_t find_first(unsigned depth, const H5E_error2_t* error, void* found) {
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(found) = error->desc;
  return 0;
}

}  // namespace

std::string reason() {
  int number = 0;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_errno, &number);
  if (number != 0) return std::strerror(number);
  std::string text = "HDF5 gives no reason";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_first, &text);
  return text;
}

void close_id(hid_t id) noexcept {
  switch (H5Iget_type(id)) {
    case H5I_FILE:
      H5Fclose(id);
      break;
    case H5I_GROUP:
      H5Gclose(id);
      break;
    case H5I_DATASET:
      H5Dclose(id);
      break;
    case H5I_DATASPACE:
      H5Sclose(id);
      break;
    case H5I_DATATYPE:
      H5Tclose(id);
      break;
    case H5I_ATTR:
      H5Aclose(id);
      break;
    default:
      H5Pclose(id);
  }
}

hid_t memory_type(Element element) {
  switch (element) {
    case Element::float64:
      return H5T_NATIVE_DOUBLE;
    case Element::float32:
      return H5T_NATIVE_FLOAT;
    case Element::int64:
      return H5T_NATIVE_INT64;
    case Element::int32:
      return H5T_NATIVE_INT32;
    case Element::int8:
      return H5T_NATIVE_INT8;
    case Element::uint8:
      return H5T_NATIVE_UINT8;
  }
  return -1;
}

hid_t file_type(Element element) {
  switch (element) {
    case Element::float64:
      return H5T_IEEE_F64LE;
    case Element::float32:
      return H5T_IEEE_F32LE;
    case Element::int64:
      return H5T_STD_I64LE;
    case Element::int32:
      return H5T_STD_I32LE;
    case Element::int8:
      return H5T_STD_I8LE;
    case Element::uint8:
      return H5T_STD_U8LE;
  }
  return -1;
}

}  // namespace detail
}  // namespace packbed::io::hdf5
