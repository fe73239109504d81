// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How commands are put on the command line (CLI11, which is slow to compile: few files include it).

#include <functional>

#include <CLI/CLI.hpp>

#include "app/bead_commands.hpp"
#include "app/commands.hpp"
#include "app/flow_commands.hpp"
#include "app/wall_support_commands.hpp"

namespace packbed::app {

/// What the user asked for, called once the whole command line has been read.
using Action = std::function<int()>;

void add_json(CLI::App& command, bool& json);

/// `packbed analyze` and `packbed compare`
void add_analyze(CLI::App& app, AnalyzeCommand& options, Action& action);
void add_compare(CLI::App& app, CompareCommand& options, Action& action);

/// `packbed bead ...`
void add_bead(CLI::App& app, BeadCommands& commands, Action& action);

/// `packbed flow ...`
void add_flow(CLI::App& app, FlowCommands& commands, Action& action);

/// `packbed wall-support ...`
void add_wall_support(CLI::App& app, WallSupportCommands& commands, Action& action);

}  // namespace packbed::app
