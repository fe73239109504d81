// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Liquid water at 0.1 MPa. Source: IAPWS SR6-08(2011), Revised Supplementary Release on
/// Properties of Liquid Water at 0.1 MPa (Patek et al., J. Phys. Chem. Ref. Data 38 (2009) 21);
/// coefficients compared with those of the Python package iapws.
/// Usable to 0.3 MPa; water is compressed by 0.05 % per 1 MPa, which we neglect.

namespace packbed::continuum {

inline constexpr double water_coldest = 253.15;  ///< [K], end of the fit (supercooled)
inline constexpr double water_hottest = 383.15;  ///< [K]

/// [kg/m3]; temperature in K, within the fit.
double water_density(double temperature);

/// Dynamic viscosity [Pa s]; temperature in K, within the fit.
double water_viscosity(double temperature);

}  // namespace packbed::continuum
