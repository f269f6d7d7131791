package org.robotui.entity.robotmodel.internal;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.Executor;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;
import org.robotui.testkit.FakeSettings;

/** A scene with one display, whose background works when the test says so. */
final class Bench implements DisplayContext, Places {
  static final String ROBOT = "robby";
  static final Rgba ROBOT_COLOR = Rgba.of(0x123456);

  final FakeSettings settings = new FakeSettings(RobotModelType.SCHEMA);
  final Map<String, RigidTransform> frames = new HashMap<>();
  final RobotModelDisplay display = new RobotModelDisplay(this, new ModelShelf());
  private final Queue<Runnable> waiting = new ArrayDeque<>();
  private final List<Envelope<? extends Data>> arrived = new ArrayList<>();
  private long now;
  int wakes;

  Bench give(Data value) {
    arrived.add(new Envelope<>(value, new SourceId(ROBOT, "port"), 0, Optional.empty(), now, Optional.empty()));
    return this;
  }

  Bench later(double seconds) {
    now += (long) (seconds * 1e9);
    return this;
  }

  DisplayResult tick() {
    List<Envelope<? extends Data>> batch = List.copyOf(arrived);
    arrived.clear();
    return display
        .update(new DisplayTick(batch, new InputState.Live(1, 0), this, settings.current(), ROBOT_COLOR, now, false));
  }

  /** Ticks until what was asked for is loaded and shown. */
  DisplayResult settled() {
    tick();
    while (!waiting.isEmpty()) {
      waiting.remove().run();
    }
    return tick();
  }

  static Part part(DisplayResult result, String key) {
    return result.parts().stream().filter(part -> part.key().toString().contains(key)).findFirst()
        .orElseThrow(() -> new AssertionError("no " + key + " in " + result.parts().stream().map(Part::key).toList()));
  }

  @Override
  public Executor background() {
    return waiting::add;
  }

  @Override
  public void wake() {
    wakes++;
  }

  @Override
  public CommandOutcome send(Data command) {
    throw new AssertionError("a model commands nothing: " + command);
  }

  @Override
  public FrameId fixed() {
    return new FrameId(ROBOT, "map");
  }

  @Override
  public Place at(FrameId frame, Optional<Stamp> stamp) {
    RigidTransform place = frame.robot().equals(ROBOT) ? frames.get(frame.name()) : null;
    return place == null ? new Place.Missing("there is no link to " + frame) : new Place.At(place);
  }

  @Override
  public List<FrameId> all() {
    return frames.keySet().stream().map(name -> new FrameId(ROBOT, name)).toList();
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return Optional.empty();
  }
}
