package org.robotui.rfic.player.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.data.Bytes;
import org.robotui.data.Color;
import org.robotui.data.Floats;
import org.robotui.data.FrameId;
import org.robotui.data.Marker;
import org.robotui.data.MarkerSet;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.player.interfaces.Bumper;

/** Bumpers as lines around the robot, for scenes: red where they are pressed. */
public final class Bumpers {
  private static final int MOST = 256;
  private static final int STEPS = 8;
  private static final double WIDTH = 0.02;
  private static final double HALF_TURN = Math.PI / 2;
  private static final Color FREE = new Color(0.55f, 0.6f, 0.65f, 1);
  private static final Color PRESSED = new Color(0.9f, 0.1f, 0.1f, 1);

  private Bumpers() {}

  public static MarkerSet of(Bumper.Geometry geometry, byte[] pressed, FrameId base, String device, Optional<Stamp> stamp, long nanos) {
    if (geometry.bumpers().size() > MOST) {
      throw new IllegalArgumentException(geometry.bumpers().size() + " bumpers are more than the " + MOST + " that a robot can have");
    }
    List<MarkerSet.Entry> entries = new ArrayList<>();
    for (int i = 0; i < geometry.bumpers().size(); i++) {
      Marker.Key key = new Marker.Key(device, i);
      Color color = i < pressed.length && pressed[i] != 0 ? PRESSED : FREE;
      entries.add(new MarkerSet.Entry(key, Optional.of(new Marker(key, base, stamp, nanos, Marker.Type.LINE_STRIP, RigidTransform.IDENTITY,
          new Vector3(WIDTH, 0, 0), color, 0, true, line(geometry.bumpers().get(i)), Bytes.EMPTY, "", "", false))));
    }
    return new MarkerSet(true, entries);
  }

  /** A bumper looks along its x axis and lies along its y axis, bent by its radius away from where it looks. */
  private static Floats line(Bumper.Part part) {
    RigidTransform pose = Poses.mounted(part.pose());
    double half = Math.abs(Poses.sane(part.length())) / 2;
    double radius = Math.abs(Poses.sane(part.radius()));
    float[] points = new float[3 * (STEPS + 1)];
    for (int i = 0; i <= STEPS; i++) {
      double along = half * (2.0 * i / STEPS - 1);
      double angle = radius > 0 ? Math.clamp(along / radius, -HALF_TURN, HALF_TURN) : 0;
      Vector3 point = radius > 0
          ? new Vector3(radius * (Math.cos(angle) - 1), radius * Math.sin(angle), 0)
          : new Vector3(0, along, 0);
      Vector3 on = pose.apply(point);
      points[3 * i] = (float) on.x();
      points[3 * i + 1] = (float) on.y();
      points[3 * i + 2] = (float) on.z();
    }
    return Floats.wrap(points);
  }
}
