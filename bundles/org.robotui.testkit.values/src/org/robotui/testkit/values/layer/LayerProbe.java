package org.robotui.testkit.values.layer;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.FakeFrames;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.EarthOrigin;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerEntry;
import org.robotui.ui.layer.LayerResult;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.layer.SeenRobot;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Placer;
import org.robotui.ui.scene.Viewport;

/**
 * A layer with what a map would give it: settings with their fallbacks, frames, and ticks a tenth of a second apart.
 * The fixed frame is {@code map} of {@code robot}, in which {@code base} lies where a test says. For one thread.
 */
public final class LayerProbe {
  /** The robot whose frames they are. */
  public static final String ROBOT = "robot";

  private static final long STEP = 100_000_000;
  private static final double SCALE = 20;

  private final LayerType type;
  private final DataLayer layer;
  private final FakeFrames frames = new FakeFrames();
  private final Map<String, Object> values = new HashMap<>();
  private List<SeenRobot> robots = List.of();
  private InputState state = new InputState.Live(10, 0);
  private long now = 1_000_000_000_000L;
  private long sequence;

  /**
   * Makes a layer of a kind.
   *
   * @param type the kind
   */
  public LayerProbe(LayerType type) {
    this.type = type;
    type.schema().settings().forEach(s -> s.fallback().ifPresent(value -> values.put(s.name(), value)));
    layer = type.create(() -> Runnable::run);
  }

  /**
   * A frame of the robot.
   *
   * @param name of the frame
   * @return the frame
   */
  public static FrameId frame(String name) {
    return new FrameId(ROBOT, name);
  }

  /**
   * Says where a frame is, for all times.
   *
   * @param name of the frame
   * @param mapFromFrame the fixed frame from it
   * @return this
   */
  public LayerProbe put(String name, RigidTransform mapFromFrame) {
    frames.fix(frame("map"), frame(name), mapFromFrame);
    return this;
  }

  /**
   * Changes a setting.
   *
   * @param name of it
   * @param value Boolean, Long, Double or String
   * @return this
   */
  public LayerProbe set(String name, Object value) {
    Setting known = type.schema().find(name).orElseThrow();
    values.put(known.name(), value);
    return this;
  }

  /**
   * Puts robots on the map.
   *
   * @param seen all of them
   * @return this
   */
  public LayerProbe robots(SeenRobot... seen) {
    robots = List.of(seen);
    return this;
  }

  /**
   * Changes the state of its sources.
   *
   * @param next from now on
   * @return this
   */
  public LayerProbe state(InputState next) {
    state = next;
    return this;
  }

  /**
   * One tick, a tenth of a second after the last.
   *
   * @param arrived what came, measured and received now
   * @return what became of it
   */
  public LayerResult tick(Data... arrived) {
    return tick(false, arrived);
  }

  /**
   * One tick at which the clock of the robot jumped back.
   *
   * @return what became of it
   */
  public LayerResult reset() {
    return tick(true);
  }

  /**
   * The layer.
   *
   * @return what is tested
   */
  public DataLayer layer() {
    return layer;
  }

  /**
   * What is painted, twenty pixels a metre around the origin of the map. Display thread.
   *
   * @param display where
   * @param width pixels
   * @param height pixels
   * @return the picture
   */
  public ImageData picture(Display display, int width, int height) {
    Theme theme = Themes.dark(display);
    Image image = new Image(display, width, height);
    GC gc = new GC(image);
    try {
      gc.setBackground(theme.color(Role.GROUND));
      gc.fillRectangle(0, 0, width, height);
      layer.paint(new Painter(gc, new Viewport(0, 0, SCALE, width, height), theme));
      return image.getImageData();
    } finally {
      gc.dispose();
      image.dispose();
      layer.dispose();
      theme.dispose();
    }
  }

  private LayerResult tick(boolean reset, Data... arrived) {
    now += STEP;
    boolean onEarth = !type.grounds().contains(LayerType.Ground.FRAME);
    List<Envelope<? extends Data>> envelopes =
        Stream.of(arrived).<Envelope<? extends Data>>map(this::envelope).toList();
    Settings settings = new Settings(type.schema(), Map.copyOf(values));
    LayerEntry entry = new LayerEntry(type.label(), 0, 1, Inks.chosen(settings).orElse(Ink.USUAL), settings);
    return layer.update(
        new LayerTick(envelopes, state, onEarth ? Optional.empty() : Optional.of(new Placer(frames, frame("map"))),
            onEarth ? Optional.of(new EarthOrigin(0, 0)) : Optional.empty(), robots, entry, now, reset));
  }

  private <T extends Data> Envelope<T> envelope(T value) {
    return new Envelope<>(value, new SourceId(ROBOT, "port"), sequence++, Optional.of(new Stamp(now, ClockKind.ROBOT)),
        now, Optional.empty());
  }
}
