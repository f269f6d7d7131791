package org.robotui.data.control;

import java.util.List;
import org.robotui.data.Data;

/**
 * The plugins of a robot's control.
 *
 * @param plugins in the order of the configuration
 */
public record ControlPlugins(List<Plugin> plugins) implements Data {
  /** Where in its life a plugin is. */
  public enum State {
    /** Its process is not there. */
    ABSENT,
    /** Its library is loaded, it is not ready yet. */
    LOADED,
    /** It is ready and does nothing. */
    STOPPED,
    /** It begins. */
    STARTING,
    /** It is called in every period. */
    RUNNING,
    /** It ends. */
    STOPPING,
    /** It could not be loaded or made ready, or it failed while it ran. */
    FAILED
  }

  /**
   * One plugin.
   *
   * @param name its name in the configuration
   * @param type its library
   * @param process the process it lives in
   * @param thread the thread that calls it
   * @param state where in its life it is
   * @param status what it says of itself, may be empty
   * @param error why it failed, whole; empty where it did not
   * @param respawns how often its process was started again
   * @param period of its thread, nanoseconds
   * @param cycles how often it was called
   * @param busy how long a call took
   */
  public record Plugin(
      String name,
      String type,
      String process,
      String thread,
      State state,
      String status,
      String error,
      long respawns,
      long period,
      long cycles,
      Histogram busy) {}

  /**
   * Copies the list.
   *
   * @param plugins in the order of the configuration
   */
  public ControlPlugins {
    plugins = List.copyOf(plugins);
  }
}
