package org.robotui.api.port;

/** Is told whether anybody wants a stream, so that a robot is only asked for what is looked at. */
@FunctionalInterface
public interface Demand {
  /** Of streams that cost nothing. */
  Demand IGNORED = wanted -> {};

  /**
   * Called on a core thread when the first consumer comes or the last goes; must not block.
   *
   * @param wanted true while there is a consumer
   */
  void changed(boolean wanted);
}
