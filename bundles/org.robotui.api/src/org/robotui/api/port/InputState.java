package org.robotui.api.port;

import java.util.OptionalDouble;

/** What an input has, and if nothing: why. Each state is shown differently. */
public sealed interface InputState {
  /**
   * A sentence for users.
   *
   * @return what is so, and what would help
   */
  String explanation();

  /**
   * No connection: nothing fits, or several do.
   *
   * @param explanation the reason of the matching
   */
  record Unconnected(String explanation) implements InputState {}

  /**
   * Connected, but nothing came yet.
   *
   * @param explanation what is waited for
   */
  record Waiting(String explanation) implements InputState {}

  /**
   * Data comes.
   *
   * @param rateHz measured rate, 0 where it cannot be told yet
   * @param ageSeconds age of the newest value
   */
  record Live(double rateHz, double ageSeconds) implements InputState {
    @Override
    public String explanation() {
      return "live";
    }
  }

  /**
   * There is a value, but it is older than it should be, is not the newest that was sent, or nothing newer can come.
   * What was received stays in sight, marked as old.
   *
   * @param ageSeconds age of the newest value
   * @param explanation for example that the link is lost
   * @param refused true where a newer message came, which could not be used
   * @param lostSeconds for how long nothing can come, as the link is lost, the source failed or nobody publishes any
   * more; empty where values are merely late
   */
  record Stale(double ageSeconds, String explanation, boolean refused, OptionalDouble lostSeconds)
      implements InputState {
    /**
     * Values are late.
     *
     * @param ageSeconds age of the newest value
     * @param explanation how late
     */
    public Stale(double ageSeconds, String explanation) {
      this(ageSeconds, explanation, false, OptionalDouble.empty());
    }

    /**
     * Newer messages came, which could not be used.
     *
     * @param ageSeconds age of the newest value
     * @param explanation what is wrong with them
     * @return the state
     */
    public static Stale refused(double ageSeconds, String explanation) {
      return new Stale(ageSeconds, explanation, true, OptionalDouble.empty());
    }

    /**
     * Nothing newer can come.
     *
     * @param ageSeconds age of the newest value
     * @param explanation why
     * @param lostSeconds for how long
     * @return the state
     */
    public static Stale lost(double ageSeconds, String explanation, double lostSeconds) {
      return new Stale(ageSeconds, explanation, false, OptionalDouble.of(lostSeconds));
    }
  }

  /**
   * The source failed before it gave anything. One that failed later is {@link Stale}.
   *
   * @param explanation the failure
   */
  record Failed(String explanation) implements InputState {}
}
