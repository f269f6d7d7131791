package org.robotui.rtps.internal.participant;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.internal.endpoint.WriterCore;

/** Which of our ends hear of which remote ones. Safe for all threads. */
final class Switchboard {

  private final Map<Guid, List<ReaderPort>> listening = new ConcurrentHashMap<>();
  private final Map<EntityId, WriterCore> writers = new ConcurrentHashMap<>();

  /** A reader of ours listens to a writer. */
  void connect(Guid writer, ReaderPort reader) {
    listening.merge(writer, List.of(reader), Switchboard::joined);
  }

  private static List<ReaderPort> joined(List<ReaderPort> one, List<ReaderPort> other) {
    return one.containsAll(other) ? one
        : Stream.concat(one.stream(), other.stream()).toList();
  }

  void disconnect(Guid writer, ReaderPort reader) {
    listening.computeIfPresent(writer, (same, all) -> {
      List<ReaderPort> others = all.stream().filter(each -> each != reader).toList();
      return others.isEmpty() ? null : others;
    });
  }

  void add(EntityId entity, WriterCore writer) {
    writers.put(entity, writer);
  }

  void remove(EntityId entity) {
    writers.remove(entity);
  }

  /** Our readers that listen to a writer. */
  List<ReaderPort> listening(Guid writer) {
    return listening.getOrDefault(writer, List.of());
  }

  /** One of our writers. */
  Optional<WriterCore> writer(EntityId entity) {
    return Optional.ofNullable(writers.get(entity));
  }
}
