package org.robotui.api.port;

/**
 * What a view takes of the streams that its port fits. Of a port of a robot: whether it is meant for all, or for who
 * names it alone, so that recorders of everything leave it out.
 */
public enum Intake {
  /** All that matching connects; values not yet taken conflate as their type says. */
  MATCHED,
  /**
   * Only what the view chooses with {@link Input#choose}; a robot is not asked for the rest. Every value is queued, of
   * samples too, within bounds of count and size: for plots, echoes, conditions and recorders.
   */
  CHOSEN
}
