#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "devices/serial/message_pattern.h"
#include "devices/serial/table_state.h"

namespace vantage {

/// How a table's firmware says where it is and what it does.
struct StatusProfile {
  std::string ask;
  bool immediate = false;  ///< a byte that is obeyed at once, without line end and without an ok
  MessagePattern report;   ///< what a report is known by
  std::optional<MessagePattern> state;
  MessagePattern machine;                ///< position in machine coordinates: one number, or a list of all axes
  std::optional<MessagePattern> work;    ///< position in work coordinates, where the machine's is missing
  std::optional<MessagePattern> offset;  ///< machine = work + offset; not in every report
  std::optional<MessagePattern> count;   ///< a number that changes while the motor turns
  std::map<std::string, TableState> states;
  std::string wait;  ///< command that is over when the table rests; empty where the state tells
};

/// How settings of the board are read that change what its answers mean.
struct BoardSettings {
  std::string ask;
  MessagePattern pattern;  ///< groups: number, value
  std::string inches;      ///< number of the setting that makes it report inches
  std::string homing;      ///< number of the setting that makes it look for its index
};

/// How a table turns.
struct MoveProfile {
  std::string send;  ///< with {axis}, {units}, {feed}, {delta}, {direction} (1 for more units), {magnitude}
  bool relative = false;
  int decimals = 3;           ///< of the units in a command
  double feedSeconds = 60.0;  ///< {feed} is in units per so many seconds
};

/// A firmware of turntables: how it is spoken with. See resources/manual/turntables.md for the fields.
struct TableProfile {
  std::string name;   ///< that of its file, without the ending
  std::string title;  ///< as operators know it
  std::vector<int> baud;
  std::string axis;  ///< one letter, or none
  std::string axes;  ///< letters in the order in which lists of positions have them
  double unitsPerTurn = 360.0;
  int sense = 1;           ///< 1: more units turn it counter-clockwise seen from above; -1
  double speed = 30.0;     ///< [deg/s] asked for
  double slowest = 1.0;    ///< [deg/s] slower than this is taken for stuck where it does not say where it is
  double fastest = 1e6;    ///< [deg/s] what claims to have been faster has not turned
  double tolerance = 0.1;  ///< [deg] between where it was told to go and where it says it is
  /// [deg] turned by so much at a time where it can neither be stopped nor asked: a stop waits for the end of that
  std::optional<double> longestMove;
  std::chrono::milliseconds settle{500};  ///< from its rest to that of the object on it

  std::string lineEnd;
  std::string messageEnds;  ///< characters, each of which ends a message
  std::string prompt;       ///< a character that is a message of its own, without an end; or none
  std::string heartbeat;    ///< a character that comes and goes at any time and means nothing; or none
  bool echo = false;        ///< it repeats every command

  std::optional<MessagePattern> greeting;
  std::chrono::milliseconds greetingWait{3000};
  std::string identify;
  bool identifyImmediate = false;
  MessagePattern identity;
  std::vector<std::string> begin;  ///< commands before the first move

  std::optional<MessagePattern> ok;
  std::optional<MessagePattern> error;
  std::optional<MessagePattern> alarm;
  std::optional<MessagePattern> done;  ///< the move is over

  std::optional<StatusProfile> status;
  std::optional<BoardSettings> settings;
  MoveProfile move;
  std::string stopHold;     ///< byte that slows it down to rest, position kept
  std::string stopReset;    ///< byte that makes it forget the move then
  std::string stopCommand;  ///< or a command that stops it
  std::string unlock;       ///< command after an alarm
  std::string index;        ///< command that makes it look for its index
  std::string motorOff;
  std::map<std::string, std::string> meanings;  ///< of "error:CODE" and "alarm:CODE"
};

/// @throws IoError, InvalidInput that names file, JSON pointer and what was expected
[[nodiscard]] TableProfile readTableProfile(const std::string& path);

/// All that a folder holds, in order of their names. @throws as readTableProfile
[[nodiscard]] std::vector<TableProfile> readTableProfiles(const std::string& folder);

/// Those that a protocol of a SerialTableDevice stands for: all of the folder when it is empty, else the one of that
/// name or, when it has a slash or ends in .json, of that file. After it may follow what differs at this table, each
/// as ":key=value" with a key of the file that holds a number or a text: "grbl:axis=A:units_per_turn=40".
/// @throws IoError, InvalidInput
[[nodiscard]] std::vector<TableProfile> tableProfilesFor(const std::string& protocol, const std::string& folder);

}  // namespace vantage
