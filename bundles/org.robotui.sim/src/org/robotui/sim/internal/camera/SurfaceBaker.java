package org.robotui.sim.internal.camera;

import java.util.Optional;
import org.robotui.sim.internal.world.FloorPlanReader;
import org.robotui.sim.internal.world.Room;
import org.robotui.sim.internal.world.Solid;
import org.robotui.sim.internal.world.World;

/** Paints the floors and ceilings once: patterns, lamps, and the soft shadow at the foot of everything. */
final class SurfaceBaker {
  private static final double RESOLUTION = 0.025;
  private static final double SHADOW_REACH = 0.35;
  private static final int CEILING = 0xe9e7e1;
  private static final int LAMP = 0xfffdf4;
  private static final int OUTSIDE = 0x777570;

  private final World world;
  private final double maxX;
  private final double maxY;

  SurfaceBaker(World world) {
    this.world = world;
    maxX = world.rooms().stream().mapToDouble(Room::x2).max().orElse(0);
    maxY = world.rooms().stream().mapToDouble(Room::y2).max().orElse(0);
  }

  private interface Painter {
    int colourAt(double x, double y);
  }

  Surface floor() {
    return bake((x, y) -> Rgb.scale(floorColour(x, y), shadow(x, y, 0.05)));
  }

  Surface ceiling() {
    return bake((x, y) -> Rgb.scale(ceilingColour(x, y), shadow(x, y, FloorPlanReader.ROOM_HEIGHT - 0.05)));
  }

  private Surface bake(Painter painter) {
    int width = (int) Math.ceil(maxX / RESOLUTION);
    int height = (int) Math.ceil(maxY / RESOLUTION);
    int[] pixels = new int[width * height];
    for (int i = 0; i < pixels.length; i++) {
      pixels[i] = painter.colourAt((i % width + 0.5) * RESOLUTION, (i / width + 0.5) * RESOLUTION);
    }
    return new Surface(0, 0, RESOLUTION, width, height, pixels);
  }

  private double shadow(double x, double y, double height) {
    double nearest = SHADOW_REACH;
    for (Solid solid : world.solids()) {
      if (solid.covers(height) && solid.isNear(x, y, nearest)) {
        nearest = Math.min(nearest, Math.max(0, solid.distance(x, y)));
      }
    }
    double light = nearest / SHADOW_REACH;
    return 1 - 0.34 * (1 - light) * (1 - light);
  }

  private int floorColour(double x, double y) {
    Optional<Room> room = world.roomAt(x, y);
    if (room.isEmpty()) {
      return OUTSIDE;
    }
    int colour = room.get().floorColour();
    return switch (room.get().floor()) {
      case PLANK -> plank(colour, x, y);
      case TILE -> tile(colour, x, y);
      case CARPET -> Rgb.scale(colour, 0.96 + 0.08 * noise((int) (x * 40), (int) (y * 40)));
    };
  }

  private static int plank(int colour, double x, double y) {
    int row = (int) Math.floor(y / 0.2);
    double along = x + 1.3 * noise(row, 7);
    int plank = (int) Math.floor(along / 1.5);
    boolean joint = y - row * 0.2 < 0.02 || along - plank * 1.5 < 0.02;
    double tone = 0.93 + 0.14 * noise(row, plank);
    return Rgb.scale(colour, joint ? tone * 0.84 : tone);
  }

  private static int tile(int colour, double x, double y) {
    int column = (int) Math.floor(x / 0.5);
    int row = (int) Math.floor(y / 0.5);
    boolean joint = x - column * 0.5 < 0.022 || y - row * 0.5 < 0.022;
    return Rgb.scale(colour, joint ? 0.84 : 0.97 + 0.06 * noise(column, row));
  }

  private int ceilingColour(double x, double y) {
    return world.roomAt(x, y).filter(room -> isLamp(room, x, y)).isPresent() ? LAMP : Rgb.scale(CEILING, 0.9);
  }

  private static boolean isLamp(Room room, double x, double y) {
    double spacing = 2.6;
    double dx = Math.IEEEremainder(x - room.centreX(), spacing);
    double fromEnd = Math.min(x - room.x1(), room.x2() - x);
    return Math.abs(dx) < 0.5 && Math.abs(y - room.centreY()) < 0.13 && fromEnd > 0.4;
  }

  /** A repeatable value in 0..1 for a pair of numbers. */
  private static double noise(int a, int b) {
    int hash = a * 374761393 + b * 668265263;
    hash = (hash ^ (hash >>> 13)) * 1274126177;
    return ((hash ^ (hash >>> 16)) & 0xffff) / 65535.0;
  }
}
