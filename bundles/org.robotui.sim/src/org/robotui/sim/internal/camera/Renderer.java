package org.robotui.sim.internal.camera;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.sim.internal.world.FloorPlanReader;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.Room;
import org.robotui.sim.internal.world.Shapes;
import org.robotui.sim.internal.world.Solid;
import org.robotui.sim.internal.world.Walker;
import org.robotui.sim.internal.world.World;

/** Renders what the robot's camera sees, one column of the picture after the other. For one thread. */
public final class Renderer {
  private static final int MARKER = 0x3fb68b;
  private static final int HAZE = 0xb9bcc0;
  private static final double HAZE_DISTANCE = 26;
  private static final double SKIRTING = 0.09;

  private final World world;
  private final Lens lens;
  private final Surface floor;
  private final Surface ceiling;
  private final Hits hits = new Hits();
  private final int[] pixels;

  public Renderer(World world, Lens lens) {
    this.world = world;
    this.lens = lens;
    SurfaceBaker baker = new SurfaceBaker(world);
    floor = baker.floor();
    ceiling = baker.ceiling();
    pixels = new int[lens.width() * lens.height()];
  }

  /**
   * Renders a picture.
   *
   * @param robot where it stands
   * @param goal a place to be marked
   * @param person where somebody stands
   * @return pixels of 0xrrggbb, row by row from the top; overwritten by the next call
   */
  public int[] render(Pose2 robot, Optional<Pose2> goal, Optional<Pose2> person) {
    List<Solid> solids = new ArrayList<>(world.solids());
    goal.ifPresent(place -> addMarker(solids, place));
    person.ifPresent(place -> solids.addAll(Walker.figure(place)));
    Pose2 eye = robot.times(new Pose2(lens.forward(), 0, 0));
    double cos = Math.cos(eye.yaw());
    double sin = Math.sin(eye.yaw());
    for (int column = 0; column < lens.width(); column++) {
      double side = (lens.centreX() - column - 0.5) / lens.focalLength();
      Ray ray = new Ray(eye.x(), eye.y(), cos - side * sin, sin + side * cos);
      hits.collect(solids, ray.x(), ray.y(), ray.dx(), ray.dy());
      renderColumn(column, ray);
    }
    return pixels;
  }

  /** The direction has length 1 along the optical axis, so that ray parameters are depths. */
  private record Ray(double x, double y, double dx, double dy) {}

  private static void addMarker(List<Solid> solids, Pose2 goal) {
    Solid.Kind kind = Solid.Kind.GLOWING;
    solids.add(Shapes.column(kind, MARKER, goal.x(), goal.y(), 0.22, 0, 0.02));
    solids.add(Shapes.column(kind, 0xe8f4ee, goal.x(), goal.y(), 0.02, 0.02, 0.75));
    solids.add(Shapes.column(kind, MARKER, goal.x(), goal.y(), 0.11, 0.75, 1.0));
  }

  private void renderColumn(int column, Ray ray) {
    int first = hits.firstVisible(FloorPlanReader.ROOM_HEIGHT);
    double depth = hits.count() == 0 ? HAZE_DISTANCE : hits.enter(first);
    renderCeiling(column, ray, lineAt(FloorPlanReader.ROOM_HEIGHT, depth));
    renderFloor(column, ray, lineAt(0, depth));
    for (int i = first; i < hits.count(); i++) {
      renderSolid(column, ray, i);
    }
  }

  /** The screen line, from the top, of a height at a depth. */
  private double lineAt(double height, double depth) {
    return lens.centreY() - (height - lens.above()) * lens.focalLength() / depth;
  }

  private void renderCeiling(int column, Ray ray, double end) {
    double rise = FloorPlanReader.ROOM_HEIGHT - lens.above();
    for (int line = 0; line < Math.min(lens.height(), end + 1) && line + 0.5 < lens.centreY(); line++) {
      double depth = rise * lens.focalLength() / (lens.centreY() - line - 0.5);
      pixels[line * lens.width() + column] = sample(ceiling, ray, depth);
    }
  }

  private void renderFloor(int column, Ray ray, double begin) {
    int first = Math.max((int) begin - 1, (int) lens.centreY() + 1);
    for (int line = first; line < lens.height(); line++) {
      double depth = lens.above() * lens.focalLength() / (line + 0.5 - lens.centreY());
      pixels[line * lens.width() + column] = sample(floor, ray, depth);
    }
  }

  private int sample(Surface surface, Ray ray, double depth) {
    double pixelSize = depth * depth / (lens.above() * lens.focalLength());
    int colour = surface.at(ray.x() + depth * ray.dx(), ray.y() + depth * ray.dy(), surface.levelFor(pixelSize));
    return haze(colour, depth);
  }

  private static int haze(int colour, double depth) {
    return Rgb.mix(colour, HAZE, Math.min(0.6, depth / HAZE_DISTANCE));
  }

  private void renderSolid(int column, Ray ray, int hit) {
    Solid solid = hits.solid(hit);
    double near = hits.enter(hit);
    double far = hits.exit(hit);
    int colour = colourOf(solid, ray, near, hits.edge(hit));
    double top = lineAt(solid.top(), near);
    double bottom = lineAt(solid.bottom(), near);
    boolean wall = solid.kind() == Solid.Kind.WALL;
    if (!wall && solid.top() < lens.above()) {
      fill(column, lineAt(solid.top(), far), top, haze(Rgb.scale(solid.colour(), 1.08), near));
    }
    if (solid.bottom() > lens.above()) {
      fill(column, bottom, lineAt(solid.bottom(), far), haze(Rgb.scale(colour, 0.7), near));
    }
    fill(column, top, bottom, haze(colour, near));
    if (wall && solid.bottom() <= 0) {
      fill(column, lineAt(SKIRTING, near), bottom, haze(Rgb.scale(colour, 0.68), near));
    }
    if (!wall && solid.kind() != Solid.Kind.GLOWING && solid.bottom() <= 0) {
      fill(column, top, Math.min(bottom, top + Math.max(1, 3 / near)), haze(Rgb.scale(colour, 1.15), near));
    }
  }

  private int colourOf(Solid solid, Ray ray, double near, int edge) {
    if (solid.kind() == Solid.Kind.GLOWING) {
      return solid.colour();
    }
    double light = 0.90 + 0.10 * (0.6 * solid.normalX(edge) - 0.8 * solid.normalY(edge));
    return Rgb.scale(solid.kind() == Solid.Kind.WALL ? wallColour(ray, near, solid) : solid.colour(), light);
  }

  /** A wall has the colour of the room in front of it. */
  private int wallColour(Ray ray, double near, Solid wall) {
    double before = near - 0.13;
    Optional<Room> room = world.roomAt(ray.x() + before * ray.dx(), ray.y() + before * ray.dy());
    return room.map(Room::wallColour).orElse(wall.colour());
  }

  /** Fills a part of a column; lines that are covered in part are blended, so that edges are smooth. */
  private void fill(int column, double from, double to, int colour) {
    double first = Math.max(0, from);
    double last = Math.min(lens.height(), to);
    if (first >= last) {
      return;
    }
    int begin = (int) Math.ceil(first);
    int end = (int) last;
    blend(column, begin - 1, Math.min(begin, last) - first, colour);
    for (int line = begin; line < end; line++) {
      pixels[line * lens.width() + column] = colour;
    }
    if (end >= begin) {
      blend(column, end, last - end, colour);
    }
  }

  private void blend(int column, int line, double weight, int colour) {
    if (weight > 0 && line >= 0 && line < lens.height()) {
      int i = line * lens.width() + column;
      pixels[i] = Rgb.mix(pixels[i], colour, weight);
    }
  }
}
