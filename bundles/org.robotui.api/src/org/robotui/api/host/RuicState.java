package org.robotui.api.host;

/** The life cycle of a RUIC or a component. */
public enum RuicState {
  /** Known, nothing created. */
  ADDED,
  /** Components created, robot interfaces running, views idle. */
  INITIALIZED,
  /** Shown in a window: views tick. */
  SELECTED,
  /** Not shown: robot interfaces go on, views draw nothing. */
  UNSELECTED,
  /** Ended, nothing left. */
  SHUT_DOWN,
  /** Broken, with a reason; a restart makes a new instance. */
  FAILED
}
