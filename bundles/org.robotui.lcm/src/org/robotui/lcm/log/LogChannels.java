package org.robotui.lcm.log;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.lcm.type.TypeText;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;

/** The channels of a log, each with a type that was sent by it. */
final class LogChannels {

  private static final String ENCODING = "lcm";
  /** Names come from a file: messages of those beyond so many are left out. */
  private static final int MOST = 10_000;

  private record Key(String name, Optional<Long> fingerprint) {}

  private final TypeLibrary types;
  private final Map<Key, RecordedChannel> known = new HashMap<>();
  private final List<RecordedChannel> all = new ArrayList<>();

  LogChannels(TypeLibrary types) {
    this.types = types;
  }

  List<RecordedChannel> all() {
    return List.copyOf(all);
  }

  /**
   * @param fingerprint what a message begins with; none where it is too short
   * @return empty where there are too many
   */
  Optional<RecordedChannel> of(String name, Optional<Long> fingerprint) {
    Key key = new Key(name, fingerprint);
    if (!known.containsKey(key) && all.size() < MOST) {
      RecordedChannel made = made(key);
      known.put(key, made);
      all.add(made);
    }
    return Optional.ofNullable(known.get(key));
  }

  private RecordedChannel made(Key key) {
    Optional<LcmType> type = key.fingerprint().flatMap(number -> types.withFingerprint(number).stream().findFirst());
    RecordedSchema schema = type.map(found -> new RecordedSchema(found.name(), ENCODING,
        TypeText.of(found, types).getBytes(StandardCharsets.UTF_8))).orElse(RecordedSchema.NONE);
    Map<String, String> notes = key.fingerprint()
        .map(number -> Map.of("fingerprint", "0x" + HexFormat.of().toHexDigits(number))).orElse(Map.of());
    return new RecordedChannel(all.size(), key.name(), ENCODING, schema, notes);
  }
}
