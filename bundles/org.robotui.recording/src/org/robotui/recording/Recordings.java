package org.robotui.recording;

import java.nio.file.Path;
import org.robotui.recording.internal.bag.BagOpener;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.mcap.McapOpener;

/** Opens recordings of any format that is known here. Any thread may use it. */
public final class Recordings {

  private Recordings() {}

  /**
   * Opens a file by what it begins with; its name does not matter. A file with an index is open at once; any other is
   * read through first, which is said by {@link RecordingReader#isIndexed}. Damaged files are opened too.
   *
   * @param file the recording
   * @param progress hears how far a file without an index is
   * @return the recording; who opens it closes it
   * @throws RecordingException if it cannot be read, or is of none of the formats
   */
  public static RecordingReader open(Path file, ScanProgress progress) throws RecordingException {
    FileBytes bytes = FileBytes.open(file);
    boolean opened = false;
    try {
      RecordingReader recording = open(bytes, progress);
      opened = true;
      return recording;
    } finally {
      if (!opened) {
        bytes.close();
      }
    }
  }

  /**
   * Whether a file is of one of the formats, by what it begins with.
   *
   * @param file any file
   * @return true where {@link #open} would try to read it
   * @throws RecordingException if it cannot be read
   */
  public static boolean isOne(Path file) throws RecordingException {
    FileBytes bytes = FileBytes.open(file);
    try {
      return McapOpener.isOne(bytes) || BagOpener.isOne(bytes);
    } finally {
      bytes.close();
    }
  }

  private static RecordingReader open(FileBytes bytes, ScanProgress progress) throws RecordingException {
    if (McapOpener.isOne(bytes)) {
      return McapOpener.open(bytes, progress);
    }
    if (BagOpener.isOne(bytes)) {
      return BagOpener.open(bytes, progress);
    }
    throw new RecordingException(bytes.path(), 0,
        "this is no recording that is known here: MCAP and bags of ROS 1 (version 2.0) are");
  }
}
