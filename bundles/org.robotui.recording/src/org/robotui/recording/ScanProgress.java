package org.robotui.recording;

/** Hears how far a file without an index has been read through. Called by the thread that opens the file. */
@FunctionalInterface
public interface ScanProgress {

  /** Nobody wants to know. */
  ScanProgress NONE = (done, size) -> {};

  /**
   * So far it is.
   *
   * @param done bytes that are behind
   * @param size bytes of the file
   */
  void scanned(long done, long size);
}
