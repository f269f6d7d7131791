package org.robotui.rtps.internal.endpoint;

import org.robotui.rtps.WriterStatistics;

/** What a writer counts. Its lock guards it. */
final class WriterTally {

  private long written;
  private long bytes;
  private long refused;
  private long unacknowledged;

  void written(Change change) {
    written++;
    bytes += change.size();
  }

  void refused() {
    refused++;
  }

  void unacknowledged() {
    unacknowledged++;
  }

  WriterStatistics statistics(long repaired, ChangeCache cache) {
    return new WriterStatistics(written, bytes, refused, unacknowledged, repaired, cache.size(), cache.bytes());
  }
}
