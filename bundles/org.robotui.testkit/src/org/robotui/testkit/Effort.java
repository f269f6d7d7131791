package org.robotui.testkit;

import java.time.Duration;

/**
 * How hard tests with random input try: so many rounds in everyday runs; in long ones ({@code ./robotui test --long})
 * as many as a time allows. The times of all such tests together are about an hour. Used by one thread.
 */
public final class Effort {
  private static final int LONG = 50;

  private final int everyday;
  private final long end;
  private int rounds;

  private Effort(int everyday, Duration longRun) {
    this.everyday = everyday;
    this.end = System.nanoTime() + longRun.toNanos();
  }

  /**
   * Rounds of a test that is quick in any case.
   *
   * @param everyday how many in everyday runs
   * @return so many, or fifty times as many in long runs
   */
  public static int rounds(int everyday) {
    return isLong() ? everyday * LONG : everyday;
  }

  /**
   * The effort of one test, beginning now.
   *
   * @param everyday rounds in any run
   * @param longRun how long to go on in long runs, where {@code ROBOTUI_LONG_MINUTES} does not say it
   * @return nothing tried yet
   */
  public static Effort of(int everyday, Duration longRun) {
    String minutes = System.getenv("ROBOTUI_LONG_MINUTES");
    return new Effort(everyday, minutes == null ? longRun : Duration.ofMinutes(Long.parseLong(minutes)));
  }

  /**
   * Where the random input of a test begins, so that several long runs try different things and each can be repeated.
   *
   * @return the number in {@code ROBOTUI_SEED}, 0 where it is not set
   */
  public static long seed() {
    String set = System.getenv("ROBOTUI_SEED");
    return set == null ? 0 : Long.parseLong(set);
  }

  /**
   * Whether this is a long run.
   *
   * @return true with {@code ROBOTUI_LONG=1} in the environment
   */
  public static boolean isLong() {
    return "1".equals(System.getenv("ROBOTUI_LONG"));
  }

  /**
   * Whether to try once more; counts.
   *
   * @return true for another round
   */
  public boolean goesOn() {
    boolean more = rounds < everyday || isLong() && System.nanoTime() < end;
    rounds += more ? 1 : 0;
    return more;
  }

  /**
   * How often it was tried.
   *
   * @return the rounds
   */
  public int rounds() {
    return rounds;
  }
}
