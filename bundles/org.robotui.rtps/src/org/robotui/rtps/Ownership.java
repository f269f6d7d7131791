package org.robotui.rtps;

/** Whether several writers may write one instance. Both ends of a topic must say the same. */
public enum Ownership {
  /** All may. */
  SHARED,
  /** The strongest one alone is heard. */
  EXCLUSIVE
}
