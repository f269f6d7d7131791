package org.robotui.uic.scene3d.internal.waypoint;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Part;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.uic.scene3d.internal.SceneOptions;

/**
 * The waypoints of a scene: what is drawn of them, and how hands change them. They are kept in the settings with each
 * change, and each change can be undone. Worker thread of the scene, where nothing else is said.
 */
public final class Waypoints {
  /** The display that their parts belong to. */
  public static final String DISPLAY = "#waypoints";
  private static final int MOST_UNDONE = 100;

  private final SettingsStore settings;
  private final Deque<Route> before = new ArrayDeque<>();
  private final List<Grips> grips = new ArrayList<>();
  private final WaypointLook look = new WaypointLook();
  private final Tour tour;
  private Route route = Route.NONE;
  private Optional<Held> held = Optional.empty();
  private Optional<RigidTransform> fixedFromFrame = Optional.empty();
  private Optional<FrameId> drawnIn = Optional.empty();
  private volatile Route shown = Route.NONE;

  /** Those of the settings; the tour drives along them. */
  public Waypoints(SettingsStore settings, Tour tour) {
    this.settings = settings;
    this.tour = tour;
  }

  /** A waypoint in a hand: where it is now, not yet kept. */
  private record Held(int index, RigidTransform pose) {}

  /** The handles of a waypoint, which stay the same while there is one of its number. */
  private record Grips(WaypointHandle moves, WaypointHandle turns) {}

  /** Which waypoint a part belongs to, from 0; none for the line through all. */
  public static OptionalInt index(Part part) {
    return part.handle().isPresent() && part.key() instanceof WaypointLook.Key key ? OptionalInt.of(key.index())
        : OptionalInt.empty();
  }

  /** What there is; any thread. */
  public Route route() {
    return shown;
  }

  /** Drives along them; any thread asks, the worker drives. */
  public Tour tour() {
    return tour;
  }

  /** What is to be drawn now. */
  public List<Part> tick(Places places) {
    Settings now = settings.current();
    route = Route.read(now);
    held = held.filter(h -> h.index < route.poses().size());
    drawnIn = Optional.of(places.fixed());
    fixedFromFrame = places.at(frame(places.fixed()), Optional.empty()).found();
    Route seen = held.map(h -> route.with(h.index, h.pose)).orElse(route);
    shown = seen.frame().isPresent() || seen.poses().isEmpty() ? seen
        : new Route(Optional.of(places.fixed()), seen.poses());
    while (grips.size() < route.poses().size()) {
      grips.add(new Grips(new WaypointHandle(this, grips.size(), false), new WaypointHandle(this, grips.size(), true)));
    }
    return fixedFromFrame
        .map(fixed -> look.parts(shown, fixed, now.number(SceneOptions.WAYPOINT_SIZE), tour.driving(), this::handle))
        .orElse(List.of());
  }

  /** Adds one behind the others. */
  public CommandNotice add(FrameId fixed, RigidTransform pose) {
    if (route.poses().size() >= Route.MOST) {
      return new CommandNotice(Health.BAD, "There are " + Route.MOST + " waypoints already");
    }
    if (route.poses().isEmpty()) {
      change(new Route(Optional.of(fixed), List.of(pose)));
    } else if (fixedFromFrame.isEmpty()) {
      return new CommandNotice(Health.BAD,
          "Not added: it is not known where the frame of the waypoints is, " + frame(fixed).name());
    } else {
      change(route.plus(fixedFromFrame.get().inverse().times(pose)));
    }
    return new CommandNotice(Health.OK, "Waypoint " + route.poses().size() + " added \u00b7 Ctrl+Z undoes it");
  }

  /** Takes those of a file in place of what there is. */
  public CommandNotice take(RouteText.Outcome.Read read) {
    if (read.poses().isEmpty()) {
      return new CommandNotice(Health.BAD, "Not loaded: there are no waypoints in the file");
    }
    int count = read.poses().size();
    return drawnIn.map(fixed -> {
      change(read.route(fixed));
      return new CommandNotice(Health.OK, (count == 1 ? "1 waypoint" : count + " waypoints") + " loaded in "
          + frame(fixed).name() + " \u00b7 Ctrl+Z undoes it");
    }).orElse(new CommandNotice(Health.BAD, "Not loaded: no frame is known yet"));
  }

  /** Removes one, by its index from 0. */
  public void remove(int index) {
    if (index < route.poses().size()) {
      change(route.without(index));
    }
  }

  /** Removes all. */
  public void clear() {
    change(Route.NONE);
  }

  /** Lets a waypoint come one earlier (-1) or later (1). */
  public void move(int index, int by) {
    if (index < route.poses().size()) {
      change(route.moved(index, by));
    }
  }

  /** Takes the last change back. */
  public CommandNotice undo() {
    Optional<Route> last = Optional.ofNullable(before.pollLast());
    last.ifPresent(this::keep);
    return last
        .map(r -> new CommandNotice(Health.OK,
            "Undone: " + r.poses().size() + (r.poses().size() == 1 ? " waypoint" : " waypoints")))
        .orElse(new CommandNotice(Health.NONE, "There is nothing to undo"));
  }

  /** The frame of the waypoints; that of the scene where none is written. */
  FrameId frame(FrameId fixed) {
    return route.frame().orElse(fixed);
  }

  /** Where a waypoint is in the fixed frame. */
  Optional<RigidTransform> place(int index) {
    return index < route.poses().size() ? fixedFromFrame.map(fixed -> fixed.times(route.poses().get(index)))
        : Optional.empty();
  }

  /** A hand moves a waypoint. */
  void hold(int index, RigidTransform fixedFromWaypoint) {
    held = fixedFromFrame.map(fixed -> new Held(index, fixed.inverse().times(fixedFromWaypoint)));
  }

  /** The hand lets go. */
  void release() {
    held.filter(h -> h.index < route.poses().size()).ifPresent(h -> change(route.with(h.index, h.pose)));
    held = Optional.empty();
  }

  private WaypointHandle handle(int index, boolean turns) {
    return turns ? grips.get(index).turns : grips.get(index).moves;
  }

  private void change(Route next) {
    if (!next.equals(route)) {
      before.addLast(route);
      if (before.size() > MOST_UNDONE) {
        before.removeFirst();
      }
      keep(next);
    }
  }

  private void keep(Route next) {
    route = next;
    next.write(settings);
  }
}
