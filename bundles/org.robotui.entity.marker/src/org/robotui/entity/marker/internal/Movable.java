package org.robotui.entity.marker.internal;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarker.Control;
import org.robotui.data.marker.InteractiveMarker.Orientation;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.data.marker.MarkerFeedback.Event;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Ray;

/**
 * An interactive marker as it is shown. While a user drags it, it is where the user has it and the server hears of
 * that; what the server says meanwhile counts when the user lets go. Only on the worker thread of the scene.
 */
final class Movable {
  private static final long SIGN_OF_LIFE = TimeUnit.MILLISECONDS.toNanos(250);

  private final String client;
  private final Sender sender;
  private InteractiveMarker marker;
  private List<List<ControlLook.Piece>> looks = List.of();
  private Map<String, ControlHandle> handles = Map.of();
  private Optional<RigidTransform> fixedFromFrame = Optional.empty();
  private RigidTransform pose;
  private Optional<HandleDrag> grip = Optional.empty();
  private Control gripped;
  private Vector3 touched = Vector3.ZERO;
  private boolean moved;
  private boolean told;
  private boolean refused;
  private long saidAt;

  Movable(InteractiveMarker marker, String client, Sender sender) {
    this.client = client;
    this.sender = sender;
    this.marker = marker;
    this.pose = usable(marker.pose());
    gripped = marker.controls().isEmpty() ? nothing() : marker.controls().getFirst();
    look();
  }

  private static Control nothing() {
    return new Control("", "", InteractiveMarker.Mode.NONE, Orientation.INHERIT, Quaternion.IDENTITY, false, List.of(),
        false);
  }

  InteractiveMarker marker() {
    return marker;
  }

  RigidTransform pose() {
    return pose;
  }

  List<List<ControlLook.Piece>> looks() {
    return looks;
  }

  ControlHandle handle(Control control) {
    return handles.get(control.name());
  }

  /** A pose that can be drawn: what is no rotation counts as none. */
  private static RigidTransform usable(RigidTransform sent) {
    double length = sent.rotation().norm();
    Quaternion turn = Double.isFinite(length) && length > 1e-9 ? sent.rotation().normalized() : Quaternion.IDENTITY;
    return new RigidTransform(sent.translation().isFinite() ? sent.translation() : Vector3.ZERO, turn);
  }

  boolean flawed() {
    return !marker.pose().translation().isFinite();
  }

  /** Takes what the server says now. */
  void take(InteractiveMarker newer) {
    boolean same = newer.controls().equals(marker.controls()) && newer.scale() == marker.scale();
    marker = newer;
    if (!same) {
      look();
    }
    if (grip.isPresent()) {
      told = true;
    } else {
      pose = usable(newer.pose());
    }
  }

  private void look() {
    looks = marker.controls().stream().map(c -> ControlLook.of(c, marker.scale())).toList();
    Map<String, ControlHandle> kept = new HashMap<>();
    marker.controls().forEach(c -> kept.put(c.name(),
        Optional.ofNullable(handles.get(c.name())).orElseGet(() -> new ControlHandle(this, c.name()))));
    handles = kept;
  }

  Optional<Control> control(String name) {
    return marker.controls().stream().filter(c -> c.name().equals(name)).findFirst();
  }

  /** Where its frame is; says what was dragged since the last tick, or that it is still held. */
  void tick(Optional<RigidTransform> place, long nowNanos) {
    fixedFromFrame = place;
    if (grip.isPresent() && (moved || nowNanos - saidAt > SIGN_OF_LIFE)) {
      say(moved ? Event.POSE_UPDATE : Event.KEEP_ALIVE, 0);
      moved = false;
      saidAt = nowNanos;
    }
  }

  /** Where the parts of a control are in the frame of the marker: those that are fixed do not turn with it. */
  RigidTransform base(Control control) {
    return control.orientation() == Orientation.FIXED ? new RigidTransform(pose.translation(), Quaternion.IDENTITY)
        : pose;
  }

  void press(Control control, Ray ray, Vector3 place) {
    fixedFromFrame.ifPresent(frame -> {
      gripped = control;
      touched = frame.inverse().apply(place);
      told = false;
      moved = false;
      refused = false;
      Vector3 axis = frame.rotation().times(base(control).rotation()).times(ControlLook.rotation(control))
          .rotate(new Vector3(1, 0, 0));
      boolean faces = control.orientation() == Orientation.VIEW_FACING;
      grip = Optional.of(new HandleDrag(control.mode(), faces ? ray.direction() : axis, frame.times(pose), place, ray));
      say(Event.MOUSE_DOWN, 0);
    });
  }

  void drag(Ray ray) {
    fixedFromFrame.ifPresent(frame -> grip.ifPresent(g -> {
      RigidTransform now = frame.inverse().times(g.drag(ray));
      moved |= !now.equals(pose);
      pose = now;
    }));
  }

  void release(boolean clicked) {
    if (grip.isEmpty()) {
      return;
    }
    if (moved) {
      say(Event.POSE_UPDATE, 0);
    }
    say(Event.MOUSE_UP, 0);
    if (clicked && gripped.mode() == InteractiveMarker.Mode.BUTTON) {
      say(Event.BUTTON_CLICK, 0);
    }
    grip = Optional.empty();
    if (told || refused) {
      pose = usable(marker.pose());
    }
  }

  void choose(Control control, int entry) {
    gripped = control;
    say(Event.MENU_SELECT, entry);
  }

  private void say(Event event, int entry) {
    Optional<Vector3> point = grip.map(g -> touched);
    refused |= !sender.send(new MarkerFeedback(marker.feedback(), client, marker.name(), gripped.name(), event,
        marker.frame(), marker.stamp(),
        pose, entry, point));
  }
}
