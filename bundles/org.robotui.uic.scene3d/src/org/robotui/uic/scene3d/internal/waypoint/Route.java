package org.robotui.uic.scene3d.internal.waypoint;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.uic.scene3d.internal.SceneOptions;

/**
 * Waypoints in their order.
 *
 * @param frame in which they are given; none while there are none
 * @param poses frame from base at each, level
 */
public record Route(Optional<FrameId> frame, List<RigidTransform> poses) {
  /** The most waypoints. */
  public static final int MOST = 500;
  /** Without waypoints. */
  public static final Route NONE = new Route(Optional.empty(), List.of());

  /** Copies the list. */
  public Route {
    poses = List.copyOf(poses);
  }

  /** Reads those of the settings. */
  public static Route read(Settings settings) {
    List<RigidTransform> poses = settings.list(SceneOptions.WAYPOINTS).stream().limit(MOST).map(Route::pose).toList();
    Optional<FrameId> frame = frame(settings.text(SceneOptions.WAYPOINT_FRAME).strip());
    return poses.isEmpty() ? NONE : new Route(frame, poses);
  }

  /** Keeps them in the settings. */
  public void write(SettingsStore settings) {
    settings.set(SceneOptions.WAYPOINT_FRAME, frame.map(f -> f.robot() + '/' + f.name()).orElse(""));
    settings.set(SceneOptions.WAYPOINTS, poses.stream().<Object>map(Route::fields).toList());
  }

  /** As a configuration has them. */
  public String yaml() {
    StringBuilder text = new StringBuilder();
    frame.ifPresent(f -> text.append(SceneOptions.WAYPOINT_FRAME).append(": ").append(f.robot()).append('/')
        .append(f.name()).append('\n'));
    text.append(SceneOptions.WAYPOINTS).append(poses.isEmpty() ? ": []\n" : ":\n");
    poses.forEach(pose -> text.append("  - ").append(fields(pose).toString().replace("=", ": ")).append('\n'));
    return text.toString();
  }

  Route with(int index, RigidTransform pose) {
    return changed(list -> {
      list.set(index, pose);
      return list;
    });
  }

  Route plus(RigidTransform pose) {
    return changed(list -> {
      list.add(pose);
      return list;
    });
  }

  Route without(int index) {
    return changed(list -> {
      list.remove(index);
      return list;
    });
  }

  /** With a waypoint one place earlier (-1) or later (1), where there is one. */
  Route moved(int index, int by) {
    return index + by < 0 || index + by >= poses.size() ? this : changed(list -> {
      Collections.swap(list, index, index + by);
      return list;
    });
  }

  private Route changed(UnaryOperator<List<RigidTransform>> change) {
    return new Route(frame, change.apply(new ArrayList<>(poses)));
  }

  /** A frame as it is written: robot/frame. */
  static Optional<FrameId> frame(String written) {
    int cut = written.indexOf('/');
    return cut > 0 ? Optional.of(new FrameId(written.substring(0, cut), written.substring(cut + 1))) : Optional.empty();
  }

  private static RigidTransform pose(Object group) {
    Map<?, ?> fields = group instanceof Settings s ? s.values() : group instanceof Map<?, ?> m ? m : Map.of();
    RigidTransform level = RigidTransform.planar(number(fields, "x"), number(fields, "y"), number(fields, "yaw"));
    return new RigidTransform(level.translation().plus(new Vector3(0, 0, number(fields, "z"))), level.rotation());
  }

  private static double number(Map<?, ?> fields, String name) {
    return fields.get(name) instanceof Number number ? number.doubleValue() : 0;
  }

  /** To a tenth of a millimetre and of a milliradian: what a hand can place is coarser. */
  static Map<String, Object> fields(RigidTransform pose) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("x", rounded(pose.translation().x()));
    fields.put("y", rounded(pose.translation().y()));
    fields.put("z", rounded(pose.translation().z()));
    fields.put("yaw", rounded(pose.rotation().yaw()));
    return fields;
  }

  private static double rounded(double value) {
    return Math.rint(value * 1e4) / 1e4;
  }
}
