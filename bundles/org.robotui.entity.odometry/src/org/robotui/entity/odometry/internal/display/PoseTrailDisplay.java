package org.robotui.entity.odometry.internal.display;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.api.config.Settings;
import org.robotui.api.port.InputState;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.Pose;
import org.robotui.data.navigation.Odometry;
import org.robotui.entity.odometry.internal.colored.ColorBy;
import org.robotui.entity.odometry.internal.colored.ColoredTrail;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.ColorScale;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Uncertainty;

/**
 * The newest poses in one frame, and how sure the last is; or the newest alone, on a way that is coloured by a value.
 */
final class PoseTrailDisplay<T extends Pose> implements Display {
  private static final double THIN = 0.08;

  private final Class<T> type;
  private final Function<T, Doubles> covariance;
  private final Recent<T, Object> recent;
  private final Deque<T> trail = new ArrayDeque<>();
  private Optional<Made> made = Optional.empty();
  private Optional<Sure> sure = Optional.empty();
  private final ColoredTrail way;
  private final ColoredLine line = new ColoredLine();
  private Optional<ColoredTrail.Seen> colored = Optional.empty();
  private long broken;

  /** The arrows, and what they were made of. */
  private record Made(List<Pose> poses, boolean axes, double length, Instances shape) {}

  /** The uncertainty of a value. */
  private record Sure(Pose of, double deviations, double length, Optional<Instances> place,
      Optional<Instances> heading) {}

  PoseTrailDisplay(Class<T> type, Function<T, Doubles> covariance, DisplayContext context) {
    this.type = type;
    way = new ColoredTrail(type, context.background(), context::history);
    this.covariance = covariance;
    recent = new Recent<>(type, Anchor.When.NOW, T::frame, pose -> 1);
  }

  @Override
  public DisplayResult update(DisplayTick tick) {
    Settings s = tick.settings();
    recent.update(tick);
    ColorBy by = ColorBy.of(s);
    colored = by.field().isEmpty() ? Optional.empty()
        : way.update(tick.arrived(), by, s.number(PoseSettings.WAY), tick.reset());
    if (tick.reset() || tick.state() instanceof InputState.Unconnected) {
      trail.clear();
    }
    tick.arrived().stream().filter(e -> colored.isEmpty() || way.follows(e.source())).map(e -> e.value())
        .filter(type::isInstance).map(type::cast).forEach(pose -> take(pose, s));
    while (trail.size() > s.integer("keep")) {
      trail.removeFirst();
    }
    List<Part> parts = new ArrayList<>();
    recent.newest().filter(e -> !trail.isEmpty()).flatMap(e -> e.anchor().found())
        .ifPresent(place -> add(parts, place, tick));
    DisplayStatus shown = trail.isEmpty() && broken > 0
        ? new DisplayStatus.Unfit("the pose is no number")
        : shown();
    return new DisplayResult(parts, recent.status(tick, shown), broken);
  }

  private DisplayStatus shown() {
    return colored.flatMap(ColoredTrail.Seen::problem).<DisplayStatus>map(DisplayStatus.Partly::new)
        .orElseGet(() -> new DisplayStatus.Shown(colored.map(c -> c.way().count() + " places")
            .orElseGet(() -> trail.size() + (trail.size() == 1 ? " pose" : " poses"))));
  }

  @Override
  public Optional<ColorScale> colors() {
    return colored.flatMap(ColoredTrail.Seen::scale);
  }

  @Override
  public void close() {
    recent.clear();
    trail.clear();
    way.clear();
    line.clear();
  }

  /**
   * Takes a pose that is far enough from the last; one that is not takes its place, so that the newest is always seen.
   */
  private void take(T pose, Settings s) {
    RigidTransform at = pose.pose();
    if (!at.translation().isFinite() || !Double.isFinite(at.rotation().norm())) {
      broken++;
      return;
    }
    if (!trail.isEmpty() && !trail.getLast().frame().equals(pose.frame())) {
      trail.clear();
    }
    if (trail.size() > 1 && near(before().pose(), at, s)) {
      trail.removeLast();
    }
    trail.addLast(pose);
    while (trail.size() > PoseSettings.MOST) {
      trail.removeFirst();
    }
  }

  private T before() {
    T last = trail.removeLast();
    T before = trail.getLast();
    trail.addLast(last);
    return before;
  }

  private static boolean near(RigidTransform a, RigidTransform b, Settings s) {
    Quaternion turn = a.rotation().inverse().times(b.rotation());
    double angle = Math.toDegrees(2 * Math.atan2(new Vector3(turn.x(), turn.y(), turn.z()).norm(), Math.abs(turn.w())));
    return a.translation().minus(b.translation()).norm() < s.number("distance") && angle < s.number("angle");
  }

  private void add(List<Part> parts, RigidTransform place, DisplayTick tick) {
    Settings s = tick.settings();
    boolean axes = s.text("shape").equals("axes");
    Rgba color = faded(ColorSetting.read(s, "color"), tick);
    colored.flatMap(c -> tick.places().at(c.way().frame(), Optional.empty()).found()
        .map(at -> line.part(c, at, color.alpha()))).ifPresent(parts::add);
    Instances arrows = arrows(axes, s.number("length"));
    List<Pose> poses = made.orElseThrow().poses();
    parts.add(new Part("poses", arrows, place, Material.lit(axes ? Rgba.WHITE.withAlpha(color.alpha()) : color),
        (element, at) -> element >= 0 && element < poses.size() ? describe(poses.get(element))
            : Properties.of("poses")));
    if (s.flag("covariance")) {
      addUncertainty(parts, place, tick);
    }
  }

  private void addUncertainty(List<Part> parts, RigidTransform place, DisplayTick tick) {
    T newest = trail.getLast();
    Sure drawn = sure(newest, tick.settings().number("deviations"), tick.settings().number("length"));
    RigidTransform at = place.times(new RigidTransform(newest.pose().translation(), Quaternion.IDENTITY));
    drawn.place().ifPresent(shape -> parts.add(new Part("place", shape, at,
        Material.lit(faded(ColorSetting.read(tick.settings(), "covariance_color"), tick)),
        (element, where) -> describe(newest))));
    drawn.heading().ifPresent(shape -> parts.add(new Part("heading", shape, place.times(turned(newest.pose())),
        Material.lit(faded(ColorSetting.read(tick.settings(), "heading_color"), tick)),
        (element, where) -> describe(newest))));
  }

  private static Rgba faded(Rgba color, DisplayTick tick) {
    return color.withAlpha(color.alpha() * tick.settings().number("opacity") * Recent.opacity(tick));
  }

  private Instances arrows(boolean axes, double length) {
    List<Pose> poses = colored.isPresent() ? List.of(trail.getLast()) : List.copyOf(trail);
    if (made.filter(m -> m.poses.equals(poses) && m.axes == axes && m.length == length).isEmpty()) {
      Vector3 scale = axes ? new Vector3(length, length, length) : new Vector3(length, THIN * length, THIN * length);
      Placings placings = new Placings(poses.size());
      poses.forEach(pose -> placings.add(turned(pose.pose()), scale));
      made = Optional.of(new Made(poses, axes, length, placings.of(axes ? Meshes.axes() : Meshes.arrow())));
    }
    return made.orElseThrow().shape();
  }

  private Sure sure(T pose, double deviations, double length) {
    if (sure.filter(u -> u.of == pose && u.deviations == deviations && u.length == length).isEmpty()) {
      Doubles numbers = covariance.apply(pose);
      sure = Optional.of(new Sure(pose, deviations, length, Uncertainty.position(numbers, deviations),
          Uncertainty.heading(numbers, deviations, length)));
    }
    return sure.orElseThrow();
  }

  /** A rotation that was never set (all 0) is none. */
  private static RigidTransform turned(RigidTransform pose) {
    return new RigidTransform(pose.translation(),
        pose.rotation().norm() > 1e-9 ? pose.rotation().normalized() : Quaternion.IDENTITY);
  }

  private static Properties describe(Pose pose) {
    List<Properties.Entry> entries = new ArrayList<>(List.of(
        new Properties.Entry("frame", pose.frame().name()),
        number("x", "%.3f m", pose.pose().translation().x()),
        number("y", "%.3f m", pose.pose().translation().y()),
        number("z", "%.3f m", pose.pose().translation().z()),
        number("yaw", "%.1f\u00b0", Math.toDegrees(pose.pose().rotation().yaw()))));
    if (pose instanceof Odometry odometry) {
      entries.add(number("speed", "%.3f m/s", odometry.linear().norm()));
      entries.add(number("turn", "%.1f\u00b0/s", Math.toDegrees(odometry.angular().z())));
    }
    return new Properties("pose", entries);
  }

  private static Properties.Entry number(String name, String format, double value) {
    return new Properties.Entry(name, String.format(Locale.ROOT, format, value));
  }
}
