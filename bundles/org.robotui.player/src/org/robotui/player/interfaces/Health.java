package org.robotui.player.interfaces;

import org.robotui.player.layout.Kind;

/** How the robot's computer is. The interface {@code health}. */
public final class Health {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("health", "state", State.class);

  private Health() {}

  /**
   * What is in use.
   *
   * @param cpu of the processors
   * @param memory main memory
   * @param swap memory on disk
   */
  public record State(Cpu cpu, Memory memory, Memory swap) {}

  /**
   * Load.
   *
   * @param idle not used, percent
   * @param system used by the operating system, percent
   * @param user used by programs, percent
   */
  public record Cpu(float idle, float system, float user) {}

  /**
   * Memory of one kind.
   *
   * @param total what there is, bytes
   * @param used what is used, bytes
   * @param free what is free, bytes
   */
  public record Memory(long total, long used, long free) {}
}
