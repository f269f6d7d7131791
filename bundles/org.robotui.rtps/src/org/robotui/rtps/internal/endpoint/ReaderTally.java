package org.robotui.rtps.internal.endpoint;

import org.robotui.rtps.ReaderStatistics;

/** What a reader counts. Its lock guards it. */
final class ReaderTally {

  private long received;
  private long bytes;
  private long lost;
  private long incomplete;
  private long damaged;
  private long deadlines;
  private long died;

  void received(Change change) {
    received++;
    bytes += change.size();
  }

  void damaged() {
    damaged++;
  }

  void late() {
    deadlines++;
  }

  void died() {
    died++;
  }

  void of(RemoteWriter writer) {
    lost += writer.takeLost();
    incomplete += writer.takeIncomplete();
  }

  ReaderStatistics statistics(long listenerErrors) {
    return new ReaderStatistics(received, bytes, lost, incomplete, damaged, deadlines, died, listenerErrors);
  }
}
