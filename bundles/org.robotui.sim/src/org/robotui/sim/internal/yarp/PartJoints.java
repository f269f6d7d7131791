package org.robotui.sim.internal.yarp;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robotui.urdf.Joint;

/**
 * The joints of one part of a humanoid, without masses: they sway about where they begin until one is told something.
 */
final class PartJoints implements BoardJoints {
  private static final double SWAY_RADIANS = 0.12;
  private static final double SWAY_METRES = 0.01;
  private static final double SWAY_PACE = 0.8;
  private static final double BEGINS = 2;

  private final List<Joint> described;
  private final List<BoardJoint> joints;
  private final double sway;
  private final double[] begin; // guarded by this, as the following
  private final double[] at;
  private final double[] speeds;
  private final double[] wishes;
  private final double[] fastest;
  private boolean driven;

  /**
   * @param begin positions in radians or metres
   * @param still whether they do not move by themselves
   */
  PartJoints(List<Joint> described, double[] begin, boolean still) {
    this.described = List.copyOf(described);
    this.joints = described.stream().map(PartJoints::board).toList();
    this.sway = still ? 0 : 1;
    this.begin = new double[begin.length];
    for (int i = 0; i < begin.length; i++) {
      this.begin[i] = within(i, said(described.get(i), begin[i]));
    }
    this.at = this.begin.clone();
    this.speeds = new double[begin.length];
    this.wishes = this.begin.clone();
    this.fastest = new double[begin.length];
  }

  private static BoardJoint board(Joint joint) {
    Optional<Joint.Limits> limits = joint.limits();
    boolean endless = joint.type() == Joint.Type.CONTINUOUS || limits.isEmpty();
    return new BoardJoint(joint.name(), slides(joint),
        said(joint, endless ? -Math.PI : limits.get().lower()), said(joint, endless ? Math.PI : limits.get().upper()),
        said(joint, limits.map(Joint.Limits::velocity).filter(v -> v > 0).orElse(1.0)));
  }

  private static boolean slides(Joint joint) {
    return joint.type() == Joint.Type.PRISMATIC;
  }

  private static double said(Joint joint, double si) {
    return slides(joint) ? si : Math.toDegrees(si);
  }

  private double within(int joint, double position) {
    return Math.clamp(position, joints.get(joint).lower(), joints.get(joint).upper());
  }

  /** Goes on: seconds since the begin, and since the last time. */
  synchronized void step(double time, double dt) {
    for (int i = 0; i < at.length; i++) {
      double next = driven ? at[i] + Math.clamp(wishes[i] - at[i], -fastest[i] * dt, fastest[i] * dt)
          : swayed(i, time);
      speeds[i] = (next - at[i]) / dt;
      at[i] = next;
    }
  }

  private double swayed(int joint, double time) {
    Joint one = described.get(joint);
    double most = slides(one) ? SWAY_METRES : said(one, SWAY_RADIANS);
    double grown = sway * Math.min(1, time / BEGINS);
    return within(joint, begin[joint] + grown * most * Math.sin(SWAY_PACE * time + joint));
  }

  @Override
  public List<BoardJoint> joints() {
    return joints;
  }

  @Override
  public synchronized List<JointMotion> motions() {
    return IntStream.range(0, at.length).mapToObj(i -> new JointMotion(at[i], speeds[i])).toList();
  }

  @Override
  public synchronized void move(int joint, double position, double speed) {
    begin();
    wishes[joint] = within(joint, position);
    fastest[joint] = Math.min(speed, joints.get(joint).fastest());
  }

  /** The others stay where they are. */
  private void begin() {
    if (!driven) {
      driven = true;
      System.arraycopy(at, 0, wishes, 0, at.length);
    }
  }

  @Override
  public synchronized void stay(int joint) {
    begin();
    wishes[joint] = at[joint];
  }
}
