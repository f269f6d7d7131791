package org.robotui.api.command;

/** What became of a command. */
public sealed interface CommandOutcome {
  /** The arbiter took it and sends it on. */
  record Accepted() implements CommandOutcome {}

  /**
   * It was refused and will not be sent.
   *
   * @param why the rule
   * @param explanation a sentence for users, with what would help
   */
  record Refused(Why why, String explanation) implements CommandOutcome {}

  /** Why a command was refused. */
  enum Why {
    /** No connection to such a port. */
    NOT_CONNECTED,
    /** The link is down. */
    LINK_DOWN,
    /** The stop is latched. */
    STOPPED,
    /** Somebody else, or nobody, holds the lease. */
    NO_LEASE,
    /** The display was silent too long. */
    DISPLAY_SILENT,
    /** It was too old. */
    EXPIRED,
    /** The robot interface or the robot refused it. */
    ROBOT
  }
}
