package org.robotui.rtps;

/** Who says that a writer is alive. What is later in this list offers more. */
public enum Liveliness {
  /** Its participant does, by itself. */
  AUTOMATIC,
  /** The application says so for all writers of its participant. */
  MANUAL_BY_PARTICIPANT,
  /** The application says so for each writer. */
  MANUAL_BY_TOPIC
}
