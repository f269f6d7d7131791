package org.robotui.testkit.display;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.stream.Stream;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;

/**
 * A display with what a scene would give it: settings with their fallbacks, places, and ticks a tenth of a second
 * apart. For one thread.
 */
public final class DisplayProbe implements AutoCloseable {
  private static final long STEP = 100_000_000;

  private final DisplayType type;
  private final Display display;
  private final FakePlaces places = new FakePlaces();
  private final Map<String, Object> values = new HashMap<>();
  private InputState state = new InputState.Live(10, 0);
  private long now = 1_000_000_000_000L;
  private long sequence;

  /**
   * Makes a display of a kind.
   *
   * @param type the kind
   */
  public DisplayProbe(DisplayType type) {
    this.type = type;
    type.schema().settings().forEach(s -> s.fallback().ifPresent(value -> values.put(s.name(), value)));
    display = type.create(new Still());
  }

  /**
   * Where frames are.
   *
   * @return to be changed by the test
   */
  public FakePlaces places() {
    return places;
  }

  /**
   * Changes a setting.
   *
   * @param name of it
   * @param value Boolean, Long, Double or String
   * @return this
   */
  public DisplayProbe set(String name, Object value) {
    Setting known = type.schema().find(name).orElseThrow();
    values.put(known.name(), value);
    return this;
  }

  /**
   * Changes the state of its sources.
   *
   * @param next from now on
   * @return this
   */
  public DisplayProbe state(InputState next) {
    state = next;
    return this;
  }

  /**
   * One tick, a tenth of a second after the last.
   *
   * @param arrived what came, measured and received now
   * @return what the display shows
   */
  public DisplayResult tick(Data... arrived) {
    return tick(false, arrived);
  }

  /**
   * One tick at which the clock of the robot jumped back.
   *
   * @return what the display shows
   */
  public DisplayResult reset() {
    return tick(true);
  }

  /**
   * The parts after one tick.
   *
   * @param arrived what came
   * @return what is drawn
   */
  public List<Part> parts(Data... arrived) {
    return tick(arrived).parts();
  }

  @Override
  public void close() {
    display.close();
  }

  private DisplayResult tick(boolean reset, Data... arrived) {
    now += STEP;
    List<Envelope<? extends Data>> envelopes =
        Stream.of(arrived).<Envelope<? extends Data>>map(this::envelope).toList();
    return display
        .update(new DisplayTick(envelopes, state, places, new Settings(type.schema(), values), Rgba.WHITE, now, reset));
  }

  private <T extends Data> Envelope<T> envelope(T value) {
    return new Envelope<>(value, new SourceId(FakePlaces.ROBOT, "port"), sequence++,
        Optional.of(new Stamp(now, ClockKind.ROBOT)), now,
        Optional.empty());
  }

  /** Runs what is asked at once; sends nothing. */
  private static final class Still implements DisplayContext {
    @Override
    public Executor background() {
      return Runnable::run;
    }

    @Override
    public void wake() {
      // A test ticks by itself.
    }

    @Override
    public CommandOutcome send(Data command) {
      throw new UnsupportedOperationException("no command was expected: " + command);
    }
  }
}
