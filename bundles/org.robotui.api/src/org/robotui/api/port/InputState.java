package org.robotui.api.port;

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
   * The newest value is older than it should be, or is not the newest that was sent.
   *
   * @param ageSeconds age of the newest value
   * @param explanation for example that the link is lost
   * @param refused true where a newer message came, which could not be used
   */
  record Stale(double ageSeconds, String explanation, boolean refused) implements InputState {
    /**
     * A value that is older than it should be.
     *
     * @param ageSeconds age of the newest value
     * @param explanation for example that the link is lost
     */
    public Stale(double ageSeconds, String explanation) {
      this(ageSeconds, explanation, false);
    }
  }

  /**
   * The source failed.
   *
   * @param explanation the failure
   */
  record Failed(String explanation) implements InputState {}
}
