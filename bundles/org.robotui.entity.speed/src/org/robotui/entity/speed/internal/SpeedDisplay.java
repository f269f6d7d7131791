package org.robotui.entity.speed.internal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Properties.Entry;
import org.robotui.gl.shape.TriangleMesh;

/** The newest speed, as an arrow in the frame in which it was measured. Called on the worker of the scene. */
final class SpeedDisplay implements Display {

  /** Metres: a shorter arrow is not drawn. */
  private static final double SHORTEST = 0.01;

  private static final double LONGEST = 100;

  private static final double HEAD = 0.25;

  private static final double WIDTH = 0.04;

  private final Recent<Odometry, TriangleMesh> recent =
      new Recent<>(Odometry.class, Anchor.When.NOW, Odometry::childFrame, odometry -> 1);

  @Override
  public DisplayResult update(DisplayTick tick) {
    recent.update(tick);
    Optional<Recent.Entry<Odometry, TriangleMesh>> newest = recent.newest();
    List<Part> parts = newest.map(entry -> parts(entry, tick)).orElse(List.of());
    String words =
        newest.map(entry -> String.format(Locale.ROOT, "%.2f m/s", entry.value().linear().norm())).orElse("");
    return new DisplayResult(parts, recent.status(tick, new DisplayStatus.Shown(words)), recent.dropped());
  }

  private static List<Part> parts(Recent.Entry<Odometry, TriangleMesh> newest, DisplayTick tick) {
    Vector3 speed = newest.value().linear();
    double length = Math.min(LONGEST, speed.norm() * tick.settings().number(SpeedType.SCALE));
    if (length < SHORTEST) {
      return List.of();
    }
    TriangleMesh arrow = newest.prepared(length,
        odometry -> Meshes.arrow(length * (1 - HEAD), length * WIDTH, length * HEAD, 3 * length * WIDTH));
    Material material =
        Material.lit(ColorSetting.read(tick.settings(), SpeedType.COLOR).withAlpha(Recent.opacity(tick)));
    return newest.anchor().found().map(at -> List.of(new Part("arrow", arrow, at.times(towards(speed)), material,
        (element, place) -> Properties.of("Speed", new Entry("speed", speed.norm() + " m/s"))))).orElse(List.of());
  }

  /** From the x axis, along which the mesh points, to a direction. */
  private static RigidTransform towards(Vector3 direction) {
    double yaw = Math.atan2(direction.y(), direction.x());
    double pitch = Math.atan2(-direction.z(), Math.hypot(direction.x(), direction.y()));
    return new RigidTransform(Vector3.ZERO, Quaternion.fromRollPitchYaw(0, pitch, yaw));
  }

  @Override
  public void close() {
    recent.clear();
  }
}
