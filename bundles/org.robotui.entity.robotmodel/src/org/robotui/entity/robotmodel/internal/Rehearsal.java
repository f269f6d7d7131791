package org.robotui.entity.robotmodel.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;

/** One plan while it is shown, and what was executed since. Worker thread, but for its words. */
final class Rehearsal {
  private static final double PAUSE_SECONDS = 1;
  private static final int MOST_NAMED = 12;
  private static final double TRAIL = 0.45;

  private final Course course;
  private final Deviation deviation;
  private final Ghost ghost;
  private final String tip;
  private Trace trace = new Trace();
  private volatile String link = "";
  private float[] way = {};
  private LineSet line = LineSet.of(LineSet.Kind.STRIP, 1);
  private double seconds;
  private Optional<Long> last = Optional.empty();
  private volatile List<Properties.Entry> words = List.of();

  Rehearsal(Course course) {
    this.course = course;
    deviation = new Deviation(course.plan());
    ghost = new Ghost(course, (element, place) -> describe("Planned"));
    tip = course.tip();
    say();
  }

  Plan plan() {
    return course.plan();
  }

  String tip() {
    return tip;
  }

  Deviation deviation() {
    return deviation;
  }

  /** Follows a link from now on; with another one the executed line begins anew. */
  void follow(String next, float width) {
    if (!next.equals(link)) {
      link = next;
      way = course.way(link);
      line = LineSet.of(LineSet.Kind.STRIP, width, way);
      trace = new Trace();
    }
    if (line.width() != width) {
      line = LineSet.of(LineSet.Kind.STRIP, width, way);
    }
  }

  /** Goes on with the show; it begins with the first call. */
  void pass(long nowNanos, double speed) {
    seconds += last.map(before -> (nowNanos - before) * 1e-9 * speed).orElse(0.0);
    last = Optional.of(nowNanos);
  }

  /** Takes where the joints of the robot are. */
  void executed(Map<String, Double> positions) {
    deviation.take(positions);
    if (deviation.farthest().isPresent()) {
      Vector3 at = course.places(positions).get(link).translation();
      trace.add(at);
      say();
    }
  }

  List<Part> parts(RigidTransform fixedFromRoot, Settings settings) {
    Rgba color = ColorSetting.read(settings, TrajectoryType.COLOR);
    double opacity = color.alpha() * settings.number(TrajectoryType.OPACITY);
    List<Part> parts = new ArrayList<>();
    ghost.figure(fixedFromRoot, course.plan().at(moment(settings.text(TrajectoryType.REPEAT))),
        Material.lit(color.withAlpha(opacity)), parts);
    if (settings.integer(TrajectoryType.TRAIL) > 0) {
      ghost.trail((int) settings.integer(TrajectoryType.TRAIL), fixedFromRoot,
          Material.lit(color.withAlpha(TRAIL * opacity)), parts);
    }
    if (settings.flag(TrajectoryType.PATH)) {
      parts.add(
          new Part("path", line, fixedFromRoot, Material.flat(color), (element, place) -> describe("Planned path")));
    }
    if (settings.flag(TrajectoryType.EXECUTED) && trace.size() > 1) {
      parts.add(new Part("executed", trace.line(line.width()), fixedFromRoot,
          Material.flat(ColorSetting.read(settings, TrajectoryType.EXECUTED_COLOR)),
          (element, place) -> describe("Executed path")));
    }
    return parts;
  }

  /** The second of the plan that is shown now. */
  private double moment(String repeat) {
    double duration = course.plan().duration();
    return switch (repeat) {
      case "end" -> duration;
      case "once" -> Math.min(seconds, duration);
      default -> Math.min(seconds % (duration + PAUSE_SECONDS), duration);
    };
  }

  private Properties describe(String what) {
    return new Properties(what + " of " + link, words);
  }

  private void say() {
    List<Properties.Entry> entries = new ArrayList<>();
    entries.add(new Properties.Entry("Points", Integer.toString(plan().points())));
    entries.add(new Properties.Entry("Duration", String.format(Locale.ROOT, "%.2f s", plan().duration())));
    for (int i = 0; i < Math.min(MOST_NAMED, plan().joints().size()); i++) {
      String name = plan().joints().get(i).name();
      deviation.of(i).ifPresent(away -> entries.add(new Properties.Entry(name, "at most " + away.words() + " off")));
    }
    words = List.copyOf(entries);
  }
}
