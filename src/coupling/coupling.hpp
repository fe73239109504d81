// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads and liquid act on each other, at instants an interval apart. What each gives the other at such an
/// instant is the same to round-off; text: docs/theory/coupling.md.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "coupling/cell_window.hpp"
#include "coupling/drag/drag_law.hpp"
#include "coupling/weights.hpp"
#include "dem/dem.hpp"
#include "mesh/cell_partition.hpp"
#include "mesh/column_mesh.hpp"

namespace packbed::coupling {

/// How the pull of the liquid follows a bead that moves within an interval.
enum class Scheme {
  frozen_flux,      ///< the flux of liquid and beads together stays
  frozen_velocity,  ///< that of the liquid and the pressure gradient stay: the classical scheme
};

/// How much of two beads that overlap is solid.
enum class OverlapRule {
  full,    ///< both whole: a bead that is squeezed keeps its volume (thesis eq. 7.9)
  merged,  ///< what they have in common counts once: water leaves a gel that is squeezed
};

struct CouplingOptions {
  DragLaw drag = KochHill{};
  Scheme scheme = Scheme::frozen_flux;
  OverlapRule overlap = OverlapRule::full;
  double coarse_grain = 1.0;  ///< diameters of a bead of the bed over those of the resin
  double rho_f = 998.2;       ///< [kg/m3]
  double mu_f = 1e-3;         ///< [Pa s]
  WeightOptions widths{};
  /// The law sees no smaller void fraction. The code of the thesis had 0.40; without: as it is.
  std::optional<double> min_void_fraction{};
};

/// What the beads are to the liquid, one value per own cell.
struct BedFields {
  std::vector<double> eps{};       ///< void fraction
  std::vector<double> exchange{};  ///< B = sum w K / V, K in the cell [kg/(m3 s)]
  std::vector<Vec3> u_solid{};     ///< sum w K v / sum w K [m/s]
  std::vector<double>
      source{};  ///< water that left the beads since the last pull [1/s]; empty: none
};

/// What the liquid is to the beads, one value per own cell.
struct LiquidFields {
  std::span<const Vec3> u{};       ///< interstitial velocity [m/s]
  std::span<const Vec3> grad_p{};  ///< of the pressure without its hydrostatic part [Pa/m]
};

/// Of a cell, below which a run stops: what passes it is a hundred times as fast as above the bed, exchanges follow
/// each other as quickly, and a bed that its flow closes would be stepped on for ever.
inline constexpr double least_void_fraction = 0.01;

/// Extremes of the last instant, of all ranks.
struct CouplingFigures {
  double largest_solid_fraction = 0.0;  ///< of a cell
  double largest_reynolds = 0.0;        ///< of a bead of mean size
};

class Coupling {
 public:
  /// Cells belong to ranks by `partition`, beads by the cells of their centers.
  Coupling(const mesh::ColumnMesh& mesh,
           const mesh::ColumnShape& shape,
           const mesh::CellPartition& partition,
           const CouplingOptions& options,
           const Ranks& ranks);

  /// Fields of the beads as they are, whose velocity is that since the last pull, `dt` [s] ago (0: they rest).
  /// All ranks call it. Throws DivergenceError where beads fill a cell.
  BedFields bed(const dem::Dem& dem, const mesh::ColumnMesh& mesh, double dt);

  /// Sets the drag of the beads, which must not have moved since bed(). All ranks call it.
  void pull(const LiquidFields& liquid, dem::Dem& dem);

  /// The velocity that Reynolds numbers of the next bed() are taken from: pull() sets it, a resumed run must.
  void set_velocity(std::span<const Vec3> u);

  /// How many layers a bead may reach up or down in this mesh. One that is stretched to more of them than that
  /// of the constructor needs another Coupling.
  [[nodiscard]] std::int64_t reach_in_layers(const mesh::ColumnMesh& mesh) const {
    return weights_.reach_in_layers(mesh);
  }
  [[nodiscard]] const CouplingFigures& figures() const { return figures_; }
  [[nodiscard]] const CouplingOptions& options() const { return options_; }

 private:
  void find_beads(const dem::Dem& dem, double dt);
  [[nodiscard]] std::vector<double> expelled(double dt);
  /// Of a cell, sum w times: volume, a D, a D^2, a D v, a D^2 v of the beads, a being Grain::share.
  static constexpr std::size_t bead_sums = 9;
  using BeadSums = std::array<double, bead_sums>;
  [[nodiscard]] std::vector<BeadSums> sum_beads() const;
  void set_laws(const mesh::ColumnMesh& mesh, const std::vector<BeadSums>& sums);
  /// Of a cell: terms of force and rate of its beads that do not depend on the bead (two are padding).
  using CellPull = std::array<double, 16>;
  [[nodiscard]] std::vector<CellPull> pulls_of_cells(const LiquidFields& liquid) const;
  [[nodiscard]] double mean_diameter() const;
  double set_law(std::size_t c, double slip, double mean_diameter);
  [[noreturn]] void stop_at_full_cell(const mesh::ColumnMesh& mesh, std::size_t c) const;
  /// Place of a cell in the window.
  [[nodiscard]] std::size_t at(std::int64_t cell) const {
    return static_cast<std::size_t>(cell - window_.first());
  }

  /// An own bead at an instant.
  struct Grain {
    std::size_t place = 0;  ///< in the arrays of the Dem
    double volume = 0.0;    ///< that counts [m3]
    double share = 1.0;     ///< of the whole bead, by volume
    double diameter = 0.0;  ///< [m]
    double lens = 0.0;      ///< what does not count [m3]
    double expelled = 0.0;  ///< since the last pull [m3]
    Vec3 v;                 ///< mean of the past interval [m/s]
  };

  /// Drag coefficient of a grain of diameter D in a cell: K = (slow + inertial D) D [kg/s].
  struct CellLaw {
    double slow = 0.0;      ///< at Re = 0 [kg/(m s)]
    double inertial = 0.0;  ///< [kg/(m2 s)]
  };

  CouplingOptions options_;
  Ranks ranks_;
  Weights weights_;
  CellWindow window_;
  bool is_empty_y_;
  std::vector<Grain> grains_{};
  // Fields of the window.
  std::vector<double> volume_{};  ///< of the cells [m3]
  std::vector<double> eps_{};
  std::vector<double> exchange_{};
  std::vector<CellLaw> law_{};
  std::vector<Vec3> u_{};
  CouplingFigures figures_{};
};

}  // namespace packbed::coupling
