package org.robotui.uic.plot.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.joint.JointState;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.KeptHistory;

/** Robots with numbers, for tests and pictures. */
public final class Robots {
  public static final SourceId ODOM = new SourceId("base", "/odom");
  public static final SourceId JOINTS = new SourceId("arm", "/joint_states");
  public static final SourceId SONAR = new SourceId("base", "/sonar");

  private static final long MILLI = 1_000_000L;

  private Robots() {}

  public static Odometry odometry(double forward, double turn) {
    return new Odometry(new FrameId("Keira", "odom"), new FrameId("Keira", "base_link"),
        new RigidTransform(new Vector3(forward, turn, 0), new Quaternion(0, 0, 0, 1)), Doubles.EMPTY,
        new Vector3(forward, 0, 0), new Vector3(0, 0, turn), Doubles.EMPTY);
  }

  public static JointState joints(double phase) {
    List<JointState.Joint> joints = new ArrayList<>();
    for (String name : List.of("shoulder", "elbow", "wrist")) {
      double at = phase * (1 + joints.size());
      joints.add(new JointState.Joint(name, Math.sin(at), Math.cos(at), Double.NaN));
    }
    return new JointState(joints);
  }

  public static void candidates(FakeInput<Data> input) {
    input.candidates(List.of(new Input.Candidate(ODOM, "Odometry"), new Input.Candidate(JOINTS, "JointState"),
        new Input.Candidate(SONAR, "RangeReadings"), new Input.Candidate(new SourceId("base", "/scan"), "LaserScan"),
        new Input.Candidate(new SourceId("base", "/battery"), "Battery"),
        new Input.Candidate(new SourceId("base", "/turtle1/pose"), "turtlesim/Pose")));
  }

  /** Five minutes of driving, recorded. */
  public static KeptHistory run(KeptHistory history) {
    Random random = new Random(2);
    for (int ms = 0; ms <= 300_000; ms += 20) {
      double s = ms / 1000.0;
      double noise = random.nextGaussian() * 0.004;
      double stop = s > 180 && s < 205 ? 0 : 1;
      history.add(ODOM.port(), s, odometry(stop * (0.28 * Math.sin(s / 14) + 0.12) + noise,
          stop * 0.35 * Math.cos(s / 9) - noise));
      if (ms % 100 == 0) {
        history.add(JOINTS.port(), s, joints(s / 20));
      }
    }
    return history;
  }

  /** A minute of driving that ends now. */
  public static void drive(FakeInput<Data> input) {
    drive(input, 0);
  }

  /** A minute of driving that ends now; the values of some milliseconds were lost on the way. */
  public static void drive(FakeInput<Data> input, long lost) {
    candidates(input);
    Random random = new Random(1);
    long now = System.nanoTime();
    for (long ms = -62_000; ms <= 0; ms += 20) {
      double s = ms / 1000.0;
      double noise = random.nextGaussian() * 0.006;
      if (lost > 0 && ms > -9000 && ms <= lost - 9000) {
        input.skip(ODOM, 1);
        continue;
      }
      input.put(ODOM, odometry(0.28 * Math.sin(s / 4) + 0.12 + noise, 0.35 * Math.cos(s / 5) - 0.1 - noise),
          now + ms * MILLI, Optional.empty());
      if (ms % 100 == 0) {
        input.put(JOINTS, joints(s / 6), now + ms * MILLI, Optional.empty());
        RangeReading reading = new RangeReading(new FrameId("Keira", "sonar"), RangeReading.Kind.ULTRASOUND, 0.3, 0.1,
            4, 2 + Math.sin(s / 3) + noise * 20);
        input.put(SONAR, new RangeReadings(List.of(reading)), now + ms * MILLI, Optional.empty());
      }
    }
  }
}
