package org.robotui.recorder.internal.capture;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DataRecord;
import org.robotui.recording.RecordedSchema;

/** The series of messages that were met. One thread adds, any thread looks. */
final class HeadTable {
  /** How long a definition is not asked for again that was not known, in nanoseconds. */
  private static final long PATIENCE = 1_000_000_000L;
  private static final String DATA = "robotui.";
  /** Programs that start again and again would be one more series each time. */
  private static final int MOST_SENDERS = 64;

  /**
   * Where a stream comes from.
   *
   * @param ui the robot UI
   * @param robot the robot
   * @param framework the type of the robot interface
   * @param port its port
   */
  record Place(String ui, String robot, String framework, SourceId port) {}

  /** Several ports may give what comes by one topic: the first one gives it its name. */
  private record Kind(String ui, String component, String topic, String schema, String encoding) {
    Kind(Place place, String topic, String schema, String encoding) {
      this(place.ui(), place.port().component(), topic, schema, encoding);
    }
  }

  /** Senders of one topic stay apart, as in bags; those after the first ones are one, without a name. */
  private record Key(Kind kind, String sender) {}

  private record Known(StreamHead head, boolean complete, long lookedNanos) {}

  private final Map<Key, Known> known = new LinkedHashMap<>();
  private final Map<Kind, Integer> senders = new HashMap<>();
  private final List<StreamHead> all = new CopyOnWriteArrayList<>();

  List<StreamHead> all() {
    return all;
  }

  void add(StreamHead head) {
    all.add(head);
  }

  StreamHead of(Place place, Envelope<?> envelope) {
    return envelope.raw().map(raw -> of(place, raw)).orElseGet(() -> ofData(place, envelope));
  }

  /** A definition may become known later: what comes then is another series. */
  StreamHead of(Place place, RawMessage raw) {
    Key key = key(new Kind(place, topic(place, raw), raw.schema(), raw.encoding()), raw.origin().sender());
    Known found = known.get(key);
    if (found != null && (found.complete() || System.nanoTime() - found.lookedNanos() < PATIENCE)) {
      return found.head();
    }
    Optional<RawDefinition> definition = raw.origin().definition().get();
    StreamHead head = found != null && definition.isEmpty() ? found.head()
        : added(new StreamHead(place.ui(), key.kind().topic(), raw.encoding(), schema(raw, definition),
            metadata(place, raw.schema(), key.sender(), raw.origin().kept())));
    known.put(key, new Known(head, definition.isPresent(), System.nanoTime()));
    return head;
  }

  private Key key(Kind kind, String sender) {
    Key own = new Key(kind, sender);
    if (sender.isEmpty() || known.containsKey(own)) {
      return own;
    }
    int before = senders.getOrDefault(kind, 0);
    if (before == MOST_SENDERS) {
      return new Key(kind, "");
    }
    senders.put(kind, before + 1);
    return own;
  }

  private StreamHead added(StreamHead head) {
    all.add(head);
    return head;
  }

  private static String topic(Place place, RawMessage raw) {
    return raw.origin().topic().isEmpty() ? place.port().port() : raw.origin().topic();
  }

  private static RecordedSchema schema(RawMessage raw, Optional<RawDefinition> definition) {
    return definition.map(d -> {
      byte[] content = new byte[d.content().size()];
      d.content().copyTo(0, content, 0, content.length);
      return new RecordedSchema(d.name(), d.encoding(), content);
    }).orElseGet(() -> RecordedSchema.NONE);
  }

  private StreamHead ofData(Place place, Envelope<?> envelope) {
    String type = envelope.value().getClass().getSimpleName();
    Key key = new Key(new Kind(place, "/" + place.ui() + "/" + place.port(), type, DataJson.ENCODING), "");
    return known.computeIfAbsent(key, k -> new Known(
        added(new StreamHead(place.ui(), k.kind().topic(), DataJson.ENCODING,
            DataJson.schema(DATA + type, DataRecord.of(envelope.value())), metadata(place, type, "", false))),
        true, 0)).head();
  }

  private static Map<String, String> metadata(Place place, String type, String sender, boolean latched) {
    Map<String, String> metadata = new HashMap<>(Map.of("robotui.ui", place.ui(), "robotui.robot", place.robot(),
        "robotui.framework", place.framework(), "robotui.interface", place.port().component(), "robotui.port",
        place.port().port(), "robotui.type", type));
    if (!sender.isEmpty()) {
      metadata.put("callerid", sender); // as bags note it
    }
    if (latched) {
      metadata.put("latching", "1"); // as bags note it: readers deliver the last one to who comes later
    }
    return metadata;
  }
}
