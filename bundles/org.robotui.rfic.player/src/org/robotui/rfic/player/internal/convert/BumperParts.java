package org.robotui.rfic.player.internal.convert;

import java.util.ArrayList;
import java.util.List;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.Bumpers;
import org.robotui.geometry.RigidTransform;
import org.robotui.player.interfaces.Bumper;

/** Bumpers: where the geometry says that they are, and pressed as the state says. */
public final class BumperParts {
  private static final int MOST = 256;

  private BumperParts() {}

  /** Those that the geometry does not tell of have no length. */
  public static Bumpers of(List<Bumper.Part> parts, byte[] pressed, FrameId base) {
    int count = Math.max(parts.size(), pressed.length);
    if (count > MOST) {
      throw new IllegalArgumentException(count + " bumpers are more than the " + MOST + " that a robot can have");
    }
    List<org.robotui.data.sensor.Bumper> bumpers = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      boolean touched = i < pressed.length && pressed[i] != 0;
      bumpers.add(i < parts.size() ? of(parts.get(i), touched)
          : new org.robotui.data.sensor.Bumper(RigidTransform.IDENTITY, 0, 0, touched));
    }
    return new Bumpers(base, bumpers);
  }

  private static org.robotui.data.sensor.Bumper of(Bumper.Part part, boolean pressed) {
    return new org.robotui.data.sensor.Bumper(Poses.mounted(part.pose()), Math.abs(Poses.sane(part.length())),
        Math.abs(Poses.sane(part.radius())), pressed);
  }
}
