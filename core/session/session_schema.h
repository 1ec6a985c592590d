#pragma once

#include <string>
#include <vector>

#include "session/database.h"

namespace vantage {

/// The tables of a session file, version 5. core/session/README.md tells how to read them with the sqlite3 shell.
///
///   meta(key, value)      schema, program; cursor and tip: the steps that hold now and that redo ends at; note:...
///   file(name, content)   the profile as it was read (profile.json), and the files that it names
///   object(id, hash, mesh)                           what the simulated scanner looks at, zstd
///   rays(id, rows, columns, receivers, data)         ranging rays of recorded scans, zstd
///   scan(id, stand, position, known_by, angle_sigma, position_sigma, taken_with, rays, nominal, range, colours)
///                                                    every range image as it came, zstd over 32-bit floats; never
///                                                    deleted; position NULL: of none; sigmas [rad, mm] of the pose,
///                                                    NULL: those of the profile; taken_with: the devices, as they
///                                                    name themselves; colours: zstd over three bytes per ray
///   step(id, parent, kind, command, settings, mode, stands, chosen, termination, views, model, plan, hash)
///                                                    every command that was carried out, what it led to; chosen NULL:
///                                                    as proposed
///   view(step, place, scan, status, pose, record, plan)
///                                                    per step the scans with what became of them; record and plan
///                                                    name the steps that made them
///   record(step, scan, data)                         what a scan brought: registration, areas, times
///   plan(step, summary, data)                        the plan made in a step; data: what is per patch, zstd
///   model(step, data)                                the model made in a step, zstd; can be made again
///   event(id, what, step)                            every command, undo and redo, in order
///
/// Every row ends with a `sum` over its table's name and its other columns, so that what was changed behind the
/// program's back is noticed. Poses are 12 doubles, the first three rows of T_object_scanner (view) or T_table_scanner
/// (scan). Bytes are little endian.
inline constexpr int kSessionSchema = 5;

/// Names of the tables of a version in the order above.
[[nodiscard]] std::vector<std::string> sessionTables(int version);

void createSessionTables(Database& database, int version = kSessionSchema);
/// One of them.
void createSessionTable(Database& database, int version, const std::string& name);

/// "INSERT INTO table VALUES(?1, ..., row_sum(...))": a row with its sum. The second replaces one with the same key.
[[nodiscard]] std::string insertInto(const std::string& table);
[[nodiscard]] std::string replaceIn(const std::string& table);
/// An expression: whether a row is as it was written. @param alias of the table in the query.
[[nodiscard]] std::string intact(const std::string& table, const std::string& alias = {}, int version = kSessionSchema);
/// Sums for rows that have none yet.
void addSums(Database& database, const std::string& table, int version = kSessionSchema);
/// The column by which the rows of a table are told apart.
[[nodiscard]] const char* keyOf(const std::string& table);

/// @return the schema's version.
/// @throws InvalidInput when the database is not a session: its tables are not exactly those of a version.
[[nodiscard]] int checkSessionTables(Database& database);

}  // namespace vantage
