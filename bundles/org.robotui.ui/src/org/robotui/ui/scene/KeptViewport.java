package org.robotui.ui.scene;

import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.config.ValueType;
import org.robotui.ui.UiContext;
import org.robotui.ui.display.Written;

/**
 * Where hands have left the camera of a view from above, kept in the settings of the view, so that it is there again at
 * the next start. Display thread.
 */
public final class KeptViewport {
  /** The setting. */
  public static final String CAMERA = "camera";

  private static final String X = "x";
  private static final String Y = "y";
  private static final String SCALE = "scale";
  private static final int REST_MILLIS = 500;
  private static final double FAR = 1e10;
  private static final ValueType PLACE = new ValueType.Num(-FAR, FAR, "m");

  private final SettingsStore settings;
  private final LongSupplier nanos;
  private final Consumer<Runnable> atRest;
  private final Runnable write = this::write;
  private Optional<Map<String, Object>> unwritten = Optional.empty();

  /**
   * In settings whose schema has {@link #setting}.
   *
   * @param settings where it is kept
   * @param nanos monotonic nanoseconds
   * @param atRest runs what it is given once, a while after it was given last
   */
  public KeptViewport(SettingsStore settings, LongSupplier nanos, Consumer<Runnable> atRest) {
    this.settings = settings;
    this.nanos = nanos;
    this.atRest = atRest;
  }

  /**
   * Written when the hands have rested for half a second.
   *
   * @param settings where it is kept
   * @param context of the window
   * @param display of the window
   * @return what keeps it
   */
  public static KeptViewport in(SettingsStore settings, UiContext context, Display display) {
    return new KeptViewport(settings, context::nanos, write -> display.timerExec(REST_MILLIS, write));
  }

  /**
   * The setting that the view must have.
   *
   * @return to be put into its schema
   */
  public static Setting setting() {
    Schema schema = Schema.of(
        Setting.of(X, PLACE, 0.0, "What is in the middle, in the fixed frame."),
        Setting.of(Y, PLACE, 0.0, "What is in the middle, in the fixed frame."),
        Setting.of(SCALE, new ValueType.Num(0, Viewport.MAX_SCALE, "px/m"), 0.0,
            "How large it is shown; 0 to show all there is."));
    return Setting.optional(CAMERA, new ValueType.Section(schema),
        "Where the user left the camera; without it, all there is is shown.").asState();
  }

  /**
   * Where it was left.
   *
   * @param now the size of the window
   * @return what is seen from there; none where all there is is shown
   */
  Optional<Viewport> read(Viewport now) {
    Map<String, Object> left = Written.fields(settings.current().values().getOrDefault(CAMERA, Map.of()));
    double scale = Written.number(left, SCALE, 0);
    return scale > 0
        ? Optional.of(
            new Viewport(Written.number(left, X, 0), Written.number(left, Y, 0), scale, now.width(), now.height()))
        : Optional.empty();
  }

  /** Hands have moved the camera there. */
  void moved(Viewport there) {
    later(Map.of(X, there.centerX(), Y, there.centerY(), SCALE, there.scale()));
  }

  /** From now on all there is is shown. */
  void forget() {
    if (settings.current().has(CAMERA) || unwritten.isPresent()) {
      later(Map.of(X, 0.0, Y, 0.0, SCALE, 0.0));
    }
  }

  long nanos() {
    return nanos.getAsLong();
  }

  private void later(Map<String, Object> value) {
    unwritten = Optional.of(value);
    atRest.accept(write);
  }

  /** Writes now what is not written yet: the view ends. */
  public void write() {
    unwritten.ifPresent(value -> settings.set(CAMERA, value));
    unwritten = Optional.empty();
  }
}
