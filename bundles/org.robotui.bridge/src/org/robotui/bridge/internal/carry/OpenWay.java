package org.robotui.bridge.internal.carry;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.bridge.BridgeTransform.Direction;
import org.robotui.api.config.Settings;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.bridge.internal.change.FieldMapping;
import org.robotui.bridge.internal.change.FrameRenaming;
import org.robotui.bridge.internal.change.StampMoving;
import org.robotui.bridge.internal.change.ValueRewriting;
import org.robotui.bridge.internal.far.Crossing;
import org.robotui.bridge.internal.far.FarSide;
import org.robotui.bridge.internal.far.FarSide.Passage;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.Late;
import org.robotui.data.Stamp;
import org.robotui.data.command.RelayMessage.Answer;
import org.robotui.data.command.RelayMessage.Original;
import org.robotui.data.command.RelayMessage.Wire;
import org.robotui.data.record.DynamicRecord;

/** A way between two robot UIs that are there. */
final class OpenWay implements AutoCloseable {
  private final Ruic source;
  private final Ruic sink;
  private final WayEnds ends;
  private final PortAccess near;
  private final PortAccess beyond;
  private final FarSide far;
  private final Settings settings;
  private final Direction direction;
  private final StampMoving stamps;
  private final ValueRewriting rewriting;
  private final Optional<FieldMapping> fields;
  private final CarryContext surroundings;

  private OpenWay(BridgeConfig config, Direction direction, WayEnds ends, Ruic source, Ruic sink,
      CarryContext surroundings) {
    this.source = source;
    this.sink = sink;
    this.ends = ends;
    this.direction = direction;
    this.settings = config.settings();
    this.surroundings = surroundings;
    boolean back = direction == Direction.BACK;
    this.stamps = StampMoving.of(settings, back, source.clock(), sink.clock());
    FrameRenaming forth = FrameRenaming.of(settings, robot(sink, ends.to()));
    this.rewriting = new ValueRewriting(back ? forth.back(robot(sink, ends.to())) : forth, stamps);
    this.fields = FieldMapping.of(settings);
    this.near = source.access(ends.principal());
    this.near.onArrival(surroundings.arrival());
    this.beyond = sink.access(ends.principal());
    this.far = new FarSide(ends.to(), sink, beyond, settings);
  }

  /** Opens a way; none where one of its robot UIs is not there. */
  static Optional<OpenWay> of(BridgeConfig config, Direction direction, WayEnds ends, CarryContext surroundings) {
    return surroundings.ruic(ends.from()).flatMap(source -> surroundings.ruic(ends.to())
        .map(sink -> new OpenWay(config, direction, ends, source, sink, surroundings)));
  }

  static String missing(WayEnds ends, CarryContext surroundings) {
    BridgeEnd absent = surroundings.ruic(ends.from()).isEmpty() ? ends.from() : ends.to();
    return "the robot UI '" + absent.ruic() + "' does not run";
  }

  private static String robot(Ruic ruic, BridgeEnd end) {
    return ruic.interfaces().stream().filter(i -> i.id().equals(end.port().component())).map(InterfaceConfig::robot)
        .filter(name -> !name.isEmpty()).findFirst().orElse(ruic.name());
  }

  boolean isCurrent(CarryContext now) {
    return ends.stillJoin(source, sink, now);
  }

  PortAccess near() {
    return near;
  }

  FarSide far() {
    return far;
  }

  /** Why nothing can pass as it is configured. */
  Optional<String> wrong() {
    return settings.has("transform") && surroundings.transform(settings.text("transform")).isEmpty()
        ? Optional.of("no transform '" + settings.text("transform") + "' is installed; there are: "
            + String.join(", ", surroundings.transformIds()))
        : Optional.empty();
  }

  /** Whether a value holds until it is replaced, so that those who come later get it. */
  boolean isKept(Envelope<?> envelope) {
    DataType type = DataType.of(envelope.value().getClass());
    boolean holds = envelope.raw().map(raw -> raw.origin().kept()).orElse(false)
        || !type.expires() && type.late() != Late.NONE;
    return settings.has("latched") ? settings.flag("latched") : holds;
  }

  /** Has a value said at the other side; false where it is to be tried again. */
  boolean pass(Envelope<?> envelope, Answer answer, long now) {
    try {
      Optional<Crossing> crossing = crossing(envelope, answer);
      return crossing.isEmpty() || !tryAgain(far.send(crossing.get(), now), crossing.get());
    } catch (IllegalArgumentException e) {
      answer.told(Optional.of(String.valueOf(e.getMessage())));
      return true;
    }
  }

  /** What holds is said again when the robot comes, anyway; what does not is of no use then. */
  private static boolean tryAgain(Passage passage, Crossing crossing) {
    return switch (passage) {
      case Passage.Over over -> false;
      case Passage.Later later -> true;
      case Passage.Away away -> {
        crossing.answer().told(Optional.of(away.reason()));
        yield false;
      }
    };
  }

  private Optional<Crossing> crossing(Envelope<?> envelope, Answer answer) {
    Optional<Stamp> stamp = stamps.of(envelope);
    boolean kept = isKept(envelope);
    if (fields.isPresent()) {
      Data made = fields.get().of(rewriting.of(envelope.record(), stamp), stamp);
      return Optional.of(new Crossing(made, stamp, Original.NONE, kept, answer));
    }
    Data value = rewriting.of(envelope.value(), stamp);
    if (settings.has("transform")) {
      return surroundings.transform(settings.text("transform")).flatMap(t -> t.apply(value, direction))
          .map(made -> new Crossing(made, stamp, Original.NONE, kept, answer));
    }
    Original original = envelope.raw().map(raw -> original(raw, stamp)).orElse(Original.NONE);
    return Optional.of(new Crossing(value, stamp, original, kept, answer));
  }

  private Original original(RawMessage raw, Optional<Stamp> stamp) {
    Optional<Wire> wire = rewriting.isNone()
        ? Optional.of(new Wire(raw.encoding(), () -> raw.origin().definition().get().map(OpenWay::text), raw.bytes()))
        : Optional.empty();
    return new Original(raw.schema(), () -> raw.record().map(record -> rewritten(record, stamp)), wire);
  }

  private static String text(RawDefinition definition) {
    return StandardCharsets.UTF_8.decode(definition.content().buffer(ByteOrder.BIG_ENDIAN)).toString();
  }

  private DynamicRecord rewritten(DynamicRecord record, Optional<Stamp> stamp) {
    return rewriting.of(record, stamp);
  }

  @Override
  public void close() {
    far.close();
    near.close();
    beyond.close();
  }
}
