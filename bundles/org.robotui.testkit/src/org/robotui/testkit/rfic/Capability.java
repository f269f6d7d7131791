package org.robotui.testkit.rfic;

/** What a framework may lack. Checks that need it are then left out, and say so with the reason that the peer gives. */
public enum Capability {
  /** The robot takes a motion. */
  COMMANDS,
  /** The robot sees whether somebody asks for a stream. */
  DEMAND,
  /** Messages carry the time of their measurement. */
  STAMPS,
  /** The framework keeps a list of who is there. */
  REGISTRATIONS,
  /** The robot sees who is linked to it, and one that is away is noticed as such. */
  LINKS,
  /** The robot can be away and come back. */
  RETURN,
  /** The robot can hang: it is linked, takes nothing and says nothing. */
  HANG,
  /** Bytes that nobody can read can be put before the robot interface. */
  GARBAGE
}
