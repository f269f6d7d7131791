package org.robotui.uic.scene3d.internal.waypoint;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.input.Numerals;
import org.robotui.data.FrameId;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.uic.scene3d.internal.SceneOptions;

/**
 * Waypoints as files have them: YAML as a configuration has it, or CSV with names of columns in its first line. Any
 * thread.
 */
public final class RouteText {
  /** The most characters that are read. */
  public static final int MOST = 1 << 20;
  static final List<String> NUMBERS = List.of("x", "y", "z", "yaw");
  private static final double FARTHEST = 1e9;
  private static final String CSV = ".csv";
  private static final String FRAME = "# frame: ";

  private RouteText() {}

  /** What a file holds, or why it cannot be taken. */
  public sealed interface Outcome {
    /**
     * It can.
     *
     * @param frame as written; robot/frame, or a frame alone; none where it names none
     * @param poses frame from base at each, level
     */
    record Read(Optional<String> frame, List<RigidTransform> poses) implements Outcome {
      /** Copies the list. */
      public Read {
        poses = List.copyOf(poses);
      }

      /** As waypoints of a scene; a frame without a robot, and no frame at all, are meant as the fixed frame has it. */
      public Route route(FrameId fixed) {
        Optional<FrameId> named = frame.map(f -> Route.frame(f).orElseGet(() -> new FrameId(fixed.robot(), f)));
        return poses.isEmpty() ? Route.NONE : new Route(named.or(() -> Optional.of(fixed)), poses);
      }
    }

    /**
     * It cannot.
     *
     * @param why names the line and what to write
     */
    record Unreadable(String why) implements Outcome {}
  }

  /** Reads a text; the ending of its file's name tells what it is: CSV, else YAML. */
  public static Outcome read(String file, String text) {
    if (text.length() > MOST) {
      return new Outcome.Unreadable("it is larger than " + MOST + " characters");
    }
    try {
      return isCsv(file) ? csv(text.lines().toList()) : YamlRoute.read(text);
    } catch (RouteException e) {
      return new Outcome.Unreadable(e.getMessage());
    }
  }

  /** Writes waypoints for a file of a name. */
  public static String write(String file, Route route) {
    return isCsv(file) ? csv(route) : route.yaml();
  }

  private static boolean isCsv(String file) {
    return file.toLowerCase(Locale.ROOT).endsWith(CSV);
  }

  private static String csv(Route route) {
    StringBuilder text = new StringBuilder();
    route.frame().ifPresent(f -> text.append(FRAME).append(f.robot()).append('/').append(f.name()).append('\n'));
    text.append(String.join(",", NUMBERS)).append('\n');
    for (RigidTransform pose : route.poses()) {
      Map<String, Object> fields = Route.fields(pose);
      text.append(String.join(",", NUMBERS.stream().map(name -> fields.get(name).toString()).toList())).append('\n');
    }
    return text.toString();
  }

  private static Outcome csv(List<String> lines) throws RouteException {
    Optional<String> frame = Optional.empty();
    List<String> columns = List.of();
    List<RigidTransform> poses = new ArrayList<>();
    for (int i = 0; i < lines.size(); i++) {
      String line = lines.get(i).strip();
      List<String> cells = List.of(line.split("\\s*[,;\\t]\\s*", -1));
      if (line.startsWith(FRAME)) {
        frame = Optional.of(line.substring(FRAME.length()).strip());
      } else if (columns.isEmpty() && !line.isEmpty() && line.charAt(0) != '#') {
        columns = columns(cells, i + 1);
      } else if (!line.isEmpty() && line.charAt(0) != '#') {
        poses.add(pose(columns, cells, i + 1, poses.size()));
      }
    }
    return new Outcome.Read(frame, poses);
  }

  private static List<String> columns(List<String> cells, int line) throws RouteException {
    boolean good = cells.contains("x") && cells.contains("y") && NUMBERS.containsAll(cells)
        && cells.stream().distinct().count() == cells.size();
    if (!good) {
      throw new RouteException(line,
          "the first line names the columns, for example x,y,z,yaw (metres and radians; z and yaw may be left out)");
    }
    return cells;
  }

  private static RigidTransform pose(List<String> columns, List<String> cells, int line, int before)
      throws RouteException {
    if (cells.size() != columns.size()) {
      throw new RouteException(line, "there are " + cells.size() + " values and " + columns.size() + " columns");
    }
    double[] numbers = new double[NUMBERS.size()];
    for (int i = 0; i < cells.size(); i++) {
      numbers[NUMBERS.indexOf(columns.get(i))] = number(cells.get(i), columns.get(i), line);
    }
    return pose(numbers, line, before);
  }

  /** The pose of x, y, z and yaw, if not too many came before it. */
  static RigidTransform pose(double[] numbers, int line, int before) throws RouteException {
    if (before >= Route.MOST) {
      throw new RouteException(line, "there are more than " + Route.MOST + " waypoints");
    }
    return new RigidTransform(new Vector3(numbers[0], numbers[1], numbers[2]), Quaternion.fromYaw(numbers[3]));
  }

  static double number(String written, String name, int line) throws RouteException {
    Optional<Double> number = Numerals.decimal(written).filter(n -> Math.abs(n) <= FARTHEST);
    if (number.isPresent()) {
      return number.get();
    }
    String shown = written.length() > 40 ? written.substring(0, 40) + "\u2026" : written;
    throw new RouteException(line, "'" + shown + "' is no " + name + ": a number of "
        + (name.equals(NUMBERS.getLast()) ? "radians" : "metres") + " is expected");
  }

  /** What is wrong, with the line. */
  static final class RouteException extends Exception {
    private static final long serialVersionUID = 1;

    RouteException(int line, String what) {
      super("line " + line + ": " + what);
    }
  }

  /** The words of a file of YAML. */
  static List<String> words() {
    return List.of(SceneOptions.WAYPOINT_FRAME, SceneOptions.WAYPOINTS);
  }
}
