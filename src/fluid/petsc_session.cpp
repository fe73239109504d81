// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/petsc_session.hpp"

#include <cstdlib>

#include <petscsys.h>

#include "core/error.hpp"

namespace packbed::fluid {
namespace {

void end_mpi() {
  int ended = 0;
  MPI_Finalized(&ended);
  if (ended == 0) MPI_Finalize();
}

// MPI_Finalize frees MPI_COMM_SELF first of all, and so calls this while MPI still works.
int end_petsc(MPI_Comm /*comm*/, int /*key*/, void* /*value*/, void* /*state*/) {
  return PetscFinalize() == 0 ? MPI_SUCCESS : MPI_ERR_OTHER;
}

bool start() {
  int started = 0;
  MPI_Initialized(&started);
  if (started == 0) {
    MPI_Init(nullptr, nullptr);
    std::atexit(end_mpi);
  }
  ::unsetenv("PETSC_OPTIONS");  // a run depends on its case alone
  PetscOptionsSetValue(nullptr, "-skip_petscrc", "1");
  PetscOptionsSetValue(nullptr, "-no_signal_handler", "1");  // signals are the program's
  if (PetscInitializeNoArguments() != 0) throw DivergenceError("PETSc cannot be started");
  PetscPopSignalHandler();
  PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
  int key = MPI_KEYVAL_INVALID;
  MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, end_petsc, &key, nullptr);
  MPI_Comm_set_attr(MPI_COMM_SELF, key, nullptr);
  MPI_Comm_free_keyval(&key);
  return true;
}

}  // namespace

void start_petsc() {
  static const bool started = start();
  static_cast<void>(started);
}

}  // namespace packbed::fluid
