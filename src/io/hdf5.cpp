// SPDX-License-Identifier: BSD-3-Clause
#include "io/hdf5.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "io/hdf5_detail.hpp"

#ifndef H5_HAVE_PARALLEL
#error "packbed needs the parallel build of HDF5 (Debian: libhdf5-openmpi-dev)"
#endif

namespace packbed::io::hdf5 {

using detail::close_id;
using detail::file_type;
using detail::Local;
using detail::memory_type;
using detail::new_list;
using detail::ok;

namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>,
              "Object keeps an hid_t without knowing its name");

constexpr std::array elements = {Element::float64, Element::float32, Element::int64,
                                 Element::int32,   Element::int8,    Element::uint8};

/// Extents of rows of `width` numbers: one dimension if width is 1.
struct Extents {
  std::array<hsize_t, 2> sizes;
  int dimensions;
};
Extents extents(std::int64_t rows, std::size_t width) {
  return {{static_cast<hsize_t>(rows), width}, width == 1 ? 1 : 2};
}

/// Rows of a chunk of a compressed array: about 64 kB.
std::int64_t rows_of_chunk(const ArrayForm& form) {
  const auto row = static_cast<std::int64_t>(form.width * bytes_of(form.element));
  return std::clamp<std::int64_t>(65536 / row, 1, std::max<std::int64_t>(form.rows, 1));
}

Local space_of(std::int64_t rows, std::size_t width, const std::filesystem::path& file) {
  const auto e = extents(rows, width);
  return {H5Screate_simple(e.dimensions, e.sizes.data(), nullptr), file, "describing an array"};
}

/// Rows `first` to first + rows - 1 of an array's space.
void select_rows(hid_t space,
                 std::int64_t first,
                 std::int64_t rows,
                 std::size_t width,
                 const std::filesystem::path& file) {
  if (rows == 0) {
    ok(H5Sselect_none(space), file, "choosing rows");
    return;
  }
  const std::array<hsize_t, 2> start = {static_cast<hsize_t>(first), 0};
  const auto count = extents(rows, width);
  ok(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.sizes.data(), nullptr),
     file, "choosing rows");
}

}  // namespace

Object::Object(std::int64_t id, std::filesystem::path file, std::string name)
    : id_(id), file_(std::move(file)), name_(std::move(name)) {}

Object::~Object() {
  if (id_ >= 0) close_id(id_);
}

Object::Object(Object&& other) noexcept
    : id_(std::exchange(other.id_, -1)),
      file_(std::move(other.file_)),
      name_(std::move(other.name_)) {}

Object& Object::operator=(Object&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(file_, other.file_);
  std::swap(name_, other.name_);
  return *this;
}

std::string Object::label(const std::string& name) const {
  return fmt::format("\"{}{}{}\"", name_, name_.empty() || name.empty() ? "" : "/", name);
}

void Object::close() {
  const auto id = std::exchange(id_, -1);
  if (id < 0) return;
  const bool is_file = H5Iget_type(id) == H5I_FILE;
  ok(is_file ? H5Fclose(id) : H5Oclose(id), file_, is_file ? "closing" : "closing " + label(""));
}

Object Object::create_group(const std::string& name) const {
  const auto list = new_list(H5P_GROUP_CREATE, file_);
  ok(H5Pset_obj_track_times(list, false), file_, "setting HDF5 up");
  const auto id = H5Gcreate2(id_, name.c_str(), H5P_DEFAULT, list, H5P_DEFAULT);
  return {ok(id, file_, "making group " + label(name)), file_, name};
}

Object Object::open_group(const std::string& name) const {
  const auto id = H5Gopen2(id_, name.c_str(), H5P_DEFAULT);
  return {ok(id, file_, "opening group " + label(name)), file_, name};
}

Object Object::create_array(const std::string& name, const ArrayForm& form) const {
  const auto what = "making array " + label(name);
  const auto list = new_list(H5P_DATASET_CREATE, file_);
  ok(H5Pset_obj_track_times(list, false), file_, what);
  if (form.deflate > 0 && form.rows > 0) {
    const auto chunk = extents(rows_of_chunk(form), form.width);
    ok(H5Pset_chunk(list, chunk.dimensions, chunk.sizes.data()), file_, what);
    ok(H5Pset_shuffle(list), file_, what);
    ok(H5Pset_deflate(list, static_cast<unsigned>(form.deflate)), file_, what);
  } else {
    // As with MPI-IO, which knows no other way: so files are the same with and without it.
    ok(H5Pset_alloc_time(list, H5D_ALLOC_TIME_EARLY), file_, what);
    ok(H5Pset_fill_time(list, H5D_FILL_TIME_NEVER), file_, what);
  }
  const auto links = new_list(H5P_LINK_CREATE, file_);
  ok(H5Pset_create_intermediate_group(links, 1), file_, what);
  const auto space = space_of(form.rows, form.width, file_);
  const auto id =
      H5Dcreate2(id_, name.c_str(), file_type(form.element), space, links, list, H5P_DEFAULT);
  return {ok(id, file_, what), file_, name};
}

Object Object::open_array(const std::string& name) const {
  if (!has(name)) {
    throw DataError(fmt::format("{}: there is no {} in it", file_.string(), label(name)));
  }
  const auto id = H5Dopen2(id_, name.c_str(), H5P_DEFAULT);
  return {ok(id, file_, "opening " + label(name)), file_, name};
}

bool Object::has(const std::string& name) const {
  // Every part of the path must be asked for; a missing folder is an error of H5Lexists.
  for (auto slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1)) {
    if (H5Lexists(id_, name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return H5Lexists(id_, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Object::arrays() const {
  std::vector<std::string> names;
  const auto add = [](hid_t group, const char* name, const H5L_info_t*, void* to) -> herr_t {
    const auto id = H5Oopen(group, name, H5P_DEFAULT);
    if (id < 0) return -1;
    if (H5Iget_type(id) == H5I_DATASET)
      static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    H5Oclose(id);
    return 0;
  };
  ok(H5Lvisit(id_, H5_INDEX_NAME, H5_ITER_INC, add, &names), file_, "listing " + label(""));
  std::ranges::sort(names);
  return names;
}

ArrayForm Object::form() const {
  const auto what = "reading the form of " + label("");
  const Local space(H5Dget_space(id_), file_, what);
  std::array<hsize_t, 2> sizes = {0, 1};
  const int dimensions = ok(H5Sget_simple_extent_ndims(space), file_, what);
  const Local type(H5Dget_type(id_), file_, what);
  const auto* element = std::ranges::find_if(
      elements, [&](Element e) { return ok(H5Tequal(type, file_type(e)), file_, what) > 0; });
  if (dimensions < 1 || dimensions > 2 || element == elements.end()) {
    throw DataError(fmt::format("{}: {} is no array of numbers in one or two dimensions",
                                file_.string(), label("")));
  }
  ok(H5Sget_simple_extent_dims(space, sizes.data(), nullptr), file_, what);
  return {.element = *element,
          .rows = static_cast<std::int64_t>(sizes[0]),
          .width = static_cast<std::size_t>(sizes[1])};
}

void Object::write_rows(std::int64_t first,
                        const ArrayForm& values,
                        const void* data,
                        bool is_collective) const {
  const auto what = "writing " + label("");
  const auto list = new_list(H5P_DATASET_XFER, file_);
  if (is_collective) {
    ok(H5Pset_dxpl_mpio(list, H5FD_MPIO_COLLECTIVE), file_, what);
  }
  const Local space(H5Dget_space(id_), file_, what);
  select_rows(space, first, values.rows, values.width, file_);
  const auto memory = space_of(values.rows, values.width, file_);
  ok(H5Dwrite(id_, memory_type(values.element), memory, space, list, data), file_, what);
}

void Object::read_rows(std::int64_t first, const ArrayForm& values, void* data) const {
  const auto what = "reading " + label("");
  const Local space(H5Dget_space(id_), file_, what);
  select_rows(space, first, values.rows, values.width, file_);
  const auto memory = space_of(values.rows, values.width, file_);
  ok(H5Dread(id_, memory_type(values.element), memory, space, H5P_DEFAULT, data), file_, what);
}

void Object::flush() const { ok(H5Fflush(id_, H5F_SCOPE_GLOBAL), file_, "writing"); }

std::uint64_t Object::end() const {
  hsize_t end = 0;
  ok(H5Fget_filesize(id_, &end), file_, "asking for the length");
  return end;
}

std::vector<std::byte> Object::image() const {
  flush();
  const auto size = ok(H5Fget_file_image(id_, nullptr, 0), file_, "making the file");
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  ok(H5Fget_file_image(id_, bytes.data(), bytes.size()), file_, "making the file");
  return bytes;
}

namespace {

/// Starts HDF5 before main, so before MPI too. Otherwise HDF5 cleans up when MPI or the program ends,
/// and crashes there if it could not close a file for an error of the disk; the message and the exit
/// code of the program would be lost. Our files are closed by their owners.
const herr_t started = [] {
  H5dont_atexit();
  H5open();
  return H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // it prints nothing: reason() tells
}();

}  // namespace

Object create_file(const std::filesystem::path& file, std::size_t user_block, const Ranks& ranks) {
  const auto access = new_list(H5P_FILE_ACCESS, file);
  const auto creation = new_list(H5P_FILE_CREATE, file);
  ok(H5Pset_obj_track_times(creation, false), file, "setting HDF5 up");
  ok(H5Pset_userblock(creation, user_block), file, "setting HDF5 up");
  if (ranks.size() > 1) {
    ok(H5Pset_fapl_mpio(access, MPI_COMM_WORLD, MPI_INFO_NULL), file, "setting MPI-IO up");
  } else {
    // The file has a name of its own until it is whole; some file systems cannot lock.
    ok(H5Pset_file_locking(access, false, true), file, "setting HDF5 up");
  }
  const auto id = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, access);
  return {ok(id, file, "making the file"), file, ""};
}

Object create_in_memory(const std::filesystem::path& file) {
  const auto access = new_list(H5P_FILE_ACCESS, file);
  const auto creation = new_list(H5P_FILE_CREATE, file);
  ok(H5Pset_obj_track_times(creation, false), file, "setting HDF5 up");
  ok(H5Pset_fapl_core(access, std::size_t{1} << 20U, false), file, "setting HDF5 up");
  // The name is never used: nothing is opened.
  const auto id = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, access);
  return {ok(id, file, "making the file in memory"), file, ""};
}

Object open_file(const std::filesystem::path& file) {
  const auto access = new_list(H5P_FILE_ACCESS, file);
  ok(H5Pset_file_locking(access, false, true), file, "setting HDF5 up");
  const auto id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, access);
  return {ok(id, file, "opening"), file, ""};
}

}  // namespace packbed::io::hdf5
