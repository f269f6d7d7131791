package org.robotui.rfic.recording.internal.session;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.robotui.api.replay.Lane;
import org.robotui.api.replay.TimeRange;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;

/** What is known of the topics of a recording; when their messages lie is found out by reading all of it once. */
final class LaneScan {
  private static final int PARTS = 200;
  private static final int TURN = 2000;
  /** Larger files would keep a disk busy for minutes. */
  private static final long MOST_BYTES = 4L << 30;

  private final TopicTable table;
  private final RecordingReader recording;
  private final TimeRange span;
  private volatile List<Lane> lanes;

  LaneScan(TopicTable table, RecordingReader recording, TimeRange span) {
    this.table = table;
    this.recording = recording;
    this.span = span;
    this.lanes = lanes(Map.of());
  }

  List<Lane> lanes() {
    return lanes;
  }

  private List<Lane> lanes(Map<Integer, int[]> densities) {
    List<Lane> all = new ArrayList<>();
    for (String topic : table.topics()) {
      List<PlayedChannel> channels = table.of(topic);
      int[] sum = new int[densities.isEmpty() ? 0 : PARTS];
      channels.forEach(each -> {
        int[] own = densities.getOrDefault(each.channel().id(), new int[sum.length]);
        Arrays.setAll(sum, i -> sum[i] + own[i]);
      });
      all.add(new Lane(topic, channels.getFirst().format().type(),
          channels.stream().mapToLong(PlayedChannel::count).sum(), IntStream.of(sum).boxed().toList()));
    }
    return all;
  }

  /** Reads all of it, slowly enough that others read as well; of a very large file nothing. */
  void run(BooleanSupplier over) throws InterruptedException {
    if (recording.file().toFile().length() <= MOST_BYTES) {
      read(over);
    }
  }

  private void read(BooleanSupplier over) throws InterruptedException {
    Map<Integer, int[]> densities = new HashMap<>();
    RecordingCursor cursor = recording.cursor(RecordingInterval.ALWAYS, Set.of());
    try {
      int count = 0;
      for (Optional<RecordedMessage> next = cursor.next(); next.isPresent() && !over.getAsBoolean(); next =
          cursor.next()) {
        densities.computeIfAbsent(next.get().channel().id(), id -> new int[PARTS])[part(next.get().logTime())]++;
        if (++count % TURN == 0) {
          Thread.sleep(1);
        }
      }
      if (!over.getAsBoolean()) {
        lanes = lanes(densities);
      }
    } catch (RecordingException e) {
      // who plays it meets the same, and tells it
    }
  }

  private int part(long time) {
    double share = (double) (span.nearest(time) - span.start()) / Math.max(1, span.length());
    return Math.min(PARTS - 1, (int) (share * PARTS));
  }
}
