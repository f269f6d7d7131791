package org.robotui.xbot;

import java.util.List;

/**
 * What there is: written by the supervisor, read whole.
 *
 * @param robot the robot's name
 * @param hal what moves it, such as {@code dummy}
 * @param realTime false where the control runs without real-time rights
 * @param halRespawns how often the process at the hardware was started again
 * @param joints by index
 * @param imus names of inertial measurement units, by index
 * @param forceTorques names of force-torque sensors, by index
 * @param hosts processes of plugins, by index
 * @param plugins by index
 * @param chains the joints that belong together
 */
public record Board(
    String robot,
    String hal,
    boolean realTime,
    long halRespawns,
    List<Joint> joints,
    List<String> imus,
    List<String> forceTorques,
    List<Host> hosts,
    List<Plugin> plugins,
    List<Chain> chains) {
  /**
   * One joint. Positions are radians where it turns, metres where it slides; infinite limits are none.
   *
   * @param name its name in the URDF
   * @param id its number in the joint map
   * @param prismatic whether it slides
   * @param lower least position
   * @param upper greatest position
   * @param velocity greatest speed per second
   * @param effort greatest effort, newton metres or newton
   */
  public record Joint(String name, int id, boolean prismatic, double lower, double upper, double velocity,
      double effort) {}

  /**
   * One process of plugins.
   *
   * @param name its name
   * @param pid its process, 0 while there is none
   * @param respawns how often it was started again
   * @param error why it is not there, or empty
   */
  public record Host(String name, int pid, long respawns, String error) {}

  /**
   * One plugin.
   *
   * @param name its name in the configuration
   * @param type its library
   * @param host index of its process
   * @param thread index of its thread in the process
   * @param state where in its life it is
   * @param respawns how often it was lost with its process
   * @param io whether it is an IO plugin of the communication handler
   * @param error why it failed, or empty
   * @param status what it says of itself, may be empty
   */
  public record Plugin(
      String name,
      String type,
      int host,
      int thread,
      PluginState state,
      long respawns,
      boolean io,
      String error,
      String status) {}

  /**
   * A chain of joints.
   *
   * @param name of the group in the SRDF
   * @param joints indices of its joints, from base to tip
   */
  public record Chain(String name, List<Integer> joints) {
    /**
     * Copies the list.
     *
     * @param name of the group
     * @param joints indices
     */
    public Chain {
      joints = List.copyOf(joints);
    }
  }

  /** Where in its life a plugin is. */
  public enum PluginState {
    /** Its process is not there. */
    ABSENT,
    /** Its library is loaded. */
    LOADED,
    /** It is ready. */
    STOPPED,
    /** It begins. */
    STARTING,
    /** It is called in every period. */
    RUNNING,
    /** It ends. */
    STOPPING,
    /** It failed. */
    FAILED
  }

  /**
   * Copies the lists.
   *
   * @param robot the robot's name
   * @param hal what moves it
   * @param realTime whether it has real-time rights
   * @param halRespawns restarts of the process at the hardware
   * @param joints by index
   * @param imus by index
   * @param forceTorques by index
   * @param hosts by index
   * @param plugins by index
   * @param chains the joints that belong together
   */
  public Board {
    joints = List.copyOf(joints);
    imus = List.copyOf(imus);
    forceTorques = List.copyOf(forceTorques);
    hosts = List.copyOf(hosts);
    plugins = List.copyOf(plugins);
    chains = List.copyOf(chains);
  }
}
