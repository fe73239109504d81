// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads, walls and contacts stepped in time. Velocity Verlet in leapfrog form: after the first step
/// velocities stand at half steps, and the laws see v(n - 1/2). Order 2 without damping, 1 with.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/ranks.hpp"
#include "dem/contact_list.hpp"
#include "dem/contact_report.hpp"
#include "dem/domain.hpp"
#include "dem/exchange.hpp"
#include "dem/force_pass.hpp"
#include "dem/leapfrog.hpp"
#include "dem/old_contacts.hpp"
#include "dem/particles.hpp"
#include "dem/partition.hpp"
#include "dem/stable_step.hpp"
#include "dem/state.hpp"
#include "dem/walls.hpp"

namespace packbed::dem {

struct DemOptions {
  Domain domain;
  ContactModel model;
  double step = 0.0;                ///< [s]
  double inertia_scale = 1.0;       ///< see InertiaScale, dem/particles.hpp
  double inertia_diameter = 0.0;    ///< [m]; 0: all beads alike
  double background_damping = 0.0;  ///< 1 / time in which a free bead would slow down [1/s]
  double skin = 0.0;                ///< gap below which pairs are listed [m]; 0: chosen
  double overlap_limit = 0.3;       ///< of the smaller diameter; beyond it the run stops
  double load_tolerance = 1.05;     ///< work of the fullest rank over the mean, before a new cut
  /// Cells by which beads belong to ranks; rows of the key grid if there are none. Not copied: it may
  /// be stretched between steps (mesh::ColumnMesh::set_top), alike on all ranks.
  std::shared_ptr<mesh::ColumnMesh> mesh = {};

  [[nodiscard]] InertiaScale inertia() const { return {inertia_scale, inertia_diameter}; }
};

/// All beads taken together: forces at the present positions, velocities at the present time.
struct Sums {
  double time;                   ///< [s]
  std::vector<Vec3> wall_force;  ///< on each wall [N]
  double weight;                 ///< less buoyancy, downwards [N]
  double kinetic_energy;         ///< with the masses that move [J]
  double elastic_energy;         ///< of normal and tangential springs [J]
  double mean_contact_force;     ///< of touching pairs and wall contacts [N]
  double mean_unbalanced_force;  ///< of beads that are free, weight and drag included [N]
  double mean_overlap;           ///< of touching pairs of beads [m]
  double max_overlap_ratio;      ///< overlap / smaller diameter
  double coordination_number;    ///< touching pairs of beads, two per pair, per bead
};

/// And each of them, in the order of ids.
struct Snapshot : Sums {
  std::vector<Vec3> x, v, w;
  std::vector<Vec3> force, torque;  ///< of contacts and walls, without weight
  std::vector<Vec3> drag;           ///< force of the liquid
  std::vector<BeadProperties> beads;
};

/// A velocity that a bead is given.
struct NewVelocity {
  std::int64_t id = 0;
  Vec3 v;  ///< [m/s]
};

// Of a snapshot.
struct ContactTerms;
struct BeadLook;

class Dem {
 public:
  /// Throws DivergenceError for overlaps beyond the limit.
  /// Every rank is given all beads and takes its own.
  Dem(const DemOptions& options,
      const std::vector<BeadStart>& beads,
      std::vector<Wall> walls,
      const Ranks& ranks = Ranks::alone());

  /// Goes on from a state, that of all ranks, with the same bits. With Lists::anew beads may have been
  /// added or taken away (their contacts too, as no bead is where a contact's id points): lists are
  /// renewed at once. `options` give domain, laws and limits; the state gives the rest.
  enum class Lists { as_saved, anew };
  Dem(const DemOptions& options,
      const DemState& all,
      Lists lists,
      const Ranks& ranks = Ranks::alone());

  /// `count` time steps. Throws DivergenceError naming bead, position and step.
  void run(std::int64_t count);

  /// From the next step on; the half step between the two is taken with their mean.
  void set_step(double step) {
    time_before_ = time();
    steps_before_ = steps_;
    options_.step = step;
  }

  // What a protocol changes on the way; between steps.
  void set_background_damping(double rate) { options_.background_damping = rate; }  ///< [1/s]
  void set_friction(double friction) { options_.model.friction = friction; }  ///< bead on bead
  /// Of the rolling law, if it has one.
  void set_rolling_friction(double mu_r);
  /// Weight less buoyancy, downwards [N], of each bead.
  void set_weights(const std::function<double(const BeadProperties&)>& weight);
  void set_inertia(const InertiaScale& inertia);
  void set_inertia_scale(double scale) { set_inertia({.scale = scale}); }  ///< of all beads alike
  /// Named on rank 0; all ranks call it.
  void set_velocities(const std::vector<NewVelocity>& velocities);
  /// Puts the beads into a liquid that does not pull yet, or takes them out. All ranks call it.
  void set_in_liquid(bool in_liquid) { dem::set_in_liquid(in_liquid, particles_); }
  /// One per bead of particles(), in a liquid; it acts from the next step on and stays with its bead. That
  /// of halo beads is not looked at.
  [[nodiscard]] std::span<Drag> drag() { return particles_.drag; }
  /// Likewise: beads at the last coupling; the centers may be on another side of a periodic box by now.
  [[nodiscard]] std::span<CouplingMark> coupled_at() { return particles_.coupled_at; }
  /// All diameters times `factor`, at constant density: masses, weights, moments of inertia and the
  /// coefficients of all contacts follow; centers, velocities, spins and springs (as lengths and
  /// angles) stay, and so do skin and box. The lists are renewed. All ranks call it. Throws ValueError
  /// for a factor that is not positive, DivergenceError for overlaps beyond the limit.
  void scale_diameters(double factor);

  /// This rank's share of everything that the next steps depend on (dem/state.hpp).
  [[nodiscard]] DemState state() const;

  /// All ranks call it; the beads are on rank 0, the sums everywhere. Costs some time steps.
  [[nodiscard]] Snapshot snapshot() const;
  /// The sums alone, quicker.
  [[nodiscard]] Sums sums() const;
  /// On each wall, as in a snapshot, but quickly [N]; of all ranks, all call it.
  [[nodiscard]] std::vector<Vec3> wall_forces() const;
  /// All ranks call it; the contacts are on rank 0, sorted by ids, the lower one first.
  [[nodiscard]] std::vector<ContactReport> touching_contacts() const;
  /// Volume of each bead of particles() that its contacts take: beyond the plane in which the surfaces of two
  /// beads meet, and behind walls, which count as flat [m3]. That of halo beads is not complete.
  [[nodiscard]] std::vector<double> lens_volumes() const;
  /// Pairs of such caps that meet inside their bead, and that lens_volumes() therefore counts twice; of all
  /// ranks, all call it.
  [[nodiscard]] std::int64_t meeting_lenses() const;
  /// Throws DivergenceError for the first overlap beyond the limit. The driver asks at every output.
  void check_overlaps() const;
  /// Of the beads of all ranks; all call it.
  [[nodiscard]] StableStep stable() const;
  /// [s]; a product, so that a long run does not add up rounding errors.
  [[nodiscard]] double time() const {
    return time_before_ + static_cast<double>(steps_ - steps_before_) * options_.step;
  }
  [[nodiscard]] const DemOptions& options() const { return options_; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] std::int64_t renewals() const { return renewals_; }
  /// Own and halo beads of this rank.
  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] std::int64_t bead_count() const { return bead_count_; }  ///< of all ranks
  [[nodiscard]] std::int64_t repartitions() const { return repartitions_; }
  [[nodiscard]] const Ranks& ranks() const { return ranks_; }
  /// Which rank owns which cell of DemOptions::mesh, or which row.
  [[nodiscard]] const mesh::CellPartition& partition() const { return partition_.runs(); }
  [[nodiscard]] const ContactList& contacts() const { return contacts_; }
  [[nodiscard]] std::vector<Wall>& walls() { return walls_; }
  [[nodiscard]] const std::vector<Wall>& walls() const { return walls_; }
  [[nodiscard]] const std::vector<WallContacts>& wall_contacts() const { return wall_contacts_; }

 private:
  void take_over(const DemProgress& progress);
  void restore_lists(const DemState& all);
  void start_anew(const DemState& all);
  [[nodiscard]] Motion motion_of(const BeadProperties& bead, const Vec3& x, const Vec3& v) const;
  void step_once();
  void renew();
  void renew_if_needed();
  void check_finite() const;
  /// That the beads are as many, and have the same momentum, to the bit, as before.
  void check_migration(const std::array<double, 3>& momentum_before) const;
  /// Time over which v(n - 1/2) has moved the springs: the last step. Before the first one the coming
  /// step, so that beads which slide from the start do not look as if they stuck.
  [[nodiscard]] double spring_step() const { return last_step_ > 0.0 ? last_step_ : options_.step; }
  void sort_beads_and_contacts();
  void trade_beads_and_contacts();
  void list_near_pairs(OldContacts old);
  void list_wall_contacts(const std::vector<std::int32_t>& place);
  void take_over_wall_contacts(const std::vector<NamedWallContact>& arrived,
                               const std::vector<std::int32_t>& place,
                               const PlaceOfId& place_of);
  [[nodiscard]] double adapted_near_skin() const;
  [[nodiscard]] double far_displacement() const;
  [[nodiscard]] Coefficients coefficients_of(const PairKey& p) const;
  void fill_coefficients(const Wall& wall, WallContacts& contacts) const;
  void add_forces_of_walls();
  void add_contact_forces_and_move(const Leapfrog& step);
  [[nodiscard]] Vec3 move_own(std::size_t first, std::size_t last, const Leapfrog& step);
  void add_wall_forces_here(Particles& p,
                            std::vector<WallContacts>& near,
                            std::vector<Vec3>& wall_force) const;
  [[nodiscard]] ContactTerms add_pair_forces_here(Particles& p) const;
  void sum_contacts(ContactTerms& terms,
                    const std::vector<WallContacts>& wall_contacts,
                    Sums& s) const;
  /// The sums; each own bead is handed on, in the order of ids, if there is somebody to take it.
  [[nodiscard]] Sums look(const std::function<void(const BeadLook&)>& take) const;
  void move_walls(double drift);
  [[nodiscard]] double overlap(const PairKey& p) const;

  DemOptions options_;
  Particles particles_;
  std::vector<Wall> walls_;
  ContactList contacts_;
  std::vector<WallContacts> wall_contacts_;
  Ranks ranks_;
  HaloExchange halo_;
  std::vector<Run> own_runs_;
  std::int64_t bead_count_ = 0;
  std::int64_t repartitions_ = 0;
  double largest_diameter_ = 0.0;  ///< of all ranks' beads [m]
  double cell_ = 0.0;              ///< width of the key grid: the largest diameter at the start [m]

  // Two lists, two skins. Pairs within options_.skin are found at renewals, which also bring the beads
  // into a new order. Of these, pairs within near_skin_ are listed with their springs. What decides of
  // renewals is the same on all ranks.
  std::vector<PairKey> far_pairs_;
  std::vector<Vec3> far_reference_;  ///< centers at the last renewal
  double far_moved_ = 0.0;           ///< since the renewal, when near pairs were last listed [m]
  double near_skin_ = 0.0;           ///< [m]
  double moved_ = 0.0;               ///< bound of the largest displacement since then [m]
  double walls_moved_ = 0.0;         ///< of the fastest wall since the renewal [m]
  std::int64_t near_listed_ = 0;     ///< step at which near pairs were last listed
  double last_step_ = 0.0;           ///< 0 before the first step
  double time_before_ = 0.0;         ///< when the present step size came into force [s]
  std::int64_t steps_before_ = 0;
  std::int64_t steps_ = 0;
  std::int64_t renewals_ = 0;
  Partition partition_;
};

}  // namespace packbed::dem
