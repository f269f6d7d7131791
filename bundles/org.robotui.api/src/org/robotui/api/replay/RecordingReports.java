package org.robotui.api.replay;

import java.io.IOException;

/** Writes reports of recordings that are open. An OSGi service, safe for all threads. */
public interface RecordingReports {
  /**
   * What a recording tells of a session, as one page that needs nothing else. Reads all of it, which may take minutes;
   * not for the display thread.
   *
   * @param track which recording
   * @return HTML that is well-formed XML, too
   * @throws IOException where the file cannot be read any more
   * @throws InterruptedException where the thread was interrupted
   * @throws IllegalArgumentException where it is not open any more
   */
  String page(TrackId track) throws IOException, InterruptedException;
}
