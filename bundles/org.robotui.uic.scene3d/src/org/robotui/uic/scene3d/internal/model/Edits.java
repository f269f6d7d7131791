package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.robotui.api.config.SettingsStore;
import org.robotui.geometry.Vector3;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.camera.CameraKind;
import org.robotui.uic.scene3d.internal.camera.CameraPose;

/** What the user changes, kept in the settings. With the first change the automatic displays are written down. */
public final class Edits {
  /** The view that a scene begins with. */
  public static final String START = "start";

  private final SettingsStore settings;
  private final Supplier<List<DisplaySpec>> now;

  /** Changes the settings; the supplier gives the displays as they are listed now. */
  public Edits(SettingsStore settings, Supplier<List<DisplaySpec>> now) {
    this.settings = settings;
    this.now = now;
  }

  /** Adds a display of a source and says its id. */
  public String add(String type, String source) {
    String id = add(type);
    change(id, spec -> spec.from(List.of(source)));
    return id;
  }

  /** Adds a display and says its id. */
  public String add(String type) {
    List<DisplaySpec> specs = new ArrayList<>(now.get());
    Set<String> taken = specs.stream().map(DisplaySpec::id).collect(Collectors.toCollection(HashSet::new));
    String id = DisplayCodec.free(type, taken);
    specs.add(DisplaySpec.of(id, type));
    write(specs);
    return id;
  }

  /** Removes a display. */
  public void remove(String id) {
    List<DisplaySpec> specs = now.get().stream().filter(s -> !s.id().equals(id)).toList();
    if (specs.isEmpty()) {
      settings.set(SceneOptions.AUTOMATIC, false);
    }
    write(specs);
  }

  /** Moves a display up (-1) or down (1). */
  public void move(String id, int by) {
    List<DisplaySpec> specs = new ArrayList<>(now.get());
    for (int i = 0; i < specs.size(); i++) {
      if (specs.get(i).id().equals(id) && i + by >= 0 && i + by < specs.size()) {
        Collections.swap(specs, i, i + by);
        write(specs);
        return;
      }
    }
  }

  /** Changes a display. */
  public void change(String id, UnaryOperator<DisplaySpec> change) {
    List<DisplaySpec> before = now.get();
    List<DisplaySpec> after = before.stream().map(s -> s.id().equals(id) ? change.apply(s) : s).toList();
    if (!after.equals(before)) {
      write(after);
    }
  }

  /** Sets one setting of a display. */
  public void set(String id, String name, Object value) {
    change(id, spec -> {
      Map<String, Object> values = new LinkedHashMap<>(spec.settings());
      values.put(name, value);
      return spec.with(values);
    });
  }

  /** Shows what the robot offers again. */
  public void automatic() {
    settings.set(SceneOptions.AUTOMATIC, true);
    settings.set(SceneOptions.DISPLAYS, List.of());
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
    views.put(name,
        Map.of(SceneOptions.KIND, pose.kind().word(), "x", pose.focus().x(), "y", pose.focus().y(), "z",
            pose.focus().z(),
            "distance", pose.distance(), "yaw", pose.yaw(), "pitch", pose.pitch()));
    settings.set(SceneOptions.VIEWS, views);
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

  private void write(List<DisplaySpec> specs) {
    settings.set(SceneOptions.DISPLAYS, DisplayCodec.write(specs));
  }
}
