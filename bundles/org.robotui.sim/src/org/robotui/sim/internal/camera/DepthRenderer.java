package org.robotui.sim.internal.camera;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robotui.sim.internal.world.FloorPlanReader;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.Solid;
import org.robotui.sim.internal.world.Walker;
import org.robotui.sim.internal.world.World;

/** Renders how far away each pixel of the camera's picture is, along the optical axis. For one thread. */
public final class DepthRenderer {
  private static final double NEAREST = 0.3;
  private static final double FARTHEST = 8;

  private final World world;
  private final Lens lens;
  private final Hits hits = new Hits();
  private final double[] column;
  private final short[] depths;

  public DepthRenderer(World world, Lens lens) {
    this.world = world;
    this.lens = lens;
    column = new double[lens.height()];
    depths = new short[lens.width() * lens.height()];
  }

  /**
   * Renders a picture.
   *
   * @param robot where it stands
   * @param person where somebody stands
   * @return millimetres, row by row from the top, zero where nothing is measured; overwritten by the next call
   */
  public short[] render(Pose2 robot, Optional<Pose2> person) {
    List<Solid> solids = new ArrayList<>(world.solids());
    person.ifPresent(place -> solids.addAll(Walker.figure(place)));
    Pose2 eye = robot.times(new Pose2(lens.forward(), 0, 0));
    double cos = Math.cos(eye.yaw());
    double sin = Math.sin(eye.yaw());
    for (int x = 0; x < lens.width(); x++) {
      double side = (lens.centreX() - x - 0.5) / lens.focalLength();
      hits.collect(solids, eye.x(), eye.y(), cos - side * sin, sin + side * cos);
      renderColumn();
      store(x);
    }
    return depths;
  }

  private void renderColumn() {
    Arrays.fill(column, Double.POSITIVE_INFINITY);
    plane(FloorPlanReader.ROOM_HEIGHT, 0, lens.height());
    plane(0, 0, lens.height());
    for (int i = hits.firstVisible(FloorPlanReader.ROOM_HEIGHT); i < hits.count(); i++) {
      solid(hits.solid(i), hits.enter(i), hits.exit(i));
    }
  }

  /** From the farthest to the nearest, each hides what is behind it. */
  private void solid(Solid solid, double near, double far) {
    double top = lineAt(solid.top(), near);
    double bottom = lineAt(solid.bottom(), near);
    if (solid.top() < lens.above()) {
      plane(solid.top(), lineAt(solid.top(), far), top);
    }
    if (solid.bottom() > lens.above()) {
      plane(solid.bottom(), bottom, lineAt(solid.bottom(), far));
    }
    for (int line = first(top); line < last(bottom); line++) {
      column[line] = near;
    }
  }

  /** A level surface, on those of the lines from which it can be seen. */
  private void plane(double height, double from, double to) {
    double rise = (height - lens.above()) * lens.focalLength();
    for (int line = first(from); line < last(to); line++) {
      double depth = rise / (lens.centreY() - line - 0.5);
      if (depth > 0) {
        column[line] = depth;
      }
    }
  }

  private double lineAt(double height, double depth) {
    return lens.centreY() - (height - lens.above()) * lens.focalLength() / depth;
  }

  private static int first(double from) {
    return (int) Math.max(0, Math.round(from));
  }

  private int last(double to) {
    return (int) Math.min(lens.height(), Math.round(to));
  }

  private void store(int x) {
    for (int line = 0; line < lens.height(); line++) {
      double depth = column[line];
      boolean measured = depth >= NEAREST && depth <= FARTHEST;
      depths[line * lens.width() + x] = (short) (measured ? Math.round(1000 * depth) : 0);
    }
  }
}
