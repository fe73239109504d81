// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace packbed::fluid {

/// Starts MPI, where it does not run, and PETSc, the first time; PETSc ends with MPI, and MPI with the
/// program or where its session ends (core/ranks.hpp). Nothing of the user's environment for PETSc counts.
void start_petsc();

}  // namespace packbed::fluid
