package org.robotui.uic.scene3d.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.eclipse.swt.graphics.Point;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Toast;
import org.robotui.uic.scene3d.internal.SceneParts;
import org.robotui.uic.scene3d.internal.camera.Lens;

/** The tool in hand, and what it has marked. Display thread. */
final class Tools {
  private static final double LEAST_DRAG = 8;

  private final SceneParts parts;
  private final Consumer<CommandNotice> soon;
  private final Runnable changed;
  private final Toast toast = new Toast();
  private final List<Vector3> measured = new ArrayList<>();
  private List<Point> stretched = List.of();
  private Optional<ToolKind> kind = Optional.empty();
  private Optional<Vector3> pressed = Optional.empty();
  private Optional<Vector3> dragged = Optional.empty();

  Tools(SceneParts parts, Consumer<CommandNotice> soon, Runnable changed) {
    this.parts = parts;
    this.soon = soon;
    this.changed = changed;
  }

  boolean using(ToolKind wanted) {
    return kind.filter(k -> k == wanted).isPresent();
  }

  Optional<ToolKind> kind() {
    return kind;
  }

  Toast toast() {
    return toast;
  }

  void toggle(ToolKind wanted) {
    kind = using(wanted) ? Optional.empty() : Optional.of(wanted);
    forget();
    changed.run();
  }

  /** What is to be known now: where the robot drives, or how the tool in hand is used. */
  Optional<String> hint() {
    OptionalInt driving = parts.waypoints().tour().driving();
    return driving.isPresent()
        ? Optional.of("Driving to waypoint " + (driving.getAsInt() + 1) + " of "
            + parts.waypoints().route().poses().size() + " \u00b7 Enter ends it")
        : kind.map(ToolKind::hint);
  }

  /** Ends the tool; false where there was none. */
  boolean end() {
    boolean some = kind.isPresent() || !measured.isEmpty();
    kind = Optional.empty();
    toast.clear();
    forget();
    changed.run();
    return some;
  }

  private void forget() {
    measured.clear();
    pressed = Optional.empty();
    dragged = Optional.empty();
    stretched = List.of();
  }

  /** Two places at most, the second may still be missing. */
  List<Vector3> measured() {
    return List.copyOf(measured);
  }

  void measure(Vector3 place) {
    stretched = List.of();
    if (measured.size() == 2) {
      measured.clear();
    }
    measured.add(place);
    changed.run();
  }

  /** Measures anew, from one place to another; nothing where one of them is in the sky. */
  void measure(Optional<Vector3> from, Optional<Vector3> to) {
    forget();
    if (from.isPresent() && to.isPresent()) {
      measured.add(from.get());
      measured.add(to.get());
    }
    changed.run();
  }

  /** Shows where a measure goes that is being dragged, in pixels: places are looked up when the button is let go. */
  void stretch(Point from, Point to) {
    stretched = List.of(from, to);
    changed.run();
  }

  /** The ends of the measure that is being dragged, in pixels; empty where none is. */
  List<Point> stretched() {
    return stretched;
  }

  /** Whether the floor is pointed at with press and drag. */
  boolean points() {
    return kind.filter(k -> k != ToolKind.MEASURE).isPresent();
  }

  void press(Lens lens, double x, double y) {
    pressed = lens.level(x, y, 0);
    dragged = Optional.empty();
    changed.run();
  }

  void drag(Lens lens, double x, double y) {
    Optional<Lens.Spot> from = pressed.flatMap(lens::spot);
    boolean far = from.filter(s -> Math.hypot(s.x() - x, s.y() - y) >= LEAST_DRAG).isPresent();
    dragged = far ? lens.level(x, y, 0) : Optional.empty();
    changed.run();
  }

  void release() {
    pose().ifPresent(pose -> send(kind.orElseThrow(), pose));
    pressed = Optional.empty();
    dragged = Optional.empty();
    changed.run();
  }

  /** What is pointed out now. */
  Optional<RigidTransform> pose() {
    return pressed.map(p -> RigidTransform.planar(p.x(), p.y(),
        dragged.map(d -> Math.atan2(d.y() - p.y(), d.x() - p.x())).orElse(heading(p))));
  }

  void send(ToolKind what, RigidTransform pose) {
    Optional<FrameId> frame = parts.model().stage().fixed();
    if (what == ToolKind.WAYPOINTS) {
      frame.ifPresent(f -> parts.model().soon(() -> soon.accept(parts.waypoints().add(f, pose))));
      return;
    }
    if (what == ToolKind.GOAL && parts.waypoints().tour().driving().isPresent()) {
      parts.waypoints().tour().cede("another goal was given");
    }
    CommandNotice told =
        frame.map(f -> what == ToolKind.GOAL ? parts.commander().goal(f, pose) : parts.commander().initialPose(f, pose))
            .orElse(new CommandNotice(Health.BAD, "Not sent: no frame is known yet in which it could be given"));
    kind = Optional.empty();
    say(told);
  }

  void say(CommandNotice told) {
    toast.say(told, System.nanoTime());
    changed.run();
  }

  /** Where a robot would look at a place if nothing else is said: on from where it is now. */
  double heading(Vector3 place) {
    return parts.model().stage().robots().stream().flatMap(r -> r.fixedFromBase().stream()).findFirst()
        .map(RigidTransform::translation).map(at -> Math.atan2(place.y() - at.y(), place.x() - at.x())).orElse(0.0);
  }
}
