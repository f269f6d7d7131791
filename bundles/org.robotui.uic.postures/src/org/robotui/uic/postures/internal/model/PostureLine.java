package org.robotui.uic.postures.internal.model;

import java.util.Locale;
import java.util.Map;

/**
 * One posture as it is listed.
 *
 * @param index its place, from 0
 * @param posture what it is
 * @param standing how the robot stands to it
 * @param away by how much the farthest joint is away, and which one it is; empty where that is not known
 */
public record PostureLine(int index, Posture posture, Standing standing, String away) {
  private static final double NEAR = 0.02;

  /** How the robot stands to a posture. */
  public enum Standing {
    /** It is elsewhere. */
    ELSEWHERE,
    /** Its joints are there. */
    HERE,
    /** It goes there. */
    TARGET,
    /** It was to go there, and could not. */
    FAILED
  }

  static PostureLine of(int index, Posture posture, RobotNow now, PlayerLook player) {
    String farthest = "";
    double distance = 0;
    boolean known = !now.measured().isEmpty();
    for (Map.Entry<String, Double> joint : posture.joints().entrySet()) {
      double away = Math.abs(now.measured().getOrDefault(joint.getKey(), Double.NaN) - joint.getValue());
      known &= !Double.isNaN(away);
      if (away > distance) {
        distance = away;
        farthest = joint.getKey();
      }
    }
    Standing standing = player.target().filter(posture::equals).isPresent() ? Standing.TARGET
        : player.failed().filter(posture::equals).isPresent() ? Standing.FAILED
            : known && distance < NEAR ? Standing.HERE : Standing.ELSEWHERE;
    String words = !known ? "" : distance < NEAR ? "here" : String.format(Locale.ROOT, "%.2f  %s", distance, farthest);
    return new PostureLine(index, posture, standing, words);
  }

  /** The duration, as users read it. */
  public String time() {
    return String.format(Locale.ROOT, posture.seconds() == Math.rint(posture.seconds()) ? "%.0f s" : "%.1f s",
        posture.seconds());
  }
}
