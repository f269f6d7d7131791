package org.robotui.entity.marker.internal;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Rgba;

/** Stands in for a scene: says where frames are, and makes ticks. */
final class Ticks implements Places {
  static final SourceId SOURCE = new SourceId("robot", "objects");
  final Map<String, RigidTransform> frames = new HashMap<>(Map.of("map", RigidTransform.IDENTITY));
  final Map<String, Object> values = new HashMap<>();
  private final Schema schema;
  FrameId fixed = frame("map");
  long now = 1_000_000_000L;
  int asked;

  Ticks(Schema schema) {
    this.schema = schema;
    schema.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
  }

  static FrameId frame(String name) {
    return new FrameId("robby", name);
  }

  DisplayTick of(Data... arrived) {
    return tick(false, arrived);
  }

  DisplayTick tick(boolean reset, Data... arrived) {
    List<Envelope<? extends Data>> envelopes = Arrays.stream(arrived)
        .<Envelope<? extends Data>>map(v -> new Envelope<>(v, SOURCE, 1, Optional.empty(), now, Optional.empty()))
        .toList();
    return new DisplayTick(envelopes, new InputState.Live(10, 0), this, new Settings(schema, values), Rgba.WHITE, now,
        reset);
  }

  @Override
  public FrameId fixed() {
    return fixed;
  }

  @Override
  public Place at(FrameId frame, Optional<Stamp> stamp) {
    asked++;
    return Optional.ofNullable(frames.get(frame.name())).<Place>map(Place.At::new)
        .orElse(new Place.Missing("no transform from " + frame.name() + " to map"));
  }

  @Override
  public List<FrameId> all() {
    return frames.keySet().stream().sorted().map(Ticks::frame).toList();
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return Optional.empty();
  }
}
