// SPDX-License-Identifier: BSD-3-Clause
// Starts MPI and PETSc before the tests, out of sight of the leak checker, and lets it look before they end: Open MPI does not
// free all that it allocates as it starts and ends, in modules that it has unloaded then, so that no suppression could
// name them. What the tests allocate is watched.
#include <gtest/gtest.h>

#include "fluid/petsc_session.hpp"

// Of the sanitizers' run-time library, if it is linked.
extern "C" {
__attribute__((weak)) void __lsan_disable();        // NOLINT
__attribute__((weak)) void __lsan_enable();         // NOLINT
__attribute__((weak)) void __lsan_do_leak_check();  // NOLINT
}

namespace packbed::fluid {
namespace {

class StartMpi : public ::testing::Environment {
 public:
  void SetUp() override {
    if (__lsan_disable != nullptr) __lsan_disable();
    start_petsc();
    if (__lsan_enable != nullptr) __lsan_enable();
  }
  // The check is made once: the one at exit does nothing after this.
  void TearDown() override {
    if (__lsan_do_leak_check != nullptr) __lsan_do_leak_check();
  }
};

const auto* const start_mpi = ::testing::AddGlobalTestEnvironment(new StartMpi);

}  // namespace
}  // namespace packbed::fluid
