// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The beads of a block of contacts brought into lanes, and the forces of the lanes brought back to
/// the beads, one contact after the other. Records are read and written whole and turned into lanes by
/// transposing 8 x 8 numbers in registers with AVX-512, 4 x 4 without. Both do the same arithmetic in
/// the same order.

#include <cstring>

#include "dem/contact_list.hpp"
#include "dem/particles.hpp"

#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace packbed::dem {

/// Relative motion of the pairs of one block, one lane each. In the order of the records of beads.
struct alignas(64) Relative {
  double x[3][lanes];         ///< x_i - x_j
  double v[3][lanes];         ///< v_i - v_j
  double sum_w[3][lanes];     ///< w_i + w_j
  double mean_r[lanes];       ///< (R_i + R_j) / 2
  double diff_w[3][lanes];    ///< w_i - w_j
  double half_diff_r[lanes];  ///< (R_i - R_j) / 2
};

/// Forces on the beads of one block. j gets the opposite force.
struct alignas(64) Forces {
  double force[3][lanes];
  double torque_i[3][lanes];
  double torque_j[3][lanes];
};

/// Asks for records of the beads of a block that comes soon.
template <int writes, class Records>
void prefetch_records(const ContactBlock& block, const Records& records) {
  for (const auto j : block.j) __builtin_prefetch(&records[static_cast<std::size_t>(j)], writes);
}

/// Asks for one half, 0 or 1, of a block that comes later.
inline void prefetch_half(const ContactBlock& block, std::size_t half) {
  constexpr std::size_t line = 64;
  constexpr std::size_t middle = sizeof(ContactBlock) / (2 * line) * line;
  const char* start = reinterpret_cast<const char*>(&block);
  const std::size_t end = half == 0 ? middle : sizeof(ContactBlock);
  for (std::size_t k = half * middle; k < end; k += line) __builtin_prefetch(start + k, 1);
}

/// Four numbers in a register, or in two.
using Four = double __attribute__((vector_size(32), may_alias));

#ifdef __AVX512F__

using Eight = double __attribute__((vector_size(64), may_alias));

/// {a, a}, loaded at once.
inline Eight twice(const Four& a) { return _mm512_maskz_broadcast_f64x4(0xff, a); }

// Steps of a transposition. "Part": 128 bits, two numbers.

/// The first (second) number of each part of a and b in turn.
inline Eight first_of_parts(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
inline Eight second_of_parts(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
/// The even (odd) parts of a and b in turn.
inline Eight even_parts(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}
inline Eight odd_parts(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}
/// The lower (upper) halves of a and b.
inline Eight lower_halves(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
}
inline Eight upper_halves(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
}

/// Four rows r[0..3]: out[c] holds the numbers c and c + 4 of all of them, {r[.][c], r[.][c + 4]}.
inline void transpose_halves(Eight r0, Eight r1, Eight r2, Eight r3, Eight (&out)[4]) {
  const Eight even_01 = first_of_parts(r0, r1);
  const Eight odd_01 = second_of_parts(r0, r1);
  const Eight even_23 = first_of_parts(r2, r3);
  const Eight odd_23 = second_of_parts(r2, r3);
  out[0] = even_parts(even_01, even_23);
  out[1] = even_parts(odd_01, odd_23);
  out[2] = odd_parts(even_01, even_23);
  out[3] = odd_parts(odd_01, odd_23);
}

/// Column c of eight rows goes to out + c * stride.
inline void transpose(const Eight (&row)[8], double* out, int columns) {
  Eight upper[4];
  Eight lower[4];
  transpose_halves(row[0], row[1], row[2], row[3], upper);
  transpose_halves(row[4], row[5], row[6], row[7], lower);
  for (int c = 0; c < columns; ++c) {
    *reinterpret_cast<Eight*>(out + c * lanes) =
        c < 4 ? lower_halves(upper[c], lower[c]) : upper_halves(upper[c - 4], lower[c - 4]);
  }
}

inline void gather_records(const ContactBlock& block,
                           const Particles& particles,
                           Relative& relative) {
  const auto* motion = reinterpret_cast<const Eight*>(particles.motion.data());
  const auto* spin = reinterpret_cast<const Four*>(particles.spin.data());
  const Eight sign{1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0};
  constexpr int motion_columns = 6;
  constexpr int spin_columns = 8;
  for (int lane = 0; lane < lanes; lane += 8) {
    Eight motions[8];
    Eight spins[8];
#pragma GCC unroll 8
    for (int k = 0; k < 8; ++k) {
      const auto i = block.i[lane + k];
      const auto j = block.j[lane + k];
      motions[k] = motion[i] - motion[j];
      spins[k] = twice(spin[i]) + sign * twice(spin[j]);
    }
    transpose(motions, &relative.x[0][lane], motion_columns);
    transpose(spins, &relative.sum_w[0][lane], spin_columns);
  }
}

inline void scatter(const ContactBlock& block, const Forces& forces, Particles& particles) {
  auto* load = reinterpret_cast<Eight*>(particles.load.data());
  for (int lane = 0; lane < lanes; lane += 8) {
    const auto rows = [lane](const double(&a)[3][lanes], Eight(&out)[4]) {
      const auto at = [&](int c) { return *reinterpret_cast<const Eight*>(&a[c][lane]); };
      transpose_halves(at(0), at(1), at(2), Eight{}, out);  // {contact k, contact k + 4}
    };
    Eight force[4];
    Eight torque_i[4];
    Eight torque_j[4];
    rows(forces.force, force);
    rows(forces.torque_i, torque_i);
    rows(forces.torque_j, torque_j);
    for (auto& torque : torque_j) torque = -torque;
#pragma GCC unroll 8
    for (int k = 0; k < 8; ++k) {
      const auto row = [k](const Eight(&a)[4], const Eight(&b)[4]) {
        return k < 4 ? lower_halves(a[k], b[k]) : upper_halves(a[k - 4], b[k - 4]);
      };
      load[block.i[lane + k]] += row(force, torque_i);
      load[block.j[lane + k]] -= row(force, torque_j);
    }
  }
}

#else

/// Row k of a becomes column k.
inline void transpose(Four (&a)[4]) {
  const Four even_01 = __builtin_shufflevector(a[0], a[1], 0, 4, 2, 6);
  const Four odd_01 = __builtin_shufflevector(a[0], a[1], 1, 5, 3, 7);
  const Four even_23 = __builtin_shufflevector(a[2], a[3], 0, 4, 2, 6);
  const Four odd_23 = __builtin_shufflevector(a[2], a[3], 1, 5, 3, 7);
  a[0] = __builtin_shufflevector(even_01, even_23, 0, 1, 4, 5);
  a[1] = __builtin_shufflevector(odd_01, odd_23, 0, 1, 4, 5);
  a[2] = __builtin_shufflevector(even_01, even_23, 2, 3, 6, 7);
  a[3] = __builtin_shufflevector(odd_01, odd_23, 2, 3, 6, 7);
}

/// Column c of four rows goes to out + c * stride.
inline void store_columns(Four (&row)[4], double* out, int columns) {
  transpose(row);
  for (int c = 0; c < columns; ++c) *reinterpret_cast<Four*>(out + c * lanes) = row[c];
}

inline void gather_records(const ContactBlock& block,
                           const Particles& particles,
                           Relative& relative) {
  const auto* motion = reinterpret_cast<const Four*>(particles.motion.data());  // two of each bead
  const auto* spin = reinterpret_cast<const Four*>(particles.spin.data());
  for (int lane = 0; lane < lanes; lane += 4) {
    Four place[4];  // and v.x
    Four speed[4];
    Four sum[4];
    Four difference[4];
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
      const std::ptrdiff_t i = block.i[lane + k];
      const std::ptrdiff_t j = block.j[lane + k];
      place[k] = motion[2 * i] - motion[2 * j];
      speed[k] = motion[2 * i + 1] - motion[2 * j + 1];
      sum[k] = spin[i] + spin[j];
      difference[k] = spin[i] - spin[j];
    }
    store_columns(place, &relative.x[0][lane], 4);
    store_columns(speed, &relative.v[1][lane], 2);
    store_columns(sum, &relative.sum_w[0][lane], 4);
    store_columns(difference, &relative.diff_w[0][lane], 4);
  }
}

inline void scatter(const ContactBlock& block, const Forces& forces, Particles& particles) {
  auto* load = reinterpret_cast<Four*>(particles.load.data());  // two of each bead
  for (int lane = 0; lane < lanes; lane += 4) {
    const auto rows = [lane](const double(&a)[3][lanes], Four(&out)[4]) {
      for (int c = 0; c < 3; ++c) out[c] = *reinterpret_cast<const Four*>(&a[c][lane]);
      out[3] = Four{};
      transpose(out);
    };
    Four force[4];
    Four torque_i[4];
    Four torque_j[4];
    rows(forces.force, force);
    rows(forces.torque_i, torque_i);
    rows(forces.torque_j, torque_j);
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
      const std::ptrdiff_t i = block.i[lane + k];
      const std::ptrdiff_t j = block.j[lane + k];
      load[2 * i] += force[k];
      load[2 * i + 1] += torque_i[k];
      load[2 * j] -= force[k];
      load[2 * j + 1] += torque_j[k];
    }
  }
}

#endif

/// Whether one of the images of an axis is shifted.
inline bool any_shifted(const std::int8_t (&image)[lanes]) {
  std::uint64_t words[lanes / 8];
  std::memcpy(words, image, sizeof(words));
  return (words[0] | words[1] | words[2] | words[3]) != 0;
}

/// Relative motion of the pairs of a block; images of j are shifted by whole box lengths.
inline void gather(const ContactBlock& block,
                   const Particles& particles,
                   const Vec3& box,
                   Relative& relative) {
  gather_records(block, particles, relative);
  const double size[3] = {box.x, box.y, box.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (!any_shifted(block.image[axis])) continue;
    for (int lane = 0; lane < lanes; ++lane) {
      relative.x[axis][lane] -= size[axis] * block.image[axis][lane];
    }
  }
}

}  // namespace packbed::dem
