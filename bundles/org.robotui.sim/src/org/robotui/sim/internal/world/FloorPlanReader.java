package org.robotui.sim.internal.world;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.sim.internal.world.Solid.Kind;

/** Reads a floor plan; its comments explain the format. */
public final class FloorPlanReader {
  public static final double ROOM_HEIGHT = 2.5;
  private static final double DOOR_HEIGHT = 2.05;
  private static final double JAMB_WIDTH = 0.05;
  private static final int FRAME = 0xf1eee6;
  private static final int PANE = 0xbfdcec;

  private final List<Room> rooms = new ArrayList<>();
  private final List<Solid> solids = new ArrayList<>();
  private final List<Thing> things = new ArrayList<>();
  private final List<Pose2> walk = new ArrayList<>();
  private Optional<Pose2> start = Optional.empty();

  private FloorPlanReader() {}

  /**
   * Reads a plan that comes along.
   *
   * @throws IllegalArgumentException if there is none of this name
   */
  static FloorPlan read(String name) {
    String file = name + ".txt";
    try (InputStream in = FloorPlanReader.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalArgumentException("there is no floor plan " + file + " beside FloorPlanReader");
      }
      return read(new InputStreamReader(in, StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new IllegalStateException(file + " cannot be read", e);
    }
  }

  /**
   * Reads a plan.
   *
   * @throws IllegalArgumentException naming the line that is wrong
   */
  public static FloorPlan read(Reader source) throws IOException {
    FloorPlanReader reader = new FloorPlanReader();
    BufferedReader lines = new BufferedReader(source);
    int number = 0;
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      number++;
      reader.readLine(number, line.strip());
    }
    Pose2 start = reader.start.orElseThrow(() -> new IllegalArgumentException("floor plan: no 'start' line"));
    return new FloorPlan(reader.rooms, reader.solids, reader.things, reader.walk, start);
  }

  private void readLine(int number, String line) {
    if (line.isEmpty() || line.startsWith("#")) {
      return;
    }
    try {
      readWords(new Words(line));
    } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
      throw new IllegalArgumentException("floor plan line " + number + ": '" + line + "': " + e.getMessage(), e);
    }
  }

  private void readWords(Words words) {
    switch (words.text()) {
      case "room" -> rooms.add(room(words));
      case "wall" -> wall(words);
      case "window" -> window(words.line());
      case "panel" -> panel(words);
      case "box" -> box(words);
      case "column" -> column(words);
      case "walk" -> walk(words);
      case "start" -> start = Optional.of(
          new Pose2(words.number(), words.number(), Math.toRadians(words.number())));
      default -> throw new IllegalArgumentException(
          "expected room, wall, window, panel, box, column, walk or start");
    }
  }

  private static Room room(Words words) {
    String name = words.text();
    Line area = words.line();
    Room.Floor floor = Room.Floor.valueOf(words.text().toUpperCase(Locale.ROOT));
    return new Room(name, area.x1(), area.y1(), area.x2(), area.y2(), floor, words.colour(), words.colour());
  }

  private void wall(Words words) {
    Line line = words.line();
    double thickness = words.number();
    double from = -thickness / 2;
    while (words.more()) {
      if (!words.text().equals("door")) {
        throw new IllegalArgumentException("expected 'door from to' after the thickness");
      }
      double doorFrom = words.number();
      double doorTo = words.number();
      solids.add(wallSlab(line.part(from, doorFrom), thickness, 0));
      door(line, doorFrom, doorTo, thickness);
      from = doorTo;
    }
    solids.add(wallSlab(line.part(from, line.length() + thickness / 2), thickness, 0));
  }

  private void door(Line line, double from, double to, double thickness) {
    double jamb = thickness + 0.04;
    solids.add(wallSlab(line.part(from, to), thickness, DOOR_HEIGHT));
    solids.add(Shapes.slab(Kind.OBJECT, FRAME, line.part(from - JAMB_WIDTH, from), jamb, 0, DOOR_HEIGHT));
    solids.add(Shapes.slab(Kind.OBJECT, FRAME, line.part(to, to + JAMB_WIDTH), jamb, 0, DOOR_HEIGHT));
    Line above = line.part(from - JAMB_WIDTH, to + JAMB_WIDTH);
    solids.add(Shapes.slab(Kind.OBJECT, FRAME, above, jamb, DOOR_HEIGHT, DOOR_HEIGHT + JAMB_WIDTH));
  }

  private static Solid wallSlab(Line line, double thickness, double bottom) {
    return Shapes.slab(Kind.WALL, FRAME, line, thickness, bottom, ROOM_HEIGHT);
  }

  private void window(Line line) {
    double thickness = 0.22;
    solids.add(Shapes.slab(Kind.OBJECT, FRAME, line, thickness, 0.90, 2.20));
    double half = line.length() / 2;
    solids.add(Shapes.slab(Kind.GLOWING, PANE, line.part(0.06, half - 0.03), thickness + 0.02, 0.96, 2.14));
    solids.add(
        Shapes.slab(Kind.GLOWING, PANE, line.part(half + 0.03, 2 * half - 0.06), thickness + 0.02, 0.96, 2.14));
  }

  private void panel(Words words) {
    int colour = words.colour();
    Line line = words.line();
    double bottom = words.number();
    double top = words.number();
    solids.add(Shapes.slab(Kind.OBJECT, 0x4a4640, line.extended(0.04), 0.03, bottom - 0.04, top + 0.04));
    solids.add(Shapes.slab(Kind.OBJECT, colour, line, 0.05, bottom, top));
  }

  private void walk(Words words) {
    while (words.more()) {
      walk.add(new Pose2(words.number(), words.number(), 0));
    }
  }

  private void column(Words words) {
    int colour = words.colour();
    double x = words.number();
    double y = words.number();
    double width = 2 * words.number();
    add(words, colour, x, y, width, width, true);
  }

  private void box(Words words) {
    int colour = words.colour();
    Line across = words.line();
    add(words, colour, (across.x1() + across.x2()) / 2, (across.y1() + across.y2()) / 2,
        Math.abs(across.x2() - across.x1()),
        Math.abs(across.y2() - across.y1()), false);
  }

  private void add(Words words, int colour, double x, double y, double width, double depth, boolean round) {
    double height = words.number();
    Thing thing = new Thing(words.more() ? words.text() : "", round, x, y, width, depth, height, colour);
    solids.add(thing.solid());
    if (!thing.name().isEmpty()) {
      things.add(thing);
    }
  }

  /** The words of one line, taken from left to right. */
  private static final class Words {
    private final String[] words;
    private int next;

    Words(String line) {
      words = line.split("\\s+");
    }

    boolean more() {
      return next < words.length;
    }

    String text() {
      if (!more()) {
        throw new IllegalArgumentException("the line ends too early");
      }
      return words[next++];
    }

    double number() {
      return Double.parseDouble(text());
    }

    int colour() {
      return Integer.parseInt(text(), 16);
    }

    Line line() {
      return new Line(number(), number(), number(), number());
    }
  }
}
