package org.robotui.recorder.internal.file;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.SequencedMap;
import org.robotui.recorder.internal.capture.Captured;
import org.robotui.recorder.internal.capture.StreamHead;

/**
 * What holds until it is replaced, such as maps and fixed transforms: whoever reads a later file, or the last seconds
 * alone, needs it too. For one thread at a time.
 */
final class HeldMessages {
  /** Of what is larger nobody would want a copy in each file. */
  private static final long MOST_BYTES = 64L << 20;

  private record Key(StreamHead head, String holder) {}

  private final SequencedMap<Key, Captured> newest = new LinkedHashMap<>();
  private long bytes;

  void note(Captured message) {
    message.holder().ifPresent(holder -> {
      Key key = new Key(message.head(), holder);
      Captured before = newest.remove(key);
      bytes += message.weight() - (before == null ? 0 : before.weight());
      newest.put(key, message);
      if (bytes > MOST_BYTES) {
        bytes -= newest.pollFirstEntry().getValue().weight();
      }
    });
  }

  List<Captured> all() {
    return List.copyOf(newest.values());
  }
}
