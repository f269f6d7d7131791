package org.robotui.rtps.internal.endpoint;

/** Memory that several parts share. Not safe for threads: its owner's lock guards it. */
final class MemoryBudget {

  private final long most;
  private long used;

  MemoryBudget(long most) {
    this.most = most;
  }

  /** Takes so many bytes, if they are there. */
  boolean take(long bytes) {
    if (bytes > most - used) {
      return false;
    }
    used += bytes;
    return true;
  }

  void free(long bytes) {
    used -= bytes;
  }

  long used() {
    return used;
  }
}
