package org.robotui.rfic.line.internal;

/** What can be wrong with a robot interface, and the check that has to find it. */
enum Flaw {
  NONE(""),
  GREEN_TOO_EARLY("is connecting first, and connected only when the robot is there"),
  GREEN_THOUGH_MUTE("is not connected to a robot that hangs from the beginning"),
  MILLIMETRES("brings what the robot says, in SI units and in frames of this robot"),
  OWN_STAMPS("tells when something was measured, by the clock of its source"),
  BRINGS_ALL("brings nothing that nobody wants"),
  ASKS_FOR_ALL("asks the robot for nothing that nobody wants"),
  FORGETS_DEMAND("tells why a robot is lost, and brings its data again when it is back"),
  SWALLOWS_GARBAGE("complains of what nobody can read, and goes on"),
  HEARS_ITSELF("tells of a robot that hangs though it is commanded"),
  DEGREES("takes motions, and the robot hears them with their units"),
  NEVER_STOPS("stops what it drives when it ends"),
  STOPS_OTHERS("leaves alone at its end what it drives no more"),
  SENDS_AFTER_END("sends nothing after its end"),
  KEEPS_COMMANDS("keeps no command for a robot that comes back"),
  LEAVES_OFFERS("withdraws at its end all that it offered, and brings nothing more"),
  LEAVES_THREAD("ends while it calls a robot that is away"),
  LEAVES_SOCKET("unlinks itself from the robot"),
  HANGS_AT_END("ends in time while the robot hangs");

  final String found;

  Flaw(String found) {
    this.found = found;
  }
}
