// SPDX-License-Identifier: BSD-3-Clause
#include "core/quantity.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <locale.h>  // NOLINT(modernize-deprecated-headers): uselocale is POSIX
#include <udunits2.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packbed {
namespace {

constexpr std::array dimension_table = {
    DimensionInfo{Dimension::length, "length", "m", "m", "90 um"},
    DimensionInfo{Dimension::time, "time", "s", "s", "0.5 s"},
    DimensionInfo{Dimension::velocity, "velocity", "m/s", "m_s", "20 mm/min"},
    DimensionInfo{Dimension::volume_flow, "volume flow", "m3/s", "m3_s", "2 L/h"},
    DimensionInfo{Dimension::pressure, "pressure", "Pa", "Pa", "3 bar"},
    DimensionInfo{Dimension::viscosity, "viscosity", "Pa.s", "Pa_s", "1 mPa s"},
    DimensionInfo{Dimension::density, "density", "kg/m3", "kg_m3", "1140 kg/m3"},
    DimensionInfo{Dimension::temperature, "temperature", "K", "K", "20 degC"},
    DimensionInfo{Dimension::force, "force", "N", "N", "0.5 N"},
    DimensionInfo{Dimension::frequency, "frequency", "Hz", "Hz", "30 Hz"},
    DimensionInfo{Dimension::inverse_length, "inverse length", "m-1", "1_m", "1e10 m-1"},
    DimensionInfo{Dimension::fraction, "fraction", "1", "", "0.38"},
};

// Units that chromatographers write and UDUNITS does not know.
constexpr std::array<std::pair<const char*, const char*>, 2> own_units = {
    std::pair{"cP", "mPa.s"},
    std::pair{"mPas", "mPa.s"},
};

struct UnitDeleter {
  void operator()(ut_unit* unit) const noexcept { ut_free(unit); }
};
struct ConverterDeleter {
  void operator()(cv_converter* converter) const noexcept { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;
using Converter = std::unique_ptr<cv_converter, ConverterDeleter>;

// UDUNITS reads numbers in the locale of the process: a decimal comma would break its database.
class PlainNumbers {
 public:
  PlainNumbers() : plain_(newlocale(LC_ALL_MASK, "C", nullptr)), before_(uselocale(plain_)) {}
  ~PlainNumbers() {
    uselocale(before_);
    freelocale(plain_);
  }
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;
  PlainNumbers(PlainNumbers&&) = delete;
  PlainNumbers& operator=(PlainNumbers&&) = delete;

 private:
  locale_t plain_;
  locale_t before_;
};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Digits in a unit may only be exponents ("m3", "m-3", "m^3"); UDUNITS would multiply by others.
bool has_stray_number(std::string_view unit) {
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i]) || (i > 0 && is_digit(unit[i - 1]))) continue;
    std::size_t before = i;
    if (before > 0 && unit[before - 1] == '-') --before;
    if (before > 0 && unit[before - 1] == '^') continue;
    if (before == 0 || !is_letter(unit[before - 1])) return true;
  }
  return false;
}

bool nearly(double a, double b) { return std::abs(a - b) < 1e-12 * std::abs(b); }

// The number times 10^power, by moving its decimal point: "86.9" and -6 give 8.69e-5 exactly.
double shifted(const std::string& digits, int power) {
  const auto e = digits.find_first_of("eE");
  const int old = e == std::string::npos ? 0 : std::stoi(digits.substr(e + 1));
  return *to_number(fmt::format("{}e{}", digits.substr(0, e), old + power));
}

// The number times the scale of a unit, rounded once wherever the scale allows it.
double scaled(const NumberWithUnit& q, double scale) {
  const double power = std::round(std::log10(scale));
  if (std::abs(power) < 30.0 && nearly(scale, std::pow(10.0, power))) {
    return shifted(q.digits, static_cast<int>(power));
  }
  constexpr double exact_integers = 1e15;
  const double whole = std::round(scale);
  const double inverse = std::round(1.0 / scale);
  if (scale > 1.0 && whole < exact_integers && nearly(scale, whole)) return q.number * whole;
  if (scale < 1.0 && inverse < exact_integers && nearly(1.0 / scale, inverse)) {
    return q.number / inverse;
  }
  return q.number * scale;
}

// Scale and offset apart, so that "20 degC" is 293.15 K.
double convert(const cv_converter& converter, const NumberWithUnit& q) {
  const double offset = cv_convert_double(&converter, 0.0);
  const double scale = cv_convert_double(&converter, 1.0) - offset;
  return scaled(q, scale) + offset;
}

}  // namespace

const DimensionInfo& info(Dimension dimension) {
  return dimension_table[static_cast<std::size_t>(dimension)];
}

std::span<const DimensionInfo> all_dimensions() { return dimension_table; }

NumberWithUnit split_quantity(std::string_view text) {
  text = trimmed(text);
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double number = 0.0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (status == std::errc::result_out_of_range) {
    throw ValueError("the number is outside the range of double precision");
  }
  const bool starts_well = !digits.empty() && (is_digit(digits[0]) || digits[0] == '.' ||
                                               (digits[0] == '-' && !text.starts_with('+')));
  if (status != std::errc{} || !starts_well) throw ValueError("it does not start with a number");
  if (!std::isfinite(number)) throw ValueError("the number is not finite");
  const auto unit = trimmed(digits.substr(static_cast<std::size_t>(end - digits.data())));
  if (unit.starts_with(',')) throw ValueError("write a decimal point, not a comma");
  if (has_stray_number(unit)) throw ValueError("it has more than one number");
  const auto length = static_cast<std::size_t>(end - digits.data());
  return {number, std::string(digits.substr(0, length)), std::string(unit)};
}

class UnitSystem::Database {
 public:
  Database() {
    const PlainNumbers guard;
    ut_set_error_message_handler(ut_ignore);
    ut_status status{};
    if (const char* path = ut_get_path_xml(nullptr, &status); path != nullptr) path_ = path;
    system_.reset(ut_read_xml(nullptr));
    if (system_ == nullptr) {
      throw DataError(fmt::format(
          "cannot read the unit database {}; install the package libudunits2-data", path_));
    }
    for (const auto& [name, meaning] : own_units) {
      const Unit unit(ut_parse(system_.get(), meaning, UT_UTF8));
      ut_map_name_to_unit(name, UT_UTF8, unit.get());
    }
  }

  /// Null if the unit is not known.
  [[nodiscard]] Unit parse(const std::string& unit) const {
    const PlainNumbers guard;
    return Unit(ut_parse(system_.get(), unit.c_str(), UT_UTF8));
  }

  /// Null if the unit is of another dimension.
  [[nodiscard]] Converter to_si(const ut_unit& unit, Dimension dimension) const {
    const Unit target = parse(std::string(info(dimension).si_unit));
    // UDUNITS also converts between reciprocal units (s to Hz); only the same dimension counts.
    const Unit quotient(ut_divide(&unit, target.get()));
    if (quotient == nullptr || ut_is_dimensionless(quotient.get()) == 0) return nullptr;
    return Converter(ut_get_converter(const_cast<ut_unit*>(&unit), target.get()));
  }

  [[nodiscard]] std::optional<Dimension> dimension_of(const ut_unit& unit) const {
    for (const auto& known : dimension_table) {
      if (to_si(unit, known.dimension) != nullptr) return known.dimension;
    }
    return std::nullopt;
  }

 private:
  struct SystemDeleter {
    void operator()(ut_system* system) const noexcept { ut_free_system(system); }
  };
  std::string path_;
  std::unique_ptr<ut_system, SystemDeleter> system_;
};

UnitSystem::UnitSystem() : database_(std::make_unique<Database>()) {}
UnitSystem::~UnitSystem() = default;

double UnitSystem::to_si(std::string_view text, Dimension dimension) const {
  const auto& wanted = info(dimension);
  const auto quantity = split_quantity(text);
  const auto& unit_text = quantity.unit;
  if (unit_text.empty()) {
    if (dimension == Dimension::fraction) return quantity.number;
    throw ValueError("it has no unit");
  }
  if (dimension == Dimension::fraction && unit_text != "%" && unit_text != "percent") {
    throw ValueError(fmt::format("a {} takes no unit but %", wanted.name));
  }
  const Unit unit = database_->parse(unit_text);
  if (unit == nullptr) throw ValueError(fmt::format("the unit \"{}\" is not known", unit_text));
  const Converter converter = database_->to_si(*unit, dimension);
  if (converter == nullptr) {
    const auto found = database_->dimension_of(*unit);
    if (found) {
      throw ValueError(fmt::format("it is a {}, not a {}", info(*found).name, wanted.name));
    }
    throw ValueError(fmt::format("\"{}\" is not a unit of {}", unit_text, wanted.name));
  }
  const double value = convert(*converter, quantity);
  if (!std::isfinite(value)) throw ValueError("the number is not finite in SI units");
  return value;
}

Dimension UnitSystem::dimension_of(std::string_view text, Dimension otherwise) const {
  const Unit unit = database_->parse(split_quantity(text).unit);
  if (unit == nullptr) return otherwise;
  return database_->dimension_of(*unit).value_or(otherwise);
}

}  // namespace packbed
