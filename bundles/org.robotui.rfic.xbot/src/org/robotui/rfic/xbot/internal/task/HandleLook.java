package org.robotui.rfic.xbot.internal.task;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.InteractiveMarker.Control;
import org.robotui.data.marker.InteractiveMarker.Mode;
import org.robotui.data.marker.InteractiveMarker.Orientation;
import org.robotui.data.marker.Marker;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** What the handle of a task consists of. */
final class HandleLook {
  /** Size of the arrows and rings, metres. */
  static final double SCALE = 0.3;
  /** The name of the button. */
  static final String GO = "go";

  private static final double HALF = Math.sqrt(0.5);
  private static final List<Quaternion> AXES =
      List.of(Quaternion.IDENTITY, new Quaternion(0, 0, HALF, HALF), new Quaternion(0, -HALF, 0, HALF));
  private static final List<String> NAMES = List.of("x", "y", "z");
  private static final Color GREEN = new Color(0.20f, 0.70f, 0.42f, 1);
  private static final Color RED = new Color(0.90f, 0.30f, 0.25f, 1);
  private static final Color GREY = new Color(0.42f, 0.44f, 0.47f, 0.7f);
  private static final double BUTTON = 0.25;
  private static final double ASIDE = 0.62;
  private static final double LETTERS = 0.16;
  private static final double DOT = 0.12;
  private static final double LINE = 0.015;
  private static final double SHAFT_FROM = 0.5;
  private static final double SHAFT = 0.4;
  private static final double THICK = 0.08;

  private final FrameId own;

  HandleLook(String robot) {
    own = new FrameId(robot, "");
  }

  /** Arrows and rings for what the task has: about its own axes, or those of its base where it has not all. */
  List<Control> grips(FrameTask task) {
    boolean all = task.mask().indexOf('0') < 0;
    Orientation orientation = all ? Orientation.INHERIT : Orientation.FIXED;
    List<Control> controls = new ArrayList<>();
    for (int i = 0; i < AXES.size(); i++) {
      if (task.has(i)) {
        controls.add(control("move_" + NAMES.get(i), Mode.MOVE_AXIS, orientation, AXES.get(i), List.of()));
      }
      if (task.has(AXES.size() + i)) {
        controls.add(control("turn_" + NAMES.get(i), Mode.ROTATE_AXIS, orientation, AXES.get(i), List.of()));
      }
    }
    return controls;
  }

  /** A ball to be clicked, with a word at it. */
  Control button() {
    RigidTransform aside = at(new Vector3(0, ASIDE * SCALE, ASIDE * SCALE));
    RigidTransform above = at(new Vector3(0, ASIDE * SCALE, (ASIDE + BUTTON) * SCALE));
    double size = BUTTON * SCALE;
    return control(GO, Mode.BUTTON, Orientation.FIXED, Quaternion.IDENTITY,
        List.of(marker(Marker.Type.SPHERE, aside, new Vector3(size, size, size), GREEN, Floats.EMPTY, ""),
            marker(Marker.Type.TEXT, above, new Vector3(0, 0, LETTERS * SCALE), GREEN, Floats.EMPTY, "Move")));
  }

  /**
   * What is missing to a target that is out of reach: a dot at the target, and a line from there.
   *
   * @param end where the frame comes to, seen from the target
   */
  Control missing(Vector3 end) {
    double size = DOT * SCALE;
    return control("missing", Mode.NONE, Orientation.INHERIT, Quaternion.IDENTITY,
        List.of(marker(Marker.Type.SPHERE, RigidTransform.IDENTITY, new Vector3(size, size, size), RED, Floats.EMPTY,
            ""),
            marker(Marker.Type.LINE_LIST, RigidTransform.IDENTITY, new Vector3(LINE, 0, 0), RED,
                Floats.of(0, 0, 0, (float) end.x(), (float) end.y(), (float) end.z()), "")));
  }

  /** Arrows that cannot be gripped. */
  Control grey() {
    Vector3 size = new Vector3(SHAFT * SCALE, THICK * SCALE, THICK * SCALE);
    List<Marker> arrows = new ArrayList<>();
    for (Quaternion axis : AXES) {
      for (Quaternion turn : List.of(axis, axis.times(Quaternion.fromYaw(Math.PI)))) {
        RigidTransform place = new RigidTransform(turn.rotate(new Vector3(SHAFT_FROM * SCALE, 0, 0)), turn);
        arrows.add(marker(Marker.Type.ARROW, place, size, GREY, Floats.EMPTY, ""));
      }
    }
    return control("off", Mode.NONE, Orientation.INHERIT, Quaternion.IDENTITY, arrows);
  }

  private static RigidTransform at(Vector3 place) {
    return new RigidTransform(place, Quaternion.IDENTITY);
  }

  private static Control control(String name, Mode mode, Orientation orientation, Quaternion axes, List<Marker> look) {
    return new Control(name, "", mode, orientation, axes, true, look, false);
  }

  private Marker marker(Marker.Type type, RigidTransform pose, Vector3 scale, Color color, Floats points,
      String text) {
    return new Marker(new Marker.Key("", 0), own, Optional.empty(), 0, type, pose, scale, color, 0, false, points,
        Bytes.EMPTY, text, "", false);
  }
}
