package org.robotui.rfic.gazebo.internal.session;

import java.nio.ByteBuffer;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.gazebo.GazeboNode;
import org.robotui.web.ArrivalSubscription;

/**
 * The time of a world, by its clock, else by its statistics. It comes with each step of the simulation, which may be a
 * thousand times a second: only the newest is looked at, when somebody asks. Safe for all threads.
 */
final class SimulatedTime implements AutoCloseable {
  private static final long SECOND = 1_000_000_000L;
  private static final List<Source> SOURCES = List.of(new Source("/clock", Set.of("gz.msgs.Clock",
      "ignition.msgs.Clock"), "sim"),
      new Source("/stats", Set.of("gz.msgs.WorldStatistics", "ignition.msgs.WorldStatistics"), "sim_time"));

  private final GazeboNode node;
  private final TypeFormats formats;
  private Optional<Followed> followed = Optional.empty();
  private volatile Optional<Said> newest = Optional.empty();
  private volatile long heardNanos;

  /** A kind of topic that says the time. */
  private record Source(String name, Set<String> types, String field) {
    boolean is(String topic, String type) {
      return topic.endsWith(name) && types.contains(type);
    }
  }

  private record Followed(String topic, ArrivalSubscription subscription) {}

  private record Said(String type, String field, ByteBuffer payload) {}

  SimulatedTime(GazeboNode node, TypeFormats formats) {
    this.node = node;
    this.formats = formats;
  }

  /** When the time was heard last, by {@link System#nanoTime()}; 0 while it was not. */
  long heardNanos() {
    return heardNanos;
  }

  synchronized void follow(WorldTable table) {
    Optional<Map.Entry<String, String>> best = Optional.empty();
    Optional<Source> kind = Optional.empty();
    for (Source source : SOURCES) {
      if (best.isEmpty()) {
        best = table.published().entrySet().stream().filter(each -> source.is(each.getKey(), each.getValue()))
            .min(Map.Entry.comparingByKey(Comparator.comparingInt(String::length)));
        kind = best.map(each -> source);
      }
    }
    String topic = best.map(Map.Entry::getKey).orElse("");
    if (!followed.map(Followed::topic).orElse("").equals(topic)) {
      end();
      if (best.isPresent()) {
        follow(topic, best.get().getValue(), kind.orElseThrow().field());
      }
    }
  }

  private void follow(String topic, String type, String field) {
    followed = Optional.of(new Followed(topic, node.subscribe(topic, type, 1, (sender, payload, nanos) -> {
      newest = Optional.of(new Said(type, field, payload));
      heardNanos = nanos;
    })));
  }

  /** Nanoseconds since the begin of the simulation; none while nobody says that. */
  OptionalLong now() {
    return newest.map(this::read).orElse(OptionalLong.empty());
  }

  private OptionalLong read(Said said) {
    try {
      DynamicRecord record = formats.of(said.type()).read(said.payload().duplicate());
      return OptionalLong.of(number(record, said.field() + ".sec") * SECOND + number(record, said.field() + ".nsec"));
    } catch (IllegalArgumentException e) {
      return OptionalLong.empty();
    }
  }

  private static long number(DynamicRecord record, String path) {
    return record.at(FieldPath.parse(path)).filter(FieldValue.Num.class::isInstance)
        .map(value -> (long) ((FieldValue.Num) value).value()).orElse(0L);
  }

  private void end() {
    followed.ifPresent(each -> each.subscription().close());
    followed = Optional.empty();
    newest = Optional.empty();
  }

  @Override
  public synchronized void close() {
    end();
  }
}
