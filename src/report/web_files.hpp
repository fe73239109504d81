// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The files of src/report/web, put into the program when it is built.

namespace packbed::report {

extern const char* const uplot_script;
extern const char* const uplot_license;
extern const char* const uplot_style;
extern const char* const page_script;
extern const char* const page_style;

}  // namespace packbed::report
