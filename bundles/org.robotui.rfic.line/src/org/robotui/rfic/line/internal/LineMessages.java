package org.robotui.rfic.line.internal;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** What messages mean. The robot speaks in millimetres and degrees, data types in metres and radians (REP 103). */
final class LineMessages {

  private static final double MILLIMETRES = 1000;

  private static final long LAST_SECOND = Duration.ofNanos(Long.MAX_VALUE).toSeconds() - 1;

  /**
   * Where the robot is.
   *
   * @param odometry its pose
   * @param stamp when it was measured, by the robot's clock
   */
  record Pose(Odometry odometry, Stamp stamp) {

    /** Where the robot is in its frame of odometry, by which maps and scenes find it. */
    TransformSet frames() {
      return new TransformSet(
          List.of(new FrameTransform(odometry.frame(), odometry.childFrame(), stamp, odometry.pose(), false)));
    }
  }

  private LineMessages() {}

  /**
   * Reads {@code pose SECONDS X Y}, the position in millimetres.
   *
   * @param robot whose frames are meant
   * @throws IllegalArgumentException where it is no such message
   */
  static Pose pose(String text, String robot) {
    String[] words = text.split(" ");
    if (words.length != 4) {
      throw new IllegalArgumentException("a pose has three numbers, this one " + (words.length - 1));
    }
    RigidTransform pose = RigidTransform.planar(number(words[2]) / MILLIMETRES, number(words[3]) / MILLIMETRES, 0);
    Odometry odometry = new Odometry(new FrameId(robot, "odom"), new FrameId(robot, "base"), pose, Doubles.EMPTY,
        Vector3.ZERO, Vector3.ZERO, Doubles.EMPTY);
    long seconds = (long) number(words[1]);
    if (seconds < 0 || seconds > LAST_SECOND) {
      throw new IllegalArgumentException("a pose was measured at " + seconds + " s, which is no time");
    }
    return new Pose(odometry, Stamp.of(seconds, 0, ClockKind.ROBOT));
  }

  /** {@code drive MILLIMETRES_PER_SECOND DEGREES_PER_SECOND}. */
  static String drive(VelocityCommand command) {
    return "drive " + command.linear().x() * MILLIMETRES + " " + Math.toDegrees(command.angular().z());
  }

  static byte[] encoded(String text) {
    return (text + "\n").getBytes(StandardCharsets.UTF_8);
  }

  private static double number(String word) {
    double number = Double.parseDouble(word);
    if (!Double.isFinite(number)) {
      throw new IllegalArgumentException("a pose has the number " + word);
    }
    return number;
  }
}
