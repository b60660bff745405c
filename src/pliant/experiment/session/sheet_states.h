#pragma once

#include <vector>

#include "pliant/measurement/session.h"

namespace pliant {

/// Boundary conditions of an equilibrium.
struct SheetState {
  int frame = 0;  ///< whose clips hold the sheet, and whose shape is the first guess
  std::vector<int> held;
};

/// A frame between two states: share of the second, from 0 to 1; both are one where it is 0.
struct SheetBlend {
  int first = 0, second = 0;
  double share = 0;
};

/// The equilibria that a session's frames are made of.
///
/// With clips each frame is a state. A table holds whole rows of nodes, as if its edge were at
/// certain places: what a session's frames say of an edge between two of them is interpolated
/// between the two equilibria, so that the overhang does not grow by steps of a mesh.
struct SheetStates {
  std::vector<SheetState> states;
  std::vector<SheetBlend> frames;
};

SheetStates sheet_states(const Session& session);

/// The states in which a table may hold the mesh, needed by a frame or not: from the sheet that
/// hangs furthest to the one that lies on the table whole. Frames lie between neighbours.
/// @param session  with a table
SheetStates states_on_table(const Session& session);

/// Where the edge of a table seems to be that holds some nodes of a mesh (m, along the table's
/// axis): hinges all of whose vertices are held do not bend, and reach so far from the sheet's
/// beginning, each counted by what it adds to the stiffness against bending about the edge.
double edge_of_held(const Session& session, const std::vector<int>& held);

}  // namespace pliant
