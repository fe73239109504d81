// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The commands of the program, one file each. Each prints to standard output, throws Error, and
/// returns the code for the shell.

#include <filesystem>
#include <string>
#include <vector>

namespace packbed::app {

struct CheckCommand {
  std::filesystem::path file;
  std::filesystem::path mesh_svg;  ///< file to draw the mesh to; empty: none
  bool json = false;
};
int check(const CheckCommand& command);

struct RunCommand {
  std::filesystem::path file;
  std::string directory;  ///< empty: as the case says
  bool overwrite = false;
  bool resume = false;  ///< from the last checkpoint in the folder
  int ranks = 0;        ///< processes to start; 0: as many as serve
  bool json = false;
};
int run(const RunCommand& command);

struct ReportCommand {
  std::vector<std::filesystem::path> runs;  ///< folders; several are compared
  std::filesystem::path output;    ///< empty: report.html in the folder, or comparison.html
  std::filesystem::path measured;  ///< table to show in place of the runs' own; empty: none
};
int report(const ReportCommand& command);

struct AnalyzeCommand {
  std::filesystem::path run;     ///< folder
  std::filesystem::path output;  ///< folder; empty: analysis in that of the run
  int frame = -1;                ///< this one alone; -1: those at ends of stages
  bool all = false;              ///< all frames
  bool json = false;
};
int analyze(const AnalyzeCommand& command);

struct CompareCommand {
  std::vector<std::filesystem::path> runs;  ///< folders
  std::filesystem::path output = "comparison.html";
  std::filesystem::path csv;  ///< empty: none
};
int compare(const CompareCommand& command);

struct ResinsCommand {
  std::string name;     ///< empty: list all
  std::string library;  ///< file of the user's own; empty: none
  bool json = false;
};
int resins(const ResinsCommand& command);

struct UnitsCommand {
  bool json = false;
};
int units(const UnitsCommand& command);

}  // namespace packbed::app
