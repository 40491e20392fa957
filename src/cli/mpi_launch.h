// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

/// \file
/// How `mpirun` started the program, and the program that links MPI.

namespace endmill {

/// The processes that a launcher of MPI started.
struct MpiLaunch {
    int count = 1;  ///< number of processes; 1 without a launcher
    int rank = 0;   ///< of this process
};

/// What the launcher wrote into the environment: `mpirun` of Open MPI, launchers that speak
/// PMI, or `srun` with PMIx.
MpiLaunch mpi_launch();

/// Removes it from the environment, so that a child process does not take itself for a rank.
void forget_mpi_launch();

/// The program `endmill-mpi` beside this one; empty if it is not there.
std::filesystem::path mpi_program();

}  // namespace endmill
