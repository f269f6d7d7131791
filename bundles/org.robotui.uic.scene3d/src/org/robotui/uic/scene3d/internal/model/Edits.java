package org.robotui.uic.scene3d.internal.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.config.SettingsStore;
import org.robotui.geometry.Vector3;
import org.robotui.ui.display.DisplayList;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.display.Written;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.camera.CameraKind;
import org.robotui.uic.scene3d.internal.camera.CameraPose;

/** What the user changes in a scene, its displays among it, kept in the settings. */
public final class Edits extends DisplayList {
  /** The view that a scene begins with. */
  public static final String START = "start";

  private final SettingsStore settings;

  /** Changes the settings; the supplier gives the displays as they are listed now. */
  public Edits(SettingsStore settings, Supplier<List<DisplaySpec>> now) {
    super(settings, SceneOptions.DISPLAYS, Growth.LAST, now);
    this.settings = settings;
  }

  /** Chooses what is drawn at rest. */
  public void fixedFrame(String name) {
    settings.set(SceneOptions.FIXED_FRAME, name);
  }

  /** Chooses what the camera keeps up with. */
  public void follow(String frame, boolean yaw) {
    settings.set(SceneOptions.FOLLOW, frame);
    settings.set(SceneOptions.FOLLOW_YAW, yaw);
  }

  /** Opens or closes the list of displays. */
  public void tree(boolean open) {
    settings.set(SceneOptions.TREE, open);
  }

  /** Keeps a view under a name. */
  public void keep(String name, CameraPose pose) {
    Map<String, Object> views = new LinkedHashMap<>(written());
    views.put(name, written(pose));
    settings.set(SceneOptions.VIEWS, views);
  }

  /** Keeps where the user left the camera. */
  public void left(CameraPose pose) {
    settings.set(SceneOptions.CAMERA, written(pose));
  }

  /** Where the user left the camera; none where a view is named start, which holds then. */
  public Optional<CameraPose> left() {
    return start().isPresent() ? Optional.empty()
        : Optional.ofNullable(settings.current().values().get(SceneOptions.CAMERA))
            .map(written -> pose(Written.fields(written)));
  }

  private static Map<String, Object> written(CameraPose pose) {
    return Map.of(SceneOptions.KIND, pose.kind().word(), "x", pose.focus().x(), "y", pose.focus().y(), "z",
        pose.focus().z(), "distance", pose.distance(), "yaw", pose.yaw(), "pitch", pose.pitch());
  }

  /** Forgets a view. */
  public void forget(String name) {
    Map<String, Object> views = new LinkedHashMap<>(written());
    views.remove(name);
    settings.set(SceneOptions.VIEWS, views);
  }

  /** The views that are kept, by name. */
  public Map<String, CameraPose> views() {
    Map<String, CameraPose> views = new LinkedHashMap<>();
    written().forEach((name, view) -> views.put(name, pose(Written.fields(view))));
    return views;
  }

  /** The view that the scene begins with. */
  public Optional<CameraPose> start() {
    return Optional.ofNullable(views().get(START));
  }

  private Map<String, Object> written() {
    Map<String, Object> views = Written.fields(settings.current().map(SceneOptions.VIEWS));
    views.replaceAll((name, view) -> Written.fields(view));
    return views;
  }

  private static CameraPose pose(Map<String, Object> fields) {
    Vector3 focus =
        new Vector3(Written.number(fields, "x", 0), Written.number(fields, "y", 0), Written.number(fields, "z", 0));
    return new CameraPose(CameraKind.of(Written.text(fields, SceneOptions.KIND)).orElse(CameraKind.ORBIT), focus,
        Written.number(fields, "distance", CameraPose.START.distance()), Written.number(fields, "yaw", 0),
        Written.number(fields, "pitch", CameraPose.START.pitch()));
  }
}
