package org.robotui.recording.internal.copy;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordingCopy;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.RecordingWriter;

/** Writes a part of recordings into one. For one thread and one time. */
public final class CopyRun {
  private final List<CopiedRecording> recordings;

  /** The writer is closed by whoever made it. */
  public CopyRun(List<RecordingReader> from, RecordingPart part, RecordingWriter writer) {
    this.recordings = from.stream().map(each -> new CopiedRecording(each, part, writer)).toList();
  }

  /** Copies. */
  public RecordingCopy.Outcome run() throws RecordingException {
    List<RecordingDamage> lost = new ArrayList<>();
    Map<List<Object>, RecordedChannel> channels = new HashMap<>();
    long count = 0;
    for (CopiedRecording each : recordings) {
      each.channels(channels);
      each.notesAndFiles(lost);
    }
    for (CopiedRecording each : recordings) {
      count += each.held();
    }
    count += messages();
    recordings.forEach(each -> lost.addAll(each.damages(recordings.size() > 1)));
    return new RecordingCopy.Outcome(count, lost);
  }

  private long messages() throws RecordingException {
    PriorityQueue<CopiedRecording> waiting = new PriorityQueue<>(
        Comparator.comparingLong(CopiedRecording::time).thenComparingInt(recordings::indexOf));
    for (CopiedRecording each : recordings) {
      each.begin();
      if (each.hasNext()) {
        waiting.add(each);
      }
    }
    long count = 0;
    while (!waiting.isEmpty()) {
      CopiedRecording first = waiting.remove();
      first.writeNext();
      count++;
      if (first.hasNext()) {
        waiting.add(first);
      }
    }
    return count;
  }
}
