package org.robotui.rfic.xbot.internal.follow;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * What a plugin says of trajectories. One that was told after another one is followed once it was found good: until
 * then there are two of them.
 *
 * @param told the tag of that which was told last; 0 is none
 * @param toldPhase how far that is
 * @param followed the tag of that which is followed, or was last
 * @param phase how far that is
 * @param seconds on its way
 * @param refusal why what was told was refused
 * @param ending why what was followed was given up
 * @param desired where the joints of the robot are to be: positions, velocities and accelerations, each by index
 */
record FollowReport(long told, Phase toldPhase, long followed, Phase phase, double seconds, String refusal,
    String ending, double[][] desired) {
  private static final int HEAD = 5;
  private static final int LINES = 6;
  private static final int NUMBERS = 3;

  /** How far a trajectory is. */
  enum Phase {
    /** There is none. */
    NONE,
    /** It is being told. */
    TELLING,
    /** It is being checked. */
    CHECKING,
    /** It was refused before it began. */
    REFUSED,
    /** Likewise, as it names other joints than it should. */
    BAD_JOINTS,
    /** It is followed. */
    MOVING,
    /** At its end, joints come within their tolerances. */
    SETTLING,
    /** All was done. */
    DONE,
    /** Somebody stopped it. */
    STOPPED,
    /** A joint left its path tolerance. */
    OFF_PATH,
    /** A joint did not come within its goal tolerance in time. */
    OFF_GOAL
  }

  /** Reads what a supervisor answers; none where it is no such report. */
  static Optional<FollowReport> read(String text) {
    String[] lines = text.split("\n", -1);
    String[] head = lines[0].split(" ", -1);
    if (lines.length < LINES || head.length < HEAD) {
      return Optional.empty();
    }
    try {
      return Optional.of(new FollowReport(Long.parseUnsignedLong(head[0]), phase(head[1]),
          Long.parseUnsignedLong(head[2]), phase(head[3]), Double.parseDouble(head[4]), lines[1], lines[2],
          Arrays.stream(lines, NUMBERS, LINES).map(FollowReport::numbers).toArray(double[][]::new)));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static Phase phase(String word) {
    return Phase.valueOf(word.toUpperCase(Locale.ROOT));
  }

  private static double[] numbers(String line) {
    return line.isEmpty() ? new double[0]
        : Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray();
  }

  /** Whether what was told last was refused. */
  boolean isRefused() {
    return toldPhase == Phase.REFUSED || toldPhase == Phase.BAD_JOINTS;
  }
}
