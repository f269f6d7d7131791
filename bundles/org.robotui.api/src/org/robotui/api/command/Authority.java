package org.robotui.api.command;

import java.util.Optional;
import org.robotui.data.command.MotionLimits;

/** Who may command one robot, and its stop. Safe for all threads; never blocks. */
public interface Authority {
  /**
   * The robot's name.
   *
   * @return as in the configuration
   */
  String robot();

  /**
   * Who holds the lease.
   *
   * @return the holder, or none
   */
  Optional<Principal> holder();

  /**
   * Takes the lease. One that somebody else holds is only taken over when the taker has confirmed it.
   *
   * @param principal who takes it
   * @param takeover true where the user confirmed to take it from the holder
   * @return whether it was taken
   */
  LeaseOutcome take(Principal principal, boolean takeover);

  /**
   * Gives the lease back; what the holder moves is stopped. Does nothing where somebody else holds it.
   *
   * @param principal who gives it back
   */
  void giveBack(Principal principal);

  /**
   * Stops and latches: the configured stop call, and zero on the robot's main motion ports and wherever we drove. It is
   * said once, and again as often as the robot reports motion until the stop is released, whoever moves it. Needs no
   * lease and does not depend on the display thread.
   *
   * @param by who stops
   */
  void stop(Principal by);

  /**
   * Releases the stop. Nothing moves by that.
   *
   * @param by who releases
   */
  void releaseStop(Principal by);

  /**
   * How fast the robot may be commanded to move, whoever commands: faster commands are scaled down.
   *
   * @return the strictest limits of its configurations
   */
  MotionLimits limits();

  /**
   * Whether the stop is latched.
   *
   * @return who stopped, or none
   */
  Optional<Principal> stoppedBy();

  /** Whether a lease was taken. */
  sealed interface LeaseOutcome {
    /** It was, or was held already. */
    record Granted() implements LeaseOutcome {}

    /**
     * It was not: ask the user whether to take it over.
     *
     * @param holder who holds it
     */
    record HeldBy(Principal holder) implements LeaseOutcome {}
  }
}
